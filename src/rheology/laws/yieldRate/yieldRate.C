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

#include "yieldRate.H"
#include "checkedEntry.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::yieldRate::form> Foam::yieldRate::formNames
({
    { form::PAPANASTASIOU, "Papanastasiou" },
    { form::BERCOVIER_ENGELMAN, "BercovierEngelman" }
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::yieldRate::yieldRate(const dictionary& coeffs)
:
    form_(formNames.get("regularisation", coeffs)),
    eps_(checkedEntry::positive("eps", dimless/dimTime, coeffs).value())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::yieldRate::inverse
(
    const scalar rate,
    const scalar eps
) const
{
    if (form_ == form::BERCOVIER_ENGELMAN)
    {
        return 1/sqrt(sqr(rate) + sqr(eps));
    }

    // Its limit, where the quotient is of two zeros
    return rate > VSMALL ? -std::expm1(-rate/eps)/rate : 1/eps;
}


// ************************************************************************* //
