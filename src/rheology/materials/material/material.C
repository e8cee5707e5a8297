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

#include "material.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::material::material(const word& name, const dictionary& dict)
:
    name_(name),
    rho_(checkedEntry::nonNegative("rho", dimDensity, dict)),
    law_(viscosityLaw::New(dict))
{
    wordList allowed({"rho", "viscosityLaw"});

    // Constants of laws not chosen may stay
    for (const word& law : viscosityLaw::names())
    {
        allowed.append(law + "Coeffs");
    }

    checkedEntry::only(dict, allowed);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::material::print(Ostream& os) const
{
    os  << "    " << name_ << ": rho " << rho_.value()
        << ", " << law_->type() << " viscosity: eta " << law_->eta().value()
        << ", etaC " << law_->etaC().value()
        << ", M " << law_->M().value() << ", B ";

    if (law_->invB().value() > 0)
    {
        os  << 1/law_->invB().value();
    }
    else
    {
        os  << "infinite";
    }

    if (law_->followsFlow())
    {
        os  << " at rest, and then as the flow is";
    }
    law_->print(os);

    os  << nl;
}


// ************************************************************************* //
