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

#include "oneLayer.H"
#include "emptyPolyPatch.H"
#include "planarFrame.H"
#include "polyMesh.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Largest distance between corners in front and back, and largest component
//- along the normal of other faces, by the size of the cell
static const Foam::scalar largestSlant = 1e-4;

//- Smallest volume of a cell by that of the box around it, and largest sum of
//- its face areas by theirs: below rounding, far above what is right
static const Foam::scalar smallestVolume = 1e-10;
static const Foam::scalar largestGap = 1e-6;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static void refuse
    (
        const polyMesh& mesh,
        const label celli,
        const string& found
    )
    {
        FatalErrorInFunction
            << "The mesh is not one layer of cells: cell " << celli << " at "
            << mesh.cellCentres()[celli] << ' ' << found.c_str() << nl
            << "    Allowed: cells of positive volume with one face in front"
            << " and one behind in patches of type empty, or of type wedge,"
            << " straight over each other; checkMesh says more"
            << exit(FatalError);
    }

    //- Stop unless a cell has a volume and a closed surface
    static void checkBody(const polyMesh& mesh, const label celli)
    {
        const scalar V = mesh.cellVolumes()[celli];
        const boundBox box(mesh.cells()[celli].points
        (
            mesh.faces(), mesh.points()
        ), false);

        // Not so where it is not a number
        if (!(V > smallestVolume*cmptProduct(box.span())))
        {
            refuse(mesh, celli, "has the volume " + name(V) + " m3");
        }

        vector sum(Zero);
        scalar all = 0;
        for (const label facei : mesh.cells()[celli])
        {
            const vector& S = mesh.faceAreas()[facei];
            sum += mesh.faceOwner()[facei] == celli ? S : -S;
            all += mag(S);
        }
        if (!(mag(sum) < largestGap*all))
        {
            refuse(mesh, celli, "is not closed, or a face is turned round");
        }
    }

    //- Stop unless the corners of two faces of a cell lie over each other
    static void checkCorners
    (
        const polyMesh& mesh,
        const label celli,
        const labelPair& faces,
        const direction normal
    )
    {
        const pointField front(mesh.faces()[faces[0]].points(mesh.points()));
        const pointField back(mesh.faces()[faces[1]].points(mesh.points()));
        const scalar size = sqrt(mag(mesh.faceAreas()[faces[0]]));

        if (front.size() != back.size())
        {
            refuse
            (
                mesh, celli,
                "has " + name(front.size()) + " corners in front and "
              + name(back.size()) + " behind"
            );
        }

        for (const point& p : front)
        {
            scalar least = VGREAT;
            for (const point& q : back)
            {
                vector d(p - q);
                d[normal] = 0;
                least = min(least, mag(d));
            }
            if (!(least < largestSlant*size))
            {
                refuse
                (
                    mesh, celli,
                    "has a corner in front that is " + name(least)
                  + " m beside the nearest one behind"
                );
            }
        }
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::oneLayer::isPlane(const polyPatch& pp)
{
    return isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp);
}


const Foam::polyMesh& Foam::oneLayer::check(const polyMesh& mesh)
{
    if (mesh.nGeometricD() != 2)
    {
        FatalErrorInFunction
            << "The mesh is not planar: it has " << mesh.nGeometricD()
            << " directions in which it is solved, patch types "
            << mesh.boundaryMesh().types() << nl
            << "    Allowed: two, that is one cell across, with patches of"
            << " type empty in front and back, or of type wedge"
            << exit(FatalError);
    }
    const direction normal = planarFrame(mesh).normalAxis();

    List<labelPair> faces(mesh.nCells(), labelPair(-1, -1));
    labelList nEmpty(mesh.nCells(), Zero);
    boolList isEmpty(mesh.nFaces(), false);

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isPlane(pp))
        {
            forAll(pp, i)
            {
                const label celli = pp.faceCells()[i];
                faces[celli][min(nEmpty[celli], 1)] = pp.start() + i;
                isEmpty[pp.start() + i] = true;
                ++nEmpty[celli];
            }
        }
    }

    forAll(faces, celli)
    {
        if (nEmpty[celli] != 2)
        {
            refuse
            (
                mesh, celli,
                "has " + name(nEmpty[celli]) + " faces of type empty or wedge"
            );
        }
        checkBody(mesh, celli);
        checkCorners(mesh, celli, faces[celli], normal);
    }

    forAll(isEmpty, facei)
    {
        const vector& S = mesh.faceAreas()[facei];

        if (!isEmpty[facei] && mag(S[normal]) > largestSlant*mag(S))
        {
            refuse
            (
                mesh, mesh.faceOwner()[facei],
                "has a face beside those in front and back that is not upright"
            );
        }
    }
    return mesh;
}


// ************************************************************************* //
