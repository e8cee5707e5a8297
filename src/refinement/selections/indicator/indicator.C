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

#include "indicator.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace cellSelections
{
    defineTypeNameAndDebug(indicator, 0);
    addToRunTimeSelectionTable(cellSelection, indicator, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::cellSelections::indicator::thresholdOf
(
    const scalar share
) const
{
    const fvMesh& mesh = scene_.mesh();
    scalarField values(mesh.lookupObject<volScalarField>(field_));
    Foam::sort(values);
    const label n = label(share*values.size());

    return n > 0 ? values[values.size() - n] : GREAT;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::cellSelections::indicator::place() const
{
    const fvMesh& mesh = scene_.mesh();
    boolList chosen(mesh.nCells(), false);
    if (scene_.nPasses())
    {
        return chosen;
    }

    const auto& values = mesh.lookupObject<volScalarField>(field_);
    forAll(chosen, celli)
    {
        chosen[celli] = values[celli] >= threshold_;
    }
    scene_.addRings(chosen, rings_);
    return chosen;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellSelections::indicator::indicator
(
    const dictionary& dict,
    const refinedScene& scene
)
:
    cellSelection(dict, scene),
    field_(dict.getOrDefault<word>("field", "errorIndicator")),
    threshold_(dict.getOrDefault<scalar>("threshold", GREAT)),
    rings_(number(dict, "rings", 0, 1000, 1))
{
    checkedEntry::only
    (
        dict, {"type", "levels", "field", "share", "threshold", "rings"}
    );
    if (!scene.mesh().foundObject<volScalarField>(field_))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'field' is " << field_ << nl
            << "    Allowed: the scalar fields of time "
            << scene.mesh().time().timeName() << ", "
            << flatOutput(scene.mesh().sortedNames<volScalarField>())
            << exit(FatalIOError);
    }
    if (dict.found("share") == dict.found("threshold"))
    {
        checkedEntry::refuse
        (
            dict, "share",
            dict.found("share") ? "there with threshold" : "not there",
            "one of share and threshold"
        );
    }
    if (dict.found("share"))
    {
        const scalar share = dict.get<scalar>("share");
        if (share <= 0 || share > 1)
        {
            checkedEntry::refuse
            (
                dict, "share", Foam::name(share), "above 0, up to 1"
            );
        }
        threshold_ = thresholdOf(share);
    }
}


// ************************************************************************* //
