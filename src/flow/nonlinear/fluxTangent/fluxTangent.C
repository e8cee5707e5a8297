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

#include "fluxTangent.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fluxTangent::setShares()
{
    const faceGeometry& mesh = system_.faces();
    const flowBoundary& boundary = system_.boundary();
    const viscousCoefficients& K = system_.coefficients();

    mesh.forTwoSided
    (
        [&](const label f) { share_[f] = K[f].Kn + K[f].Kt; }
    );
    for (const label f : mesh.oneSided())
    {
        const auto kind = boundary.velocity(mesh.boundaryOf(f));
        share_[f] =
            (kind == flowBoundary::OPEN ? 0 : K[f].Kn)
          + (kind == flowBoundary::VELOCITY ? K[f].Kt : 0);
    }

    scalarField diag[2], face;
    system_.parts().velocityBlock(0, diag[0], face);
    system_.parts().velocityBlock(1, diag[1], face);
    total_ = -(diag[0] + diag[1]);

    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        rAU_[celli] = mesh.V()[celli]/total_[celli];
    }
    mesh.halo().swap(rAU_);
}


void Foam::fluxTangent::along(const scalarField& phi) const
{
    const faceGeometry& mesh = system_.faces();
    const label n = mesh.nCells();

    change_ = 0;
    for (label f = 0; f < mesh.nFaces(); ++f)
    {
        change_[mesh[f].own] += share_[f]*phi[f];
    }
    mesh.forTwoSided
    (
        [&](const label f)
        {
            if (mesh[f].nei < n)
            {
                change_[mesh[f].nei] += share_[f]*phi[f];
            }
        }
    );
    for (label celli = 0; celli < n; ++celli)
    {
        change_[celli] /= total_[celli];
    }
    mesh.halo().swap(change_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluxTangent::fluxTangent
(
    const cosseratSystem& system,
    const lawsInFlow& laws
)
:
    system_(system),
    laws_(laws),
    share_(system.faces().nFaces()),
    total_(),
    flux_(system.faces().nFaces(), Zero),
    rAU_(system.faces().nSlots(), 1.0),
    change_(system.faces().nSlots())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fluxTangent::set(const operatorState& s, const bool near)
{
    const faceGeometry& mesh = system_.faces();
    const flowBoundary& boundary = system_.boundary();

    flux_ = 0;
    if (!near)
    {
        total_.clear();
        return;
    }

    setShares();
    mesh.forTwoSided
    (
        [&](const label f)
        {
            flux_[f] = mesh[f].S*system_.fluxOfPressure().speed(s, f);
        }
    );
    for (const label f : mesh.oneSided())
    {
        const label i = mesh.boundaryOf(f);
        if
        (
            boundary.velocity(i) == flowBoundary::OPEN
         && boundary.pressureFixed(i)
        )
        {
            flux_[f] = mesh[f].S*system_.fluxOfPressure().openSpeed(s, f);
        }
    }
}


void Foam::fluxTangent::add(const scalarField& phi, scalarField& r) const
{
    const faceGeometry& mesh = system_.faces();
    const unknowns& all = system_.layout();
    const viscousCoefficients& K = system_.coefficients();

    if (!total_.size())
    {
        return;
    }

    along(phi);
    mesh.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh[f];
            const label P = face.own, N = face.nei;
            const scalar etaP = K.eta(P), etaN = K.eta(N);
            // Of the mean of rAU, to which the softer cell gives more
            const scalar wP = face.w*rAU_[P], wN = (1 - face.w)*rAU_[N];
            const scalar change =
                (wP*change_[P] + wN*change_[N])/(wP + wN)
              + (laws_.cell(P) - laws_.cell(N))*(etaN - etaP)/(etaP + etaN);
            all.addInflow(r, P, -change*flux_[f]);
            all.addInflow(r, N, change*flux_[f]);
        }
    );
    for (const label f : mesh.oneSided())
    {
        const label P = mesh[f].own;
        all.addInflow(r, P, -change_[P]*flux_[f]);
    }
}


// ************************************************************************* //
