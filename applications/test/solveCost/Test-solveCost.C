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

Application
    Test-solveCost

Description
    Times one flow solve from a zero start against one Poisson solve by
    GAMG-preconditioned CG to 1e-6 on the same mesh in the same process,
    alternating; set-up of both included. The best of several is printed:

        solveCost: cells N flowSeconds F iterations I poissonSeconds P
        poissonIterations J poissonUnits F/P peakMemory K

    The last is that of the process, in kB, on the master.

    The case is one of cosseratPicFoam.

Usage
    Test-solveCost [-repeat n]

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "checkedEntry.H"
#include "creepingFlow.H"
#include "gravityMeshObject.H"
#include "givenFractions.H"
#include "materialPointCloud.H"
#include "clockTime.H"
#include "memInfo.H"
#include "gaussLaplacianScheme.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- Seconds and iterations of -div(grad p) = 1 with p = 0 on one patch
static scalar poisson(const fvMesh& mesh, label& iterations)
{
    wordList types(mesh.boundary().size(), "zeroGradient");
    label nFixed = 0;
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (patch.coupled() || patch.type() == "empty")
        {
            types[patchi] = patch.type();
        }
        else if (nFixed++ == 0)
        {
            types[patchi] = "fixedValue";
        }
    }

    volScalarField p
    (
        IOobject("poisson", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero),
        types
    );
    const volScalarField source
    (
        IOobject("source", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless/dimArea, 1)
    );

    dictionary controls
    (
        IStringStream
        (
            "solver PCG; tolerance 1e-6; relTol 0;"
            "preconditioner { preconditioner GAMG; nVcycles 1;"
            " smoother GaussSeidel; tolerance 1e-10; relTol 0.01; }"
        )()
    );

    clockTime timer;
    const surfaceScalarField gamma
    (
        IOobject("one", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1)
    );
    fv::gaussLaplacianScheme<scalar, scalar> scheme(mesh);
    fvScalarMatrix matrix(scheme.fvmLaplacian(gamma, p) + source);
    iterations = matrix.solve(controls).nIterations();
    return timer.elapsedTime();
}


int main(int argc, char *argv[])
{
    argList::addOption("repeat", "n", "Number of repetitions, default 5");
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const label nRepeat = args.getOrDefault<label>("repeat", 5);
    const label precision = 6;
    Info().precision(precision);

    materialFields materials(mesh);
    #include "createGravity.H"

    scalar flowSeconds = GREAT, poissonSeconds = GREAT;
    label nFlow = 0, nPoisson = 0;

    for (label i = 0; i < nRepeat; ++i)
    {
        creepingFlow flow(materials);
        const surfaceScalarField& phi = flow.phi();

        if (i == 0)
        {
            autoPtr<materialPointCloud> points;
            #include "createPoints.H"
            materials.correct();
        }

        clockTime timer;
        flow.solve();
        flowSeconds = min(flowSeconds, timer.elapsedTime());
        nFlow = flow.performance().iterations;

        poissonSeconds = min(poissonSeconds, poisson(mesh, nPoisson));
    }

    Info<< "solveCost: cells " << returnReduce(mesh.nCells(), sumOp<label>())
        << " flowSeconds " << flowSeconds << " iterations " << nFlow
        << " poissonSeconds " << poissonSeconds
        << " poissonIterations " << nPoisson
        << " poissonUnits " << flowSeconds/poissonSeconds
        << " peakMemory " << memInfo().peak() << nl << endl;

    return 0;
}


// ************************************************************************* //
