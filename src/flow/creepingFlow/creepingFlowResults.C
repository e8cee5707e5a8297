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

#include "creepingFlow.H"
#include "zeroGradientFvPatchFields.H"
#include "fvcGrad.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::creepingFlow::tellFunctionObjects() const
{
    const word solver("FGMRES");
    const flexibleGMRES::performance& did = performance_;

    auto scalars = [&](const word& name, const label i)
    {
        solverData(mesh_).setSolverPerformance
        (
            name,
            SolverPerformance<scalar>
            (
                solver, name, did.initial[i], did.final[i],
                did.iterations, did.converged, false
            )
        );
    };

    // One residual of all components
    solverData(mesh_).setSolverPerformance
    (
        fields_.U().name(),
        SolverPerformance<vector>
        (
            solver, fields_.U().name(), vector::uniform(did.initial[0]),
            vector::uniform(did.final[0]),
            Vector<label>::uniform(did.iterations), did.converged, false
        )
    );
    scalars(fields_.pRgh().name(), 1);
    if (system_.cosserat())
    {
        scalars(fields_.omega().name(), 2);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::creepingFlow::show
(
    const std::function<void(const flowState&)>& use
) const
{
    const tmp<volTensorField> tgradU(gradU());
    const tmp<vectorField> tgradOmega(results().gradOmega());

    use
    (
        flowState
        {
            mesh_, frame_.e(), tgradU().primitiveField(),
            fields_.p().primitiveField(), fields_.omega().primitiveField(),
            tgradOmega(), nullptr
        }
    );
}


Foam::tmp<Foam::volTensorField> Foam::creepingFlow::stress() const
{
    // e_kij of gamma_ij = u_i,j + e_kij omega_k                             [5]
    const tensor permutation(-(*frame_.e()));

    const volTensorField gamma(gradU()().T() + fields_.omega()*permutation);

    tmp<volTensorField> tsigma
    (
        volTensorField::New
        (
            "sigma",
            (materials_.eta() + materials_.etaC())*gamma
          + (materials_.eta() - materials_.etaC())*gamma.T()
          - fields_.p()*tensor::I
        )
    );

    if (materials_.parts().has(sceneParts::COMPRESSIBILITY))
    {
        tsigma.ref() -= materials_.eta()*tr(gamma)*tensor::I;
    }

    return tsigma;
}


Foam::tmp<Foam::volVectorField> Foam::creepingFlow::coupleStress() const
{
    return volVectorField::New
    (
        "coupleStress",
        materials_.M()*fvc::grad(fields_.omega(), "linear")
    );
}


Foam::tmp<Foam::volScalarField> Foam::creepingFlow::dissipation() const
{
    tmp<volScalarField> tdissipation
    (
        volScalarField::New
        (
            "dissipation",
            mesh_,
            dimensionedScalar(dimPower/dimVolume, Zero),
            zeroGradientFvPatchScalarField::typeName
        )
    );
    scalarField& power = tdissipation.ref().primitiveFieldRef();
    power = (results().dissipated() + results().bent())/mesh_.V();

    if (materials_.parts().has(sceneParts::COMPRESSIBILITY))
    {
        // B tr(D)^2, with B tr(D) = -p; the rest is in the viscous force
        power -= fields_.p().primitiveField()*tr(gradU()().primitiveField());
    }
    tdissipation.ref().correctBoundaryConditions();

    return tdissipation;
}


Foam::tmp<Foam::volScalarField> Foam::creepingFlow::gradientDissipation() const
{
    const tmp<volTensorField> tgrad(gradU());
    const volSymmTensorField D(symm(tgrad()));
    const volScalarField s(fields_.omega() - (frame_.e() & (*skew(tgrad()))));

    tmp<volScalarField> tdissipation
    (
        volScalarField::New
        (
            "gradientDissipation",
            2*materials_.eta()*(D && D)
          + 4*materials_.etaC()*sqr(s)
          + materials_.M()*magSqr(fvc::grad(fields_.omega(), "linear"))
        )
    );

    const faceGeometry& mesh = system_.faces();
    if (mesh.axial().active())
    {
        scalarField& power = tdissipation.ref().primitiveFieldRef();
        forAll(power, celli)
        {
            power[celli] += materials_.M()[celli]
               *sqr(fields_.omega()[celli]/mesh.radius(celli));
        }
    }

    if (materials_.parts().has(sceneParts::COMPRESSIBILITY))
    {
        // (B - eta) tr(D)^2, with B tr(D) = -p
        tdissipation.ref() -=
            (fields_.p() + materials_.eta()*tr(D))*tr(D);
    }

    return tdissipation;
}


// ************************************************************************* //
