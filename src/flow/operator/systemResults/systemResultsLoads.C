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

#include "systemResults.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::systemResults::wallLoads
(
    const label patchi,
    vectorField& pressure,
    vectorField& viscous,
    scalarField& couple
) const
{
    const planarFrame& frame = mesh_.frame();
    const fvPatch& patch = mesh_.mesh().boundary()[patchi];
    const vectorField n(patch.nf());

    pressure.setSize(patch.size());
    viscous.setSize(patch.size());
    couple.setSize(patch.size());

    forAll(patch, i)
    {
        const label slot = mesh_.halo().start(patchi) + i;
        const label f = mesh_.faceOf(slot);
        const label P = mesh_[f].own;

        pressure[i] =
            system_.pressure().onWall(s_, slot, true)
           *mesh_[f].S*n[i];

        viscous[i] = -frame.inSpace(system_.viscous().onWall(s_, f, true));

        couple[i] =
            system_.cosserat() && !system_.rotationUndetermined(P)
          ? -system_.viscous().coupleOnWall(s_, f, true) : 0;
    }
}


Foam::tmp<Foam::vectorField> Foam::systemResults::cornerLoads() const
{
    scalarField r(system_.size(), Zero);
    system_.corners().addForce(s_.u, true, r);

    tmp<vectorField> tforce(new vectorField(mesh_.nCells()));
    vectorField& force = tforce.ref();
    forAll(force, celli)
    {
        force[celli] =
            -mesh_.frame().inSpace(system_.layout().u(r, celli));
    }

    return tforce;
}


void Foam::systemResults::netInflow(scalar& net, scalar& magnitude) const
{
    net = magnitude = 0;

    for (const label f : mesh_.oneSided())
    {
        const label i = mesh_.boundaryOf(f);
        if (system_.boundary().velocity(i) == flowBoundary::VELOCITY)
        {
            const vector2D u(system_.boundary().u(i));
            net -= mesh_[f].S*(u & mesh_[f].n);
            magnitude += mesh_[f].S*mag(u);
        }
        else
        {
            const scalar u = system_.boundary().normalSpeed(i);
            net -= mesh_[f].S*u;
            magnitude += mesh_[f].S*mag(u);
        }
    }

    reduce(net, sumOp<scalar>());
    reduce(magnitude, sumOp<scalar>());
}


// ************************************************************************* //
