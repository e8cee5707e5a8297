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

Application
    refineScene

Group
    grpMeshManipulationUtilities

Description
    Refines cells of a planar mesh where it matters, by system/refineSceneDict,
    and takes the fields and the material points of the start time along, so
    that the run goes on from there.

    Cells are halved both ways in the plane, level by level, with at most one
    hanging node on a side of a cell (planarRefinement.H). Which ones is said by
    any number of selections (cellSelection.H): around corners, which are found
    by themselves; at the surface of a material; by OpenFOAM's sources of sets;
    by an indicator.

    - Fields on cells take the value of the cell before; those on faces, and
      the flow of the step before, are deleted: the solver makes them anew.
      Files that are the same on any mesh are not touched.
    - Points keep their places and all that they carry. Small cells then have
      few of them, which is mended as the run goes on (pointPopulation.H).
    - The mesh is replaced where it is; but if earlier times are on it, that of
      this time is written beside its fields.
    - Decompose after it.

Usage
    \b refineScene [OPTIONS]

      - \par -overwrite
        Replace mesh and fields of the start time; without it they are written
        to the time one deltaT later

      - \par -dict \<file\>
        Another dictionary than system/refineSceneDict

    system/refineSceneDict:
    \verbatim
    refine
    {
        corners
        {
            type        corners;
            levels      6;
        }
        fill
        {
            type        surface;
            material    granular;
            levels      2;
        }
    }

    maxCells        100000;
    \endverbatim

    Where the entries mean:
    \table
        Property | Description                               | Default
        refine   | selections by name, see cellSelection     | required
        maxCells | number of cells at which to stop with an error | 1000000
    \endtable

SourceFiles
    refineScene.C
    timeFiles.C

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "axialSymmetry.H"
#include "cellSelection.H"
#include "checkedEntry.H"
#include "cloud.H"
#include "ListOps.H"
#include "OSspecific.H"
#include "ReadFields.H"
#include "refinedScene.H"
#include "Time.H"
#include "timeFiles.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Read the fields of a type; with keep, those that are uniform are not
//- written again
template<class Type>
static void readFields
(
    const fvMesh& mesh,
    const IOobjectList& objects,
    const bool keep,
    PtrList<GeometricField<Type, fvPatchField, volMesh>>& fields
)
{
    ReadFields(mesh, objects, fields);
    for (auto& field : fields)
    {
        if (keep && timeFiles::uniform(field))
        {
            field.writeOpt() = IOobject::NO_WRITE;
        }
    }
}


//- Refine until all selections have their levels
static void refineAll
(
    refinedScene& scene,
    const PtrList<cellSelection>& selections,
    const label maxCells
)
{
    const fvMesh& mesh = scene.mesh();
    while (true)
    {
        boolList chosen(mesh.nCells(), false);
        for (const cellSelection& selection : selections)
        {
            selection.choose(chosen);
        }
        const label n = std::count(chosen.begin(), chosen.end(), true);
        if (!n)
        {
            return;
        }
        // Three more for each, those refined for balance aside
        if (mesh.nCells() + 3*n > maxCells)
        {
            FatalErrorInFunction
                << "Refining " << n << " of " << mesh.nCells()
                << " cells makes more than maxCells, " << maxCells << nl
                << "    Cure: fewer levels or rings, or a larger maxCells in"
                << " refineSceneDict" << exit(FatalError);
        }
        scene.refine(chosen);
        Info<< "Level " << scene.nPasses() << ": " << n << " cells chosen, "
            << mesh.nCells() << " cells" << endl;
    }
}


//- What the program does and takes
static void addOptions()
{
    argList::addNote
    (
        "Refine a planar mesh around corners, at surfaces, in boxes or by an"
        " indicator, with fields and points of the start time"
    );
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addBoolOption
    (
        "overwrite", "Replace mesh and fields of the start time"
    );
    argList::addOption
    (
        "dict", "file", "Another dictionary than system/refineSceneDict"
    );
}


//- The dictionary of a call
static IOdictionary readDict(const argList& args, const Time& runTime)
{
    const IOdictionary dict
    (
        IOobject
        (
            args.found("dict")
          ? args.opt<fileName>("dict")
          : fileName(runTime.system()/"refineSceneDict"),
            runTime,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    // Others may be variables, such as those of a preset
    checkedEntry::reportUnread(dict, {"refine", "maxCells"});

    return dict;
}


//- Move on to the time after the start, with the names of its points
static void nextTime(Time& runTime)
{
    const fileName names(runTime.timePath()/"uniform"/cloud::prefix);
    ++runTime;
    if (isDir(names))
    {
        mkDir(runTime.timePath()/"uniform");
        cp(names, runTime.timePath()/"uniform");
    }
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    addOptions();

    #include "setRootCase.H"
    #include "createTime.H"

    fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion, runTime.timeName(), runTime,
            IOobject::MUST_READ
        )
    );

    if (axialSymmetry(mesh).active())
    {
        FatalErrorInFunction
            << "The mesh is a wedge" << nl
            << "    Allowed: planar meshes, with patches of type empty"
            << exit(FatalError);
    }

    const IOdictionary dict(readDict(args, runTime));
    const bool overwrite = args.found("overwrite");
    const fileName place
    (
        overwrite ? timeFiles::instance(mesh) : fileName()
    );
    const IOobjectList objects(mesh, runTime.timeName());
    PtrList<volScalarField> scalars;
    PtrList<volVectorField> vectors;
    PtrList<volSphericalTensorField> sphericals;
    PtrList<volSymmTensorField> symmetrics;
    PtrList<volTensorField> tensors;
    readFields(mesh, objects, overwrite, scalars);
    readFields(mesh, objects, overwrite, vectors);
    readFields(mesh, objects, overwrite, sphericals);
    readFields(mesh, objects, overwrite, symmetrics);
    readFields(mesh, objects, overwrite, tensors);

    refinedScene scene(mesh);
    PtrList<cellSelection> selections;
    for (const entry& e : dict.subDict("refine"))
    {
        selections.append(cellSelection::New(e.dict(), scene));
    }

    const label nBefore = mesh.nCells();
    refineAll
    (
        scene, selections, dict.getOrDefault<label>("maxCells", 1000000)
    );
    Info<< nl << "Cells: " << nBefore << " before, " << mesh.nCells()
        << " now" << endl;
    if (mesh.nCells() == nBefore)
    {
        Info<< "Nothing to be refined: nothing written" << nl << "End" << nl;
        return 0;
    }

    if (overwrite)
    {
        mesh.setInstance(place);
        timeFiles::removeStale(mesh, objects);
        timeFiles::removeBeside(mesh);
    }
    else
    {
        nextTime(runTime);
        mesh.setInstance(runTime.timeName());
    }
    mesh.write();
    scene.write();
    Info<< "Written: mesh in " << mesh.facesInstance()
        << ", fields and " << scene.points().size() << " points in "
        << runTime.timeName() << nl << nl << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
