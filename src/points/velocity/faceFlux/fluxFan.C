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

#include "fluxFan.H"
#include "scalarMatrices.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static List<vector> waysTo
    (
        const UList<point>& corners,
        const point& centre
    )
    {
        List<vector> ways(corners.size());
        forAll(ways, i)
        {
            ways[i] = corners[i] - centre;
        }
        return ways;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fluxFan::solve()
{
    // Unknown: 0 the centre, 1 + i the middle of spoke i. Known: corner i,
    // n + i the middle of the edge from it, 2n the vorticity
    const label n = spokes_.size();
    scalarSquareMatrix K(n + 1, Zero);
    inner_ = RectangularMatrix<scalar>(n + 1, 2*n + 1, Zero);

    for (label i = 0; i < n; ++i)
    {
        const label j = (i + 1) % n;
        const vector& a = spokes_[i];
        const vector& b = spokes_[j];
        const vector e(b - a);

        // Area times the products of the gradients of the barycentric
        // coordinates: of centre (c) and corners (a, b)
        const scalar cc = (e & e)/(2*twoA_[i]);
        const scalar aa = (b & b)/(2*twoA_[i]);
        const scalar bb = (a & a)/(2*twoA_[i]);
        const scalar ca = -(e & b)/(2*twoA_[i]);
        const scalar cb = (e & a)/(2*twoA_[i]);
        const scalar ab = -(a & b)/(2*twoA_[i]);

        // Stiffness of quadratic functions
        K(0, 0) += cc;
        K(0, 1 + i) += 4*ca/3;
        K(1 + i, 0) += 4*ca/3;
        K(0, 1 + j) += 4*cb/3;
        K(1 + j, 0) += 4*cb/3;
        K(1 + i, 1 + i) += 8*(cc + aa + ca)/3;
        K(1 + j, 1 + j) += 8*(cc + bb + cb)/3;
        K(1 + i, 1 + j) += 8*ab/3;
        K(1 + j, 1 + i) += 8*ab/3;

        inner_(0, i) += ca/3;
        inner_(0, j) += cb/3;
        inner_(1 + i, i) -= 4*ca/3;
        inner_(1 + j, j) -= 4*cb/3;
        inner_(1 + i, n + i) -= 8*cb/3;
        inner_(1 + j, n + i) -= 8*ca/3;

        inner_(1 + i, 2*n) += twoA_[i]/6;
        inner_(1 + j, 2*n) += twoA_[i]/6;
    }

    labelList pivots(n + 1);
    LUDecompose(K, pivots);
    scalarField column(n + 1);
    for (label k = 0; k <= 2*n; ++k)
    {
        forAll(column, i)
        {
            column[i] = inner_(i, k);
        }
        LUBacksubstitute(K, pivots, column);
        forAll(column, i)
        {
            inner_(i, k) = column[i];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluxFan::fluxFan
(
    const planarFrame& frame,
    const point& centre,
    const UList<point>& corners
)
:
    frame_(frame),
    centre_(centre),
    spokes_(waysTo(corners, centre)),
    twoA_(corners.size()),
    velocity_(corners.size())
{
    forAll(spokes_, i)
    {
        twoA_[i] = frame_.cross(spokes_[i], spokes_[spokes_.fcIndex(i)]);
    }
    if (flatness() > 0)
    {
        solve();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fluxFan::flatness() const
{
    return min(twoA_)*twoA_.size()/sum(twoA_);
}


void Foam::fluxFan::set
(
    const UList<scalar>& flux,
    const UList<scalar>& slope,
    const scalar vorticity
)
{
    const label n = spokes_.size();
    const scalar divergence = 2*sum(flux)/sum(twoA_);

    // What is known of the stream function
    scalarList known(2*n + 1);
    known[0] = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar next = known[i] + flux[i] - 0.5*divergence*twoA_[i];
        known[n + i] = 0.5*(known[i] + next) - slope[i]/8;
        if (i < n - 1)
        {
            known[i + 1] = next;
        }
    }
    known[2*n] = vorticity;

    scalarList inner(n + 1, Zero);
    forAll(inner, k)
    {
        forAll(known, l)
        {
            inner[k] += inner_(k, l)*known[l];
        }
    }

    for (label i = 0; i < n; ++i)
    {
        const label j = (i + 1) % n;
        const scalar c = inner[0], a = known[i], b = known[j];
        const scalar ca = inner[1 + i], cb = inner[1 + j], ab = known[n + i];

        // Slopes of psi along the ways from a corner to the two others
        const FixedList<Pair<scalar>, 3> slopes
        ({
            {4*ca - 3*c - a, 4*cb - 3*c - b},
            {c + 3*a - 4*ca, 4*ab + c - 4*ca - b},
            {4*ab + c - 4*cb - a, c + 3*b - 4*cb}
        });

        forAll(slopes, k)
        {
            const scalar along0 = slopes[k].first();
            const scalar along1 = slopes[k].second();

            // (psi,1, -psi,0) of the gradient with these along the spokes
            const vector spoke
            (
                (k == 0 ? vector(Zero) : k == 1 ? spokes_[i] : spokes_[j])
            );
            velocity_[i][k] =
                (along1*spokes_[i] - along0*spokes_[j])/twoA_[i]
              + 0.5*divergence*spoke;
        }
    }
}


Foam::vector Foam::fluxFan::value(const point& p) const
{
    const vector d(p - centre_);

    // The triangle that holds it, or the nearest for one that rounding has
    // put outside
    label in = 0;
    scalar best = -GREAT;
    scalar before = frame_.cross(spokes_[0], d);
    forAll(spokes_, i)
    {
        const scalar after = frame_.cross(spokes_[spokes_.fcIndex(i)], d);
        const scalar inside = min(before, -after)/twoA_[i];
        if (inside > best)
        {
            best = inside;
            in = i;
        }
        before = after;
    }

    const vector& next = spokes_[spokes_.fcIndex(in)];
    const scalar lambdaA = -frame_.cross(next, d)/twoA_[in];
    const scalar lambdaB = frame_.cross(spokes_[in], d)/twoA_[in];
    const FixedList<vector, 3>& U = velocity_[in];

    return (1 - lambdaA - lambdaB)*U[0] + lambdaA*U[1] + lambdaB*U[2];
}


// ************************************************************************* //
