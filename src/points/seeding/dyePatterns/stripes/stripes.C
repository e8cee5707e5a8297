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

#include "stripes.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dyePatterns
{
    defineTypeNameAndDebug(stripes, 0);
    addToRunTimeSelectionTable(dyePattern, stripes, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dyePatterns::stripes::stripes(const dictionary& dict)
:
    dyePattern(dict),
    along_(checkedEntry::direction("along", dict)),
    origin_(dict.get<point>("origin")),
    width_(checkedEntry::positive("width", dimLength, dict).value())
{
    checkedEntry::only(dict, {"type", "material", "along", "origin", "width"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::dyePatterns::stripes::mark(const point& p) const
{
    const scalar pairs = ((p - origin_) & along_)/(2*width_);

    return pairs - std::floor(pairs) < 0.5 ? 1 : 0;
}


// ************************************************************************* //
