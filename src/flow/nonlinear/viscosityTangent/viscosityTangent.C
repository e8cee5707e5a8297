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

#include "viscosityTangent.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::viscosityTangent::setCell
(
    const label celli,
    const operatorState& s
)
{
    byG_[celli] = tensor2D(Zero);
    byGradOmega_[celli] = Zero;
    byOmega_[celli] = byP_[celli] = 0;

    const viscositySlopes* slopes = system_.materials().law(celli).slopes();
    if (!slopes || slopes->byRate.empty())
    {
        return;
    }

    // Of Gamma^2 = 2 D:D + 4 q s^2 + b |grad omega|^2, D without its trace
    const scalar k = slopes->byRate[celli];
    tensor2D D(0.5*(s.G[celli] + s.G[celli].T()));
    const scalar mean = 0.5*(D.xx() + D.yy());
    D.xx() -= mean;
    D.yy() -= mean;
    byG_[celli] = 4*k*D;
    byP_[celli] = slopes->byPressure[celli];

    if (system_.cosserat() && !system_.rotationUndetermined(celli))
    {
        const scalar bySpin = 8*slopes->q*k*s.relativeRotation(celli);
        byOmega_[celli] = bySpin;
        byG_[celli].xy() -= 0.5*bySpin;
        byG_[celli].yx() += 0.5*bySpin;
        byGradOmega_[celli] = 2*slopes->b*k*s.gradOmega[celli];
    }
}


Foam::vector2D Foam::viscosityTangent::wallForce
(
    const operatorState& s,
    const label f
) const
{
    const planarFace& face = system_.faces()[f];
    const label i = system_.faces().boundaryOf(f);
    vector2D F(system_.viscous().onWall(s, f, true));

    switch (system_.boundary().velocity(i))
    {
        case flowBoundary::VELOCITY:
        {
            // Without what takes the traction from halfway to the wall
            const vector2D t(face.t());
            F += 0.5*face.S/face.dc*(s.f[face.own] & t)*t;
            break;
        }
        case flowBoundary::TRACTION:
        {
            F = (F & face.n)*face.n;
            break;
        }
        case flowBoundary::OPEN:
        {
            break;
        }
    }
    return F;
}


void Foam::viscosityTangent::calcChange(const operatorState& s) const
{
    for (label celli = 0; celli < system_.nCells(); ++celli)
    {
        phi_[celli] = (byG_[celli] && s.G[celli]) + byP_[celli]*s.p[celli];
        if (system_.cosserat())
        {
            phi_[celli] +=
                byOmega_[celli]*s.omega[celli]
              + (byGradOmega_[celli] & s.gradOmega[celli]);
        }
    }
    system_.faces().halo().swap(phi_);
}


Foam::scalar Foam::viscosityTangent::change(const label f) const
{
    const planarFace& face = system_.faces()[f];
    const viscousCoefficients& K = system_.coefficients();
    const scalar P = (1 - face.w)/K.side(f, 0).a, N = face.w/K.side(f, 1).a;

    return (P*phi_[face.own] + N*phi_[face.nei])/(P + N);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityTangent::viscosityTangent(const cosseratSystem& system)
:
    system_(system)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscosityTangent::set(const operatorState& s)
{
    const faceGeometry& mesh = system_.faces();
    const label n = system_.nCells();
    const bool cosserat = system_.cosserat();

    byG_.setSize(n);
    byGradOmega_.setSize(n);
    byOmega_.setSize(n);
    byP_.setSize(n);
    phi_.setSize(mesh.nSlots());
    force_.setSize(mesh.nFaces());
    couple_.setSize(cosserat ? mesh.nFaces() : 0);
    moment_.setSize(cosserat ? n : 0);

    for (label celli = 0; celli < n; ++celli)
    {
        setCell(celli, s);
        if (cosserat)
        {
            moment_[celli] = -4*mesh.V()[celli]
               *system_.coefficients().etaC(celli)*s.relativeRotation(celli);
        }
    }
    mesh.forTwoSided
    (
        [&](const label f)
        {
            force_[f] = system_.viscous().onFace(s, f);
            if (cosserat)
            {
                couple_[f] = system_.viscous().coupleOnFace(s, f);
            }
        }
    );
    for (const label f : mesh.oneSided())
    {
        force_[f] = wallForce(s, f);
        if (cosserat)
        {
            couple_[f] =
                system_.boundary().rotationFixed(mesh.boundaryOf(f))
              ? system_.viscous().coupleOnWall(s, f, true)
              : 0;
        }
    }
}


void Foam::viscosityTangent::add
(
    const operatorState& direction,
    scalarField& r
) const
{
    const faceGeometry& mesh = system_.faces();
    const unknowns& all = system_.layout();
    const bool cosserat = system_.cosserat();

    calcChange(direction);
    mesh.forTwoSided
    (
        [&](const label f)
        {
            const label P = mesh[f].own, N = mesh[f].nei;
            const scalar phi = change(f);
            all.addForce(r, P, phi*force_[f]);
            all.addForce(r, N, -phi*force_[f]);
            if (cosserat)
            {
                all.addCouple(r, P, phi*couple_[f]);
                all.addCouple(r, N, -phi*couple_[f]);
            }
        }
    );
    for (const label f : mesh.oneSided())
    {
        const label P = mesh[f].own;
        all.addForce(r, P, phi_[P]*force_[f]);
        if (cosserat)
        {
            all.addCouple(r, P, phi_[P]*couple_[f]);
        }
    }
    for (label celli = 0; cosserat && celli < system_.nCells(); ++celli)
    {
        if (!system_.rotationUndetermined(celli))
        {
            all.addCouple(r, celli, phi_[celli]*moment_[celli]);
        }
    }
}


// ************************************************************************* //
