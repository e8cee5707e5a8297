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

#include "druckerPragerViscosity.H"
#include "checkedEntry.H"
#include "unitConversion.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace viscosityLaws
{
    defineTypeNameAndDebug(druckerPrager, 0);
    addToRunTimeSelectionTable(viscosityLaw, druckerPrager, dictionary);
}
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::viscosityLaws::druckerPrager::yieldStress
(
    const scalar p
) const
{
    return max(cohesion_*cos(angle_) + p*sin(angle_), least_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityLaws::druckerPrager::druckerPrager(const dictionary& coeffs)
:
    plasticLaw(coeffs),
    cohesion_
    (
        checkedEntry::nonNegative("cohesion", dimPressure, coeffs).value()
    ),
    angle_
    (
        degToRad(checkedEntry::nonNegative("angle", dimless, coeffs).value())
    ),
    least_(checkedEntry::positive("leastStress", dimPressure, coeffs).value())
{
    checkEntries
    (
        plasticLaw::entries({"cohesion", "angle", "leastStress"})
    );
    if (angle_ >= 0.5*constant::mathematical::pi)
    {
        checkedEntry::refuse
        (
            coeffs, "angle", Foam::name(radToDeg(angle_)), "below 90 degrees"
        );
    }

    setRest();
}


// ************************************************************************* //
