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

#include "materialOutflow.H"
#include "checkedEntry.H"
#include "materialPointCloud.H"
#include "creepingFlow.H"
#include "oneLayer.H"
#include "planarFrame.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(materialOutflow, 0);
    addToRunTimeSelectionTable(functionObject, materialOutflow, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::materialOutflow::writeRow()
{
    // Of the cells
    const materialFields& materials = creepingFlow::find(mesh_).materials();
    const label material =
        materialPointCloud::findMaterial(material_, materials.names(), dict_);

    scalar out = 0, inPoints = 0, inCells = 0;

    const scalarField& V = mesh_.V();
    const vectorField& C = mesh_.C().primitiveField();
    const volScalarField* alpha = mesh_.findObject<volScalarField>
    (
        IOobject::groupName("alpha", material_)
    );
    forAll(V, celli)
    {
        const scalar volume = V[celli]*(alpha ? (*alpha)[celli] : 1);
        inCells += volume;
        out += beyond(C[celli]) ? volume : 0;
    }

    // Better of the points, where there are any
    const materialPointCloud* points =
        mesh_.findObject<materialPointCloud>(materialPointCloud::cloudName);

    if (points)
    {
        out = 0;
        for (const materialPoint& p : *points)
        {
            if (p.material() == material)
            {
                inPoints += p.volume();
                out += beyond(p.position(mesh_)) ? p.volume() : 0;
            }
        }
    }
    else
    {
        inPoints = inCells;
    }

    for (scalar* sum : {&out, &inPoints, &inCells})
    {
        reduce(*sum, sumOp<scalar>());
        *sum /= depth_;
    }

    const scalar now = time_.value();
    const scalar flux =
        now > lastTime_ ? (out - lastVolume_)/(now - lastTime_) : 0;
    lastVolume_ = out;
    lastTime_ = now;

    if (Pstream::master())
    {
        writeCurrentTime(file());
        file()
            << token::TAB << out << token::TAB << flux
            << token::TAB << inPoints << token::TAB << inCells << endl;
    }

    const char* unit = axial_.active() ? " m3" : " m2";
    Log << type() << ' ' << name() << ": " << out << unit << " of "
        << material_ << " beyond the plane, " << flux << unit << "/s" << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::materialOutflow::materialOutflow
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName, dict),
    axial_(mesh_),
    depth_
    (
        axial_.active()
      ? 1/axial_.toCircle()
      : mesh_.bounds().span()
        [planarFrame(oneLayer::check(mesh_)).normalAxis()]
    ),
    lastVolume_(0),
    lastTime_(GREAT)
{
    read(dict);

    if (Pstream::master())
    {
        writeHeader
        (
            file(),
            "Volume of " + material_
          + (axial_.active() ? " around the axis" : " a thickness of the mesh")
        );
        const string unit(axial_.active() ? "[m3" : "[m2");
        writeCommented(file(), "Time [s]");
        writeTabbed(file(), "beyond the plane " + unit + ']');
        writeTabbed(file(), "flux through the plane " + unit + "/s]");
        writeTabbed(file(), "all points " + unit + ']');
        writeTabbed(file(), "on the mesh " + unit + ']');
        file() << endl;
    }

    // Of the start, which a run does not execute; where times already written
    // are processed there is no flow yet
    if (!postProcess)
    {
        writeRow();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::materialOutflow::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    dict_ = dict;
    dict.readEntry("material", material_);
    dict.readEntry("point", point_);
    normal_ = checkedEntry::direction("normal", dict);

    return true;
}


bool Foam::functionObjects::materialOutflow::execute()
{
    writeRow();
    return true;
}


// ************************************************************************* //
