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

Foam::vector2D Foam::viscosityTangent::wallForce
(
    const operatorState& s,
    const label f
) const
{
    const planarFace& face = system_.faces()[f];
    const vector2D F(system_.viscous().onWall(s, f, true));
    const vector2D t(face.t());

    switch (system_.boundary().velocity(system_.faces().boundaryOf(f)))
    {
        case flowBoundary::VELOCITY:
        {
            // Without what takes the traction from halfway to the wall
            return F + 0.5*face.S/face.dc*(s.f[face.own] & t)*t;
        }
        case flowBoundary::TRACTION:
        {
            const scalar Fn = F & face.n;
            return Fn*face.n + frictionForce(Fn, f)*t;
        }
        case flowBoundary::OPEN:
        {
            break;
        }
    }
    return Zero;
}


Foam::scalar Foam::viscosityTangent::frictionForce
(
    const scalar normalForce,
    const label f
) const
{
    if (!system_.boundary().frictional())
    {
        return 0;
    }

    // By the change of the normal traction, less what the wall resists of the
    // motion that it makes
    const viscousCoefficients& K = system_.coefficients();
    const wallLaw byNormal
    (
        system_.boundary().sliding(system_.faces().boundaryOf(f)).change(1)
    );
    return -byNormal.given*normalForce
       *K.wallGain(f, byNormal.resistance)/K.wallGain(f, 0);
}


void Foam::viscosityTangent::setCell
(
    const operatorState& s,
    const label celli
)
{
    moment_[celli] =
        system_.rotationUndetermined(celli)
      ? 0
      : -4*system_.faces().V()[celli]*system_.coefficients().etaC(celli)
       *s.relativeRotation(celli);
    if (system_.hoop().active())
    {
        moment_[celli] += system_.hoop().couple(s, celli);
    }
}


void Foam::viscosityTangent::setWall(const operatorState& s, const label f)
{
    force_[f] = wallForce(s, f);
    if (!system_.cosserat())
    {
        return;
    }

    couple_[f] = 0;
    if (system_.boundary().rotationFixed(system_.faces().boundaryOf(f)))
    {
        // What takes the couple from halfway to the wall is of the cell
        const planarFace& face = system_.faces()[f];
        const label P = face.own;
        const scalar way =
            2*system_.coefficients().etaC(P)*s.relativeRotation(P)
           *face.S/face.dc;
        couple_[f] = system_.viscous().coupleOnWall(s, f, true) - way;
        moment_[P] += way;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityTangent::viscosityTangent
(
    const cosseratSystem& system,
    const lawsInFlow& laws
)
:
    system_(system),
    laws_(laws),
    force_(system.faces().nFaces()),
    couple_(system.cosserat() ? system.faces().nFaces() : 0),
    moment_(system.cosserat() ? system.nCells() : 0),
    hoop_(system.hoop().active() ? system.nCells() : 0),
    phi_(system.faces().nFaces()),
    fluxes_(system, laws)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscosityTangent::set(const operatorState& s, const bool near)
{
    const faceGeometry& mesh = system_.faces();

    forAll(moment_, celli)
    {
        setCell(s, celli);
    }
    forAll(hoop_, celli)
    {
        hoop_[celli] = system_.hoop().force(s, celli);
    }
    mesh.forTwoSided
    (
        [&](const label f)
        {
            force_[f] = system_.viscous().onFace(s, f);
            if (system_.cosserat())
            {
                couple_[f] = system_.viscous().coupleOnFace(s, f);
            }
        }
    );
    for (const label f : mesh.oneSided())
    {
        setWall(s, f);
    }
    fluxes_.set(s, near);
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

    laws_.along(direction);
    forAll(phi_, f)
    {
        phi_[f] = laws_.face(direction, f);
    }
    mesh.forTwoSided
    (
        [&](const label f)
        {
            const label P = mesh[f].own, N = mesh[f].nei;
            const scalar phi = phi_[f];
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
        const scalar phi = phi_[f];
        all.addForce(r, P, phi*force_[f]);
        if (cosserat)
        {
            all.addCouple(r, P, phi*couple_[f]);
        }
    }
    forAll(moment_, celli)
    {
        all.addCouple(r, celli, laws_.cell(celli)*moment_[celli]);
    }
    forAll(hoop_, celli)
    {
        all.addForce
        (
            r, celli, laws_.cell(celli)*hoop_[celli]*mesh.radial()
        );
    }
    fluxes_.add(phi_, r);
}


// ************************************************************************* //
