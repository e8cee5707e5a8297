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
#include "surfaceFields.H"
#include "processorFvPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::systemResults::share
(
    const planarFace& face,
    const scalar work,
    const scalar ownersShare,
    scalarField& power
) const
{
    power[face.own] += ownersShare*work;
    if (face.nei < mesh_.nCells())
    {
        power[face.nei] += work - ownersShare*work;
    }
}


Foam::scalar Foam::systemResults::wallPower() const
{
    scalar power = 0;

    for (const label f : mesh_.oneSided())
    {
        const label b = mesh_[f].nei;
        power += system_.viscous().onWall(s_, f, true) & s_.u[b];
        if (system_.cosserat())
        {
            power += system_.viscous().coupleOnWall(s_, f, true)*s_.omega[b];
        }
    }

    if (system_.corners().active())
    {
        system_.corners().addPower(s_.u, power);
    }

    return power;
}


Foam::scalar Foam::systemResults::frictionPower() const
{
    const flowBoundary& boundary = system_.boundary();
    scalar power = 0;

    for (const label i : boundary.slidingAt())
    {
        const label f = mesh_.nInternal() + i;
        const vector2D t(mesh_[f].t());
        power -=
            (system_.viscous().onWall(s_, f, true) & t)
           *((s_.u[mesh_[f].nei] & t) - boundary.sliding(i).wall());
    }
    for (const label i : boundary.rollingAt())
    {
        const label f = mesh_.nInternal() + i;
        power -=
            system_.viscous().coupleOnWall(s_, f, true)
           *(s_.omega[mesh_[f].nei] - boundary.rolling(i).wall());
    }

    return power;
}


Foam::scalar Foam::systemResults::openingPower() const
{
    const scalarField& jump = system_.boundary().jump();
    scalar power = 0;

    for (const label f : mesh_.oneSided())
    {
        if (s_.flux[f] != 0)
        {
            const label slot = mesh_[f].nei;
            power -=
                s_.flux[f]*(boundaryPressure(slot) + boundaryRhoGh(slot));
        }
    }
    forAll(jump, i)
    {
        // Seen from both sides
        power += 0.5*s_.flux[mesh_.nInternal() + i]*jump[i];
    }

    return power;
}


Foam::scalar Foam::systemResults::drivingPower
(
    const label celli,
    const vector& b
) const
{
    // Gravity changes with the stabilisation of free surfaces
    vector force(b);
    if (system_.stabilisation().active())
    {
        force +=
            system_.loads().gravity()
           *system_.stabilisation().change(celli, s_.u[celli]);
    }
    return s_.u[celli] & mesh_.frame().inPlane(force);
}


Foam::scalar Foam::systemResults::evenWeight() const
{
    const scalar lightest = system_.loads().lightest();
    if (lightest == 0 || system_.compliance() > 0)
    {
        return 0;
    }

    const vector& g = system_.loads().gradientGravity();
    const vector2D down(mesh_.frame().inPlane(g));

    scalar work = 0;
    forAll(mesh_.V(), celli)
    {
        work += mesh_.V()[celli]*(s_.u[celli] & down);
    }

    const fvMesh& mesh = mesh_.mesh();
    for (const label patchi : mesh_.halo().patches())
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (isA<processorFvPatch>(patch))
        {
            continue;
        }
        const vectorField& Cf = patch.Cf();
        const label start = mesh_.faceOf(mesh_.halo().start(patchi));
        forAll(Cf, i)
        {
            work -= s_.flux[start + i]*(Cf[i] & g);
        }
    }
    return lightest*work;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::systemResults::getFluxes(surfaceScalarField& phi) const
{
    phi.primitiveFieldRef() = SubList<scalar>(s_.flux, mesh_.nInternal());

    for (const label patchi : mesh_.halo().patches())
    {
        scalarField& phip = phi.boundaryFieldRef()[patchi];
        const label start = mesh_.faceOf(mesh_.halo().start(patchi));
        forAll(phip, i)
        {
            phip[i] = s_.flux[start + i];
        }
    }
}


Foam::tmp<Foam::volTensorField> Foam::systemResults::gradU() const
{
    const fvMesh& mesh = mesh_.mesh();
    tmp<volTensorField> tgrad
    (
        new volTensorField
        (
            IOobject("gradU", mesh.time().timeName(), mesh),
            mesh,
            dimensionedTensor(dimless/dimTime, Zero),
            "zeroGradient"
        )
    );
    volTensorField& grad = tgrad.ref();

    forAll(grad, celli)
    {
        grad[celli] = mesh_.frame().inSpace(s_.G[celli]);
        if (mesh_.axial().active())
        {
            const vector e(mesh_.frame().e());
            grad[celli] += (e*e)
               *(s_.u[celli] & mesh_.radial())/mesh_.radius(celli);
        }
    }
    grad.correctBoundaryConditions();

    return tgrad;
}


Foam::tmp<Foam::vectorField> Foam::systemResults::gradOmega() const
{
    tmp<vectorField> tgrad(new vectorField(mesh_.nCells(), Zero));
    if (s_.gradOmega.size())
    {
        forAll(tgrad(), celli)
        {
            tgrad.ref()[celli] = mesh_.frame().inSpace(s_.gradOmega[celli]);
        }
    }
    return tgrad;
}


Foam::vector Foam::systemResults::boundaryVelocity(const label slot) const
{
    return mesh_.frame().inSpace(s_.u[slot]);
}


Foam::tmp<Foam::scalarField> Foam::systemResults::dissipated() const
{
    const viscousCoefficients& K = system_.coefficients();
    tmp<scalarField> tpower(new scalarField(mesh_.nCells(), Zero));
    scalarField& power = tpower.ref();

    mesh_.forTwoSided
    (
        [&](const label f)
        {
            // Of two layers each does what its compliance is of theirs
            const planarFace& face = mesh_[f];
            const vector2D d(s_.u[face.nei] - s_.u[face.own]);
            share
            (
                face, system_.viscous().onFace(s_, f) & d,
                ownersShare(face, K.side(f, 0).a, K.side(f, 1).a), power
            );
        }
    );
    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        power[face.own] +=
            system_.viscous().onWall(s_, f, true)
          & (s_.u[face.nei] - s_.u[face.own]);
    }

    if (system_.corners().active())
    {
        system_.corners().addDissipated(s_.u, power);
    }
    for (label celli = 0; system_.cosserat() && celli < power.size(); ++celli)
    {
        power[celli] += 4*mesh_.V()[celli]*K.etaC(celli)
           *s_.relativeRotation(celli)*s_.omega[celli];
    }
    if (system_.hoop().active())
    {
        forAll(power, celli)
        {
            power[celli] -= system_.hoop().force(s_, celli)
               *(s_.u[celli] & mesh_.radial());
        }
    }

    return tpower;
}


Foam::tmp<Foam::scalarField> Foam::systemResults::bent() const
{
    const viscousCoefficients& K = system_.coefficients();
    tmp<scalarField> tpower(new scalarField(mesh_.nCells(), Zero));
    scalarField& power = tpower.ref();

    if (!system_.cosserat())
    {
        return tpower;
    }

    mesh_.forTwoSided
    (
        [&](const label f)
        {
            if (K.rotation(f).Km > 0)
            {
                const planarFace& face = mesh_[f];
                const scalar d = s_.omega[face.nei] - s_.omega[face.own];
                share
                (
                    face, system_.viscous().coupleOnFace(s_, f)*d,
                    ownersShare(face, K.side(f, 0).M, K.side(f, 1).M), power
                );
            }
        }
    );
    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        power[face.own] +=
            system_.viscous().coupleOnWall(s_, f, true)
           *(s_.omega[face.nei] - s_.omega[face.own]);
    }
    if (system_.hoop().active())
    {
        forAll(power, celli)
        {
            power[celli] -=
                system_.hoop().couple(s_, celli)*s_.omega[celli];
        }
    }

    return tpower;
}


Foam::powerTerms Foam::systemResults::power() const
{
    // What walls supply is what their own motion does
    const scalar openings = openingPower(), friction = frictionPower();
    powerTerms sum
    {
        0, wallPower() + openings + friction, Foam::sum(dissipated()()),
        Foam::sum(bent()()), friction, -openings
    };

    // What the force of the residual does beyond gravity and body force is the
    // work of the discrete pressure
    const vectorField b(system_.loads().bodyForce());
    scalarField r(system_.size(), Zero);
    system_.pressure().add(s_, system_.layout(), r);

    forAll(b, celli)
    {
        const scalar V = mesh_.V()[celli];
        const scalar driving = V*drivingPower(celli, b[celli]);
        sum.gravity += driving;
        sum.pressure +=
            (s_.u[celli] & system_.layout().u(r, celli)) - driving;

        if (system_.cosserat() && system_.loads().couple())
        {
            sum.gravity += V*s_.omega[celli]
               *system_.loads().couple()->primitiveField()[celli];
        }
    }

    const scalar even = evenWeight();
    sum.gravity -= even;
    sum.pressure += even;

    for
    (
        scalar* term :
        {
            &sum.gravity, &sum.walls, &sum.viscous, &sum.bending,
            &sum.friction, &sum.pressure
        }
    )
    {
        reduce(*term, sumOp<scalar>());
        if (mesh_.axial().active())
        {
            *term *= mesh_.axial().toCircle();
        }
    }

    return sum;
}


// ************************************************************************* //
