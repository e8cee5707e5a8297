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

#include "surface.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "ListOps.H"
#include "materialPointCloud.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace cellSelections
{
    defineTypeNameAndDebug(surface, 0);
    addToRunTimeSelectionTable(cellSelection, surface, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::cellSelections::surface::place() const
{
    const fvMesh& mesh = scene_.mesh();
    boolList chosen(mesh.nCells(), false);

    List<boolList> holds(scene_.materials().size());
    labelList nHeld(mesh.nCells(), Zero);
    forAll(holds, i)
    {
        holds[i] = scene_.holds(i);
        forAll(nHeld, celli)
        {
            nHeld[celli] += holds[i][celli];
        }
    }

    for (const label m : materials_)
    {
        forAll(chosen, celli)
        {
            chosen[celli] =
                chosen[celli] || (holds[m][celli] && nHeld[celli] > 1);
        }
        for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
        {
            const label own = mesh.faceOwner()[facei];
            const label nei = mesh.faceNeighbour()[facei];
            if (holds[m][own] != holds[m][nei])
            {
                chosen[own] = chosen[nei] = true;
            }
        }
    }

    scene_.addRings(chosen, rings_);
    return chosen;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellSelections::surface::surface
(
    const dictionary& dict,
    const refinedScene& scene
)
:
    cellSelection(dict, scene),
    materials_(identity(scene.materials().size())),
    rings_(number(dict, "rings", 0, 1000, 4))
{
    checkedEntry::only(dict, {"type", "levels", "material", "rings"});
    if (dict.found("material"))
    {
        materials_ = labelList
        (
            1,
            materialPointCloud::findMaterial
            (
                dict.get<word>("material"), scene.materials(), dict
            )
        );
    }
}


// ************************************************************************* //
