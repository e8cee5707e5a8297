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

#include "source.H"
#include "addToRunTimeSelectionTable.H"
#include "cellSet.H"
#include "checkedEntry.H"
#include "topoSetSource.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace cellSelections
{
    defineTypeNameAndDebug(source, 0);
    addToRunTimeSelectionTable(cellSelection, source, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::cellSelections::source::place() const
{
    const fvMesh& mesh = scene_.mesh();
    cellSet cells(mesh, "refined", mesh.nCells()/10);
    const autoPtr<topoSetSource> chooser
    (
        topoSetSource::New(source_, mesh, dict_)
    );
    if (chooser->setType() != topoSetSource::CELLSETSOURCE)
    {
        checkedEntry::refuse
        (
            dict_, "source", source_, "sources that choose cells"
        );
    }
    chooser->applyToSet(topoSetSource::ADD, cells);

    boolList chosen(mesh.nCells(), false);
    for (const label celli : cells)
    {
        chosen[celli] = true;
    }
    scene_.addRings(chosen, rings_);
    return chosen;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellSelections::source::source
(
    const dictionary& dict,
    const refinedScene& scene
)
:
    cellSelection(dict, scene),
    dict_(dict),
    source_(dict.get<word>("source")),
    rings_(number(dict, "rings", 0, 1000, 0))
{
    for (const char* ofSets : {"cellToCell", "faceToCell", "pointToCell"})
    {
        if (source_ == ofSets)
        {
            checkedEntry::refuse
            (
                dict, "source", source_,
                "sources that take no set: zoneToCell, boxToCell, ..."
            );
        }
    }
}


// ************************************************************************* //
