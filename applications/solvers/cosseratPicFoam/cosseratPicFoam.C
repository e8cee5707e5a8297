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
    cosseratPicFoam

Group
    grpMultiphaseSolvers

Description
    Creeping flow of granular (Cosserat, micropolar) media in a plane, or around
    an axis on a wedge (axialSymmetry.H), with the materials carried by points
    through any deformation, after Dufour, Muehlhaus and Moresi (2001), "A
    particle-in-cell formulation for large deformation in Cosserat continua".

    Each step: move the points (with the flow at mid-step solved first, if the
    points are coupled so), average them onto the mesh, solve for velocity,
    pressure and microrotation. What is written at a time belongs to
    that time, flow and points alike.

Usage
    Input
      - constant/materialProperties: the materials, see materialFields
      - constant/materialPointsProperties: the points, see materialPointCloud;
        without it there are none, and with several materials their fractions
        alpha.\<name\> are read from the start time
      - constant/g: gravity, where a material has a density; constant/hRef: the
        height of p_rgh, see heightReference
      - 0/U, 0/p_rgh, 0/omega (the last where a material has etaC)
      - system/fvSolution, creepingFlow: see creepingFlow
      - system/controlDict: adjustTimeStep and maxCo set the time step by the
        Courant number on the face fluxes

    With -postProcess it runs function objects on times written: points and
    fractions are those of the time, and the flow is solved for them again,
    starting from the one written. -doc says where the manuals are.

SourceFiles
    cosseratPicFoam.C
    checkInput.H
    checkTimeControls.H
    continuedTime.C
    createCaseMesh.H
    createCourantNo.H
    createFields.H
    createGravity.H
    createPoints.H
    manual.H
    progress.H
    solvedFields.H

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "checkedEntry.H"
#include "axialCentres.H"
#include "centreGeometry.H"
#include "checkedText.H"
#include "continuedTime.H"
#include "creepingFlow.H"
#include "gravityMeshObject.H"
#include "givenFractions.H"
#include "materialPointCloud.H"
#include "planarCells.H"
#include "progress.H"
#include "sigFpe.H"
#include "unreadFiles.H"
#include <cstdlib>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static void addNote()
    {
        argList::addNote
        (
            "Creeping flow of Cosserat media, planar or around an axis, with"
            " material points"
        );
    }

    static void addSolveOnce()
    {
        argList::addBoolOption
        (
            "solveOnce",
            "Solve for the flow of the start time and write it there, with the"
            " results of function objects; move no point"
        );
    }

    //- Write the flow of the start, with the results of function objects
    static void writeStart(Time& runTime)
    {
        runTime.writeNow();
        runTime.functionObjects().execute();
        runTime.functionObjects().end();
    }

    //- Move the points for a step and average them on the mesh; where they
    //- move by the flow at mid-step, find that
    static void movePoints
    (
        materialPointCloud& points,
        materialFields& materials,
        creepingFlow& flow,
        const scalar dt,
        progress& done
    )
    {
        if (points.predicts())
        {
            Info<< "Flow at mid-step" << endl;
            points.predict(dt, materials.fractions());
            materials.correct();
            flow.solve();
        }
        points.move(dt);
        done.spent("points");
        points.average(materials.fractions());
        points.report();
    }
}


// * * * * * * * * * * * * * * * * * Main  * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    addNote();

    #include "manual.H"

    #define NO_CONTROL
    #define CREATE_FIELDS solvedFields.H
    #include "postProcess.H"

    #include "addCheckCaseOptions.H"
    addSolveOnce();
    #include "setRootCaseLists.H"
    #include "checkInput.H"
    continuedTime runTime(args);
    #include "createCaseMesh.H"
    #include "createTimeControls.H"
    #include "checkTimeControls.H"

    #include "createFields.H"
    unreadFiles::report(materials, points.valid());
    progress done(runTime);
    const scalar typicalVolume = planarCells::typicalVolume(mesh);
    const scalar typicalSize = planarCells::typicalSize(mesh);
    const axialSymmetry axial(mesh);
    flow.solve();
    if (points.valid())
    {
        points->checkInflow(flow.U(), phi);
    }
    done.spent("flow");

    if (args.found("solveOnce"))
    {
        writeStart(runTime);
    }

    while (!args.found("solveOnce") && runTime.run())
    {
        // Of fields and function objects, the latter in run()
        done.spent("output");

        #include "readTimeControls.H"
        #include "createCourantNo.H"
        const scalar perSecond = CoNum/runTime.deltaTValue();
        #include "setDeltaT.H"
        done.courant(perSecond*runTime.deltaTValue());

        ++runTime;
        Info<< nl << "Time = " << runTime.timeName() << nl << endl;

        if (points.valid())
        {
            movePoints
            (
                points(), materials, flow, runTime.deltaTValue(), done
            );
        }

        materials.correct();
        done.spent("averages");
        flow.solve();
        done.spent("flow");

        runTime.write();
        done.report();
    }

    flow.summary();
    if (points.valid())
    {
        points->summary(materials.fractions());
    }
    done.spent("output");
    done.summary();
    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
