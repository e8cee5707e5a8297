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


#include "residenceTime.H"
#include "materialPoint.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace pointProperties
{
    defineTypeNameAndDebug(residenceTime, 0);
    addToRunTimeSelectionTable(pointProperty, residenceTime, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::pointProperties::residenceTime::step
(
    scalar& value,
    const materialPoint& p,
    const pointFlow&,
    const scalar dt
) const
{
    bool counts = within_.empty();
    for (const pointRegion& region : within_)
    {
        counts = counts || region.contains(p.position(mesh()));
    }
    if (counts)
    {
        value += dt;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointProperties::residenceTime::residenceTime
(
    const word& name,
    const dictionary& dict,
    const fvMesh& mesh,
    const label first
)
:
    typedPointProperty<scalar>
    (
        name, dict, mesh, first, dimTime, wordList({"within"})
    )
{
    PtrList<dictionary> regions;
    dict.readIfPresent("within", regions);
    within_.setSize(regions.size());
    forAll(regions, i)
    {
        within_.set(i, pointRegion::New(regions[i], mesh));
    }
}


// ************************************************************************* //
