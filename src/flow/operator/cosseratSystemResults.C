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
#include "surfaceFields.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cosseratSystem::getFluxes(surfaceScalarField& phi) const
{
    phi.primitiveFieldRef() = SubList<scalar>(phi_, nInternal_);

    forAll(phi.boundaryField(), patchi)
    {
        scalarField& phip = phi.boundaryFieldRef()[patchi];
        const label start = nInternal_ + halo_.start(patchi) - nCells_;
        forAll(phip, i)
        {
            phip[i] = phi_[start + i];
        }
    }
}


Foam::tmp<Foam::volTensorField> Foam::cosseratSystem::gradU() const
{
    tmp<volTensorField> tgrad
    (
        new volTensorField
        (
            IOobject("gradU", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedTensor(dimless/dimTime, Zero),
            "zeroGradient"
        )
    );
    volTensorField& grad = tgrad.ref();
    const label i0 = frame_.i0(), i1 = frame_.i1();

    forAll(grad, celli)
    {
        tensor& G = grad[celli];
        G[3*i0 + i0] = G00_[celli];
        G[3*i0 + i1] = G01_[celli];
        G[3*i1 + i0] = G10_[celli];
        G[3*i1 + i1] = G11_[celli];
    }
    grad.correctBoundaryConditions();

    return tgrad;
}


Foam::vector Foam::cosseratSystem::boundaryVelocity(const label slot) const
{
    return frame_.inSpace(u0_[slot], u1_[slot]);
}


Foam::scalar Foam::cosseratSystem::boundaryPressure(const label slot) const
{
    const label f = nInternal_ + slot - nCells_;
    const label P = own_[f];

    return
        boundary_.pressureFixed(slot - nCells_)
      ? givenPressure(slot - nCells_)
      : p_[P] - (f0_[P]*m0_[f] + f1_[P]*m1_[f])/dc_[f];
}


Foam::scalar Foam::cosseratSystem::boundaryRhoGh(const label slot) const
{
    const label f = nInternal_ + slot - nCells_;
    const label P = own_[f];
    const vector way(frame_.inSpace(m0_[f], m1_[f])/dc_[f]);

    return
        rhoGh_[P]
      + rho_[P]*(gradientGravity_ & way);
}


Foam::tmp<Foam::scalarField> Foam::cosseratSystem::dissipated() const
{
    tmp<scalarField> tpower(new scalarField(nCells_, Zero));
    scalarField& power = tpower.ref();

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label P = own_[f], N = nei_[f];
            scalar d0, d1, F0, F1;
            difference(f, d0, d1);
            viscousForce(f, d0, d1, F0, F1);

            // Of two layers each does what its compliance is of theirs
            const scalar cP = lambda_[f]/a_[P], cN = (1 - lambda_[f])/a_[N];
            const scalar work =
                F0*(u0_[N] - u0_[P]) + F1*(u1_[N] - u1_[P]);
            power[P] += work*cP/(cP + cN);
            if (N < nCells_)
            {
                power[N] += work*cN/(cP + cN);
            }
        }
    }

    for (const label f : oneSided_)
    {
        const label P = own_[f], b = nei_[f];
        scalar F0, F1;
        wallForce(f, true, F0, F1);
        power[P] += F0*(u0_[b] - u0_[P]) + F1*(u1_[b] - u1_[P]);
    }

    if (corners_.active())
    {
        corners_.addDissipated(u0_, u1_, power);
    }

    if (cosserat_)
    {
        for (label celli = 0; celli < nCells_; ++celli)
        {
            power[celli] += 4*V_[celli]*etaC_[celli]
               *relativeRotation(celli)*omega_[celli];
        }
    }

    return tpower;
}


Foam::tmp<Foam::scalarField> Foam::cosseratSystem::bent() const
{
    tmp<scalarField> tpower(new scalarField(nCells_, Zero));
    scalarField& power = tpower.ref();

    if (!cosserat_)
    {
        return tpower;
    }

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            if (Km_[f] > 0)
            {
                const label P = own_[f], N = nei_[f];
                const scalar cP = lambda_[f]/M_[P], cN = (1 - lambda_[f])/M_[N];
                const scalar work = faceCouple(f)*(omega_[N] - omega_[P]);
                power[P] += work*cP/(cP + cN);
                if (N < nCells_)
                {
                    power[N] += work*cN/(cP + cN);
                }
            }
        }
    }

    for (const label f : oneSided_)
    {
        power[own_[f]] +=
            wallCouple(f, true)*(omega_[nei_[f]] - omega_[own_[f]]);
    }

    return tpower;
}


Foam::scalar Foam::cosseratSystem::wallPower() const
{
    scalar power = 0;

    for (const label f : oneSided_)
    {
        const label b = nei_[f];
        scalar F0, F1;
        wallForce(f, true, F0, F1);
        power += F0*u0_[b] + F1*u1_[b];

        if (cosserat_)
        {
            power += wallCouple(f, true)*omega_[b];
        }
    }

    if (corners_.active())
    {
        corners_.addPower(u0_, u1_, power);
    }

    return power;
}


Foam::scalar Foam::cosseratSystem::openingPower() const
{
    scalar power = 0;

    for (const label f : oneSided_)
    {
        if (phi_[f] != 0)
        {
            const label slot = f - nInternal_ + nCells_;
            power -= phi_[f]*(boundaryPressure(slot) + boundaryRhoGh(slot));
        }
    }
    forAll(boundary_.jump(), i)
    {
        // Seen from both sides
        power += 0.5*phi_[nInternal_ + i]*boundary_.jump()[i];
    }

    return power;
}


Foam::cosseratSystem::powerTerms Foam::cosseratSystem::power
(
    const scalarField& x
) const
{
    scalarField r;
    residual(x, r);

    const scalar openings = openingPower();
    powerTerms sum
    {
        0, wallPower() + openings, Foam::sum(dissipated()()),
        Foam::sum(bent()()), -openings
    };

    // What the force of the residual does beyond gravity (with its change by
    // the stabilisation of free surfaces) and body force is the work of the
    // discrete pressure
    vectorField b(bodyForce());
    if (stabilisation_.active())
    {
        forAll(b, celli)
        {
            b[celli] += gravity()
               *stabilisation_.change(celli, u0_[celli], u1_[celli]);
        }
    }
    r = 0;
    addForce(r);

    for (label celli = 0; celli < nCells_; ++celli)
    {
        const scalar weight = V_[celli]*
        (
            u0_[celli]*b[celli][frame_.i0()]
          + u1_[celli]*b[celli][frame_.i1()]
        );

        if (cosserat_ && load_.couple())
        {
            sum.gravity += V_[celli]*omega_[celli]
               *load_.couple()->primitiveField()[celli];
        }

        sum.gravity += weight;
        sum.pressure +=
            u0_[celli]*r[celli] + u1_[celli]*r[nCells_ + celli] - weight;
    }

    for
    (
        scalar* term :
        {&sum.gravity, &sum.walls, &sum.viscous, &sum.bending, &sum.pressure}
    )
    {
        reduce(*term, sumOp<scalar>());
    }

    return sum;
}


void Foam::cosseratSystem::netForce
(
    const vector& direction,
    scalar& net,
    scalar& magnitude
) const
{
    net = magnitude = 0;

    auto add = [&](const scalar force)
    {
        net += force;
        magnitude += mag(force);
    };

    for (const label f : oneSided_)
    {
        const label i = f - nInternal_;
        const vector n(frame_.inSpace(n0_[f], n1_[f]));
        add(boundary_.traction(i)*S_[f]*((n ^ frame_.e()) & direction));
        if (boundary_.pressureFixed(i))
        {
            const scalar p = givenPressure(i) + boundaryRhoGh(nei_[f]);
            add(-p*S_[f]*(n & direction));
        }
    }
    forAll(boundary_.jump(), i)
    {
        // A cyclic face is seen from both sides
        const label f = nInternal_ + i;
        const vector n(frame_.inSpace(n0_[f], n1_[f]));
        add(0.5*boundary_.jump()[i]*S_[f]*(n & direction));
    }

    const vectorField b(bodyForce());
    forAll(b, celli)
    {
        add(V_[celli]*(b[celli] & direction));
    }

    reduce(net, sumOp<scalar>());
    reduce(magnitude, sumOp<scalar>());
}


void Foam::cosseratSystem::netInflow(scalar& net, scalar& magnitude) const
{
    net = magnitude = 0;

    for (const label f : oneSided_)
    {
        const label i = f - nInternal_;
        if (boundary_.velocity(i) == flowBoundary::VELOCITY)
        {
            const scalar u0 = boundary_.u0(i), u1 = boundary_.u1(i);
            net -= S_[f]*(u0*n0_[f] + u1*n1_[f]);
            magnitude += S_[f]*Foam::sqrt(sqr(u0) + sqr(u1));
        }
    }

    reduce(net, sumOp<scalar>());
    reduce(magnitude, sumOp<scalar>());
}


// ************************************************************************* //
