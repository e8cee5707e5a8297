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

#include "belowInterface.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace pointRegions
{
    defineTypeNameAndDebug(belowInterface, 0);
    addToRunTimeSelectionTable(pointRegion, belowInterface, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::pointRegions::belowInterface::withFile
(
    const dictionary& dict,
    const polyMesh& mesh
)
{
    dictionary copy(dict);

    for (const word& name : {word("height"), word("heightCoeffs")})
    {
        dictionary* function = copy.findDict(name);
        if (function && function->found("file"))
        {
            function->set
            (
                "file", inCase(function->get<fileName>("file"), mesh)
            );
        }
    }

    return copy;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointRegions::belowInterface::belowInterface
(
    const dictionary& dict,
    const polyMesh& mesh
)
:
    along_(checkedEntry::direction("along", dict)),
    up_(checkedEntry::direction("up", dict)),
    height_(Function1<scalar>::New("height", withFile(dict, mesh)))
{
    checkedEntry::only
    (
        dict,
        {"type", "material", "along", "up", "height", "heightCoeffs"}
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::pointRegions::belowInterface::contains(const point& p) const
{
    return (p & up_) < height_->value(p & along_);
}


// ************************************************************************* //
