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
    Test-operator

Description
    Writes the matrix of the discrete operator, found column by column from the
    residual of unit vectors, to the file operator of the case: the number of
    unknowns, then the rows of A in r(x) = b - A x. Unknowns are all u0, all
    u1, all p and, where there is a microrotation, all omega.

    For meshes of a few hundred cells. The case is one of cosseratPicFoam with
    fractions in files.

    With -state it writes instead what the operator makes of the fields U and
    omega of the case and no pressure, to the file state: for each cell the
    residual of u0, u1, p and omega (0 where there is none), and the gradient
    of the velocity as G_00, G_01, G_10, G_11 with G_ij = u_j,i.

Usage
    Test-operator [-state]

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "axialCentres.H"
#include "checkedEntry.H"
#include "cosseratSystem.H"
#include "gravityMeshObject.H"
#include "OFstream.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- The matrix, column by column
static void writeMatrix(const cosseratSystem& system, Ostream& os)
{
    const label n = system.size();
    scalarSquareMatrix A(n);
    operatorState s(system.newState());
    scalarField x(n, Zero), r;
    for (label j = 0; j < n; ++j)
    {
        x[j] = 1;
        system.residual(x, false, s, r);
        x[j] = 0;
        for (label i = 0; i < n; ++i)
        {
            A(i, j) = -r[i];
        }
    }

    os  << n << nl;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            os  << A(i, j) << (j + 1 < n ? ' ' : '\n');
        }
    }
}


//- Residual and gradient of a state
static void writeState
(
    const cosseratSystem& system,
    const volVectorField& U,
    const volScalarField& omega,
    Ostream& os
)
{
    const planarFrame& frame = system.faces().frame();
    const label n = system.nCells();
    operatorState s(system.newState());
    scalarField x(system.size(), Zero), r;
    for (label celli = 0; celli < n; ++celli)
    {
        x[celli] = U[celli][frame.i0()];
        x[n + celli] = U[celli][frame.i1()];
        if (system.cosserat())
        {
            x[3*n + celli] = omega[celli];
        }
    }
    system.residual(x, true, s, r);

    for (label celli = 0; celli < n; ++celli)
    {
        for (label i = 0; i < 4; ++i)
        {
            os  << (i < system.layout().nBlocks() ? r[i*n + celli] : 0) << ' ';
        }
        for (label ij = 0; ij < 4; ++ij)
        {
            os  << s.G[celli][ij]
                << (ij < 3 ? ' ' : '\n');
        }
    }
}


int main(int argc, char *argv[])
{
    argList::addBoolOption("state", "Residual and gradient of U and omega");
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    axialCentres(mesh);
    materialFields materials(mesh);
    #include "createGravity.H"
    materials.correct();

    const IOobject start
    (
        "U", runTime.timeName(), mesh, IOobject::MUST_READ, IOobject::NO_WRITE
    );
    volVectorField U(start, mesh);
    volScalarField pRgh(IOobject(start, "p_rgh"), mesh);
    volScalarField omega(IOobject(start, "omega"), mesh);

    const planarFrame frame(mesh);
    const haloExchange halo(mesh, frame);
    flowBoundary boundary
    (
        frame, halo, U, pRgh, omega,
        materials.parts().has(sceneParts::MICROROTATION)
    );
    cosseratSystem system(mesh, frame, halo, boundary, materials, true);
    boundary.update();
    system.updateWalls();
    system.update();

    const word name(args.found("state") ? "state" : "operator");
    OFstream os(name);
    os.precision(17);
    if (args.found("state"))
    {
        writeState(system, U, omega, os);
    }
    else
    {
        writeMatrix(system, os);
    }

    return 0;
}


// ************************************************************************* //
