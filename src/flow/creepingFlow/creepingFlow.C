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
#include "checkedText.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(creepingFlow, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static IOobject fieldIO
    (
        const word& name,
        const fvMesh& mesh,
        const IOobject::readOption read
    )
    {
        return IOobject
        (
            name, mesh.time().timeName(), mesh, read, IOobject::AUTO_WRITE
        );
    }

    //- Of a field that is read to be copied
    static IOobject inputIO
    (
        const word& name,
        const fvMesh& mesh,
        const IOobject::readOption read = IOobject::MUST_READ
    )
    {
        return IOobject
        (
            name, mesh.time().timeName(), mesh, read, IOobject::NO_WRITE, false
        );
    }

    //- A field of the start time. The log says which: not all errors of
    //- OpenFOAM do
    template<class Type>
    static GeometricField<Type, fvPatchField, volMesh> readField
    (
        const word& name,
        const fvMesh& mesh
    )
    {
        const IOobject io(inputIO(name, mesh));
        Info<< "Reading " << (io.instance()/name).c_str() << endl;
        const checkedText text(io.objectPath());

        return GeometricField<Type, fvPatchField, volMesh>(io, mesh);
    }

    //- The values beyond coupled patches; others are set by the system
    static void evaluateCoupled(volScalarField& field)
    {
        const Pstream::commsTypes type = Pstream::commsTypes::nonBlocking;
        const label startOfRequests = Pstream::nRequests();

        for (fvPatchScalarField& pf : field.boundaryFieldRef())
        {
            if (pf.coupled())
            {
                pf.initEvaluate(type);
            }
        }
        Pstream::waitRequests(startOfRequests);
        for (fvPatchScalarField& pf : field.boundaryFieldRef())
        {
            if (pf.coupled())
            {
                pf.evaluate(type);
            }
        }
    }
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
    controls.add("maxUses", 8);
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

    // The singular flow at a corner is known for given walls alone. Rates have no
    // bound at it, so that media beyond their yield stress flow there as if they
    // had none
    return choice == "automatic" && !boundary_.frictional();
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


Foam::volScalarField Foam::creepingFlow::readOmega
(
    const materialFields& materials
)
{
    // Where nothing solves for it a file is read all the same, so that what
    // its patches ask for in vain can be told
    const fvMesh& mesh = materials.mesh();
    IOobject io(inputIO("omega", mesh));

    if
    (
        materials.parts().has(sceneParts::MICROROTATION)
     || io.typeHeaderOk<volScalarField>(true)
    )
    {
        return readField<scalar>("omega", mesh);
    }

    return volScalarField
    (
        inputIO("omega", mesh, IOobject::NO_READ),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero),
        "calculated"
    );
}


template<class FieldType>
void Foam::creepingFlow::checkField
(
    const FieldType& field,
    const dimensionSet& dims
) const
{
    const dictionary file(fileName(field.objectPath()));

    if (field.dimensions() != dims)
    {
        FatalIOErrorInFunction(file)
            << "Entry 'dimensions' is " << field.dimensions() << nl
            << "    Allowed: " << dims << exit(FatalIOError);
    }

    for (const auto& value : field.primitiveField())
    {
        if (!checkedEntry::inRange(mag(value)))
        {
            FatalIOErrorInFunction(file)
                << "Entry 'internalField' has the value " << value << nl
                << "    Allowed: up to " << checkedEntry::largest
                << exit(FatalIOError);
        }
    }
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


void Foam::creepingFlow::pack()
{
    const label n = system_.nCells();
    const bool first = x_.size() != system_.size();
    x_.setSize(system_.size());

    SubList<scalar>(x_, n, 0) = U_.primitiveField().component(frame_.i0())();
    SubList<scalar>(x_, n, n) = U_.primitiveField().component(frame_.i1())();
    if (first)
    {
        // A solution read is taken to the heights of the system; a uniform
        // field is none, and as good a guess there
        const scalarField& pRgh = pRgh_.primitiveField();
        SubField<scalar> p(x_, n, 2*n);
        p = pRgh;
        if (gMax(pRgh) > gMin(pRgh))
        {
            p = pRgh + system_.loads().fromPRgh();
        }
    }

    if (system_.cosserat())
    {
        SubList<scalar>(x_, n, 3*n) = omega_.primitiveField();
        for (label celli = 0; celli < n; ++celli)
        {
            if (system_.rotationUndetermined(celli))
            {
                x_[3*n + celli] = 0;
            }
        }
    }
}


void Foam::creepingFlow::setPRgh()
{
    SubField<scalar> p(x_, system_.nCells(), 2*system_.nCells());
    const scalarField& from = system_.loads().fromPRgh();

    // A restart has what p_rgh leaves of the pressure: so has the run that is
    // not stopped, as long as it leaves most of the digits
    const bool near = gMax(mag(from)) < 1e3*gMax(mag(p));
    bool changed = false;

    forAll(from, celli)
    {
        scalar& pRgh = pRgh_[celli];
        if (pRgh + from[celli] != p[celli])
        {
            pRgh = p[celli] - from[celli];
            const scalar left = pRgh + from[celli];
            changed = changed || left != p[celli];
            if (near)
            {
                p[celli] = left;
            }
        }
    }

    if (near && returnReduce(changed, orOp<bool>()))
    {
        scalarField r;
        system_.residual(x_, true, state_, r);
    }
}


void Foam::creepingFlow::unpack()
{
    setPRgh();

    const label n = system_.nCells();
    const systemResults results(this->results());

    forAll(U_, celli)
    {
        U_[celli] = frame_.inSpace(state_.u[celli]);
        omega_[celli] =
            system_.cosserat() && !system_.rotationUndetermined(celli)
          ? x_[3*n + celli]
          : 0.5*state_.curl(celli);
    }

    p_.primitiveFieldRef() =
        SubField<scalar>(x_, n, 2*n) + system_.loads().rhoGh();

    // Coupled patches by evaluation, then the others as the system has them
    U_.correctBoundaryConditions();
    omega_.correctBoundaryConditions();
    evaluateCoupled(pRgh_);
    p_.correctBoundaryConditions();

    for (const label patchi : boundary_.patches())
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const labelUList& cells = patch.faceCells();

        vectorField Ub(patch.size());
        scalarField omegab(patch.size()), pRghb(patch.size()), pb(patch.size());
        forAll(patch, i)
        {
            const label slot = halo_.start(patchi) + i;
            Ub[i] = results.boundaryVelocity(slot);
            omegab[i] = omega_[cells[i]];
            if (system_.cosserat())
            {
                // What is given stays so for the material that may come
                if (boundary_.rotationFixed(boundary_.at(slot)))
                {
                    omegab[i] = boundary_.rotation(boundary_.at(slot));
                }
                else if (!system_.rotationUndetermined(cells[i]))
                {
                    omegab[i] = results.boundaryRotation(slot);
                }
            }
            const scalar p = results.boundaryPressure(slot);
            pb[i] = p + results.boundaryRhoGh(slot);
            pRghb[i] =
                boundary_.pressureFixed(boundary_.at(slot))
              ? boundary_.pressure(boundary_.at(slot))
              : p - system_.loads().fromPRgh()[cells[i]];
        }

        U_.boundaryFieldRef()[patchi] == Ub;
        omega_.boundaryFieldRef()[patchi] == omegab;
        pRgh_.boundaryFieldRef()[patchi] == pRghb;
        p_.boundaryFieldRef()[patchi] == pb;
    }

    results.getFluxes(phi_);
}


void Foam::creepingFlow::report()
{
    ++nSolves_;
    nIterations_ += performance_.iterations;
    maxIterations_ = max(maxIterations_, performance_.iterations);

    const word names[] = {"U", pRgh_.name(), "omega"};

    for (label i = 0; i < system_.layout().nBlocks() - 1; ++i)
    {
        Info<< "FGMRES:  Solving for " << names[i]
            << ", Initial residual = " << performance_.initial[i]
            << ", Final residual = " << performance_.final[i]
            << ", No Iterations " << performance_.iterations << endl;
    }
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
        FatalErrorInFunction
            << "Flow not converged at time " << mesh_.time().timeName()
            << " after " << performance_.iterations << " iterations:"
            << " residuals of U, p_rgh, omega " << performance_.final << nl
            << "    Largest etaC/eta "
            << system_.coefficients().largestCoupling()
            << ", largest jump of eta between cells "
            << system_.coefficients().largestJump() << nl
            << "    Mesh: distances to neighbours up to "
            << system_.faces().largestAspect() << " : 1, faces up to "
            << system_.faces().largestAngle()
            << " degrees from the path through them" << nl
            << "    Cures, in system/fvSolution, creepingFlow: a larger"
            << " maxIter or nDirections, block whole in preconditioner, a"
            << " larger tolerance; or notConverged warn, to go on"
            << " regardless." << nl
            << "    In the scene: cells nearer to squares (from about 10 : 1"
            << " and 45 degrees on they cost iterations), a smaller etaC/eta or"
            << " contrast (beyond 1e3 and 1e6 the flow hardly depends on"
            << " them)" << exit(FatalError);
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
    U_
    (
        fieldIO("U", mesh_, IOobject::NO_READ),
        readField<vector>("U", mesh_)
    ),
    pRgh_
    (
        fieldIO("p_rgh", mesh_, IOobject::NO_READ),
        readField<scalar>("p_rgh", mesh_)
    ),
    p_
    (
        fieldIO("p", mesh_, IOobject::NO_READ),
        mesh_,
        dimensionedScalar(dimPressure, Zero),
        "calculated"
    ),
    omega_(fieldIO("omega", mesh_, IOobject::NO_READ), readOmega(materials)),
    phi_
    (
        fieldIO("phi", mesh_, IOobject::NO_READ),
        mesh_,
        dimensionedScalar(dimVolume/dimTime, Zero)
    ),
    frame_(mesh_),
    halo_(mesh_, frame_),
    boundary_
    (
        frame_, halo_, U_, pRgh_, omega_,
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
    // Lest decomposing a written time leaves out the signs of turned faces
    phi_.setOriented();

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
            "tolerance", "maxIter", "nDirections", "notConverged",
            "preconditioner", "freeSurfaceStabilisation", "corners", "forced",
            "nonlinear"
        }
    );
    checkField(U_, dimVelocity);
    checkField(pRgh_, dimPressure);
    checkField(omega_, dimless/dimTime);

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
        pack();
        performance_ = nonlinear_.solve(x_, state_);
        nChanges_ = materials_.nChanges();
    }
    else
    {
        updateSystem();
        checkLoads();
        pack();
        performance_ = solver_.solve(x_, state_);
    }
    // Also without iterations: patch fields wait for it to take new values
    unpack();
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
