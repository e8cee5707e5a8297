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

#include "powerLawViscosity.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace viscosityLaws
{
    defineTypeNameAndDebug(powerLaw, 0);
    addToRunTimeSelectionTable(viscosityLaw, powerLaw, dictionary);
}
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::viscosityLaws::powerLaw::viscosity
(
    const scalar rate,
    const scalar,
    const scalar
) const
{
    return K_*pow(sqr(rate) + sqr(relaxed(eps_)), 0.5*(n_ - 1));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityLaws::powerLaw::powerLaw(const dictionary& coeffs)
:
    rateLaw(coeffs),
    n_(checkedEntry::positive("n", dimless, coeffs).value()),
    K_
    (
        checkedEntry::positive("K", dimPressure*pow(dimTime, n_), coeffs)
       .value()
    ),
    eps_(checkedEntry::positive("eps", dimless/dimTime, coeffs).value())
{
    checkEntries({"K", "n", "eps"});
    setRest();
}


// ************************************************************************* //
