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

#include "blockTriangular.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace flowPreconditioners
{
    defineTypeNameAndDebug(blockTriangular, 0);
    addToRunTimeSelectionTable(flowPreconditioner, blockTriangular, system);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::flowPreconditioners::blockTriangular::cycle
(
    const label block,
    const scalarField& r,
    scalarField& z
) const
{
    const label n = system_.nCells();
    const label start = block == 2 ? 3*n : block*n;
    scalarField zi(n);
    blocks_[block].apply(zi, scalarField(SubList<scalar>(r, n, start)));
    SubList<scalar>(z, n, start) = zi;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowPreconditioners::blockTriangular::blockTriangular
(
    const cosseratSystem& system,
    const dictionary& controls
)
:
    flowPreconditioner(system),
    blocks_(system.cosserat() ? 3 : 2),
    rotations_(system)
{
    const word names[] = {"U0", "U1", "omega"};
    forAll(blocks_, i)
    {
        blocks_.set
        (
            i, new multigridBlock(names[i], system.faces().halo(), controls)
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::flowPreconditioners::blockTriangular::update()
{
    flowPreconditioner::update();

    scalarField diag, face;
    for (label cmpt = 0; cmpt < 2; ++cmpt)
    {
        system_.parts().velocityBlock(cmpt, diag, face);
        system_.corners().addDiagonal(cmpt, diag);
        system_.parts().addSliding(cmpt, diag);
        blocks_[cmpt].set(diag, face);
    }
    if (system_.cosserat())
    {
        system_.parts().rotationBlock(diag, face);
        system_.parts().addRolling(diag);
        blocks_[2].set(diag, face);
    }
    rotations_.update();
}


void Foam::flowPreconditioners::blockTriangular::apply
(
    const scalarField& r,
    scalarField& z
) const
{
    const label n = system_.nCells();
    const partialOperators& parts = system_.parts();
    const scalarField p(pressureOf(r));
    scalarField left(r);
    z.setSize(r.size());

    parts.addPressureForce(p, s_, left);
    const scalarField angles(rotations_.angles(left));

    if (system_.cosserat())
    {
        cycle(2, left, z);
        parts.addRotationForce(system_.layout().omega(z), s_, left);
    }
    cycle(0, left, z);
    cycle(1, left, z);
    rotations_.add(angles, z);
    SubList<scalar>(z, n, 2*n) = p;
}


// ************************************************************************* //
