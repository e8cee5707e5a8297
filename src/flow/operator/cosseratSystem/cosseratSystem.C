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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cosseratSystem::setViscosities
(
    const scalarField& eta,
    const scalarField& etaC,
    const scalarField& M,
    const cutCells* cuts
)
{
    K_.set(eta, etaC, M, materials_.invB().primitiveField(), cuts);
    hoop_.update();
    pressureFlux_.update(parts_, materials_.followsFlow());
}


void Foam::cosseratSystem::flatten(const bool flat)
{
    if (mesh_.axial().active())
    {
        mesh_.flatten(flat);
        pressure_.setReconstruction();
    }
}


void Foam::cosseratSystem::setCorners
(
    const scalarField& eta,
    const scalarField& etaC,
    const scalarField& M
)
{
    corners_.setMaterials(eta, etaC, M, materials_.invB().primitiveField());

    const bool held = K_.held();
    K_.hold(false);
    operatorState s(newState());
    scalarField etaAround(eta), etaCAround(etaC), MAround(M);
    while (corners_.takeJobs(etaAround, etaCAround, MAround))
    {
        // Seen from close by the edge of a ring is straight
        flatten(true);

        setViscosities(etaAround, etaCAround, MAround, nullptr);
        corners_.doJobs
        (
            [&](const scalarField& x, scalarField& r)
            {
                plainResidual(x, false, false, s, r);
            }
        );

        flatten(false);
    }
    K_.hold(held);
}


void Foam::cosseratSystem::setWeights()
{
    const label n = nCells();
    scalarField diag, face;

    for (label cmpt = 0; cmpt < 2; ++cmpt)
    {
        parts_.velocityBlock(cmpt, diag, face);
        corners_.addDiagonal(cmpt, diag);
        SubList<scalar>(weights_, n, cmpt*n) = 1/sqrt(diag);
    }
    SubList<scalar>(weights_, n, 2*n) =
        sqrt(pressureViscosity(materials_.eta().primitiveField())/mesh_.V());
    if (cosserat())
    {
        parts_.rotationBlock(diag, face);
        SubList<scalar>(weights_, n, 3*n) = 1/sqrt(diag);
    }
}


void Foam::cosseratSystem::unpack
(
    const scalarField& x,
    const bool driven,
    operatorState& s
) const
{
    const label n = nCells();
    for (label celli = 0; celli < n; ++celli)
    {
        s.u[celli] = all_.u(x, celli);
    }
    SubList<scalar>(s.p, n) = all_.p(x);

    if (cosserat())
    {
        SubList<scalar>(s.omega, n) = all_.omega(x);
        mesh_.halo().swap(s.u, s.p, s.omega);
    }
    else
    {
        mesh_.halo().swap(s.u, s.p);
    }
}


void Foam::cosseratSystem::setNormal(operatorState& s) const
{
    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        const label i = mesh_.boundaryOf(f);
        if (boundary_.velocity(i) != flowBoundary::OPEN)
        {
            // The wall is at rest along a direction
            s.normal[i] =
                pressure_.onWall(s, face.nei, false)
              + K_[f].Kn*(s.u[face.own] & face.n)/face.S;
        }
    }
}


Foam::scalar Foam::cosseratSystem::flux
(
    const operatorState& s,
    const label f
) const
{
    const planarFace& face = mesh_[f];
    const label P = face.own, N = face.nei;
    const scalar wP = K_[f].wStiff, wN = 1 - wP;

    vector2D u(wP*s.u[P] + wN*s.u[N]);
    if (mesh_.leans(f) && K_.anyFluxOffset())
    {
        u += K_.fluxOffset(f) & (wP*s.G[P] + wN*s.G[N]);
    }

    return face.S*((u & face.n) + pressureFlux_.speed(s, f));
}


void Foam::cosseratSystem::addTwoSided
(
    operatorState& s,
    scalarField& r
) const
{
    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const label P = mesh_[f].own, N = mesh_[f].nei;

            const vector2D F(viscous_.onFace(s, f));
            all_.addForce(r, P, F);
            all_.addForce(r, N, -F);

            s.flux[f] = flux(s, f);
            all_.addInflow(r, P, -s.flux[f]);
            all_.addInflow(r, N, s.flux[f]);

            if (cosserat())
            {
                const scalar C = viscous_.coupleOnFace(s, f);
                all_.addCouple(r, P, C);
                all_.addCouple(r, N, -C);
            }
        }
    );
}


void Foam::cosseratSystem::addOneSided
(
    operatorState& s,
    const bool driven,
    scalarField& r
) const
{
    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        const label i = mesh_.boundaryOf(f);
        const label P = face.own;

        s.flux[f] = face.S*(s.u[face.nei] & face.n);
        if
        (
            boundary_.velocity(i) == flowBoundary::OPEN
         && boundary_.pressureFixed(i)
        )
        {
            s.flux[f] += face.S*pressureFlux_.openSpeed(s, f);
        }

        all_.addForce(r, P, viscous_.onWall(s, f, driven));
        all_.addInflow(r, P, -s.flux[f]);
        if (cosserat())
        {
            all_.addCouple(r, P, viscous_.coupleOnWall(s, f, driven));
        }
    }
}


void Foam::cosseratSystem::addCells
(
    const operatorState& s,
    const bool driven,
    scalarField& r
) const
{
    const label n = nCells();
    const scalarField& V = mesh_.V();

    pressure_.add(s, all_, r);

    for (label celli = 0; cosserat() && celli < n; ++celli)
    {
        if (rotationUndetermined(celli))
        {
            r[3*n + celli] = -V[celli]*K_.eta(celli)*s.omega[celli];
        }
        else
        {
            r[3*n + celli] -=
                4*V[celli]*K_.etaC(celli)*s.relativeRotation(celli);
        }
    }

    hoop_.add(s, all_, r);

    if (driven && cosserat() && loads_.couple())
    {
        // Zero where there is no equation for omega
        const scalarField& couple = loads_.couple()->primitiveField();
        forAll(couple, celli)
        {
            all_.addCouple(r, celli, V[celli]*couple[celli]);
        }
    }

    if (K_.compressible())
    {
        const scalarField& invB = materials_.invB().primitiveField();
        forAll(invB, celli)
        {
            const scalar hydrostatic = driven ? loads_.rhoGh()[celli] : 0;
            all_.addInflow
            (
                r, celli, -V[celli]*invB[celli]*(s.p[celli] + hydrostatic)
            );
        }
    }
}


void Foam::cosseratSystem::plainResidual
(
    const scalarField& x,
    const bool driven,
    const bool moving,
    operatorState& s,
    scalarField& r
) const
{
    unpack(x, driven, s);
    pressure_.calc(s, driven, moving);
    if (boundary_.frictional() && !driven)
    {
        setNormal(s);
    }
    gradient_.setBoundary(s, driven);
    gradient_.calc(s, driven);
    pressureFlux_.calc(s);
    if (s.fSmooth.size())
    {
        mesh_.halo().swap(s.G, s.f, s.fSmooth);
    }
    else
    {
        mesh_.halo().swap(s.G, s.f);
    }

    r.setSize(size());
    r = 0;
    addTwoSided(s, r);
    addOneSided(s, driven, r);
    addCells(s, driven, r);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cosseratSystem::cosseratSystem
(
    const fvMesh& mesh,
    const planarFrame& frame,
    const haloExchange& halo,
    const flowBoundary& boundary,
    const materialFields& materials,
    const bool wantCorners
)
:
    boundary_(boundary),
    materials_(materials),
    mesh_(mesh, frame, halo),
    all_(mesh.nCells(), materials.parts().has(sceneParts::MICROROTATION)),
    K_
    (
        mesh_, boundary, all_.cosserat(),
        materials.parts().has(sceneParts::COMPRESSIBILITY)
    ),
    hoop_(mesh_, K_),
    stabilisation_(mesh, frame, halo),
    loads_(mesh_, boundary, materials),
    gradient_(mesh_, boundary, K_),
    viscous_(mesh_, boundary, K_),
    pressure_(mesh_, boundary, K_, gradient_, loads_, stabilisation_),
    parts_(mesh_, boundary, K_, hoop_, pressure_, stabilisation_, all_),
    corners_(mesh, frame, halo, boundary, wantCorners),
    pressureFlux_(mesh_, boundary, K_),
    pressureFloats_(false),
    weights_(all_.size())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cosseratSystem::update()
{
    const scalarField& eta = materials_.eta().primitiveField();
    const scalarField& M = materials_.M().primitiveField();
    scalarField etaC(materials_.etaC().primitiveField());

    // Without bending viscosity the moment balance is s = 0: no effect of etaC
    forAll(etaC, celli)
    {
        if (M[celli] <= 0)
        {
            etaC[celli] = 0;
        }
    }

    // A compressible material may be nowhere
    pressureFloats_ =
        boundary_.closed() && !(K_.compressible() && compliance() > 0);

    stabilisation_.update(materials_.rho(), loads_.gravity());

    if (materials_.followsFlow())
    {
        K_.setOverRest(materials_.overRest());
    }
    if (corners_.active())
    {
        setCorners(eta, etaC, M);
    }
    setViscosities
    (
        eta, etaC, M, materials_.layered() ? &materials_.cuts() : nullptr
    );
    if (!K_.held())
    {
        loads_.update(M);
    }
    setWeights();
}


void Foam::cosseratSystem::residual
(
    const scalarField& x,
    const bool driven,
    operatorState& s,
    scalarField& r
) const
{
    plainResidual(x, driven, true, s, r);
    if (corners_.active())
    {
        corners_.addForce(s.u, driven, r);
    }
}


Foam::tmp<Foam::scalarField> Foam::cosseratSystem::pressureViscosity
(
    const scalarField& eta
) const
{
    return 1/(1/eta + materials_.invB().primitiveField());
}


// ************************************************************************* //
