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

#include "creepingFlow.H"
#include "checkedEntry.H"
#include "oneLayer.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(creepingFlow, 0);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::creepingFlow::preconditionerControls() const
{
    dictionary controls;
    controls.add("block", word("automatic"));
    controls.add("preconditioner", word("GAMG"));
    controls.add("nVcycles", 2);
    controls.add("nPostSweeps", 1);
    controls.add("nFinestSweeps", 1);
    controls.add("smoother", word("GaussSeidel"));
    controls.add("tolerance", 1e-10);
    controls.add("relTol", 0.01);
    controls.add("maxUses", 0);
    controls.merge(controls_.subOrEmptyDict("preconditioner"));

    return controls;
}


bool Foam::creepingFlow::readGoOn() const
{
    const word choice
    (
        controls_.getOrDefault<word>("notConverged", "error")
    );

    if (choice != "error" && choice != "warn")
    {
        FatalIOErrorInFunction(controls_)
            << "Entry 'notConverged' is " << choice << nl
            << "    Allowed: error, warn" << exit(FatalIOError);
    }

    return choice == "warn";
}


bool Foam::creepingFlow::readCorners() const
{
    const word choice
    (
        controls_.getOrDefault<word>("corners", "automatic")
    );

    if (choice != "automatic" && choice != "off")
    {
        FatalIOErrorInFunction(controls_)
            << "Entry 'corners' is " << choice << nl
            << "    Allowed: automatic, off" << exit(FatalIOError);
    }

    // The singular flow at a corner is known for given walls alone. Rates have
    // no bound at it, so that media beyond their yield stress flow there as if
    // they had none
    return choice == "automatic" && !boundary_.frictional();
}


void Foam::creepingFlow::checkControls() const
{
    const dictionary& solution = mesh_.solutionDict();
    checkedEntry::reportUnread
    (
        solution, {typeName, "solvers", "relaxationFactors", "cache"}
    );
    if (!solution.found(typeName))
    {
        Info<< "No dictionary " << typeName << " in "
            << solution.name().name() << ": all entries have their"
            << " defaults" << nl;
    }

    checkedEntry::only
    (
        controls_,
        {
            "tolerance", "maxIter", "nDirections", "nRecycled",
            "notConverged", "preconditioner", "freeSurfaceStabilisation",
            "corners", "forced", "nonlinear", "stop", "share"
        }
    );
}


void Foam::creepingFlow::printParts() const
{
    materials_.parts().print
    (
        Info,
        readCorners() ? system_.corners().description() : string("off")
    );
    Info<< "Creeping flow" << nl;
}


void Foam::creepingFlow::checkLoads() const
{
    scalar net, magnitude;

    if (system_.pressureFloats())
    {
        results().netInflow(net, magnitude);

        if (mag(net) > 1e-8*magnitude)
        {
            FatalErrorInFunction
                << "The given velocities bring in " << net
                << " m3/s net, with speeds that could bring " << magnitude
                << " m3/s, into a"
                << " closed and incompressible body" << nl
                << "    Allowed: as much out as in, or a patch with given"
                << " p_rgh, or a finite bulk viscosity B" << exit(FatalError);
        }
        if (boundary_.frictionByPressure())
        {
            FatalErrorInFunction
                << "Walls have a friction that follows the pressure, whose"
                << " level is free in a closed and incompressible body" << nl
                << "    Allowed: a patch with given p_rgh, a finite bulk"
                << " viscosity B, or mu 0 of coulombFriction and"
                << " rollingFriction" << exit(FatalError);
        }
    }

    for (label i = 0; i < motions_.size(); ++i)
    {
        const vector direction(motions_.direction(i));
        system_.loads().netForce(direction, net, magnitude);

        if (mag(net) > 1e-6*magnitude)
        {
            FatalErrorInFunction
                << "No wall holds the body along " << direction
                << ", but a net force of " << net << " N acts on it, of "
                << magnitude << " N in all" << nl
                << "    Allowed: tractions and gravity in balance, or a"
                << " velocity given on some patch" << exit(FatalError);
        }
    }
}


void Foam::creepingFlow::report()
{
    ++nSolves_;
    nIterations_ += performance_.iterations;
    maxIterations_ = max(maxIterations_, performance_.iterations);

    const word names[] = {"U", fields_.pRgh().name(), "omega"};

    for (label i = 0; i < system_.layout().nBlocks() - 1; ++i)
    {
        Info<< "FGMRES:  Solving for " << names[i]
            << ", Initial residual = " << performance_.initial[i]
            << ", Final residual = " << performance_.final[i]
            << ", No Iterations " << performance_.iterations << endl;
    }
    if (performance_.rounded > solver_.tolerance())
    {
        Info<< "FGMRES:  Rounded to double precision, as it is written, the"
            << " solution has a residual of " << performance_.rounded << endl;
    }
    stop_.report(Info);
    tellFunctionObjects();

    if (performance_.converged)
    {
        return;
    }

    ++nUnconverged_;

    for (const scalar residual : performance_.final)
    {
        if (!std::isfinite(residual))
        {
            refuseNotFinite();
        }
    }

    if (goOn_)
    {
        WarningInFunction
            << "not converged at time " << mesh_.time().timeName()
            << " after " << performance_.iterations
            << " iterations; going on, since notConverged is warn" << endl;
    }
    else if (belowRounding())
    {
        refuseTolerance();
    }
    else
    {
        refuseUnconverged();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::creepingFlow::creepingFlow(materialFields& materials)
:
    regIOobject
    (
        IOobject
        (
            typeName,
            materials.mesh().time().timeName(),
            materials.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    mesh_(materials.mesh()),
    materials_(materials),
    controls_(mesh_.solutionDict().subOrEmptyDict(typeName)),
    goOn_(readGoOn()),
    fields_(materials),
    frame_(oneLayer::check(mesh_)),
    halo_(mesh_, frame_),
    boundary_
    (
        frame_, halo_, fields_.U(), fields_.pRgh(), fields_.omega(),
        materials.parts().has(sceneParts::MICROROTATION)
    ),
    system_(mesh_, frame_, halo_, boundary_, materials, readCorners()),
    preconditioner_
    (
        flowPreconditioner::New(system_, preconditionerControls())
    ),
    motions_(system_),
    solver_
    (
        (printParts(), system_), preconditioner_(), motions_, controls_
    ),
    stop_(system_, boundary_, fields_, controls_),
    nonlinear_
    (
        materials, system_, boundary_, preconditioner_(), motions_, solver_,
        controls_.subOrEmptyDict("nonlinear"), goOn_
    ),
    state_(system_.newState()),
    nChanges_(0),
    nUnconverged_(0),
    nSolves_(0),
    nIterations_(0),
    maxIterations_(0)
{
    checkControls();
    fields_.check();

    Info<< "    preconditioner " << preconditionerControls();
    Info<< endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::creepingFlow& Foam::creepingFlow::find(const fvMesh& mesh)
{
    const creepingFlow* flow = mesh.findObject<creepingFlow>(typeName);

    if (!flow)
    {
        FatalErrorInFunction
            << "There is no " << typeName << " here, of which this is a result"
            << nl << "    For times already written: cosseratPicFoam"
            << " -postProcess, in place of postProcess" << exit(FatalError);
    }

    return *flow;
}


void Foam::creepingFlow::solve()
{
    boundary_.update();
    solveOnce();

    // What the flow changes of the pressures that are given
    const label most = 100;
    for (label i = 0; boundary_.followsFlow() && boundary_.update(); ++i)
    {
        if (i == most)
        {
            FatalErrorInFunction
                << "p_rgh of total pressures does not come to rest at time "
                << mesh_.time().timeName() << " in " << most << " solves: the"
                << " flow is too fast for the rest to be creeping" << nl
                << "    Allowed: prghPressure and fixedValue"
                << exit(FatalError);
        }
        solveOnce();
    }
}


void Foam::creepingFlow::updateSystem()
{
    system_.updateWalls();

    // As long as no property changes the matrices are those of the last solve
    if
    (
        nChanges_ != materials_.nChanges()
     || materials_.parts().has(sceneParts::MATRICES)
    )
    {
        system_.update();
        preconditioner_->update();

        if (boundary_.maybeFloating())
        {
            motions_.find();
        }
        nChanges_ = materials_.nChanges();
    }
}


void Foam::creepingFlow::solveOnce()
{
    if (system_.followsFlow())
    {
        refuseInWedge();
        // Updates the system as it goes
        system_.updateWalls();
        system_.update();
        checkLoads();
        fields_.pack(system_, x_);
        performance_ = nonlinear_.solve(x_, state_);
        nChanges_ = materials_.nChanges();
    }
    else
    {
        updateSystem();
        checkLoads();
        fields_.pack(system_, x_);
        performance_ =
            solver_.solve(x_, state_, stop_.active() ? &stop_ : nullptr);
    }
    if (mesh_.time().writeTime())
    {
        // A run that is started from there has nothing of the solves before
        solver_.forget();
    }

    // Also without iterations: patch fields wait for it to take new values
    fields_.unpack(system_, boundary_, x_, state_);
    report();
    if (nSolves_ == 1)
    {
        checkPressureWork(power());
    }
}


void Foam::creepingFlow::summary() const
{
    const powerTerms last(power());
    checkPressureWork(last);

    nonlinear_.summary();

    Info<< nl << "Flow: " << nSolves_ << " solves, " << nIterations_
        << " iterations, at most " << maxIterations_ << " in one, "
        << nUnconverged_ << " not converged" << endl;

    Info<< "Power at the end: supplied " << last.gravity + last.walls
        << " W, dissipated " << last.dissipated() << " W";
    if (!last.atRest() && !materials_.parts().has(sceneParts::COMPRESSIBILITY))
    {
        Info<< ", work of the discrete pressure " << 100*last.pressureError()
            << " % of the supply";
        if (last.pressureError() > 0.01)
        {
            Info<< nl << "    It is zero in the limit: cells are coarse for"
                << " this flow";
        }
    }
    Info<< endl;

    if (nUnconverged_)
    {
        WarningInFunction
            << nUnconverged_ << " of " << nSolves_
            << " solves did not converge: do not trust the result" << endl;
    }
}


// ************************************************************************* //
