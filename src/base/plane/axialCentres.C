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

#include "axialCentres.H"
#include "axialSymmetry.H"
#include "fvMesh.H"
#include "planarCells.H"
#include "vectorIOField.H"
#include "wedgePolyPatch.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- OpenFOAM's centres in the registry of the mesh
static const Foam::word keptName("volumeCentres");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Centre of a polygon
    static point centreOf(const pointField& corners)
    {
        // Triangles from one corner, so that it may be far from the origin
        vector area(Zero), moment(Zero);
        for (label i = 1; i < corners.size() - 1; ++i)
        {
            area += (corners[i] - corners[0]) ^ (corners[i + 1] - corners[0]);
        }
        const vector e(normalised(area));
        for (label i = 1; i < corners.size() - 1; ++i)
        {
            const vector a(corners[i] - corners[0]);
            const vector b(corners[i + 1] - corners[0]);
            moment += ((a ^ b) & e)*(a + b)/3;
        }
        return corners[0] + moment/mag(area);
    }


    //- Middle of the edge that an upright face is in the mid-plane
    static point middleOf(const pointField& corners)
    {
        point end(corners[0]);
        for (const point& p : corners)
        {
            if (magSqr(p - corners[0]) > magSqr(end - corners[0]))
            {
                end = p;
            }
        }
        return 0.5*(corners[0] + end);
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::axialCentres(fvMesh& mesh)
{
    const axialSymmetry axial(mesh);
    if (!axial.active())
    {
        return;
    }

    // Places that others refer to
    vectorField& Cf = const_cast<vectorField&>(mesh.faceCentres());
    vectorField& C = const_cast<vectorField&>(mesh.cellCentres());

    mesh.thisDb().store
    (
        new vectorIOField
        (
            IOobject(keptName, mesh.time().constant(), mesh), C
        )
    );

    const planarCells cells(mesh);
    forAll(C, celli)
    {
        C[celli] = centreOf(cells.corners(celli));
    }

    forAll(Cf, facei)
    {
        const label patchi =
            mesh.isInternalFace(facei)
          ? -1 : mesh.boundaryMesh().whichPatch(facei);
        if
        (
            patchi < 0 || !isA<wedgePolyPatch>(mesh.boundaryMesh()[patchi])
        )
        {
            pointField corners(mesh.faces()[facei].points(mesh.points()));
            for (point& p : corners)
            {
                p = axial.inMidPlane(p);
            }
            Cf[facei] = middleOf(corners);
        }
    }

    // What patches keep of them, of other processors too
    const_cast<polyBoundaryMesh&>(mesh.boundaryMesh()).movePoints
    (
        mesh.points()
    );
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::volumeCentres::exchange()
{
    vectorField& kept = mesh_.thisDb().lookupObjectRef<vectorIOField>(keptName);
    vectorField& C = const_cast<vectorField&>(mesh_.cellCentres());

    std::swap_ranges(C.begin(), C.end(), kept.begin());
}


// ************************************************************************* //
