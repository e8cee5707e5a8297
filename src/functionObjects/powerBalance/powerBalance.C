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

#include "powerBalance.H"
#include "axialSymmetry.H"
#include "creepingFlow.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(powerBalance, 0);
    addToRunTimeSelectionTable(functionObject, powerBalance, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::powerBalance::powerBalance
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName, dict)
{
    read(dict);

    if (Pstream::master())
    {
        writeHeader(file(), "Power [W]");
        writeCommented(file(), "Time [s]");
        for
        (
            const char* column :
            {
                "gravity", "walls", "pressure", "viscous", "bending",
                "imbalance/supply", "dissipation by cell gradients", "friction"
            }
        )
        {
            writeTabbed(file(), column);
        }
        file() << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::powerBalance::read(const dictionary& dict)
{
    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


bool Foam::functionObjects::powerBalance::execute()
{
    const creepingFlow& flow = creepingFlow::find(mesh_);

    const powerTerms power(flow.power());
    const axialSymmetry axial(mesh_);
    const scalar dissipation =
        (axial.active() ? axial.toCircle() : 1)
       *gSum(flow.gradientDissipation()().primitiveField()*mesh_.V());

    if (Pstream::master())
    {
        writeCurrentTime(file());
        for
        (
            const scalar value :
            {
                power.gravity, power.walls, power.pressure, power.viscous,
                power.bending, power.imbalance(), dissipation,
                power.friction
            }
        )
        {
            file() << token::TAB << value;
        }
        file() << endl;
    }

    Log << type() << ' ' << name() << ": supplied "
        << power.supplied() << " W, dissipated " << power.dissipated()
        << " W, relative imbalance " << power.imbalance() << endl;

    return true;
}


// ************************************************************************* //
