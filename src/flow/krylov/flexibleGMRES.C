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

#include "flexibleGMRES.H"
#include "flowStop.H"
#include "openfoamVersion.H"
#include "PstreamReduceOps.H"
#include "ListOps.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Share of the squared length of a vector that must remain when others are
//- taken out; otherwise the rest is no longer orthogonal to them (with a tenth
//- sheared meshes take 92 iterations instead of 41)
static const Foam::scalar remaining = 0.5;

//- Share of the length of an image that must remain when those before it are
//- taken out; otherwise it is one of them
static const Foam::scalar same = 1e-3;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::flexibleGMRES::weightedResidual
(
    const scalarField& x,
    const bool driven,
    operatorState& s,
    scalarField& r
) const
{
    system_.residual(x, driven, s, r);
    if (tangent_ && !driven)
    {
        tangent_->add(s, r);
    }
    motions_.removeFromResidual(r);
    r *= system_.weights();
}


void Foam::flexibleGMRES::removeMotions(scalarField& x) const
{
    const scalarField& weights = system_.weights();
    const scalarField before(x);

    motions_.removeFromSolution(x);

    // By rounding they are never quite gone: taken out again at a restart, a
    // run would go on from other numbers than the one that was not stopped
    const scalar change = gSumSqr(scalarField((x - before)/weights));
    if (change < sqr(1e-12)*gSumSqr(scalarField(before/weights)))
    {
        x = before;
    }
}


Foam::scalar Foam::flexibleGMRES::atRest() const
{
    operatorState s(system_.newState());
    scalarField r;
    weightedResidual(scalarField(system_.size(), Zero), true, s, r);

    return Foam::sqrt(gSumSqr(r));
}


Foam::flexibleGMRES::residuals Foam::flexibleGMRES::norms
(
    const scalarField& r,
    const scalar reference
) const
{
    const label n = system_.nCells();

    residuals sums;
    sums[0] = sumSqr(SubField<scalar>(r, 2*n, 0));
    sums[1] = sumSqr(SubField<scalar>(r, n, 2*n));
    sums[2] =
        system_.cosserat() ? sumSqr(SubField<scalar>(r, n, 3*n)) : 0;

    forAll(sums, i)
    {
        reduce(sums[i], sumOp<scalar>());
        sums[i] = Foam::sqrt(sums[i])/reference;
    }

    return sums;
}


Foam::scalar Foam::flexibleGMRES::orthogonalise
(
    scalarField& v,
    const label n,
    scalarList& h
) const
{
    // Classical Gram-Schmidt, one reduction a pass, which also gives the
    // length that remains. Another pass where that is small against what was
    // taken away; twice is enough
    scalarList products(n + 1);
    scalar sqrLength = 0;

    for (label pass = 0; pass < 2; ++pass)
    {
        v_.products(v, products);
        Pstream::listCombineGather(products, plusEqOp<scalar>());
        sendListToAll(products);

        const scalar sqrBefore = products[n];
        sqrLength = sqrBefore;
        for (label i = 0; i < n; ++i)
        {
            h[i] += products[i];
            sqrLength -= sqr(products[i]);
            products[i] *= -1;
        }
        v_.add(SubList<scalar>(products, n), v);

        if (sqrLength > remaining*sqrBefore)
        {
            break;
        }
    }
    return Foam::sqrt(max(sqrLength, scalar(0)));
}


void Foam::flexibleGMRES::recycle(operatorState& s, const label nColumns)
{
    recycled_.renew(z_);

    label n = 0;
    for (label j = 0; j < recycled_.size(); ++j)
    {
        scalarField& c = v_[n];
        motions_.removeFromSolution(recycled_[j]);
        weightedResidual(recycled_[j], false, s, c);
        c.negate();

        scalarList h(n, Zero);
        const scalar length = orthogonalise(c, n, h);
        if (length > same*Foam::sqrt(sqr(length) + sumSqr(h)))
        {
            c /= length;
            recycled_.normalise(j, n, h, length);
            ++n;
        }
    }
    recycled_.start(n, nColumns);
}


Foam::label Foam::flexibleGMRES::cycle
(
    scalarField& x,
    const scalarField& r,
    const scalar target,
    const label maxIter,
    operatorState& s,
    flowStop* stop
)
{
    const label m = min(nDirections_, maxIter);
    const scalarField& weights = system_.weights();

    recycle(s, m);
    const label first = recycled_.size();
    scalarList h(first, Zero);
    scalarField& left = v_[first];
    left = r;
    const scalar beta = orthogonalise(left, first, h);
    left /= max(beta, VSMALL);
    recycled_.add(h, x);

    hessenberg problem(m, beta);
    while (problem.size() < m && problem.residual() > target)
    {
        const label k = problem.size(), n = first + k;
        const scalarField unweighted(v_[n]/weights);
        preconditioner_.apply(unweighted, z_[k]);
        motions_.removeFromSolution(z_[k]);

        if
        (
            stop
         && stop->see(problem, recycled_.slowest(), unweighted, z_[k])
        )
        {
            scalarField xk(x), rk;
            recycled_.add(problem.solution(), z_, xk);
            weightedResidual(xk, true, s, rk);
            rk /= weights;
            stop->look(xk, rk, s);
            if (stop->reached())
            {
                break;
            }
        }

        scalarField& v = v_[n + 1];
        weightedResidual(z_[k], false, s, v);
        v.negate();

        h = scalarList(n + 1, Zero);
        const scalar norm = orthogonalise(v, n + 1, h);
        if (norm > 0)
        {
            v /= norm;
        }
        recycled_.setColumn(k, h);
        scalarList own(SubList<scalar>(h, k + 1, first));
        if (!problem.add(own, norm))
        {
            break;
        }
    }
    recycled_.add(problem.solution(), z_, x);
    if (problem.size())
    {
        recycled_.keep(problem);
    }

    return problem.size();
}


Foam::label Foam::flexibleGMRES::takeAway
(
    scalarField& dx,
    scalarField& left,
    const scalar target,
    const label maxIter,
    operatorState& s
)
{
    const scalarField first(left);
    dx = scalarField(first.size(), Zero);
    label iterations = 0;

    while (Foam::sqrt(gSumSqr(left)) > target && iterations < maxIter)
    {
        const label done =
            cycle(dx, left, 0.9*target, maxIter - iterations, s, nullptr);
        iterations += done;
        weightedResidual(dx, false, s, left);
        left += first;

        if (done == 0)
        {
            break;
        }
    }

    return iterations;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flexibleGMRES::flexibleGMRES
(
    const cosseratSystem& system,
    const flowPreconditioner& preconditioner,
    const rigidMotions& motions,
    const dictionary& controls
)
:
    system_(system),
    preconditioner_(preconditioner),
    motions_(motions),
    tolerance_(controls.getOrDefault<scalar>("tolerance", 1e-6)),
    maxIter_(controls.getOrDefault<label>("maxIter", 300)),
    nDirections_(controls.getOrDefault<label>("nDirections", 150)),
    recycled_(controls),
    v_(recycled_.most() + nDirections_ + 1),
    z_(nDirections_),
    tangent_(nullptr)
{
    if (!(tolerance_ > 0 && tolerance_ < 1) || maxIter_ < 1 || nDirections_ < 1)
    {
        FatalIOErrorInFunction(controls)
            << "tolerance is " << tolerance_ << ", maxIter " << maxIter_
            << ", nDirections " << nDirections_ << nl
            << "    Allowed: a tolerance between 0 and 1, the others at"
            << " least 1" << exit(FatalIOError);
    }

    Info<< "    tolerance " << tolerance_ << ", maxIter " << maxIter_
        << ", nDirections " << nDirections_
        << ", nRecycled " << recycled_.most() << nl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::flexibleGMRES::performance Foam::flexibleGMRES::solve
(
    scalarField& x,
    operatorState& s,
    flowStop* stop
)
{
    scalarField r;
    performance result;
    result.iterations = 0;

    weightedResidual(scalarField(x.size(), Zero), true, s, r);
    const scalar reference = Foam::sqrt(gSumSqr(r));

    if (!(reference > VSMALL))
    {
        // Nothing drives the flow: rest is the solution
        x = 0;
        result.converged = reference >= 0;
        result.initial = result.converged ? 0 : reference;
        result.final = result.initial;
        return result;
    }

    removeMotions(x);
    weightedResidual(x, true, s, r);
    scalar residual = Foam::sqrt(gSumSqr(r))/reference;
    result.initial = norms(r, reference);
    if (stop)
    {
        stop->start(s);
    }

    const scalar target = tolerance_*reference;
    while
    (
        residual > tolerance_ && result.iterations < maxIter_
     && (stop || !result.iterations)
    )
    {
        const label done = cycle
        (
            x, r, 0.9*target, maxIter_ - result.iterations, s, stop
        );
        result.iterations += done;

        weightedResidual(x, true, s, r);
        residual = Foam::sqrt(gSumSqr(r))/reference;

        if (done == 0 || (stop && stop->reached()))
        {
            break;
        }
    }

    // What is left may be below what x can hold: it is kept beside it
    scalarField rest;
    if (residual > tolerance_ && result.iterations && !stop)
    {
        result.iterations +=
            takeAway(rest, r, target, maxIter_ - result.iterations, s);
        residual = Foam::sqrt(gSumSqr(r))/reference;
    }

    result.final = norms(r, reference);
    result.converged = residual <= tolerance_ || (stop && stop->reached());
    if (rest.size())
    {
        result.converged = result.converged && rounding(x) <= tolerance_;
        x += rest;
        weightedResidual(x, true, s, r);
        result.rounded = Foam::sqrt(gSumSqr(r))/reference;
    }

    // A reference beyond range leaves zeros
    if (!std::isfinite(residual))
    {
        result.final = residual;
    }

    return result;
}


Foam::label Foam::flexibleGMRES::correct
(
    scalarField& x,
    const scalarField& r,
    const scalar share,
    const viscosityTangent* tangent
)
{
    // Nothing of the step before: more exact along what hardly resists, as a
    // load near its limit has it, steps of Newton's method go too far
    forget();

    operatorState s(system_.newState());
    scalarField left(r), dx;
    motions_.removeFromResidual(left);
    left *= system_.weights();

    tangent_ = tangent;
    const label iterations =
        takeAway(dx, left, share*Foam::sqrt(gSumSqr(left)), maxIter_, s);
    tangent_ = nullptr;

    x += dx;
    return iterations;
}


Foam::flexibleGMRES::residuals Foam::flexibleGMRES::relative
(
    const scalarField& r
) const
{
    scalarField weighted(r);
    motions_.removeFromResidual(weighted);
    weighted *= system_.weights();

    // Where nothing drives the flow there is nothing to compare with
    return norms(weighted, max(atRest(), VSMALL));
}


Foam::scalar Foam::flexibleGMRES::rounding(const scalarField& x) const
{
    operatorState s(system_.newState());
    scalarField r, rd, difference;

    // Up or down by some digits, without a pattern in the mesh
    scalarField other(x);
    unsigned bits = 1;
    for (scalar& value : other)
    {
        bits = 1664525*bits + 1013904223;
        value *= 1 + (bits & 0x80000000 ? 4*SMALL : -4*SMALL);
    }
    const scalarField d(other - x);

    // Of a linear operator that did not round: zero
    weightedResidual(other, true, s, difference);
    weightedResidual(x, true, s, r);
    weightedResidual(d, false, s, rd);
    difference -= r + rd;

    return Foam::sqrt(gSumSqr(difference))/max(atRest(), VSMALL);
}


// ************************************************************************* //
