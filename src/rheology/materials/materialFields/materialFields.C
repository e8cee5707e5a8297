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

#include "materialFields.H"
#include "checkedEntry.H"
#include "StringStream.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::materialFields::averageType>
Foam::materialFields::averageTypeNames
({
    { averageType::ARITHMETIC, "arithmetic" },
    { averageType::GEOMETRIC, "geometric" },
    { averageType::HARMONIC, "harmonic" },
    { averageType::LAYERED, "layered" }
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::PtrList<Foam::material> Foam::materialFields::readMaterials() const
{
    const dictionary& all = dict_.subDict("materials");
    PtrList<material> materials(all.size());
    label n = 0;

    for (const entry& e : all)
    {
        if (!e.isDict())
        {
            checkedEntry::refuse
            (
                all, e.keyword(), "no dictionary", "one dictionary a material"
            );
        }
        materials.set(n++, new material(e.keyword(), e.dict()));
    }

    if (n == 0)
    {
        checkedEntry::refuse
        (
            dict_, "materials", "empty", "one dictionary a material"
        );
    }

    return materials;
}


Foam::materialFields::averageType Foam::materialFields::readAverage
(
    const word& key,
    const averageType standard,
    const UList<averageType>& allowed
) const
{
    const word name
    (
        dict_.getOrDefault<word>(key, averageTypeNames[standard])
    );

    if
    (
        !averageTypeNames.found(name)
     || !allowed.found(averageTypeNames[name])
    )
    {
        wordList names;
        for (const averageType rule : allowed)
        {
            names.append(averageTypeNames[rule]);
        }
        OStringStream os;
        os  << flatOutput(names);
        checkedEntry::refuse(dict_, key, name, os.str());
    }

    return averageTypeNames[name];
}


Foam::volScalarField Foam::materialFields::newField
(
    const word& name,
    const dimensionedScalar& value
) const
{
    return volScalarField
    (
        IOobject
        (
            name,
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        ),
        mesh_,
        dimensionedScalar(name, value.dimensions(), value.value()),
        zeroGradientFvPatchScalarField::typeName
    );
}


void Foam::materialFields::average
(
    volScalarField& field,
    const scalarList& values,
    const averageType rule
) const
{
    scalarField& q = field.primitiveFieldRef();
    q = rule == averageType::GEOMETRIC ? 1 : 0;

    forAll(alphas_, m)
    {
        const scalarField& alpha = alphas_[m].primitiveField();
        const scalar value = values[m];

        switch (rule)
        {
            case averageType::ARITHMETIC:
            {
                q += alpha*value;
                break;
            }
            case averageType::GEOMETRIC:
            {
                q *= pow(scalarField(q.size(), value), alpha);
                break;
            }
            case averageType::LAYERED:
            {
                // layerMean()
                break;
            }
            case averageType::HARMONIC:
            {
                // A material without the property leaves none to the cell
                q += alpha/max(value, VSMALL);
                break;
            }
        }
    }

    if (rule == averageType::HARMONIC)
    {
        const scalar largest = max(values);
        forAll(q, celli)
        {
            q[celli] =
                largest > 0 && largest*q[celli] <= 1/SMALL ? 1/q[celli] : 0;
        }
    }

    field.correctBoundaryConditions();
}


Foam::tmp<Foam::scalarField> Foam::materialFields::layerMean
(
    const scalarList& values
) const
{
    tmp<scalarField> tmean(new scalarField(mesh_.nCells(), Zero));
    scalarField& mean = tmean.ref();
    scalarField compliance(mesh_.nCells(), Zero);

    forAll(alphas_, m)
    {
        const viscosityLaw& law = materials_[m].law();
        // Without bending viscosity etaC has no effect
        const scalar etaC = law.M().value() > 0 ? law.etaC().value() : 0;
        const scalarField share
        (
            alphas_[m].primitiveField()/(law.eta().value() + etaC)
        );
        compliance += share;
        mean += share*values[m];
    }
    mean /= compliance;

    return tmean;
}


void Foam::materialFields::checkFractions() const
{
    const scalarField& V = mesh_.V();
    scalarField sum(V.size(), Zero);

    for (const volScalarField& alpha : alphas_)
    {
        sum += alpha.primitiveField();
    }

    forAll(sum, celli)
    {
        if (mag(sum[celli] - 1) > 1e-6)
        {
            FatalErrorInFunction
                << "Material fractions of cell " << celli << " at "
                << mesh_.C()[celli] << " sum to " << sum[celli]
                << " instead of 1, time " << mesh_.time().timeName() << nl
                << "    Fractions are " << names() << " as fields alpha.<name>"
                << exit(FatalError);
        }
    }
}


bool Foam::materialFields::fractionsMoved() const
{
    scalar largest = averaged_.empty() ? GREAT : 0;

    forAll(averaged_, m)
    {
        const scalarField& alpha = alphas_[m].primitiveField();
        const scalarField& before = averaged_[m];
        forAll(alpha, celli)
        {
            largest = max(largest, mag(alpha[celli] - before[celli]));
        }
    }

    return returnReduce(largest, maxOp<scalar>()) > 1e-12;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materialFields::materialFields(const fvMesh& mesh)
:
    mesh_(mesh),
    dict_
    (
        IOobject
        (
            "materialProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    ),
    materials_(readMaterials()),
    parts_
    (
        materials_,
        mesh.solutionDict().subOrEmptyDict("creepingFlow")
    ),
    viscosityAverage_
    (
        readAverage
        (
            "viscosityAverage",
            averageType::LAYERED,
            List<averageType>
            ({
                averageType::ARITHMETIC, averageType::GEOMETRIC,
                averageType::HARMONIC, averageType::LAYERED
            })
        )
    ),
    densityAverage_
    (
        readAverage
        (
            "densityAverage",
            averageType::ARITHMETIC,
            List<averageType>
            ({
                averageType::ARITHMETIC, averageType::GEOMETRIC,
                averageType::HARMONIC
            })
        )
    ),
    alphas_(parts_.has(sceneParts::AVERAGES) ? materials_.size() : 0),
    rho_(newField("rho", materials_[0].rho())),
    eta_(newField("eta", materials_[0].law().eta())),
    etaC_(newField("etaC", materials_[0].law().etaC())),
    M_(newField("M", materials_[0].law().M())),
    invB_(newField("invB", materials_[0].law().invB())),
    fractionsRead_(true),
    nChanges_(1)
{
    checkedEntry::reportUnread
    (
        dict_, {"materials", "viscosityAverage", "densityAverage"}
    );

    forAll(alphas_, m)
    {
        IOobject io
        (
            IOobject::groupName("alpha", materials_[m].name()),
            mesh.time().timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        );

        fractionsRead_ =
            fractionsRead_ && io.typeHeaderOk<volScalarField>(true);

        alphas_.set
        (
            m,
            new volScalarField
            (
                io,
                mesh,
                dimensionedScalar(dimless, Zero),
                zeroGradientFvPatchScalarField::typeName
            )
        );
    }

    Info<< "Materials" << nl;
    for (const material& m : materials_)
    {
        m.print(Info);
    }
    if (alphas_.size())
    {
        Info<< "    viscosityAverage "
            << averageTypeNames[viscosityAverage_] << ", densityAverage "
            << averageTypeNames[densityAverage_] << nl;
    }
    Info<< endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::materialFields::names() const
{
    wordList names(materials_.size());
    forAll(materials_, m)
    {
        names[m] = materials_[m].name();
    }
    return names;
}


Foam::tmp<Foam::scalarField> Foam::materialFields::flowingDensity() const
{
    scalarList rho(materials_.size());
    forAll(materials_, m)
    {
        rho[m] = materials_[m].rho().value();
    }
    return layerMean(rho);
}


void Foam::materialFields::correct()
{
    if (alphas_.empty() || !fractionsMoved())
    {
        return;
    }

    checkFractions();
    ++nChanges_;
    averaged_.setSize(alphas_.size());
    forAll(alphas_, m)
    {
        averaged_.set(m, new scalarField(alphas_[m].primitiveField()));
    }

    const label n = materials_.size();
    scalarList rho(n), eta(n), etaC(n), M(n), invB(n);

    forAll(materials_, m)
    {
        const viscosityLaw& law = materials_[m].law();
        rho[m] = materials_[m].rho().value();
        eta[m] = law.eta().value();
        etaC[m] = law.etaC().value();
        M[m] = law.M().value();
        invB[m] = law.invB().value();
    }

    average(rho_, rho, densityAverage_);
    if (viscosityAverage_ == averageType::LAYERED)
    {
        eta_.primitiveFieldRef() = layerMean(eta);
        etaC_.primitiveFieldRef() = layerMean(etaC);
        eta_.correctBoundaryConditions();
        etaC_.correctBoundaryConditions();
        average(M_, M, averageType::HARMONIC);
    }
    else
    {
        average(eta_, eta, viscosityAverage_);
        average(etaC_, etaC, viscosityAverage_);
        average(M_, M, viscosityAverage_);
    }
    // Volume changes of the materials of a cell add up
    average(invB_, invB, averageType::ARITHMETIC);
}


// ************************************************************************* //
