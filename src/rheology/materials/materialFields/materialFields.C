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
#include "zeroGradientFvPatchFields.H"

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
                all, e.keyword(), "no dictionary", "one dictionary per material"
            );
        }
        materials.set(n++, new material(e.keyword(), e.dict()));
    }

    if (n == 0)
    {
        checkedEntry::refuse
        (
            dict_, "materials", "empty", "one dictionary per material"
        );
    }

    return materials;
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


template<class Get>
Foam::UPtrList<const Foam::materialProperty> Foam::materialFields::all
(
    const Get& get
) const
{
    UPtrList<const materialProperty> values(materials_.size());
    forAll(materials_, m)
    {
        values.set(m, &get(materials_[m]));
    }
    return values;
}


void Foam::materialFields::copy
(
    volScalarField& field,
    const materialProperty& value
) const
{
    forAll(field, celli)
    {
        field[celli] = value[celli];
    }
    field.correctBoundaryConditions();
}


void Foam::materialFields::takeCuts()
{
    if (!cutsHeld_)
    {
        cuts_.update(alphas_);
    }
    forAll(eta_, celli)
    {
        const cutCells::layers l(cuts_.at(celli));
        eta_[celli] = l.eta;
        etaC_[celli] = l.etaC;
        M_[celli] = l.M;
    }
    eta_.correctBoundaryConditions();
    etaC_.correctBoundaryConditions();
    M_.correctBoundaryConditions();
}


void Foam::materialFields::setProperties()
{
    if (alphas_.empty())
    {
        const viscosityLaw& law = materials_[0].law();
        copy(eta_, law.eta());
        copy(etaC_, law.etaC());
        copy(M_, law.M());
        copy(invB_, law.invB());
        return;
    }

    typedef const material& type;
    typedef const materialProperty& property;

    const auto rho = all([](type m) -> property { return m.rho(); });
    const auto eta = all([](type m) -> property { return m.law().eta(); });
    const auto etaC = all([](type m) -> property { return m.law().etaC(); });
    const auto M = all([](type m) -> property { return m.law().M(); });
    const auto invB = all([](type m) -> property { return m.law().invB(); });

    cellAverage::average(alphas_, rho_, rho, densityAverage_);
    if (layered())
    {
        takeCuts();
    }
    else
    {
        cellAverage::average(alphas_, eta_, eta, viscosityAverage_);
        cellAverage::average(alphas_, etaC_, etaC, viscosityAverage_);
        cellAverage::average(alphas_, M_, M, viscosityAverage_);
    }
    // Volume changes of the materials of a cell add up
    cellAverage::average
    (
        alphas_, invB_, invB, cellAverage::rule::ARITHMETIC
    );
}


void Foam::materialFields::readFractions()
{
    forAll(alphas_, m)
    {
        IOobject io
        (
            IOobject::groupName("alpha", materials_[m].name()),
            mesh_.time().timeName(),
            mesh_,
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
                mesh_,
                dimensionedScalar(dimless, Zero),
                zeroGradientFvPatchScalarField::typeName
            )
        );
    }
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
        cellAverage::read
        (
            dict_,
            "viscosityAverage",
            cellAverage::rule::LAYERED,
            List<cellAverage::rule>
            ({
                cellAverage::rule::ARITHMETIC,
                cellAverage::rule::GEOMETRIC,
                cellAverage::rule::HARMONIC,
                cellAverage::rule::LAYERED
            })
        )
    ),
    densityAverage_
    (
        cellAverage::read
        (
            dict_,
            "densityAverage",
            cellAverage::rule::ARITHMETIC,
            List<cellAverage::rule>
            ({
                cellAverage::rule::ARITHMETIC,
                cellAverage::rule::GEOMETRIC,
                cellAverage::rule::HARMONIC
            })
        )
    ),
    alphas_(parts_.has(sceneParts::AVERAGES) ? materials_.size() : 0),
    cuts_(materials_),
    cutsHeld_(false),
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

    readFractions();

    Info<< "Materials" << nl;
    for (const material& m : materials_)
    {
        m.print(Info);
    }
    if (alphas_.size())
    {
        Info<< "    viscosityAverage "
            << cellAverage::names[viscosityAverage_] << ", densityAverage "
            << cellAverage::names[densityAverage_] << nl;
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
    tmp<scalarField> trho(new scalarField(mesh_.nCells()));
    forAll(trho(), celli)
    {
        trho.ref()[celli] =
            cuts_.mixed(celli)
          ? rho_[celli] : materials_[cuts_.centre(celli)].rho()[celli];
    }
    return trho;
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

    setProperties();
}


bool Foam::materialFields::followsFlow() const
{
    for (const material& m : materials_)
    {
        if (m.law().followsFlow())
        {
            return true;
        }
    }
    return false;
}


void Foam::materialFields::relax(const scalar factor)
{
    for (material& m : materials_)
    {
        m.law().relax(factor);
    }
}


bool Foam::materialFields::regularised() const
{
    for (const material& m : materials_)
    {
        if (m.law().regularised())
        {
            return true;
        }
    }
    return false;
}


void Foam::materialFields::rest()
{
    for (material& m : materials_)
    {
        m.law().rest();
    }
    ++nChanges_;
    setProperties();
}


Foam::label Foam::materialFields::most(const label celli) const
{
    label most = 0;
    for (label m = 1; m < alphas_.size(); ++m)
    {
        most = alphas_[m][celli] > alphas_[most][celli] ? m : most;
    }
    return most;
}


Foam::label Foam::materialFields::leading
(
    const label celli,
    scalar& share
) const
{
    share = 1;
    if (layered() && !cuts_.mixed(celli))
    {
        return cuts_.centre(celli);
    }

    label leading = most(celli);
    scalar largest = 0, sum = 0;
    forAll(alphas_, m)
    {
        const scalar alpha = alphas_[m][celli];
        const scalar eta = materials_[m].law().eta()[celli];
        const scalar part =
            viscosityAverage_ == cellAverage::rule::GEOMETRIC ? alpha
          : viscosityAverage_ == cellAverage::rule::HARMONIC ? alpha/eta
          : alpha*eta;
        sum += part;
        if (part > largest && materials_[m].law().followsFlow())
        {
            largest = part;
            leading = m;
        }
    }
    if (largest > 0)
    {
        share = largest/sum;
    }
    return leading;
}


bool Foam::materialFields::pure(const label celli) const
{
    return
        alphas_.empty() || alphas_[most(celli)][celli] > 1 - 1e-9;
}


Foam::tmp<Foam::scalarField> Foam::materialFields::overRest() const
{
    tmp<scalarField> tratio(new scalarField(mesh_.nCells()));
    forAll(tratio(), celli)
    {
        const materialProperty& eta = law(most(celli)).eta();
        tratio.ref()[celli] = eta[celli]/eta.value();
    }
    return tratio;
}


void Foam::materialFields::correct(const flowState& flow)
{
    for (material& m : materials_)
    {
        m.law().correct(flow);
    }
    ++nChanges_;
    setProperties();
}


// ************************************************************************* //
