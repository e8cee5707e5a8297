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

#include "timeFiles.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "topoSet.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::timeFiles::instance(const fvMesh& mesh)
{
    const Time& time = mesh.time();
    const fileName place(mesh.facesInstance());
    bool earlier = false;

    for (const instant& t : time.times())
    {
        if (t.name() == time.constant() || t.name() == time.timeName())
        {
            continue;
        }
        if (t.value() > time.value())
        {
            FatalErrorInFunction
                << "Time " << t.name() << " is after " << time.timeName()
                << ", which is to be refined, and on the same mesh" << nl
                << "    Cure: delete later times, or refine the last one"
                << exit(FatalError);
        }
        scalar since;
        earlier =
            earlier || place == time.constant()
         || (readScalar(place.c_str(), since) && t.value() >= since);
    }

    return earlier ? fileName(time.timeName()) : place;
}


bool Foam::timeFiles::uniform(const IOobject& field)
{
    IFstream is(field.objectPath());
    std::string line;
    while (is.good())
    {
        is.getLine(line);
        if (line.find("nonuniform") != std::string::npos)
        {
            return false;
        }
    }
    return true;
}


void Foam::timeFiles::removeStale
(
    const fvMesh& mesh,
    const IOobjectList& objects
)
{
    auto remove = [](const fileName& file)
    {
        if (rm(file) || rm(file + ".gz"))
        {
            Info<< "    " << file.name().c_str() << nl;
        }
    };

    Info<< "Deleted, since the next run makes them anew, of the files of time "
        << mesh.time().timeName() << ":" << nl;
    forAllConstIters(objects, iter)
    {
        // Of values only those of volFields are mapped. Without a folder of
        // the time the list is of the files of constant
        const word& kind = iter()->headerClassName();
        const bool mapped = kind.startsWith("vol") && kind.endsWith("Field");
        if
        (
            !mapped && kind.find("Field") != std::string::npos
         && iter()->instance() == mesh.time().timeName()
        )
        {
            remove(iter()->objectPath());
        }
    }
    remove(mesh.time().timePath()/"uniform"/"dtBefore");
    Info<< endl;
}


void Foam::timeFiles::removeBeside(const fvMesh& mesh)
{
    topoSet::removeFiles(mesh);

    const fileName folder
    (
        mesh.time().path()/mesh.facesInstance()/polyMesh::meshSubDir
    );
    for
    (
        const char* name :
        {"pointLevel", "level0Edge", "surfaceIndex", "refinementHistory"}
    )
    {
        rm(folder/name);
    }
}


// ************************************************************************* //
