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
    Test-pointCost

Description
    What the material points of a case cost beside its flow: processor time
    [s] of seeding, and means over a few steps of moving (with all that
    belongs to it), averaging and the flow solve, of the master. Prints

        pointCost: points N seeding S moving M averaging A flow F
        bytes B size Z

    with the memory a point as the growth of the process by its seeding (of
    all processors) and as the size of its object.

    The case is one of cosseratPicFoam; steps are at its maxCo.

Usage
    Test-pointCost [-steps n]

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "checkedEntry.H"
#include "creepingFlow.H"
#include "gravityMeshObject.H"
#include "materialPointCloud.H"
#include "cpuTime.H"
#include "memInfo.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addOption("steps", "n", "Number of steps, default 5");
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const label nSteps = args.getOrDefault<label>("steps", 5);
    const scalar maxCo =
        runTime.controlDict().getOrDefault<scalar>("maxCo", 0.5);

    materialFields materials(mesh);
    #include "createGravity.H"
    creepingFlow flow(materials);
    const surfaceScalarField& phi = flow.phi();

    cpuTime timer;
    const label before = memInfo().rss();
    timer.cpuTimeIncrement();
    materialPointCloud points
    (
        materials.names(), flow.U(), phi, flow.omega(),
        [&]() { return flow.gradU(); }
    );
    const scalar seeding = timer.cpuTimeIncrement();
    const scalar kB =
        returnReduce(scalar(memInfo().rss() - before), sumOp<scalar>());
    const label nPoints = points.nPoints();

    points.average(materials.fractions());
    materials.correct();
    flow.solve();

    scalar moving = 0, averaging = 0, solving = 0;

    for (label i = 0; i < nSteps; ++i)
    {
        const scalarField outflow
        (
            fvc::surfaceSum(mag(phi))().primitiveField()/mesh.V().field()
        );
        runTime.setDeltaT(2*maxCo/gMax(outflow), false);
        ++runTime;

        timer.cpuTimeIncrement();
        points.move(runTime.deltaTValue());
        moving += timer.cpuTimeIncrement()/nSteps;
        points.average(materials.fractions());
        averaging += timer.cpuTimeIncrement()/nSteps;
        materials.correct();
        flow.solve();
        solving += timer.cpuTimeIncrement()/nSteps;
    }

    Info<< "pointCost: points " << nPoints << " seeding " << seeding
        << " moving " << moving << " averaging " << averaging
        << " flow " << solving << " bytes " << 1024*kB/nPoints
        << " size " << label(sizeof(materialPoint)) << nl << endl;

    return 0;
}


// ************************************************************************* //
