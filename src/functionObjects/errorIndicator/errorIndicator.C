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

#include "errorIndicator.H"
#include "creepingFlow.H"
#include "planarCells.H"
#include "planarFit.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(errorIndicator, 0);
    addToRunTimeSelectionTable(functionObject, errorIndicator, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class FieldType>
Foam::tmp<FieldType> Foam::functionObjects::errorIndicator::newField
(
    const word& name,
    const dimensionSet& dims
) const
{
    typedef typename FieldType::value_type Type;

    return tmp<FieldType>::New
    (
        IOobject(name, time_.timeName(), mesh_),
        mesh_,
        dimensioned<Type>(dims, Zero),
        "zeroGradient"
    );
}


template<class FieldType>
void Foam::functionObjects::errorIndicator::keep(const tmp<FieldType>& tfield)
{
    word name(tfield().name());
    fields_.append(name);
    store(name, tfield);
}


Foam::boolList Foam::functionObjects::errorIndicator::rotates
(
    const creepingFlow& flow
) const
{
    const scalarField etaC(links_.values(flow.materials().etaC()));
    const scalarField M(links_.values(flow.materials().M()));

    boolList rotates(M.size());
    forAll(rotates, i)
    {
        rotates[i] = etaC[i] > 0 && M[i] > 0;
    }
    return rotates;
}


Foam::boolList Foam::functionObjects::errorIndicator::mixed
(
    const creepingFlow& flow
) const
{
    boolList mixed(mesh_.nCells(), false);
    if (!flow.materials().parts().has(sceneParts::AVERAGES))
    {
        return mixed;
    }

    // A fraction of which neither the solution nor its error takes notice
    const scalar none = 1e-3;

    for (const word& name : flow.materials().names())
    {
        const auto& alpha = lookupObject<volScalarField>
        (
            IOobject::groupName("alpha", name)
        );
        forAll(mixed, celli)
        {
            mixed[celli] =
                mixed[celli] || (alpha[celli] > none && alpha[celli] < 1 - none);
        }
    }
    return mixed;
}


Foam::tmp<Foam::volVectorField>
Foam::functionObjects::errorIndicator::gradOmega
(
    const creepingFlow& flow
) const
{
    const scalarField omega
    (
        links_.values(lookupObject<volScalarField>("omega"))
    );
    const scalarField M(links_.values(flow.materials().M()));

    planarFit<1> fit(mesh_.nCells(), frame_.e());
    for (const cellLinks::link& link : links_.links())
    {
        const label P = link.celli, N = link.behind;
        const scalar share =
            link.boundary ? 1 : 2*M[N]/max(M[P] + M[N], VSMALL);
        fit.add(P, link.way, {share*(omega[N] - omega[P])});
    }

    auto tgrad = newField<volVectorField>
    (
        "gradOmega",
        dimless/dimTime/dimLength
    );
    forAll(mesh_.C(), celli)
    {
        tgrad.ref()[celli] = fit.at(celli).slope[0];
    }
    tgrad.ref().correctBoundaryConditions();
    return tgrad;
}


Foam::List<Foam::functionObjects::errorIndicator::strain>
Foam::functionObjects::errorIndicator::strains
(
    const volTensorField& gradU,
    const volVectorField& gradOmega
) const
{
    const tensorField G(links_.values(gradU));
    const scalarField omega
    (
        links_.values(lookupObject<volScalarField>("omega"))
    );
    const vectorField k(links_.values(gradOmega));

    List<strain> strains(G.size());
    forAll(strains, i)
    {
        const auto g = [&](const int j, const int l)
        {
            return frame_.component(G[i], j, l);
        };
        strains[i] = strain
        {
            g(0, 0) - g(1, 1),
            0.5*(g(0, 1) + g(1, 0)),
            g(0, 0) + g(1, 1),
            omega[i] - 0.5*(g(0, 1) - g(1, 0)),
            k[i][frame_.i0()],
            k[i][frame_.i1()]
        };
    }
    return strains;
}


Foam::functionObjects::errorIndicator::strain
Foam::functionObjects::errorIndicator::viscosities
(
    const creepingFlow& flow,
    const label celli
) const
{
    const materialFields& m = flow.materials();
    const scalar
        eta = m.eta()[celli], etaC = m.etaC()[celli], M = m.M()[celli],
        invB = m.invB()[celli];

    return strain{eta, 4*eta, invB > 0 ? 1/invB : 0, 4*etaC, M, M};
}


Foam::tmp<Foam::symmTensorField>
Foam::functionObjects::errorIndicator::moments() const
{
    auto tmoments = tmp<symmTensorField>::New(mesh_.nCells(), Zero);
    const planarCells cells(mesh_);
    const vector e(frame_.e());

    forAll(mesh_.C(), celli)
    {
        vectorField r(cells.corners(celli) - mesh_.C()[celli]);
        r -= (r & e)*e;

        symmTensor sum(Zero);
        scalar area = 0;
        forAll(r, i)
        {
            // The triangle of the centre and an edge
            const vector &a = r[i], &b = r[r.fcIndex(i)];
            const scalar A = 0.5*mag(a ^ b);
            sum += A/12*(sqr(a) + sqr(b) + sqr(a + b));
            area += A;
        }
        tmoments.ref()[celli] = sum/area;
    }
    return tmoments;
}


Foam::tmp<Foam::scalarField>
Foam::functionObjects::errorIndicator::indicator
(
    const creepingFlow& flow,
    const List<strain>& e
) const
{
    const boolList free(rotates(flow)), both(mixed(flow));
    const scalarField a
    (
        links_.values((flow.materials().eta() + flow.materials().etaC())())
    );

    planarFit<6> fit(mesh_.nCells(), frame_.e(), 2);
    for (const cellLinks::link& link : links_.links())
    {
        const label P = link.celli, N = link.behind;
        const bool jump =
            max(a[P], a[N]) > 2*min(a[P], a[N]) || free[P] != free[N];

        if (!link.boundary && (both[P] || !jump))
        {
            strain delta;
            forAll(delta, k)
            {
                delta[k] = k < 3 || (free[P] && free[N]) ? e[N][k] - e[P][k] : 0;
            }
            fit.add(P, link.way, delta);
        }
    }

    const symmTensorField rr(moments());
    auto tpower = tmp<scalarField>::New(mesh_.nCells(), Zero);
    forAll(rr, celli)
    {
        const planarFit<6>::linear error(fit.at(celli));
        const strain viscosity(viscosities(flow, celli));
        forAll(viscosity, k)
        {
            tpower.ref()[celli] +=
                mesh_.V()[celli]*viscosity[k]
               *(
                    sqr(error.value[k])
                  + (error.slope[k] & rr[celli] & error.slope[k])
                );
        }
    }
    return tpower;
}


Foam::scalar Foam::functionObjects::errorIndicator::worstShare
(
    const scalarField& terms
)
{
    const scalar wanted = 0.1*returnReduce(terms.size(), sumOp<label>());

    // Between limits below and above that of the tenth
    scalar low = 0, high = gMax(terms);
    for (label i = 0; i < 60 && high > 0; ++i)
    {
        const scalar limit = 0.5*(low + high);
        label n = 0;
        for (const scalar term : terms)
        {
            n += term > limit;
        }
        (returnReduce(n, sumOp<label>()) > wanted ? low : high) = limit;
    }

    scalar sum = 0;
    label n = 0;
    for (const scalar term : terms)
    {
        if (term > high)
        {
            sum += term;
            ++n;
        }
    }
    reduce(sum, sumOp<scalar>());
    reduce(n, sumOp<label>());

    // Those at the limit are alike, or the rest of a tenth that is no integer
    return (sum + (wanted - n)*high)/max(gSum(terms), VSMALL);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::errorIndicator::errorIndicator
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName, dict),
    frame_(mesh_),
    links_(mesh_, frame_),
    gradients_(false)
{
    read(dict);

    if (Pstream::master())
    {
        writeHeader(file(), "Indicator of the error of the strains");
        writeCommented(file(), "Time [s]");
        for
        (
            const char* column :
            {
                "indicator [W]", "dissipated [W]", "relative error of strains",
                "share of the worst tenth"
            }
        )
        {
            writeTabbed(file(), column);
        }
        file() << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::errorIndicator::read(const dictionary& dict)
{
    gradients_ = dict.getOrDefault<Switch>("gradients", false);

    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


bool Foam::functionObjects::errorIndicator::execute()
{
    const creepingFlow& flow = creepingFlow::find(mesh_);

    auto tfield = newField<volScalarField>(typeName, dimPower);
    tmp<volTensorField> tgradU(flow.gradU());
    tmp<volVectorField> tgradOmega(gradOmega(flow));
    tfield.ref().primitiveFieldRef() =
        indicator(flow, strains(tgradU(), tgradOmega()));
    tfield.ref().correctBoundaryConditions();

    const scalar sum = gSum(tfield().primitiveField());
    const powerTerms power(flow.power());
    const scalar dissipated = power.viscous + power.bending;
    const scalar relative = Foam::sqrt(sum/max(dissipated, VSMALL));
    const scalar share = worstShare(tfield().primitiveField());

    fields_.clear();
    keep(tfield);
    if (gradients_)
    {
        keep(tgradU);
        keep(tgradOmega);
    }

    if (Pstream::master())
    {
        writeCurrentTime(file());
        for (const scalar value : {sum, dissipated, relative, share})
        {
            file() << token::TAB << value;
        }
        file() << endl;
    }

    Log << type() << ' ' << name() << ": relative error of strains "
        << relative << ", " << 100*share << " % of its square in the worst"
        << " tenth of cells" << endl;

    return true;
}


bool Foam::functionObjects::errorIndicator::write()
{
    for (const word& field : fields_)
    {
        writeObject(field);
    }
    return true;
}


// ************************************************************************* //
