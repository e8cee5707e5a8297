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

//- Share of the fall that the linear problem foresees with which a step is
//- content, and how often it is halved
static const Foam::scalar enough = 1e-4;
static const Foam::label mostHalvings = 10;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nonlinearSolver::evaluate
(
    const scalarField& x,
    operatorState& s,
    scalarField& r
)
{
    // For the gradients, then with the viscosities that they make
    system_.residual(x, true, s, r);
    laws_.see(s);
    system_.update();
    system_.residual(x, true, s, r);
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


Foam::scalar Foam::nonlinearSolver::search
(
    scalarField& x,
    const scalarField& dx,
    operatorState& s,
    scalarField& r
)
{
    const scalarField start(x), first(r), weights(system_.weights());
    const scalar before = norm(r, weights);

    scalar length = 1;
    for (label i = 0; i <= mostHalvings; ++i)
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


Foam::label Foam::nonlinearSolver::step
(
    scalarField& x,
    operatorState& s,
    scalarField& r
)
{
    const scalar residual = whole(solver_.relative(r));
    const scalar share = control_.share(residual);
    updatePreconditioner();

    scalar length = 0;
    label iterations = 0;
    if (control_.derivatives())
    {
        tangent_.set(s);
        scalarField dx(x.size(), Zero);
        iterations = solver_.correct(dx, r, share, &tangent_);

        if (control_.search())
        {
            length = search(x, dx, s, r);
        }
        else
        {
            length = 1;
            x += dx;
            evaluate(x, s, r);
        }
    }
    if (length == 0)
    {
        iterations += solver_.correct(x, r, share, nullptr);
        evaluate(x, s, r);
    }
    control_.print(residual, share, iterations, length);

    return iterations;
}


Foam::scalar Foam::nonlinearSolver::whole
(
    const flexibleGMRES::residuals& parts
)
{
    scalar sqrSum = 0;
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
    flexibleGMRES::performance& result
)
{
    scalarField r;
    evaluate(x, s, r);
    result.final = solver_.relative(r);
    if (result.iterations == 0)
    {
        result.initial = result.final;
    }

    control_.start();
    while (control_.goOn(whole(result.final)))
    {
        result.iterations += step(x, s, r);
        result.final = solver_.relative(r);
    }
    result.converged = whole(result.final) <= control_.tolerance();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonlinearSolver::nonlinearSolver
(
    materialFields& materials,
    cosseratSystem& system,
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
    control_(controls, solver.tolerance(), warn, materials.followsFlow()),
    laws_(materials, system),
    tangent_(system, laws_),
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
    laws_.start();
    system_.update();
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
        materials_.relax(factor);
        solveOne(x, s, result);
    }
    continued_ = true;

    return result;
}


// ************************************************************************* //
