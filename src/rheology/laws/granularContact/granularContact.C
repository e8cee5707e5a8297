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

#include "granularContact.H"
#include "checkedEntry.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace viscosityLaws
{
    defineTypeNameAndDebug(granularContact, 0);
    addToRunTimeSelectionTable(viscosityLaw, granularContact, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityLaws::granularContact::granularContact
(
    const dictionary& coeffs
)
:
    viscosityLaw(coeffs)
{
    using checkedEntry::positive;
    using checkedEntry::nonNegative;

    checkedEntry::only
    (
        coeffs, {"n", "k", "eta_n", "eta_m", "R", "compressible"}
    );

    const dimensionedScalar n(nonNegative("n", dimless, coeffs));
    const dimensionedScalar k(positive("k", dimless, coeffs));
    const dimensionedScalar R(nonNegative("R", dimLength, coeffs));
    const dimensionedScalar etaM
    (
        nonNegative("eta_m", eta_.dimensions(), coeffs)
    );
    const bool compressible = coeffs.get<bool>("compressible");
    const dimensionedScalar etaN
    (
        compressible
      ? positive("eta_n", eta_.dimensions(), coeffs)
      : nonNegative("eta_n", eta_.dimensions(), coeffs)
    );

    if (n.value() >= 1)
    {
        checkedEntry::refuse
        (
            coeffs, "n", Foam::name(n.value()), "zero to below one"
        );
    }

    if (etaN.value() + etaM.value() <= 0)
    {
        checkedEntry::refuse
        (
            coeffs, "eta_n", "zero, and so is eta_m", "one of them above zero"
        );
    }

    const dimensionedScalar density
    (
        (1 - n)*k/(2*Foam::constant::mathematical::pi)
    );

    eta_ = 0.5*density*(etaN + etaM);
    etaC_ = density*etaM;
    setM(R);

    if (compressible)
    {
        invB_ = 1/(density*etaN);
    }
}


// ************************************************************************* //
