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

#include "cellSelection.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(cellSelection, 0);
    defineRunTimeSelectionTable(cellSelection, dictionary);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::label Foam::cellSelection::number
(
    const dictionary& dict,
    const word& key,
    const label least,
    const label most,
    const label preset
)
{
    const label n = dict.getOrDefault<label>(key, preset);
    if (n < least || n > most)
    {
        checkedEntry::refuse
        (
            dict, key, Foam::name(n),
            Foam::name(least) + " to " + Foam::name(most)
        );
    }
    return n;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellSelection::cellSelection
(
    const dictionary& dict,
    const refinedScene& scene
)
:
    levels_(number(dict, "levels", 1, 20, dict.get<label>("levels"))),
    scene_(scene)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cellSelection::choose(boolList& chosen) const
{
    const boolList cells(place());
    forAll(cells, celli)
    {
        if (cells[celli] && scene_.level()[celli] < levels_)
        {
            chosen[celli] = true;
        }
    }
}


// ************************************************************************* //
