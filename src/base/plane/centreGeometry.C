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

#include "centreGeometry.H"
#include "fvMesh.H"
#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Centre, less an origin, and area of a face
    static void setFace
    (
        const face& f,
        const pointField& points,
        const point& origin,
        vector& centre,
        vector& area
    )
    {
        vector estimate(Zero);
        for (const label pointi : f)
        {
            estimate += points[pointi] - origin;
        }
        estimate /= f.size();

        scalar sum = 0;
        vector moment(Zero);
        area = Zero;
        forAll(f, i)
        {
            const vector a(points[f[i]] - origin);
            const vector b(points[f.nextLabel(i)] - origin);
            const vector n(0.5*((b - a) ^ (estimate - a)));
            area += n;
            sum += mag(n);
            moment += mag(n)*(a + b + estimate)/3;
        }
        centre = sum > 0 ? moment/sum : estimate;
    }


    //- Length [m] of the shortest edge
    static scalar shortestEdge(const fvMesh& mesh)
    {
        scalar shortest = GREAT;
        for (const face& f : mesh.faces())
        {
            forAll(f, i)
            {
                const vector edge
                (
                    mesh.points()[f[i]] - mesh.points()[f.nextLabel(i)]
                );
                shortest = min(shortest, mag(edge));
            }
        }
        return returnReduce(shortest, minOp<scalar>());
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::centreGeometry(fvMesh& mesh)
{
    const point origin(mesh.bounds().midpoint());
    const scalar distance = cmptMax(cmptMag(origin));

    if (distance < 100*mesh.bounds().mag())
    {
        return;
    }

    // Places that others refer to
    vectorField& Cf = const_cast<vectorField&>(mesh.faceCentres());
    vectorField& Sf = const_cast<vectorField&>(mesh.faceAreas());
    vectorField& C = const_cast<vectorField&>(mesh.cellCentres());
    scalarField& V = const_cast<scalarField&>(mesh.cellVolumes());

    forAll(Cf, facei)
    {
        setFace
        (
            mesh.faces()[facei], mesh.points(), origin, Cf[facei], Sf[facei]
        );
    }

    forAll(C, celli)
    {
        const cell& faces = mesh.cells()[celli];
        vector estimate(Zero);
        for (const label facei : faces)
        {
            estimate += Cf[facei];
        }
        estimate /= faces.size();

        vector moment(Zero);
        scalar volume = 0;
        for (const label facei : faces)
        {
            const scalar pyramid =
                (mesh.faceOwner()[facei] == celli ? 1 : -1)/3.0
               *(Sf[facei] & (Cf[facei] - estimate));
            volume += pyramid;
            moment += pyramid*(0.75*Cf[facei] + 0.25*estimate);
        }
        V[celli] = volume;
        C[celli] = mag(volume) > 0 ? moment/volume : estimate;
    }
    Cf += origin;
    C += origin;

    // What patches keep of them, of other processors too
    const_cast<polyBoundaryMesh&>(mesh.boundaryMesh()).movePoints
    (
        mesh.points()
    );

    const scalar digits =
        distance*std::numeric_limits<scalar>::epsilon();
    Info<< "The mesh is up to " << distance/mesh.bounds().mag()
        << " of its sizes away from the origin: coordinates resolve "
        << digits << " m, " << digits/shortestEdge(mesh)
        << " of its shortest edge." << nl
        << "    Unless they are exact there, results are no better than that"
        << nl << endl;
}


// ************************************************************************* //
