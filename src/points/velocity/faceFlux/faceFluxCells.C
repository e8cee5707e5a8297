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

#include "faceFlux.H"
#include "planarCells.H"
#include "oneLayer.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pointVelocities::faceFlux::setCorners
(
    const label celli,
    const labelUList& corners
)
{
    const label n = corners.size();
    const label start = start_[celli];

    scalar area = 0;
    for (label i = 2; i < n; ++i)
    {
        const point& o = points_[corners[0]];
        area += frame_.cross
        (
            points_[corners[i - 1]] - o, points_[corners[i]] - o
        );
    }
    const bool clockwise = area < 0;

    auto corner = [&](const label i)
    {
        return corners[clockwise ? n - 1 - i % n : i % n];
    };
    label first = 0;
    for (label i = 0; i < n; ++i)
    {
        if (onAxis(points_[corner(i)]) && onAxis(points_[corner(i + 1)]))
        {
            first = i + 1;
        }
    }

    for (label i = 0; i < n; ++i)
    {
        corners_[start + i] = corner(first + i);
    }
}


void Foam::pointVelocities::faceFlux::setFaces(const label celli)
{
    const polyMesh& mesh = phi_.mesh();
    const label start = start_[celli];
    const label n = start_[celli + 1] - start;

    for (label i = 0; i < n; ++i)
    {
        const point from(corner(start + i));
        const point middle(from + 0.5*edge(celli, i));
        faces_[start + i] = -1;
        if (onAxis(from) && onAxis(middle))
        {
            continue;
        }

        scalar nearest = GREAT;

        for (const label facei : mesh.cells()[celli])
        {
            const label patchi =
                mesh.isInternalFace(facei)
              ? -1
              : mesh.boundaryMesh().whichPatch(facei);

            if
            (
                patchi >= 0
             && oneLayer::isPlane(mesh.boundaryMesh()[patchi])
            )
            {
                continue;
            }

            const vector d(mesh.faceCentres()[facei] - middle);
            const scalar distance = magSqr(frame_.inPlane(d));
            if (distance < nearest)
            {
                nearest = distance;
                faces_[start + i] = facei;
            }
        }
    }
}


void Foam::pointVelocities::faceFlux::makeFan(const label celli)
{
    const label start = start_[celli];
    const label n = start_[celli + 1] - start;
    pointField corners(n);
    forAll(corners, i)
    {
        corners[i] = corner(start + i);
    }

    if (n == 3 || (n == 4 && planarCells::turns(corners).size() == 4))
    {
        return;
    }
    if (faces_[start + n - 1] < 0)
    {
        FatalErrorInFunction
            << "Cell " << celli << " has an edge on the axis and the corners "
            << corners << nl
            << "    Allowed: triangles and convex quadrilaterals along the"
            << " axis, or here velocity cellPoint, cell, cellPointFace, ... in"
            << " materialPointsProperties" << exit(FatalError);
    }

    const point centre
    (
        frame_.inSpace(frame_.inPlane(phi_.mesh().cellCentres()[celli]))
    );

    fan_[celli] = fans_.size();
    fanCells_.append(celli);
    fans_.append(new fluxFan(frame_, centre, corners));

    // Below this its numbers would be rounding
    if (fans_[fan_[celli]].flatness() < 1e-6)
    {
        FatalErrorInFunction
            << "Cell " << celli << " at " << centre << " has the corners "
            << corners << ", and its centre does not see all edges" << nl
            << "    Allowed: convex cells, also with hanging nodes, or here"
            << " velocity cellPoint, cell, cellPointFace, ... in"
            << " materialPointsProperties" << exit(FatalError);
    }
}


void Foam::pointVelocities::faceFlux::makeBox(const label celli)
{
    const label s = start_[celli];
    if (axial_.active() || fan_[celli] >= 0 || start_[celli + 1] - s != 4)
    {
        return;
    }

    const vector2D o(frame_.inPlane(corner(s)));
    const vector2D a(frame_.inPlane(corner(s + 1)) - o);
    const vector2D b(frame_.inPlane(corner(s + 3)) - o);
    const vector2D d(frame_.inPlane(corner(s + 2)) - o);
    box_[celli] = fluxBox::is(a, b, d - a - b);
    boxes_[celli] = fluxBox(o, a, b);
}


// ************************************************************************* //
