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

#include "unreadFiles.H"
#include "IFstream.H"
#include "IOobjectList.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

namespace Foam
{
    //- Names of files, by parts that they may be made of, and what there is
    //- here in their place
    static const List<Pair<string>> instead
    ({
        {"fvOptions", "forces are the fields bodyForce [N/m3] and bodyCouple"
            " [Pa] of the start time"},
        {"fvModels", "forces are the fields bodyForce [N/m3] and bodyCouple"
            " [Pa] of the start time"},
        {"fvConstraints", "what is given are values on patches"},
        {"MRF", "the frame does not turn; walls may, by rotatingWallVelocity"},
        {"SRF", "the frame does not turn; walls may, by rotatingWallVelocity"},
        {"porosity", "a porous medium is none of the materials"},
        {"dynamicMesh", "the mesh does not move"},
        {"turbulence", "the flow is creeping"},
        {"momentumTransport", "the flow is creeping"},
        {"RAS", "the flow is creeping"},
        {"LES", "the flow is creeping"},
        {"transport", "viscosities and densities are those of"
            " constant/materialProperties"},
        {"physical", "viscosities and densities are those of"
            " constant/materialProperties"},
        {"constitutive", "viscosities and densities are those of"
            " constant/materialProperties"},
        {"thermophysical", "there is no temperature"},
        {"radiation", "there is no temperature"},
        {"Cloud", "points are those of constant/materialPointsProperties"}
    });


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

    //- Write a name, with what there is in its place
    static void tell(Ostream& os, const fileName& file, const string& hint)
    {
        os  << "    " << file.c_str();
        if (!hint.empty())
        {
            os  << ": " << hint.c_str();
        }
        os  << nl;
    }

    static string hintOf(const word& name)
    {
        for (const Pair<string>& row : instead)
        {
            if (name.find(row.first()) != string::npos)
            {
                return row.second();
            }
        }
        return string();
    }

    //- Lines of the dictionaries of a case that include others
    static string includes(const fileName& path)
    {
        string lines;
        for (const word& folder : {word("system"), word("constant")})
        {
            for (const fileName& file : Foam::readDir(path/folder))
            {
                IFstream is(path/folder/file);
                string line;
                while (is.good())
                {
                    is.getLine(line);
                    if (line.find("#include") != string::npos)
                    {
                        lines += line;
                    }
                }
            }
        }
        return lines;
    }

    //- Has a file a header of OpenFOAM's
    static bool isFoamFile(const fileName& file)
    {
        IFstream is(file);
        string line;
        for (label i = 0; i < 30 && is.good(); ++i)
        {
            is.getLine(line);
            if (line.find("FoamFile") != string::npos)
            {
                return true;
            }
        }
        return false;
    }

    static void tellFiles(Ostream& os, const fileName& path)
    {
        const wordList known
        ({
            "g", "hRef", "materialProperties", "materialPointsProperties"
        });
        const string included(includes(path));

        for (fileName name : Foam::readDir(path/"constant"))
        {
            const bool read =
                known.found(name) || included.find(name) != string::npos;

            if (!read && isFoamFile(path/"constant"/name))
            {
                tell(os, "constant"/name, hintOf(name));
            }
        }
        for (const word name : {"fvOptions", "fvModels", "fvConstraints"})
        {
            if (isFile(path/"system"/name))
            {
                tell(os, "system"/name, hintOf(name));
            }
        }
    }

    static void tellFields
    (
        Ostream& os,
        const materialFields& materials,
        const bool points
    )
    {
        const fvMesh& mesh = materials.mesh();

        // Of the solver, and of tools that write what they find of the mesh
        wordList known
        ({
            "U", "p_rgh", "omega", "bodyForce", "bodyCouple", "inflowVolume",
            "C", "Cx", "Cy", "Cz", "V", "cellDist", "cellID"
        });
        wordList fractions;
        if (materials.parts().has(sceneParts::AVERAGES))
        {
            for (const word& name : materials.names())
            {
                fractions.append(IOobject::groupName("alpha", name));
            }
        }

        const IOobjectList fields(mesh, mesh.time().timeName());
        for (const word& name : fields.sortedNames())
        {
            const fileName file(fileName(mesh.time().timeName())/name);

            if (fractions.found(name))
            {
                if (points)
                {
                    tell(os, file, "fractions are those of the points");
                }
            }
            else if (name.find("alpha.") == 0)
            {
                OStringStream allowed;
                allowed
                    << "fractions are of several materials of"
                    << " constant/materialProperties: "
                    << flatOutput(materials.names());
                tell(os, file, allowed.str());
            }
            else if (name == "p")
            {
                tell(os, file, "p is a result; what is read is p_rgh");
            }
            else if (!known.found(name))
            {
                tell(os, file, hintOf(name));
            }
        }
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::unreadFiles::report
(
    const materialFields& materials,
    const bool points
)
{
    const Time& time = materials.mesh().time();
    OStringStream told;

    if (Pstream::master())
    {
        tellFiles(told, time.globalPath());
    }

    // Others are results
    IOobject io("time", time.timeName(), "uniform", time);
    if (!io.typeHeaderOk<IOdictionary>(false))
    {
        tellFields(told, materials, points);
    }

    if (!told.str().empty())
    {
        Info<< "Files that nothing reads but function objects" << nl
            << told.str().c_str() << endl;
    }
}


// ************************************************************************* //
