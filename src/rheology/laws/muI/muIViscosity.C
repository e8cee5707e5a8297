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

#include "muIViscosity.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace viscosityLaws
{
    defineTypeNameAndDebug(muI, 0);
    addToRunTimeSelectionTable(viscosityLaw, muI, dictionary);
}
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::viscosityLaws::muI::viscosity
(
    const scalar rate,
    const scalar p,
    const scalar strength
) const
{
    const scalar pressure = max(p, least_);
    const scalar I = d_*rate*sqrt(rhoGrain_/pressure);

    return
        strength*(muS_ + deltaMu_*I/(I0_ + I))*pressure
       *yield_.inverse(rate, relaxed(yield_.eps()));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityLaws::muI::muI(const dictionary& coeffs)
:
    rateLaw(coeffs),
    muS_(checkedEntry::positive("muS", dimless, coeffs).value()),
    deltaMu_(checkedEntry::nonNegative("deltaMu", dimless, coeffs).value()),
    I0_(checkedEntry::positive("I0", dimless, coeffs).value()),
    d_(checkedEntry::positive("d", dimLength, coeffs).value()),
    rhoGrain_(checkedEntry::positive("rhoGrain", dimDensity, coeffs).value()),
    least_
    (
        checkedEntry::positive("leastPressure", dimPressure, coeffs).value()
    ),
    yield_(coeffs)
{
    checkEntries
    (
        {
            "muS", "deltaMu", "I0", "d", "rhoGrain", "leastPressure",
            "regularisation", "eps"
        }
    );
    setRest();
}


// ************************************************************************* //
