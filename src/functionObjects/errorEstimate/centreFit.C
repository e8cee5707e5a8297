/*---------------------------------------------------------------------------*\
    cosseratPicFoam: creeping flow of Cosserat media with material points
-------------------------------------------------------------------------------
    Copyright (C) 2026 The cosseratPicFoam authors
-------------------------------------------------------------------------------
License
    This file is part of cosseratPicFoam.

    cosseratPicFoam is free software: you can redistribute it and/or modify it
    under the terms of the GNU General Public License as published by
    the Free Software Foundation, either version 3 of the License, or
    (at your option) any later version.

    cosseratPicFoam is distributed in the hope that it will be useful, but
    WITHOUT ANY WARRANTY; without even the implied warranty of MERCHANTABILITY
    or FITNESS FOR A PARTICULAR PURPOSE.  See the GNU General Public License
    for more details.

    You should have received a copy of the GNU General Public License
    along with cosseratPicFoam.  If not, see <http://www.gnu.org/licenses/>.

\*---------------------------------------------------------------------------*/

#include "centreFit.H"
#include "SVD.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Solve A^T A c = (1 0 0 ...) by Cholesky; false if A has not full rank
    static bool normalSolution(const scalarRectangularMatrix& A, scalarField& c)
    {
        const label n = A.n();
        scalarSquareMatrix L(n, Zero);

        for (label i = 0; i < n; ++i)
        {
            for (label j = 0; j <= i; ++j)
            {
                scalar sum = 0;
                for (label k = 0; k < A.m(); ++k)
                {
                    sum += A(k, i)*A(k, j);
                }
                const scalar whole = sum;
                for (label k = 0; k < j; ++k)
                {
                    sum -= L(i, k)*L(j, k);
                }
                if (i == j && !(sum > 1e-9*whole))
                {
                    return false;
                }
                L(i, j) = i == j ? Foam::sqrt(sum) : sum/L(j, j);
            }
        }

        c = 0;
        c[0] = 1;
        for (label i = 0; i < n; ++i)
        {
            for (label k = 0; k < i; ++k)
            {
                c[i] -= L(i, k)*c[k];
            }
            c[i] /= L(i, i);
        }
        for (label i = n - 1; i >= 0; --i)
        {
            for (label k = i + 1; k < n; ++k)
            {
                c[i] -= L(k, i)*c[k];
            }
            c[i] /= L(i, i);
        }
        return true;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarList Foam::centreFit::weights
(
    const UList<point>& places,
    const point& origin
) const
{
    const label n = places.size();

    // Coordinates in which the places are spread alike in all directions
    scalarField x(n), y(n);
    scalar xx = 0, xy = 0, yy = 0;
    forAll(places, i)
    {
        x[i] = places[i][frame_.i0()] - origin[frame_.i0()];
        y[i] = places[i][frame_.i1()] - origin[frame_.i1()];
        xx += x[i]*x[i]/n;
        xy += x[i]*y[i]/n;
        yy += y[i]*y[i]/n;
    }
    const scalar lx = Foam::sqrt(max(xx, VSMALL));
    const scalar slope = xy/max(xx, VSMALL);
    const scalar ly = Foam::sqrt(max(yy - slope*xy, 1e-12*(xx + yy)));
    y = (y - slope*x)/ly;
    x /= lx;

    const label degree = n > 12 ? 3 : n > 7 ? 2 : n > 3 ? 1 : 0;
    const label nTerms = (degree + 1)*(degree + 2)/2;
    scalarRectangularMatrix A(n, nTerms);
    scalarField w(n);

    forAll(places, i)
    {
        w[i] = 1/(0.1 + sqr(x[i]) + sqr(y[i]));
        label k = 0;
        scalar xp = w[i];
        for (label p = 0; p <= degree; ++p)
        {
            scalar term = xp;
            for (label q = 0; q <= degree - p; ++q)
            {
                A(i, k++) = term;
                term *= y[i];
            }
            xp *= x[i];
        }
    }

    // The constant term of the polynomial
    scalarList result(n, Zero);
    scalarField c(nTerms);
    if (normalSolution(A, c))
    {
        forAll(result, i)
        {
            for (label k = 0; k < nTerms; ++k)
            {
                result[i] += w[i]*A(i, k)*c[k];
            }
        }
    }
    else
    {
        // In a row of cells: without what they do not tell
        const scalarRectangularMatrix inverse(SVD(A, 1e-8).VSinvUt());
        forAll(result, i)
        {
            result[i] = inverse(0, i)*w[i];
        }
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::centreFit::centreFit
(
    const planarMesh& mesh,
    const planarFrame& frame,
    const labelUList& cellToBlock,
    const label nBlocks
)
:
    mesh_(mesh),
    frame_(frame),
    pointCells_(mesh.points().size()),
    blockCells_(invertOneToMany(nBlocks, cellToBlock))
{
    forAll(mesh.loops(), celli)
    {
        for (const label pointi : mesh.loops()[celli])
        {
            pointCells_[pointi].append(celli);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::Field<Type> Foam::centreFit::values
(
    const pointField& places,
    const Field<Type>& inCells,
    const boolUList& useCell,
    const Field<Type>& onSides,
    const boolUList& useSide
) const
{
    Field<Type> result(blockCells_.size(), Zero);
    DynamicList<point> from;
    DynamicList<Type> given;

    forAll(blockCells_, block)
    {
        labelHashSet near;
        for (const label celli : blockCells_[block])
        {
            for (const label pointi : mesh_.loops()[celli])
            {
                near.insert(pointCells_[pointi]);
            }
        }

        from.clear();
        given.clear();
        // Sorted, so that rounding does not depend on the order of hashes
        for (const label celli : near.sortedToc())
        {
            if (useCell[celli])
            {
                from.append(mesh_.centres()[celli]);
                given.append(inCells[celli]);
            }
            for (const label sidei : mesh_.cellSides()[celli])
            {
                if (useSide[sidei])
                {
                    from.append(mesh_.middle(sidei));
                    given.append(onSides[sidei]);
                }
            }
        }

        if (from.size())
        {
            const scalarList w(weights(from, places[block]));
            forAll(w, i)
            {
                result[block] += w[i]*given[i];
            }
        }
    }

    return result;
}


template Foam::Field<Foam::scalar> Foam::centreFit::values
(
    const pointField&, const Field<scalar>&, const boolUList&,
    const Field<scalar>&, const boolUList&
) const;

template Foam::Field<Foam::vector> Foam::centreFit::values
(
    const pointField&, const Field<vector>&, const boolUList&,
    const Field<vector>&, const boolUList&
) const;


// ************************************************************************* //
