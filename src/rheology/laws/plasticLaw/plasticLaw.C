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

#include "plasticLaw.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::plasticLaw::branchType>
Foam::plasticLaw::branchTypeNames
({
    { branchType::HARMONIC, "harmonic" },
    { branchType::MINIMUM, "minimum" }
});


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::wordList Foam::plasticLaw::entries(wordList own)
{
    own.append(wordList({"etaV", "etaVP", "branch"}));
    return own;
}


Foam::scalar Foam::plasticLaw::viscosity
(
    const scalar rate,
    const scalar p,
    const scalar strength
) const
{
    const scalar tauY = strength*yieldStress(p);

    if (branch_ == branchType::HARMONIC)
    {
        return 1/(1/etaV_ + rate/(tauY + etaVP_*rate));
    }
    return
        etaV_*rate <= tauY
      ? etaV_
      : (tauY/rate + etaVP_)/(1 + etaVP_/etaV_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::plasticLaw::plasticLaw(const dictionary& coeffs)
:
    rateLaw(coeffs),
    etaV_(checkedEntry::positive("etaV", eta_.dimensions(), coeffs).value()),
    etaVP_
    (
        checkedEntry::nonNegative("etaVP", eta_.dimensions(), coeffs).value()
    ),
    branch_(branchTypeNames.get("branch", coeffs))
{}


// ************************************************************************* //
