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

#include "rigidMotions.H"
#include "SVD.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::rigidMotions::candidate
(
    const label i
) const
{
    const label n = system_.nCells();
    tmp<scalarField> tx(new scalarField(system_.size(), Zero));
    scalarField& x = tx.ref();

    if (i < 2)
    {
        SubList<scalar>(x, n, i*n) = 1;
    }
    else
    {
        const fvMesh& mesh = system_.faces().mesh();
        const planarFrame& frame = system_.faces().frame();
        const vectorField& C = mesh.C().primitiveField();
        const vector centre(gSum(C*mesh.V())/gSum(mesh.V()));

        for (label celli = 0; celli < n; ++celli)
        {
            const vector d(C[celli] - centre);
            x[celli] = -d[frame.i1()];
            x[n + celli] = d[frame.i0()];
            if (system_.cosserat())
            {
                x[3*n + celli] =
                    system_.rotationUndetermined(celli) ? 0 : 1;
            }
        }
    }

    return tx;
}


Foam::scalar Foam::rigidMotions::product
(
    const scalarField& a,
    const scalarField& b
) const
{
    return gSum(volume_*a*b);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rigidMotions::rigidMotions(const cosseratSystem& system)
:
    system_(system),
    volume_(system.size()),
    sumV_(gSum(system.faces().V()))
{
    const label n = system.nCells();
    for (label block = 0; block < system.layout().nBlocks(); ++block)
    {
        SubList<scalar>(volume_, n, block*n) = system.faces().V();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rigidMotions::find()
{
    const scalarField& weights = system_.weights();
    modes_.clear();

    operatorState s(system_.newState());
    PtrList<scalarField> x(3), Ax(3);
    forAll(x, i)
    {
        x.set(i, new scalarField(candidate(i)));
        Ax.set(i, new scalarField());
        system_.residual(x[i], false, s, Ax[i]);
        Ax[i] *= weights;

        // A motion of each component of U for itself would give this norm.
        // Not of omega: at large M it would hide what holds a rotation
        const label n = 2*system_.nCells();
        const scalar norm = Foam::sqrt
        (
            gSumSqr
            (
                scalarField(SubList<scalar>(x[i], n))
               /scalarField(SubList<scalar>(weights, n))
            )
        );
        x[i] /= norm;
        Ax[i] /= norm;
    }

    scalarRectangularMatrix gram(3, 3);
    for (label i = 0; i < 3; ++i)
    {
        for (label j = 0; j < 3; ++j)
        {
            gram(i, j) = gSumProd(Ax[i], Ax[j]);
        }
    }

    const SVD svd(gram);

    for (label k = 0; k < 3; ++k)
    {
        // Rounding of the operator against the stiffness of one cell
        if (svd.S()[k] < 1e-14)
        {
            scalarField mode(system_.size(), Zero);
            forAll(x, i)
            {
                mode += svd.V()(i, k)*x[i];
            }
            for (const scalarField& other : modes_)
            {
                mode -= product(mode, other)*other;
            }
            mode /= Foam::sqrt(product(mode, mode));
            modes_.append(new scalarField(mode));
        }
    }
}


Foam::vector Foam::rigidMotions::direction(const label i) const
{
    const label n = system_.nCells();
    const scalarField& V = system_.faces().mesh().V();
    const scalar v0 = gSum(V*SubList<scalar>(modes_[i], n, 0));
    const scalar v1 = gSum(V*SubList<scalar>(modes_[i], n, n));
    const vector v(system_.faces().frame().inSpace(v0, v1));

    return mag(v) > SMALL*gSum(V) ? normalised(v) : vector(Zero);
}


void Foam::rigidMotions::removeFromSolution(scalarField& x) const
{
    for (const scalarField& mode : modes_)
    {
        x -= product(mode, x)*mode;
    }

    if (system_.pressureFloats())
    {
        const label n = system_.nCells();
        const scalarField& V = system_.faces().mesh().V();
        const scalarField p(SubList<scalar>(x, n, 2*n));
        SubList<scalar>(x, n, 2*n) = p - gSum(V*p)/sumV_;
    }
}


void Foam::rigidMotions::removeFromResidual(scalarField& r) const
{
    for (const scalarField& mode : modes_)
    {
        r -= gSumProd(mode, r)*(volume_*mode);
    }
}


// ************************************************************************* //
