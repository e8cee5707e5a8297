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

#include "viscosityLaw.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(viscosityLaw, 0);
    defineRunTimeSelectionTable(viscosityLaw, dictionary);

    static const dimensionSet dimViscosityPaS(dimPressure*dimTime);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::viscosityLaw::setM(const dimensionedScalar& R)
{
    M_.value() = 2*etaC_.value()*sqr(R.value());
}


void Foam::viscosityLaw::setB()
{
    const tokenList& B = coeffs_.lookupEntry("B", keyType::LITERAL).stream();

    if (B.size() == 1 && B[0].isWord())
    {
        if (B[0].wordToken() != "infinite")
        {
            checkedEntry::refuse
            (
                coeffs_, "B", B[0].wordToken(),
                "a number above zero, or the word infinite"
            );
        }
    }
    else
    {
        invB_ = 1/checkedEntry::positive("B", eta_.dimensions(), coeffs_);
    }
}


void Foam::viscosityLaw::scale(const scalarField& factor)
{
    for (materialProperty* property : {&eta_, &etaC_, &M_})
    {
        property->cells(factor.size()) = property->value()*factor;
    }
}


void Foam::viscosityLaw::checkAdmissible() const
{
    if (M_.value() > 0 && etaC_.value() <= 0)
    {
        checkedEntry::refuse
        (
            coeffs_,
            "etaC",
            "0 while the bending viscosity M is " + Foam::name(M_.value()),
            "etaC above zero with M, or M zero: without etaC nothing"
            " determines the microrotation"
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityLaw::viscosityLaw(const dictionary& coeffs)
:
    coeffs_(coeffs),
    eta_("eta", dimViscosityPaS, Zero),
    etaC_("etaC", dimViscosityPaS, Zero),
    M_("M", dimViscosityPaS*dimArea, Zero),
    invB_("invB", dimless/dimViscosityPaS, Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscosityLaw::rest()
{
    for (materialProperty* property : {&eta_, &etaC_, &M_})
    {
        property->rest();
    }
}


Foam::scalar Foam::viscosityLaw::shearRate
(
    const flowState& flow,
    const label celli
) const
{
    return flow.shearRate
    (
        celli, etaC_.value()/eta_.value(), M_.value()/eta_.value()
    );
}


Foam::tmp<Foam::scalarField> Foam::viscosityLaw::strength
(
    const flowState& flow
) const
{
    return tmp<scalarField>::New(flow.nCells(), Zero);
}


// ************************************************************************* //
