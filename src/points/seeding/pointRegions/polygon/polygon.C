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

#include "polygon.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace pointRegions
{
    defineTypeNameAndDebug(polygon, 0);
    addToRunTimeSelectionTable(pointRegion, polygon, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointRegions::polygon::polygon
(
    const dictionary& dict,
    const polyMesh& mesh
)
:
    frame_(mesh),
    points_(dict.get<List<point>>("points"))
{
    checkedEntry::only(dict, {"type", "material", "points"});

    if (points_.size() < 3)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'points' has " << points_.size() << " corners" << nl
            << "    Allowed: three or more" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::pointRegions::polygon::contains(const point& p) const
{
    return frame_.contains(points_, p);
}


// ************************************************************************* //
