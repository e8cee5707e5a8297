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

#include "binghamViscosity.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace viscosityLaws
{
    defineTypeNameAndDebug(bingham, 0);
    addToRunTimeSelectionTable(viscosityLaw, bingham, dictionary);
}
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::viscosityLaws::bingham::viscosity
(
    const scalar rate,
    const scalar,
    const scalar strength
) const
{
    return
        etaP_ + strength*tauY_*yield_.inverse(rate, relaxed(yield_.eps()));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityLaws::bingham::bingham(const dictionary& coeffs)
:
    rateLaw(coeffs),
    etaP_(checkedEntry::positive("etaP", eta_.dimensions(), coeffs).value()),
    tauY_(checkedEntry::nonNegative("tauY", dimPressure, coeffs).value()),
    yield_(coeffs)
{
    checkEntries({"etaP", "tauY", "regularisation", "eps"});
    setRest();
}


// ************************************************************************* //
