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
    Test-rigidShear

Description
    The benchmark "rigid shear" of Gassmoeller et al. (2019,
    doi 10.1093/gji/ggz405): points carry a density that varies smoothly, and
    drive the flow by its average to the mesh. With X = x + 1/2, Y = y + 1/2

        rho = 2 + sin(pi X) sin(pi Y)
        g = (0, -4 pi^2 cos(pi X) sin(pi Y)/rho)

    the flow of a box -1/2 <= x, y <= 1/2 with free-slip walls and eta = 1 is

        u = (sin(pi X) cos(pi Y), -cos(pi X) sin(pi Y)),
        p = 2 pi cos(pi X) cos(pi Y)

    The density is constant on streamlines, so the flow is steady while the
    points move.

    The case is one of cosseratPicFoam with a field bodyForce, which is
    overwritten, two materials of eta = 1 that do nothing but tell of the
    change, and boxes for cells. Its points have one property, density, of type
    carried and on the mesh. The solution is written as U, p and density, at
    the start time too.

Usage
    Test-rigidShear [-scatter]

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "creepingFlow.H"
#include "materialPointCloud.H"
#include "planarCells.H"
#include "Random.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using constant::mathematical::pi;

//- Density [kg/m3] at a point
static scalar density(const point& p)
{
    return 2 + Foam::sin(pi*(p.x() + 0.5))*Foam::sin(pi*(p.y() + 0.5));
}


//- Gravity [m/s2] along y at a point
static scalar gravity(const point& p)
{
    return
       -4*sqr(pi)*Foam::cos(pi*(p.x() + 0.5))*Foam::sin(pi*(p.y() + 0.5))
       /density(p);
}


//- Put as many points into each cell as before, at random places
static void scatter(materialPointCloud& points, const fvMesh& mesh)
{
    const label perCell = points.size()/mesh.nCells();
    const planarCells cells(mesh);
    Random random(1);

    points.clear();
    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        const boundBox box(cells.corners(celli), false);
        for (label i = 0; i < perCell; ++i)
        {
            point p(box.midpoint());
            p.x() = box.min().x() + random.sample01<scalar>()*box.span().x();
            p.y() = box.min().y() + random.sample01<scalar>()*box.span().y();

            materialPoint& scattered = points.add
            (
                materialPoint(mesh, p, celli, 0, 0, mesh.V()[celli]/perCell)
            );
            points.properties().start(scattered);
        }
    }
}


int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::addBoolOption("scatter", "Points at random places in their cells");
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    materialFields materials(mesh);
    creepingFlow flow(materials);
    materialPointCloud points
    (
        materials.names(), flow.U(), flow.phi(), flow.omega(),
        [&]() { return flow.gradU(); }
    );

    if (args.found("scatter"))
    {
        scatter(points, mesh);
    }

    for (materialPoint& p : points)
    {
        p.values()[0] = density(p.position(mesh));
    }

    const auto& rho = mesh.lookupObject<volScalarField>("density");
    auto& force = mesh.lookupObjectRef<volVectorField>("bodyForce");

    auto solve = [&]()
    {
        points.average(materials.fractions());

        forAll(rho, celli)
        {
            force[celli] =
                vector(0, rho[celli]*gravity(mesh.C()[celli]), 0);
        }
        materials.fractions()[0].primitiveFieldRef() =
            rho.primitiveField() - 2;
        materials.fractions()[1].primitiveFieldRef() =
            3 - rho.primitiveField();

        materials.correct();
        flow.solve();
    };

    solve();
    runTime.writeNow();

    while (runTime.run())
    {
        ++runTime;
        Info<< nl << "Time = " << runTime.timeName() << nl << endl;

        points.move(runTime.deltaTValue());
        points.report();
        solve();
        runTime.write();
    }

    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
