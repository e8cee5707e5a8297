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

#include "flowStop.H"
#include "materialFields.H"
#include "systemResults.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::flowStop::mostOfMesh = 0.01;


// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Power of a first guess over that of its error, where it is none
static const Foam::scalar atRest = 1e-3;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::flowStop::readActive(const dictionary& controls)
{
    const word choice(controls.getOrDefault<word>("stop", "tolerance"));

    if (choice != "tolerance" && choice != "discretisation")
    {
        FatalIOErrorInFunction(controls)
            << "Entry 'stop' is " << choice << nl
            << "    Allowed: tolerance, discretisation" << exit(FatalIOError);
    }
    return choice == "discretisation";
}


Foam::scalar Foam::flowStop::weightPower(const scalarField& r) const
{
    return mag
    (
        gSumProd
        (
            system_.loads().rhoGh(), scalarField(system_.layout().p(r))
        )
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowStop::flowStop
(
    const cosseratSystem& system,
    const flowBoundary& boundary,
    flowFields& fields,
    const dictionary& controls
)
:
    system_(system),
    boundary_(boundary),
    fields_(fields),
    active_(readActive(controls)),
    share_(controls.getOrDefault<scalar>("share", 0.1)),
    dissipated_(0),
    mesh_(mostOfMesh),
    reached_(false)
{
    if (!(share_ > 0 && share_ <= 1))
    {
        FatalIOErrorInFunction(controls)
            << "Entry 'share' is " << share_ << nl
            << "    Allowed: above 0, at most 1" << exit(FatalIOError);
    }
    if (!active_)
    {
        return;
    }
    if (system.followsFlow())
    {
        FatalIOErrorInFunction(controls)
            << "Entry 'stop' is discretisation, but materials or walls follow"
            << " the flow: steps of Newton's method end by their residual" << nl
            << "    Allowed: stop tolerance" << exit(FatalIOError);
    }
    indicator_.reset(new strainIndicator(system.materials()));

    Info<< "    stop at " << share_ << " of the error of the mesh, or at the"
        << " tolerance" << nl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::flowStop::start(const operatorState& s)
{
    const powerTerms power(systemResults(system_, s).power());

    // In cells that are stiff now and were soft the flow before dissipates far
    // too much. What it is supplied with is nearer
    dissipated_ = mag(power.gravity + power.walls);
    mesh_ = mostOfMesh;
    reached_ = false;
}


bool Foam::flowStop::see
(
    hessenberg& problem,
    const scalar slowest,
    const scalarField& v,
    const scalarField& z
)
{
    error_.see(problem, slowest, v, z);
    if (problem.size() == 0 && !(dissipated_ > atRest*error_()))
    {
        // The first guess says nothing of the flow: its error is the flow
        dissipated_ = errorPower::mostSmallest*error_();
    }
    return error_() <= allowed();
}


void Foam::flowStop::look
(
    scalarField& x,
    const scalarField& r,
    operatorState& s
)
{
    const scalar weight = weightPower(r);
    if (weight > share()*dissipated_)
    {
        return;
    }
    fields_.unpack(system_, boundary_, x, s);

    const systemResults results(system_, s);
    const powerTerms power(results.power());
    dissipated_ = power.viscous + power.bending;
    mesh_ =
        gSum(indicator_->power(results.gradU(), indicator_->gradOmega()))
       /max(dissipated_, VSMALL);

    reached_ = error_() <= allowed() && weight <= share()*dissipated_;
}


void Foam::flowStop::report(Ostream& os) const
{
    if (reached_)
    {
        os  << "FGMRES:  Stopped at relative error of the power: iterations "
            << Foam::sqrt(error_()/dissipated_) << ", indicator of the mesh "
            << mesh_ << ", share " << share_ << endl;
    }
}


// ************************************************************************* //
