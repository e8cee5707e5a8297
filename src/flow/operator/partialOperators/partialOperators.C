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

#include "partialOperators.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::partialOperators::partialOperators
(
    const faceGeometry& mesh,
    const flowBoundary& boundary,
    const viscousCoefficients& K,
    const hoopForce& hoop,
    const pressureForce& pressure,
    const surfaceStabilisation& stabilisation,
    const unknowns& all
)
:
    mesh_(mesh),
    boundary_(boundary),
    K_(K),
    hoop_(hoop),
    pressure_(pressure),
    stabilisation_(stabilisation),
    all_(all)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::partialOperators::velocityBlock
(
    const label cmpt,
    scalarField& diag,
    scalarField& face
) const
{
    const label n = mesh_.nCells();
    diag = scalarField(n, Zero);
    face.setSize(mesh_.nFaces());

    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const scalar nn = sqr(mesh_[f].n[cmpt]);
            face[f] = K_[f].Kn*nn + K_[f].Kt*(1 - nn);
            diag[mesh_[f].own] += face[f];
            if (mesh_[f].nei < n)
            {
                diag[mesh_[f].nei] += face[f];
            }
        }
    );
    for (const label f : mesh_.oneSided())
    {
        const auto kind = boundary_.velocity(mesh_.boundaryOf(f));
        const scalar nn = sqr(mesh_[f].n[cmpt]);

        face[f] = 0;
        if (kind != flowBoundary::OPEN)
        {
            diag[mesh_[f].own] += K_[f].Kn*nn;
        }
        if (kind == flowBoundary::VELOCITY)
        {
            diag[mesh_[f].own] += K_[f].Kt*(1 - nn);
        }
    }

    hoop_.addVelocityDiagonal(cmpt, diag);
    if (stabilisation_.active())
    {
        forAll(diag, celli)
        {
            diag[celli] +=
                mesh_.V()[celli]*stabilisation_.diagonal(celli, cmpt);
        }
    }
}


void Foam::partialOperators::rotationBlock
(
    scalarField& diag,
    scalarField& face
) const
{
    const label n = mesh_.nCells();
    diag.setSize(n);
    face.setSize(mesh_.nFaces());

    forAll(diag, celli)
    {
        diag[celli] = mesh_.V()[celli]*
        (
            K_.rotationUndetermined(celli) ? K_.eta(celli) : 4*K_.etaC(celli)
        );
    }
    mesh_.forTwoSided
    (
        [&](const label f)
        {
            face[f] = K_.rotation(f).Km;
            diag[mesh_[f].own] += face[f];
            if (mesh_[f].nei < n)
            {
                diag[mesh_[f].nei] += face[f];
            }
        }
    );
    for (const label f : mesh_.oneSided())
    {
        face[f] = 0;
        if (boundary_.rotationFixed(mesh_.boundaryOf(f)))
        {
            diag[mesh_[f].own] += K_.rotation(f).Km;
        }
    }
    hoop_.addRotationDiagonal(diag);
}


Foam::tmp<Foam::scalarField>
Foam::partialOperators::heldViscosity() const
{
    const label n = mesh_.nCells();
    const auto squares = [](const vector2D& v)
    {
        return vector2D(sqr(v.x()), sqr(v.y()));
    };

    // Walls are left out: with them it would be more beside each
    Field<vector2D> diag(mesh_.nSlots(), Zero);
    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh_[f];
            const vector2D k(0.5*K_[f].Kn*(vector2D(1, 1) + squares(face.n)));
            diag[face.own] += k;
            diag[face.nei] += k;
        }
    );
    mesh_.halo().swap(diag);

    scalarField compliance(mesh_.nSlots(), Zero);
    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh_[f];
            const scalar wP = K_[f].wStiff;
            const scalar c =
                sqr(face.S*wP)/(diag[face.own] & squares(face.n))
              + sqr(face.S*(1 - wP))/(diag[face.nei] & squares(face.n));
            compliance[face.own] += c;
            compliance[face.nei] += c;
        }
    );

    tmp<scalarField> theld(new scalarField(n));
    scalarField& held = theld.ref();
    forAll(held, celli)
    {
        held[celli] = K_.eta(celli);
        if (compliance[celli] > 0)
        {
            held[celli] =
                max(held[celli], mesh_.V()[celli]/(3*compliance[celli]));
        }
    }
    return theld;
}


void Foam::partialOperators::addSliding
(
    const label cmpt,
    scalarField& diag
) const
{
    for (const label i : boundary_.slidingAt())
    {
        // In series with the material between cell and wall
        const label f = mesh_.nInternal() + i;
        const planarFace& face = mesh_[f];
        const scalar resistance = boundary_.sliding(i).change(0).resistance;
        diag[face.own] +=
            face.S*resistance*K_.wallGain(f, resistance)
           *(1 - sqr(face.n[cmpt]));
    }
}


void Foam::partialOperators::addRolling(scalarField& diag) const
{
    for (const label i : boundary_.rollingAt())
    {
        const label f = mesh_.nInternal() + i;
        const planarFace& face = mesh_[f];
        const scalar resistance = boundary_.rolling(i).change(0).resistance;
        if (K_.M(face.own) > 0)
        {
            diag[face.own] +=
                face.S*resistance*K_.rotationGain(f, resistance);
        }
    }
}


void Foam::partialOperators::addPressureForce
(
    const scalarField& p,
    operatorState& s,
    scalarField& r
) const
{
    SubList<scalar>(s.p, mesh_.nCells()) = p;
    mesh_.halo().swap(s.p);
    pressure_.calc(s, false);
    pressure_.add(s, all_, r);
}


void Foam::partialOperators::addRotationForce
(
    const scalarField& omega,
    operatorState& s,
    scalarField& r
) const
{
    SubList<scalar>(s.omega, mesh_.nCells()) = omega;
    mesh_.halo().swap(s.omega);

    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh_[f];
            const cosseratFace& K = K_.rotation(f);
            const vector2D F
            (
                (
                    (K.KwP + K.KsP)*s.omega[face.own]
                  + (K.KwN + K.KsN)*s.omega[face.nei]
                )*face.t()
            );
            all_.addForce(r, face.own, F);
            all_.addForce(r, face.nei, -F);
        }
    );
    for (const label f : mesh_.oneSided())
    {
        if (boundary_.velocity(mesh_.boundaryOf(f)) == flowBoundary::VELOCITY)
        {
            const planarFace& face = mesh_[f];
            const cosseratFace& K = K_.rotation(f);
            all_.addForce
            (
                r, face.own, (K.KwP + K.KsP)*s.omega[face.own]*face.t()
            );
        }
    }
}


// ************************************************************************* //
