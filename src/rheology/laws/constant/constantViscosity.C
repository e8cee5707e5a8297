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

#include "constantViscosity.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace viscosityLaws
{
    defineTypeNameAndDebug(constant, 0);
    addToRunTimeSelectionTable(viscosityLaw, constant, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityLaws::constant::constant(const dictionary& coeffs)
:
    viscosityLaw(coeffs)
{
    checkedEntry::only(coeffs, {"eta", "etaC", "R", "M", "B"});

    eta_ = checkedEntry::positive("eta", eta_.dimensions(), coeffs);
    etaC_ = checkedEntry::nonNegative("etaC", etaC_.dimensions(), coeffs);

    const bool givenR = coeffs.found("R");
    const bool givenM = coeffs.found("M");

    if (givenR == givenM)
    {
        checkedEntry::refuse
        (
            coeffs,
            "R",
            givenR ? "given together with M" : "missing, and so is M",
            "one of R (internal length) and M (bending viscosity)"
        );
    }

    if (givenR)
    {
        setM(checkedEntry::nonNegative("R", dimLength, coeffs));
    }
    else
    {
        M_ = checkedEntry::nonNegative("M", M_.dimensions(), coeffs);
    }

    setB();
}


// ************************************************************************* //
