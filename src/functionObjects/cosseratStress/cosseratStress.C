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

#include "cosseratStress.H"
#include "creepingFlow.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(cosseratStress, 0);
    addToRunTimeSelectionTable(functionObject, cosseratStress, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class FieldType>
void Foam::functionObjects::cosseratStress::keep(const tmp<FieldType>& tfield)
{
    const word name(tfield().name());
    fields_.insert(name);

    if (mesh_.foundObject<FieldType>(name))
    {
        mesh_.lookupObjectRef<FieldType>(name) = tfield;
    }
    else
    {
        regIOobject::store
        (
            new FieldType(IOobject(name, time_.timeName(), mesh_), tfield)
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::cosseratStress::cosseratStress
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::cosseratStress::execute()
{
    const creepingFlow& flow = creepingFlow::find(mesh_);

    keep(flow.stress());
    keep(flow.coupleStress());
    keep(flow.dissipation());

    return true;
}


bool Foam::functionObjects::cosseratStress::write()
{
    for (const word& field : fields_)
    {
        writeObject(field);
    }

    return true;
}


// ************************************************************************* //
