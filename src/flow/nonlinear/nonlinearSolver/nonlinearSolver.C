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

#include "nonlinearSolver.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Relative residual below which fluxes follow the viscosities: further off,
//- steps that foresee it are shortened so much that they get nowhere; and above
//- which they no longer do
static const Foam::scalar nearby = 1e-3;
static const Foam::scalar away = 3e-3;

//- Steps after which the shape of what corners resist stays: it follows
//- rounded viscosities, so in jumps
static const Foam::label cornersFollow = 3;

//- Steps up to which it is seen anew what interfaces are: in yielding cells
//- beside air viscosities and gradients follow each other without end
static const Foam::label interfacesFollow = 6;

//- How often gradients look at the viscosities where those jump, which they
//- follow: in one material, and in several, between which jumps are large, so
//- that what is left of the way would make residuals depend on it
static const Foam::label looksOfOne = 2;
static const Foam::label looksOfMany = 8;

//- Share of the fall that the linear problem foresees with which a step is
//- content, share of the work at its start that may be left against it, and
//- how often it is shortened
static const Foam::scalar enough = 1e-4;
static const Foam::scalar against = 0.5;
static const Foam::label mostCuts = 10;

//- Share of the largest load of friction by which loads may be off, and how
//- often they look at the flow for it
static const Foam::scalar settled = 1e-10;
static const Foam::label mostLooks = 30;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nonlinearSolver::evaluate
(
    const scalarField& x,
    operatorState& s,
    scalarField& r,
    const label looks
)
{
    // For the gradients, then with the viscosities that they make; again where
    // gradients follow jumps of them
    system_.residual(x, true, s, r);
    label n = 0;
    do
    {
        if (lawsFollow_)
        {
            laws_.see(s);
            system_.update();
        }
        frictionOff_ = friction_.see(s);
        system_.residual(x, true, s, r);
        ++n;
    }
    while
    (
        (n < looks && system_.coefficients().anyJump())
     || (n < mostLooks && frictionOff_ > settled)
    );
}


void Foam::nonlinearSolver::holdInterfaces(const bool held)
{
    materials_.holdCuts(held);
    system_.holdInterfaces(held);
}


void Foam::nonlinearSolver::setInterfaces
(
    const scalarField& x,
    operatorState& s,
    scalarField& r
)
{
    holdInterfaces(false);
    evaluate(x, s, r, materials_.size() > 1 ? looksOfMany : looksOfOne);
    if (lawsFollow_ && system_.coefficients().anyJump())
    {
        holdInterfaces(true);
        evaluate(x, s, r);
    }
}


void Foam::nonlinearSolver::updatePreconditioner()
{
    preconditioner_.update();
    if (system_.boundary().maybeFloating())
    {
        motions_.find();
    }
}


Foam::scalar Foam::nonlinearSolver::norm
(
    const scalarField& r,
    const scalarField& weights
)
{
    return Foam::sqrt(gSumSqr(scalarField(r*weights)));
}


Foam::scalar Foam::nonlinearSolver::work
(
    const scalarField& r,
    const scalarField& dx
) const
{
    const label n = system_.nCells();
    scalar sum = 0;
    forAll(r, i)
    {
        sum += i/n == 2 ? 0 : r[i]*dx[i];
    }
    return returnReduce(sum, sumOp<scalar>());
}


Foam::scalar Foam::nonlinearSolver::searchByWork
(
    scalarField& x,
    const scalarField& dx,
    operatorState& s,
    scalarField& r
)
{
    const scalarField start(x);
    const scalar first = work(r, dx);

    // Between a length at which they work for the step and one against it
    scalar low = 0, high = 1, lowWork = first, highWork = -first, length = 1;
    for (label i = 0; i <= mostCuts; ++i)
    {
        x = start + length*dx;
        evaluate(x, s, r);
        const scalar left = work(r, dx);

        if (mag(left) <= against*first || (length == 1 && left > 0))
        {
            break;
        }
        (left > 0 ? low : high) = length;
        (left > 0 ? lowWork : highWork) = left;
        const scalar share = lowWork/(lowWork - highWork);
        length = low + min(max(share, 0.1), 0.9)*(high - low);
    }
    return length;
}


Foam::scalar Foam::nonlinearSolver::searchByResidual
(
    scalarField& x,
    const scalarField& dx,
    operatorState& s,
    scalarField& r
)
{
    const scalarField start(x), weights(system_.weights());
    const scalar before = norm(r, weights);

    scalar length = 1;
    for (label i = 0; i <= mostCuts; ++i)
    {
        x = start + length*dx;
        evaluate(x, s, r);
        if (norm(r, weights) <= (1 - enough*length)*before)
        {
            return length;
        }
        length *= 0.5;
    }

    x = start;
    evaluate(x, s, r);
    return 0;
}


Foam::scalar Foam::nonlinearSolver::search
(
    scalarField& x,
    const scalarField& dx,
    operatorState& s,
    scalarField& r
)
{
    typedef nonlinearControl::searchType type;

    if (control_.search() == type::NONE)
    {
        x += dx;
        evaluate(x, s, r);
        return 1;
    }

    // Where the linear problem is not solved well, or not symmetric, they may
    // work against the step from its start
    return
        control_.search() == type::WORK && work(r, dx) > 0
      ? searchByWork(x, dx, s, r)
      : searchByResidual(x, dx, s, r);
}


void Foam::nonlinearSolver::linearise(const operatorState& s, const bool near)
{
    if (lawsFollow_)
    {
        laws_.linearise(carried_ && control_.carriesStress());
        tangent_.set(s, near);
    }
}


void Foam::nonlinearSolver::foresee(const scalarField& dx)
{
    if (!lawsFollow_)
    {
        return;
    }

    operatorState step(system_.newState());
    scalarField r;
    system_.residual(dx, false, step, r);
    laws_.predict(step);
}


Foam::label Foam::nonlinearSolver::step
(
    scalarField& x,
    operatorState& s,
    scalarField& r
)
{
    const scalar residual = whole(solver_.relative(r));
    const scalar share = control_.share(residual);
    friction_.linearise(s, control_.derivatives());
    updatePreconditioner();

    scalar length = 0;
    label iterations = 0;
    if (control_.derivatives())
    {
        scalarField dx(x.size(), Zero);
        near_ = residual < (near_ ? away : nearby);
        linearise(s, near_);
        iterations =
            solver_.correct(dx, r, share, lawsFollow_ ? &tangent_ : nullptr);
        foresee(dx);

        length = search(x, dx, s, r);
    }
    carried_ = length > 0;
    if (carried_)
    {
        accept(length);
    }
    else
    {
        friction_.linearise(s, false);
        iterations += solver_.correct(x, r, share, nullptr);
        evaluate(x, s, r);
    }
    control_.print(residual, share, iterations, length);

    return iterations;
}


Foam::scalar Foam::nonlinearSolver::whole
(
    const flexibleGMRES::residuals& parts
) const
{
    scalar sqrSum = sqr(frictionOff_);
    for (const scalar part : parts)
    {
        sqrSum += sqr(part);
    }
    return Foam::sqrt(sqrSum);
}


void Foam::nonlinearSolver::solveOne
(
    scalarField& x,
    operatorState& s,
    flexibleGMRES::performance& result,
    const bool last
)
{
    scalarField r;
    near_ = false;
    system_.holdCorners(false);
    setInterfaces(x, s, r);
    result.final = solver_.relative(r);
    if (result.iterations == 0)
    {
        result.initial = result.final;
    }

    control_.start(last);
    for (label n = 1; control_.goOn(whole(result.final)); ++n)
    {
        system_.holdCorners(n > cornersFollow);
        result.iterations += step(x, s, r);
        if (n < interfacesFollow)
        {
            setInterfaces(x, s, r);
        }
        result.final = solver_.relative(r);
    }
    result.converged = whole(result.final) <= control_.tolerance();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonlinearSolver::nonlinearSolver
(
    materialFields& materials,
    cosseratSystem& system,
    flowBoundary& boundary,
    flowPreconditioner& preconditioner,
    rigidMotions& motions,
    flexibleGMRES& solver,
    const dictionary& controls,
    const bool warn
)
:
    materials_(materials),
    system_(system),
    preconditioner_(preconditioner),
    motions_(motions),
    solver_(solver),
    control_
    (
        controls, solver.tolerance(), warn, system.followsFlow(),
        materials.regularised() || boundary.frictional()
    ),
    laws_(materials, system),
    tangent_(system, laws_),
    lawsFollow_(materials.followsFlow()),
    friction_(system, boundary),
    frictionOff_(0),
    carried_(false),
    near_(false),
    continued_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::flexibleGMRES::performance Foam::nonlinearSolver::solve
(
    scalarField& x,
    operatorState& s
)
{
    flexibleGMRES::performance result;
    result.iterations = 0;

    // From the flow alone, as a restart
    if (lawsFollow_)
    {
        laws_.start();
    }
    friction_.start();
    carried_ = false;
    system_.holdCorners(false);
    system_.update();
    if (friction_.active())
    {
        // Walls that move may be all that drives the flow
        scalarField r;
        system_.residual(scalarField(x.size(), Zero), true, s, r);
        friction_.see(s);
    }
    updatePreconditioner();

    if (!solver_.driven())
    {
        return solver_.solve(x, s);
    }
    solver_.removeMotions(x);

    for (const scalar factor : control_.continuation())
    {
        if (factor != 1 && continued_)
        {
            continue;
        }
        if (lawsFollow_)
        {
            materials_.relax(factor);
        }
        friction_.relax(factor);
        solveOne(x, s, result, factor == 1);
    }
    continued_ = true;
    holdInterfaces(false);

    return result;
}


// ************************************************************************* //
