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
void Foam::functionObjects::errorIndicator::keep(const tmp<FieldType>& tfield)
{
    word name(tfield().name());
    fields_.append(name);
    store(name, tfield);
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
    if (!indicator_)
    {
        indicator_.reset(new strainIndicator(flow.materials()));
    }

    auto tfield = tmp<volScalarField>::New
    (
        IOobject(typeName, time_.timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimPower, Zero),
        "zeroGradient"
    );
    tmp<volTensorField> tgradU(flow.gradU());
    tmp<volVectorField> tgradOmega(indicator_->gradOmega());
    tfield.ref().primitiveFieldRef() =
        indicator_->power(tgradU(), tgradOmega());
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
