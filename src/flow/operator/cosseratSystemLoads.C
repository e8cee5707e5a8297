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

#include "cosseratSystem.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cosseratSystem::wallLoads
(
    const label patchi,
    vectorField& pressure,
    vectorField& viscous,
    scalarField& couple
) const
{
    const fvPatch& patch = mesh_.boundary()[patchi];
    const labelUList& cells = patch.faceCells();
    const vectorField n(patch.nf());
    const vectorField d(patch.Cf() - patch.Cn());
    const vector g(gravity());

    // What weightForce() moves from a cell to the next one is no force between
    // cell and wall
    vectorField moved(nCells_, Zero);
    for (const label f : jump_)
    {
        const scalar s = (wSoft_[f] - w_[f])*ff_[f]/dc_[f];
        for (const label celli : {own_[f], nei_[f]})
        {
            if (celli < nCells_)
            {
                scalar s0, s1;
                gradientVector(celli, f, s0, s1);
                moved[celli] -= s*frame_.inSpace(s0, s1);
            }
        }
    }

    pressure.setSize(patch.size());
    viscous.setSize(patch.size());
    couple.setSize(patch.size());

    forAll(patch, i)
    {
        const label slot = halo_.start(patchi) + i;
        const label f = nInternal_ + slot - nCells_;
        const label P = cells[i];

        // boundaryPressure takes no load from the cell to the face, by which p
        // rises there in a fluid at rest
        vector force(rho_[P]*g);
        if (!boundary_.pressureFixed(boundary_.at(slot)))
        {
            force += moved[P];
            if (load_.force())
            {
                force += load_.force()->primitiveField()[P];
            }
        }
        const scalar p =
            boundaryPressure(slot) + rhoGh_[P] + (force & d[i]);
        pressure[i] = p*S_[f]*n[i];

        scalar F0, F1;
        wallForce(f, true, F0, F1);
        viscous[i] = -frame_.inSpace(F0, F1);

        couple[i] =
            cosserat_ && !rotationUndetermined(P) ? -wallCouple(f, true) : 0;
    }
}


Foam::tmp<Foam::vectorField> Foam::cosseratSystem::cornerLoads() const
{
    scalarField r(size(), Zero);
    corners_.addForce(u0_, u1_, true, r);

    tmp<vectorField> tforce(new vectorField(nCells_));
    vectorField& force = tforce.ref();
    forAll(force, celli)
    {
        force[celli] = -frame_.inSpace(r[celli], r[nCells_ + celli]);
    }

    return tforce;
}


// ************************************************************************* //
