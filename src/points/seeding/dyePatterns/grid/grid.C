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

#include "grid.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dyePatterns
{
    defineTypeNameAndDebug(grid, 0);
    addToRunTimeSelectionTable(dyePattern, grid, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dyePatterns::grid::grid
(const dictionary& dict)
:
    dyePattern(dict),
    spacing_(checkedEntry::positive("spacing", dimLength, dict).value()),
    width_(checkedEntry::positive("width", dimLength, dict).value()),
    origin_(dict.get<point>("origin")),
    directions_(dict.get<Pair<vector>>("directions"))
{
    checkedEntry::only
    (
        dict,
        {"type", "material", "spacing", "width", "origin", "directions"}
    );

    if (width_ >= spacing_)
    {
        FatalIOErrorInFunction(dict)
            << "Entries width " << width_ << " and spacing " << spacing_ << nl
            << "    Allowed: a width below the spacing"
            << exit(FatalIOError);
    }
    if (!(mag(directions_[0]) > 0 && mag(directions_[1]) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'directions' is " << directions_ << nl
            << "    Allowed: two vectors, neither of them zero"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::dyePatterns::grid::mark(const point& p) const
{
    label mark = 0;
    for (label i = 0; i < 2; ++i)
    {
        const vector across(normalised(directions_[i]));
        const scalar x = ((p - origin_) & across)/spacing_;

        if (mag(x - std::round(x))*spacing_ <= 0.5*width_)
        {
            mark += i + 1;
        }
    }
    return mark;
}


// ************************************************************************* //
