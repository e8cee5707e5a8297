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

#include "discretisationStop.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::discretisationStop::power
(
    const scalarField& dx,
    operatorState& s
) const
{
    // Without the pressure, whose force does no work on what is exact
    const label n = system_.nCells();
    scalarField d(dx);
    SubField<scalar>(d, n, 2*n) = 0;

    scalarField r;
    system_.residual(d, false, s, r);
    SubField<scalar>(r, n, 2*n) = 0;

    return -gSumProd(d, r);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::discretisationStop::discretisationStop
(
    const cosseratSystem& system,
    const materialFields& materials,
    const dictionary& controls
)
:
    system_(system),
    share_(0),
    interval_(0),
    ofCells_(-1),
    change_(-1),
    left_(-1),
    reference_(0),
    stopped_(false)
{
    const word name(controls.getOrDefault<word>("stop", "residual"));
    if (name == "residual")
    {
        return;
    }
    if (name != "discretisation")
    {
        checkedEntry::refuse
        (
            controls, "stop", name, "residual, discretisation"
        );
    }
    if (system.followsFlow())
    {
        checkedEntry::refuse
        (
            controls, "stop", name,
            "residual, since viscosities or walls follow the flow"
        );
    }

    const dictionary coeffs(controls.subOrEmptyDict(name + "Coeffs"));
    checkedEntry::only(coeffs, {"share", "interval"});
    share_ = coeffs.getOrDefault<scalar>("share", 0.1);
    interval_ = coeffs.getOrDefault<label>("interval", 4);
    if (!(share_ > 0 && share_ <= 1) || interval_ < 1)
    {
        FatalIOErrorInFunction(coeffs)
            << "share is " << share_ << ", interval " << interval_ << nl
            << "    Allowed: a share between 0 and 1, an interval of at"
            << " least 1" << exit(FatalIOError);
    }
    indicator_.reset(new strainIndicator(materials));

    Info<< "    stop discretisation, share " << share_ << ", interval "
        << interval_ << nl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::discretisationStop::start(const scalar reference)
{
    reference_ = reference;
    stopped_ = false;
    change_ = -1;
    left_ = -1;
}


bool Foam::discretisationStop::met(const scalarField& dx, operatorState& s)
{
    const scalar before = change_;
    change_ = max(power(dx, s), scalar(0));
    if (before < 0)
    {
        return false;
    }

    const scalar q = Foam::sqrt(change_/max(before, VSMALL));
    left_ = q < 1 ? change_*sqr(q/(1 - q)) : GREAT;

    stopped_ = left_ <= sqr(share_)*ofCells_;

    return stopped_;
}


void Foam::discretisationStop::estimate
(
    const volTensorField& gradU,
    const scalar dissipated
)
{
    const tmp<volVectorField> tgradOmega(indicator_->gradOmega());
    ofCells_ = gSum(indicator_->power(gradU, tgradOmega())());

    const auto relative = [&](const scalar power)
    {
        return Foam::sqrt(power/max(dissipated, VSMALL));
    };
    Info<< "Error of the strains: cells " << relative(ofCells_);
    if (left_ >= 0)
    {
        Info<< ", solve " << relative(left_);
    }
    Info<< " (estimated)" << endl;
}


// ************************************************************************* //
