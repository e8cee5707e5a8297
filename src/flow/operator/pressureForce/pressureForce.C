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

#include "pressureForce.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pressureForce::setReconstruction()
{
    reconstruction_ = Zero;

    auto add = [&](const label celli, const planarFace& face, const scalar way)
    {
        reconstruction_[celli] += (way*face.S/face.dc*face.n)*face.m;
    };
    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh_[f];
            add(face.own, face, 1 - face.w);
            if (face.nei < mesh_.nCells())
            {
                add(face.nei, face, face.w);
            }
        }
    );
    for (const label f : mesh_.oneSided())
    {
        if (boundary_.pressureFixed(mesh_.boundaryOf(f)))
        {
            add(mesh_[f].own, mesh_[f], 1);
        }
    }

    // A cell may have a single face that counts
    for (tensor2D& T : reconstruction_)
    {
        T = planarFrame::generalInverse(T);
    }
}


void Foam::pressureForce::setFaces(operatorState& s, const bool driven) const
{
    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh_[f];
            s.faceForce[f] = -face.dc*(s.p[face.nei] - s.p[face.own]);
        }
    );
    if (driven)
    {
        mesh_.forTwoSided
        (
            [&](const label f) { s.faceForce[f] += loads_.faceForce(f); }
        );
        forAll(boundary_.jump(), i)
        {
            const label f = mesh_.nInternal() + i;
            s.faceForce[f] += mesh_[f].dc*boundary_.jump()[i];
        }
    }

    for (const label f : mesh_.oneSided())
    {
        const label i = mesh_.boundaryOf(f);
        s.faceForce[f] = 0;
        if (boundary_.pressureFixed(i))
        {
            const scalar given = driven ? loads_.givenPressure(i) : 0;
            s.faceForce[f] = -mesh_[f].dc*(given - s.p[mesh_[f].own]);
            if (driven)
            {
                s.faceForce[f] += loads_.faceForce(f);
            }
        }
    }
}


void Foam::pressureForce::addStabilisation(operatorState& s) const
{
    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh_[f];
            const label P = face.own, N = face.nei;
            s.faceForce[f] += stabilisation_.along(face.m)*
            (
                face.w*stabilisation_.change(P, s.u[P])
              + (1 - face.w)*stabilisation_.change(N, s.u[N])
            );
        }
    );
}


void Foam::pressureForce::reconstruct(operatorState& s) const
{
    s.f = Zero;

    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh_[f];
            const vector2D F(face.S*s.faceForce[f]/face.dc*face.n);
            s.f[face.own] += (1 - K_[f].wSoft)*F;
            s.f[face.nei] += K_[f].wSoft*F;
        }
    );
    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        s.f[face.own] += face.S*s.faceForce[f]/face.dc*face.n;
    }

    forAll(reconstruction_, celli)
    {
        s.f[celli] = reconstruction_[celli] & s.f[celli];
    }
}


void Foam::pressureForce::addAdjoint
(
    const operatorState& s,
    const unknowns& all,
    scalarField& r
) const
{
    // Work of the pressure differences on the part of the fluxes that the
    // gradients of cells make
    Field<tensor2D> B(mesh_.nSlots(), Zero);
    for (const label f : mesh_.aroundAdjoint().faces)
    {
        const planarFace& face = mesh_[f];
        const scalar wP = K_[f].wStiff;
        const tensor2D b
        (
            face.S*s.faceForce[f]/face.dc*(K_.fluxOffset(f)*face.n)
        );
        B[face.own] += wP*b;
        B[face.nei] += (1 - wP)*b;
    }
    gradient_.addAdjoint(B, all, r);

    for (const label f : mesh_.aroundAdjoint().faces)
    {
        const planarFace& face = mesh_[f];
        const scalar wP = K_[f].wStiff;
        const vector2D F(face.S*s.faceForce[f]/face.dc*face.n);
        all.addForce(r, face.own, wP*F);
        all.addForce(r, face.nei, (1 - wP)*F);
    }
    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        all.addForce(r, face.own, face.S*s.faceForce[f]/face.dc*face.n);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pressureForce::pressureForce
(
    const faceGeometry& mesh,
    const flowBoundary& boundary,
    const viscousCoefficients& K,
    const cellGradient& gradient,
    const flowLoads& loads,
    const surfaceStabilisation& stabilisation
)
:
    mesh_(mesh),
    boundary_(boundary),
    K_(K),
    gradient_(gradient),
    loads_(loads),
    stabilisation_(stabilisation),
    reconstruction_(mesh.nCells())
{
    setReconstruction();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pressureForce::calc
(
    operatorState& s,
    const bool driven,
    const bool moving
) const
{
    setFaces(s, driven);
    if (moving && stabilisation_.active())
    {
        addStabilisation(s);
    }
    reconstruct(s);
}


void Foam::pressureForce::add
(
    const operatorState& s,
    const unknowns& all,
    scalarField& r
) const
{
    scalarField adjoint;
    if (mesh_.anyAdjoint())
    {
        adjoint.setSize(r.size(), 0);
        addAdjoint(s, all, adjoint);
    }

    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        all.addForce
        (
            r,
            celli,
            mesh_.adjoint(celli)
          ? all.u(adjoint, celli)
          : vector2D(mesh_.V()[celli]*s.f[celli])
        );
    }
}


Foam::scalar Foam::pressureForce::onBoundary
(
    const operatorState& s,
    const label slot
) const
{
    const planarFace& face = mesh_[mesh_.faceOf(slot)];
    const label i = mesh_.boundaryOf(mesh_.faceOf(slot));

    return
        boundary_.pressureFixed(i)
      ? loads_.givenPressure(i)
      : s.p[face.own] - (s.f[face.own] & (face.m/face.dc));
}


Foam::scalar Foam::pressureForce::onWall
(
    const operatorState& s,
    const label slot,
    const bool driven
) const
{
    const label f = mesh_.faceOf(slot);
    const planarFace& face = mesh_[f];
    const label P = face.own;
    const bool fixed = boundary_.pressureFixed(mesh_.boundaryOf(f));

    // onBoundary takes no load from the cell to the face, by which p rises
    // there in a fluid at rest
    scalar p = onBoundary(s, slot);
    if (driven)
    {
        vector load(loads_.rho(P)*loads_.gravity());
        if (!fixed && loads_.force())
        {
            load += loads_.force()->primitiveField()[P];
        }
        p +=
            loads_.rhoGh()[P]
          + (mesh_.frame().inPlane(load) & (face.m/face.dc));
    }
    return p;
}


// ************************************************************************* //
