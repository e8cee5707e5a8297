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

#include "yieldState.H"
#include "creepingFlow.H"
#include "addToRunTimeSelectionTable.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Pressure over tau below which friction means nothing
static const Foam::scalar leastShare = 1e-6;


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(yieldState, 0);
    addToRunTimeSelectionTable(functionObject, yieldState, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::volScalarField Foam::functionObjects::yieldState::newField
(
    const word& name,
    const dimensionSet& dims
) const
{
    return volScalarField
    (
        IOobject(name, time_.timeName(), mesh_),
        mesh_,
        dimensionedScalar(dims, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
}


void Foam::functionObjects::yieldState::set
(
    const flowState& flow,
    const materialFields& materials,
    const label m
)
{
    const viscosityLaw& law = materials.law(m);
    const scalarField strength(law.strength(flow));

    forAll(gamma_, celli)
    {
        if (materials.most(celli) != m)
        {
            continue;
        }
        const scalar rate = law.shearRate(flow, celli);
        const scalar tau = law.eta()[celli]*rate;
        const scalar tauY = strength[celli], p = flow.p[celli];
        gamma_[celli] = rate;
        tau_[celli] = tau;
        yieldRatio_[celli] = tauY > 0 ? tau/tauY : 0;
        mobilisedFriction_[celli] = p > leastShare*tau ? tau/p : 0;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::yieldState::yieldState
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    gamma_(newField("Gamma", dimless/dimTime)),
    tau_(newField("tau", dimPressure)),
    yieldRatio_(newField("yieldRatio", dimless)),
    mobilisedFriction_(newField("mobilisedFriction", dimless))
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::yieldState::execute()
{
    const creepingFlow& flow = creepingFlow::find(mesh_);
    const materialFields& materials = flow.materials();

    flow.show
    (
        [&](const flowState& state)
        {
            for (label m = 0; m < materials.size(); ++m)
            {
                set(state, materials, m);
            }
        }
    );
    for
    (
        volScalarField* field
      : {&gamma_, &tau_, &yieldRatio_, &mobilisedFriction_}
    )
    {
        field->correctBoundaryConditions();
    }

    return true;
}


bool Foam::functionObjects::yieldState::write()
{
    gamma_.write();
    tau_.write();
    yieldRatio_.write();
    mobilisedFriction_.write();

    return true;
}


// ************************************************************************* //
