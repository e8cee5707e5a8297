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
#include "StringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::nonlinearControl::methodType>
Foam::nonlinearControl::methodNames
({
    { methodType::STRESS_VELOCITY, "stressVelocity" },
    { methodType::NEWTON, "Newton" },
    { methodType::PICARD, "Picard" }
});


const Foam::Enum<Foam::nonlinearControl::searchType>
Foam::nonlinearControl::searchNames
({
    { searchType::WORK, "work" },
    { searchType::RESIDUAL, "residual" },
    { searchType::NONE, "none" }
});


// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Largest share that a linear solve leaves by Eisenstat and Walker, and that
//- of Picard steps: more accurate ones do not save steps
static const Foam::scalar largestShare = 0.01;

//- Residual at which a rate of regularisation on the way is left for the next:
//- one that is smaller costs steps and saves none of the last rate
static const Foam::scalar onTheWay = 0.1;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nonlinearControl::readInner(const dictionary& dict)
{
    if (!dict.found("inner"))
    {
        return;
    }

    const tokenList& inner =
        dict.lookupEntry("inner", keyType::LITERAL).stream();

    if (inner.size() == 1 && inner[0].isNumber())
    {
        inner_ = inner[0].number();
        if (inner_ > 0 && inner_ < 1)
        {
            return;
        }
    }
    else if
    (
        inner.size() == 1 && inner[0].isWord()
     && inner[0].wordToken() == "EisenstatWalker"
    )
    {
        return;
    }
    checkedEntry::refuse
    (
        dict, "inner",
        inner.size() == 1 && inner[0].isWord()
      ? string(inner[0].wordToken()) : Foam::name(inner_),
        "EisenstatWalker, or a number above 0 and below 1"
    );
}


void Foam::nonlinearControl::check
(
    const dictionary& dict,
    const bool needed
) const
{
    if (!(tolerance_ > 0 && tolerance_ < 1))
    {
        checkedEntry::refuse
        (
            dict, "tolerance", Foam::name(tolerance_), "above 0 and below 1"
        );
    }
    if (maxIter_ < 1)
    {
        checkedEntry::refuse
        (
            dict, "maxIter", Foam::name(maxIter_), "one or more"
        );
    }
    if (nPicard_ < 0)
    {
        checkedEntry::refuse
        (
            dict, "nPicard", Foam::name(nPicard_), "zero or more"
        );
    }
    for (const scalar factor : continuation_)
    {
        if (!(factor > 0))
        {
            checkedEntry::refuse
            (
                dict, "continuation", Foam::name(factor), "factors above zero"
            );
        }
    }
    if (continuation_.size() > 1 && needed && !regularised_)
    {
        OStringStream found;
        found << flatOutput(continuation_);
        checkedEntry::refuse
        (
            dict, "continuation", found.str(),
            "(1), as no law and no wall here has a rate of regularisation"
        );
    }
    if (continuation_.empty() || continuation_.last() != 1)
    {
        checkedEntry::refuse
        (
            dict, "continuation", "a list that does not end with 1",
            "factors of which the last is 1"
        );
    }
}


void Foam::nonlinearControl::giveUp(const scalar residual)
{
    ++nUnconverged_;
    if (!warn_)
    {
        FatalErrorInFunction
            << "Flow and materials do not agree after " << n_ - 1
            << " steps, nonlinear residual "
            << residual << " instead of " << asked_ << nl
            << "    Cures, in system/fvSolution, creepingFlow: in nonlinear"
            << " more nPicard,"
            << (regularised_ ? " a continuation such as (100 10 1)," : "")
            << " a larger maxIter or tolerance, a smaller number as inner; or"
            << " notConverged warn, to go on all the same" << exit(FatalError);
    }
    WarningInFunction
        << "flow and materials do not agree, nonlinear residual "
        << residual
        << "; going on, since notConverged is warn" << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonlinearControl::nonlinearControl
(
    const dictionary& dict,
    const scalar linearTolerance,
    const bool warn,
    const bool needed,
    const bool regularised
)
:
    method_(methodNames.getOrDefault("method", dict, methodType::NEWTON)),
    tolerance_
    (
        dict.getOrDefault<scalar>("tolerance", linearTolerance)
    ),
    maxIter_(dict.getOrDefault<label>("maxIter", 100)),
    nPicard_(dict.getOrDefault<label>("nPicard", 0)),
    inner_(0),
    search_
    (
        searchNames.getOrDefault("lineSearch", dict, searchType::WORK)
    ),
    continuation_
    (
        dict.getOrDefault<scalarList>("continuation", scalarList(1, 1.0))
    ),
    warn_(warn),
    regularised_(regularised),
    asked_(tolerance_),
    n_(0),
    lastResidual_(0),
    lastShare_(0),
    nSolves_(0),
    nSteps_(0),
    most_(0),
    nUnconverged_(0)
{
    checkedEntry::only
    (
        dict,
        {
            "method", "tolerance", "maxIter", "nPicard", "inner",
            "lineSearch", "continuation"
        }
    );
    readInner(dict);
    check(dict, needed);

    if (needed)
    {
        Info<< "    nonlinear " << methodNames[method_] << ", tolerance "
            << tolerance_ << ", maxIter " << maxIter_ << ", nPicard "
            << nPicard_ << ", inner ";
        if (inner_ > 0)
        {
            Info<< inner_;
        }
        else
        {
            Info<< "EisenstatWalker";
        }
        Info<< ", lineSearch " << searchNames[search_] << ", continuation "
            << flatOutput(continuation_) << nl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nonlinearControl::start(const bool last)
{
    asked_ = last ? tolerance_ : max(tolerance_, onTheWay);
    n_ = 0;
    lastResidual_ = 0;
    ++nSolves_;
}


bool Foam::nonlinearControl::goOn(const scalar residual)
{
    ++n_;

    if (residual <= asked_)
    {
        return false;
    }
    if (n_ > maxIter_)
    {
        giveUp(residual);
        return false;
    }

    ++nSteps_;
    most_ = max(most_, n_);
    return true;
}


Foam::scalar Foam::nonlinearControl::share(const scalar residual)
{
    // Choice 2 of Eisenstat and Walker (1996), with their safeguard; never
    // far more accurate than what is asked for
    scalar share = largestShare;
    if (inner_ > 0)
    {
        share = inner_;
    }
    else if (derivatives() && lastResidual_ > 0)
    {
        share = 0.9*sqr(residual/lastResidual_);
        const scalar safe = 0.9*sqr(lastShare_);
        if (safe > 0.1)
        {
            share = max(share, safe);
        }
        share = min(max(share, 0.3*tolerance_/residual), largestShare);
    }
    lastResidual_ = residual;
    lastShare_ = share;
    return share;
}


void Foam::nonlinearControl::print
(
    const scalar residual,
    const scalar share,
    const label iterations,
    const scalar length
) const
{
    Info<< "Nonlinear: step " << n_
        << (derivatives() ? ", Newton" : ", Picard")
        << ", residual = " << residual << ", inner tolerance = " << share
        << ", No Iterations " << iterations << ", step length = " << length
        << endl;
}


void Foam::nonlinearControl::summary() const
{
    if (nSolves_)
    {
        Info<< nl << "Nonlinear: " << nSolves_ << " solves, " << nSteps_
            << " steps, at most " << most_ << " in one, " << nUnconverged_
            << " not converged" << endl;
    }
}


// ************************************************************************* //
