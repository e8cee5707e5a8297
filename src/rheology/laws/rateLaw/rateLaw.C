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

#include "rateLaw.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::rateLaw::setWeights(const scalar ratio, const scalar R)
{
    slopes_.q = ratio;
    slopes_.b = 2*ratio*sqr(R);

    if (coeffs_.found("cA"))
    {
        const scalar cA =
            checkedEntry::nonNegative("cA", dimless, coeffs_).value();
        slopes_.q = cA*sqr(ratio);
    }
    if (coeffs_.found("cm"))
    {
        const scalar cm =
            checkedEntry::nonNegative("cm", dimless, coeffs_).value();
        slopes_.b = cm*sqr(2*ratio*R);
    }
}


template<class Function>
Foam::scalar Foam::rateLaw::slope
(
    const Function& viscosity,
    const scalar step
)
{
    return log(viscosity(step)/viscosity(-step))/(2*step);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::rateLaw::checkEntries(wordList own) const
{
    own.append(wordList({"etaCRatio", "R", "B", "cA", "cm", "softening"}));
    checkedEntry::only(coeffs_, own);
}


void Foam::rateLaw::setRest()
{
    const scalar ratio =
        checkedEntry::nonNegative("etaCRatio", dimless, coeffs_).value();
    const dimensionedScalar R
    (
        checkedEntry::nonNegative("R", dimLength, coeffs_)
    );

    eta_.value() = viscosity(0, 0, 1);
    etaC_.value() = ratio*eta_.value();
    setM(R);
    setB();
    setWeights(ratio, R.value());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rateLaw::rateLaw(const dictionary& coeffs)
:
    viscosityLaw(coeffs),
    softening_(strainSoftening::New(coeffs)),
    relaxation_(1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rateLaw::correct(const flowState& flow)
{
    // Steps of the differences: half the digits and more are left
    const scalar small = 1e-5;
    const label n = flow.nCells();
    scalarField factor(n);
    slopes_.byRate.setSize(n);
    slopes_.byPressure.setSize(n);
    slopes_.byPressure = 0;

    const scalarField strength
    (
        softening_.valid()
      ? softening_->strength(flow.mesh)
      : tmp<scalarField>(new scalarField(n, 1))
    );

    forAll(factor, celli)
    {
        const scalar rate = flow.shearRate(celli, slopes_.q, slopes_.b);
        const scalar p = flow.p[celli], w = strength[celli];
        const scalar eta = viscosity(rate, p, w);
        factor[celli] = eta/eta_.value();

        // d/d(Gamma^2) = d/d(ln Gamma)/(2 Gamma^2)
        slopes_.byRate[celli] = 0;
        if (sqr(rate) > VSMALL)
        {
            slopes_.byRate[celli] = slope
            (
                [&](const scalar h) { return viscosity((1 + h)*rate, p, w); },
                small
            )/(2*sqr(rate));
        }
        if (followsPressure())
        {
            slopes_.byPressure[celli] = slope
            (
                [&](const scalar h) { return viscosity(rate, p + h, w); },
                small*(mag(p) + eta*rate + VSMALL)
            );
        }
    }
    scale(factor);
}


void Foam::rateLaw::print(Ostream& os) const
{
    os  << ", weights of Gamma^2: " << slopes_.q << " of 4 s^2, "
        << slopes_.b << " m2 of |grad omega|^2";
    if (softening_.valid())
    {
        softening_->print(os);
    }
}


// ************************************************************************* //
