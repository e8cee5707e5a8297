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

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "checkedEntry.H"
#include "cosseratSystem.H"
#include "gravityMeshObject.H"
#include "OFstream.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

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

    OFstream os("operator");
    os.precision(17);
    os  << n << nl;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            os  << A(i, j) << (j + 1 < n ? ' ' : '\n');
        }
    }

    return 0;
}


// ************************************************************************* //
