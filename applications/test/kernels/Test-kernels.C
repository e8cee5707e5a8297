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

Application
    Test-kernels

Description
    Kernels of the libraries alone, each by its name. What it gives is written
    to a file of that name in the case (of each processor its own), numbers in
    rows; tests/test_kernels.py knows what they have to be.

    cells: of each cell the number of corners, then x and y of each.

    halo: for each face of coupled patches x and y of the centre of its cell,
    then what haloExchange brings from the other side, where each cell has sent
    the scalar x + 10 y, the vector (x, y) and the tensor (xx, xy, yx, yy) of
    its centre.

    velocity: points at random places in the cells; of each its cell, x, y, the
    velocity there and its divergence by differences; then the sum of the
    fluxes of the cell over its volume. The fluxes are those of the velocity U
    of the case, or, with -linear (a b c d), those of

        u = a x + b y,   v = c x + d y.

    Of a wedge with its axis along x the divergence is that in space.

    average: half of the points of the case, chosen at random; of each its
    cell, x, y, volume, and the average of its cell of the values x + 10 y of
    the points.

    corner: exponents of the singular solutions at a corner; sectors and holds
    as in cornerFlow are read from the file wedge.

Usage
    Test-kernels <kernel> [-linear (a b c d)]

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "axialCentres.H"
#include "cornerFlow.H"
#include "haloExchange.H"
#include "IFstream.H"
#include "materialPointCloud.H"
#include "oneLayer.H"
#include "OFstream.H"
#include "planarCells.H"
#include "planarFrame.H"
#include "pointVelocity.H"
#include "Random.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- Step of differences over the size of a cell
static const scalar tiny = 1e-4;


static void testCells(const fvMesh& mesh, Ostream& os)
{
    const planarCells cells(mesh);
    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        const pointField corners(cells.corners(celli));
        os  << corners.size();
        for (const point& p : corners)
        {
            os  << ' ' << p.x() << ' ' << p.y();
        }
        os  << nl;
    }
}


static void testHalo(const fvMesh& mesh, Ostream& os)
{
    const planarFrame frame(mesh);
    const haloExchange halo(mesh, frame);

    scalarField s(halo.size(), Zero);
    Field<vector2D> v(halo.size(), Zero);
    Field<tensor2D> T(halo.size(), Zero);
    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        const vector2D C(frame.inPlane(mesh.C()[celli]));
        s[celli] = C.x() + 10*C.y();
        v[celli] = C;
        T[celli] = C*C;
    }
    halo.swap(s, v, T);

    for (const label patchi : halo.coupledPatches())
    {
        const labelUList& owners = mesh.boundary()[patchi].faceCells();
        forAll(owners, i)
        {
            const point& C = mesh.C()[owners[i]];
            os  << C.x() << ' ' << C.y();
            const label slot = halo.start(patchi) + i;
            os  << ' ' << s[slot] << ' ' << v[slot].x() << ' ' << v[slot].y()
                << ' ' << T[slot].xx() << ' ' << T[slot].xy()
                << ' ' << T[slot].yx() << ' ' << T[slot].yy() << nl;
        }
    }
}


//- Fluxes of a linear velocity
static tmp<surfaceScalarField> linearFlux
(
    const fvMesh& mesh,
    const FixedList<scalar, 4>& A
)
{
    auto tphi = surfaceScalarField::New
    (
        "phi",
        mesh,
        dimensionedScalar(dimVolume/dimTime, Zero)
    );
    const auto flux = [&](const point& C, const vector& Sf)
    {
        return
            (A[0]*C.x() + A[1]*C.y())*Sf.x()
          + (A[2]*C.x() + A[3]*C.y())*Sf.y();
    };

    surfaceScalarField& phi = tphi.ref();
    forAll(phi, facei)
    {
        phi[facei] = flux(mesh.Cf()[facei], mesh.Sf()[facei]);
    }
    forAll(phi.boundaryField(), patchi)
    {
        const vectorField& Cf = mesh.Cf().boundaryField()[patchi];
        const vectorField& Sf = mesh.Sf().boundaryField()[patchi];
        if (oneLayer::isPlane(mesh.boundaryMesh()[patchi]))
        {
            continue;
        }
        forAll(phi.boundaryField()[patchi], i)
        {
            phi.boundaryFieldRef()[patchi][i] = flux(Cf[i], Sf[i]);
        }
    }

    return tphi;
}


//- A random place in a polygon: a mean of its corners
static point randomPlace(const UList<point>& corners, Random& random)
{
    point p(Zero);
    scalar sum = 0;
    for (const point& corner : corners)
    {
        const scalar weight = random.sample01<scalar>();
        p += weight*corner;
        sum += weight;
    }

    return p/sum;
}


static void testVelocity
(
    const volVectorField& U,
    const surfaceScalarField& phi,
    const dictionary& dict,
    Ostream& os
)
{
    const fvMesh& mesh = U.mesh();
    autoPtr<pointVelocity> velocity = pointVelocity::New(dict, U, phi);
    velocity->update();

    const volScalarField net(fvc::div(phi));
    const planarCells cells(mesh);
    const bool axial = cells.axial().active();
    Random random(1);

    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        const pointField corners(cells.corners(celli));
        const scalar h = tiny*boundBox(corners, false).mag();

        for (label i = 0; i < 5; ++i)
        {
            const point p(randomPlace(corners, random));
            const auto value = [&](const vector& away)
            {
                return velocity->value(particle(mesh, p + away, celli));
            };
            const vector dx(h, 0, 0), dy(0, h, 0);
            const vector u(value(Zero));
            const scalar lean = axial ? h/p.y() : 0;
            const scalar divergence =
            (
                (value(dx) - value(-dx)).x()
              + ((1 + lean)*value(dy) - (1 - lean)*value(-dy)).y()
            )/(2*h);

            os  << celli << ' ' << p.x() << ' ' << p.y() << ' ' << u.x()
                << ' ' << u.y() << ' ' << divergence << ' ' << net[celli]
                << nl;
        }
    }
}


static void testAverage
(
    const volVectorField& U,
    const surfaceScalarField& phi,
    Ostream& os
)
{
    const fvMesh& mesh = U.mesh();
    const volScalarField omega
    (
        IOobject("none", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero)
    );
    materialPointCloud points
    (
        wordList(1, word("a")), U, phi, omega,
        [&U]() { return fvc::grad(U); }
    );

    Random random(1);
    const auto value = [&](const materialPoint& p)
    {
        return p.position(mesh).x() + 10*p.position(mesh).y();
    };

    // Enough are left for a linear fit
    labelList left(U.size(), Zero);
    for (const materialPoint& p : points)
    {
        ++left[p.cell()];
    }
    for (materialPoint& p : points)
    {
        if (left[p.cell()] > 6 && random.sample01<scalar>() < 0.5)
        {
            --left[p.cell()];
            points.drop(p);
        }
    }
    points.closeUp();

    scalarField values(points.size());
    label i = 0;
    for (const materialPoint& p : points)
    {
        values[i++] = value(p);
    }
    const scalarField average(points.average(values));

    for (const materialPoint& p : points)
    {
        const point place(p.position(mesh));
        os  << p.cell() << ' ' << place.x() << ' ' << place.y() << ' '
            << p.volume() << ' ' << average[p.cell()] << nl;
    }
}


static void testCorner(const dictionary& dict, Ostream& os)
{
    const List<vector> given(dict.get<List<vector>>("sectors"));
    List<cornerFlow::sector> sectors(given.size());
    forAll(given, i)
    {
        sectors[i] = {given[i].x(), given[i].y(), given[i].z()};
    }
    const FixedList<bool, 2> holds(dict.get<FixedList<bool, 2>>("holds"));
    const cornerFlow flow(sectors, holds[0], holds[1]);

    for (label modei = 0; modei < flow.size(); ++modei)
    {
        os  << flow.lambda(modei) << nl;
    }
}


int main(int argc, char *argv[])
{
    argList::addArgument("kernel");
    argList::addOption("linear", "(a b c d)", "Velocity of the fluxes");
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"
    axialCentres(mesh);

    const word kernel(args[1]);
    OFstream os(runTime.path()/kernel);
    os.precision(16);

    if (kernel == "cells")
    {
        testCells(mesh, os);
    }
    else if (kernel == "halo")
    {
        testHalo(mesh, os);
    }
    else if (kernel == "corner")
    {
        testCorner(dictionary(IFstream(runTime.path()/"wedge")()), os);
    }
    else
    {
        const volVectorField U
        (
            IOobject("U", runTime.timeName(), mesh, IOobject::MUST_READ),
            mesh
        );
        const surfaceScalarField phi
        (
            "phi",
            args.found("linear")
          ? linearFlux(mesh, args.get<FixedList<scalar, 4>>("linear"))
          : fvc::flux(U)
        );

        if (kernel == "velocity")
        {
            const IOdictionary dict
            (
                IOobject
                (
                    "materialPointsProperties",
                    runTime.constant(),
                    mesh,
                    IOobject::MUST_READ
                )
            );
            testVelocity(U, phi, dict, os);
        }
        else if (kernel == "average")
        {
            testAverage(U, phi, os);
        }
        else
        {
            FatalErrorInFunction
                << "Kernel '" << kernel << "'; there are cells, halo,"
                << " velocity, average, corner" << exit(FatalError);
        }
    }

    return 0;
}


// ************************************************************************* //
