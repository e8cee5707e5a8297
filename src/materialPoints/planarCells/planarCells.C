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

#include "planarCells.H"
#include "emptyPolyPatch.H"
#include "meshTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planarCells::planarCells(const fvMesh& mesh)
:
    mesh_(mesh),
    face_(mesh.nCells(), -1)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp))
        {
            forAll(pp, i)
            {
                face_[pp.faceCells()[i]] = pp.start() + i;
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::planarCells::corners(const label celli) const
{
    pointField corners(mesh_.faces()[face_[celli]].points(mesh_.points()));
    for (point& corner : corners)
    {
        meshTools::constrainToMeshCentre(mesh_, corner);
    }
    return corners;
}


bool Foam::planarCells::contains
(
    const UList<point>& corners,
    const point& p
)
{
    // On the same side of all edges would do for a convex polygon only:
    // count crossings of a ray in the two directions that vary most
    vector size(Zero);
    for (const point& corner : corners)
    {
        size = max(size, cmptMag(corner - corners[0]));
    }
    direction i0 = 0, i1 = 1;
    if (size.x() <= min(size.y(), size.z()))
    {
        i0 = 1;
        i1 = 2;
    }
    else if (size.y() <= size.z())
    {
        i1 = 2;
    }

    bool inside = false;
    forAll(corners, i)
    {
        const point& a = corners[i];
        const point& b = corners[corners.fcIndex(i)];

        if ((a[i1] > p[i1]) != (b[i1] > p[i1]))
        {
            const scalar at =
                a[i0] + (p[i1] - a[i1])/(b[i1] - a[i1])*(b[i0] - a[i0]);
            if (p[i0] < at)
            {
                inside = !inside;
            }
        }
    }
    return inside;
}


// ************************************************************************* //
