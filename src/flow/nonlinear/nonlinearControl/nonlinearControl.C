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

#include "nonlinearControl.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonlinearControl::nonlinearControl
(
    const dictionary& dict,
    const scalar linearTolerance,
    const bool warn,
    const bool needed
)
:
    tolerance_
    (
        dict.getOrDefault<scalar>("tolerance", max(1e-5, linearTolerance))
    ),
    maxIter_(dict.getOrDefault<label>("maxIter", 100)),
    warn_(warn),
    n_(0),
    nSteps_(0),
    nSolves_(0),
    most_(0),
    nUnconverged_(0)
{
    checkedEntry::only(dict, {"tolerance", "maxIter"});

    if (!(tolerance_ >= linearTolerance && tolerance_ < 1))
    {
        checkedEntry::refuse
        (
            dict, "tolerance", Foam::name(tolerance_),
            "from the tolerance of creepingFlow, " + Foam::name(linearTolerance)
          + ", to below 1"
        );
    }
    if (maxIter_ < 1)
    {
        checkedEntry::refuse
        (
            dict, "maxIter", Foam::name(maxIter_), "one or more"
        );
    }

    if (needed)
    {
        Info<< "    nonlinear tolerance " << tolerance_ << ", maxIter "
            << maxIter_ << nl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nonlinearControl::start()
{
    n_ = 0;
    ++nSteps_;
}


bool Foam::nonlinearControl::goOn(const scalar initialResidual)
{
    ++n_;
    ++nSolves_;
    most_ = max(most_, n_);

    Info<< "Nonlinear: solve " << n_ << " began with residual "
        << initialResidual << endl;

    if (initialResidual <= tolerance_)
    {
        return false;
    }
    if (n_ < maxIter_)
    {
        return true;
    }

    ++nUnconverged_;
    if (!warn_)
    {
        FatalErrorInFunction
            << "Flow and materials do not agree after " << n_
            << " solves: nonlinear residual " << initialResidual
            << " instead of " << tolerance_ << nl
            << "    Cures, in system/fvSolution, creepingFlow: a larger"
            << " maxIter or tolerance in nonlinear; or notConverged warn, to"
            << " go on all the same" << exit(FatalError);
    }
    WarningInFunction
        << "flow and materials do not agree after " << n_
        << " solves; going on, since notConverged is warn" << endl;

    return false;
}


void Foam::nonlinearControl::summary() const
{
    if (nSteps_)
    {
        Info<< nl << "Nonlinear: " << nSteps_ << " steps, " << nSolves_
            << " solves, at most " << most_ << " in one, " << nUnconverged_
            << " not converged" << endl;
    }
}


// ************************************************************************* //
