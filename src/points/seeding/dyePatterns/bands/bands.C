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

#include "bands.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dyePatterns
{
    defineTypeNameAndDebug(bands, 0);
    addToRunTimeSelectionTable(dyePattern, bands, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dyePatterns::bands::bands
(const dictionary& dict)
:
    dyePattern(dict),
    across_(checkedEntry::direction("across", dict)),
    start_(checkedEntry::place("start", dict)),
    width_(checkedEntry::positive("width", dimLength, dict).value()),
    period_(checkedEntry::positive("period", dimLength, dict).value())
{
    checkedEntry::only
    (
        dict,
        {"type", "material", "across", "start", "width", "period"}
    );

    if (width_ > period_)
    {
        FatalIOErrorInFunction(dict)
            << "Entries width " << width_ << " and period " << period_ << nl
            << "    Allowed: a width of at most the period"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::dyePatterns::bands::mark(const point& p) const
{
    const scalar x = (p & across_) - start_;
    const scalar band = std::floor(x/period_);

    if (band >= scalar(labelMax))
    {
        FatalErrorInFunction
            << "Entry 'period' of dye bands in"
            << " constant/materialPointsProperties is " << period_
            << ", which makes " << band << " bands up to " << p << nl
            << "    Allowed: up to " << labelMax << " bands"
            << exit(FatalError);
    }

    return band >= 0 && x - band*period_ < width_ ? label(band) + 1 : 0;
}


// ************************************************************************* //
