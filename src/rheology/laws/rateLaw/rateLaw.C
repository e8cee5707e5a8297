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


Foam::tmp<Foam::scalarField> Foam::rateLaw::softened
(
    const flowState& flow
) const
{
    if (!softening_.valid())
    {
        return tmp<scalarField>::New(flow.nCells(), 1.0);
    }

    tmp<scalarField> tshare(softening_->strength(flow.mesh));
    if (flow.toPlaces)
    {
        flow.toPlaces(tshare.ref());
    }
    return tshare;
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
    scalarField factor;
    at(flow, factor, slopes_);
    scale(factor);
}


bool Foam::rateLaw::at
(
    const flowState& flow,
    scalarField& overRest,
    viscositySlopes& slopes
) const
{
    // Steps of the differences: half the digits and more are left
    const scalar small = 1e-5;
    const label n = flow.nCells();
    overRest.setSize(n);
    slopes.q = slopes_.q;
    slopes.b = slopes_.b;
    slopes.byRate.setSize(n);
    slopes.byPressure.setSize(n);
    slopes.byPressure = 0;

    const scalarField share(softened(flow));

    forAll(overRest, i)
    {
        const scalar rate = flow.shearRate(i, slopes.q, slopes.b);
        const scalar p = flow.p[i], w = share[i];
        const scalar eta = viscosity(rate, p, w);
        overRest[i] = eta/eta_.value();

        // d/d(Gamma^2) = d/d(ln Gamma)/(2 Gamma^2)
        slopes.byRate[i] = 0;
        if (sqr(rate) > VSMALL)
        {
            slopes.byRate[i] = slope
            (
                [&](const scalar h) { return viscosity((1 + h)*rate, p, w); },
                small
            )/(2*sqr(rate));
        }
        if (followsPressure())
        {
            slopes.byPressure[i] = slope
            (
                [&](const scalar h) { return viscosity(rate, p + h, w); },
                small*(mag(p) + eta*rate + VSMALL)
            );
        }
    }
    return true;
}


Foam::tmp<Foam::scalarField> Foam::rateLaw::strength
(
    const flowState& flow
) const
{
    tmp<scalarField> tstrength(softened(flow));
    scalarField& strength = tstrength.ref();
    forAll(strength, i)
    {
        strength[i] *= yieldStress(flow.p[i]);
    }
    return tstrength;
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
