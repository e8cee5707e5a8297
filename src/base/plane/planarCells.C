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
#include "meshTools.H"
#include "oneLayer.H"
#include "volFields.H"
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planarCells::planarCells(const fvMesh& mesh)
:
    mesh_(mesh),
    axial_(mesh),
    thickness_(0),
    face_(mesh.nCells(), -1)
{
    const labelPair across(axes(mesh));
    thickness_ = mesh.bounds().span()[3 - across.first() - across.second()];

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (oneLayer::isPlane(pp))
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
        if (axial_.active())
        {
            corner = axial_.inMidPlane(corner);
        }
        else
        {
            meshTools::constrainToMeshCentre(mesh_, corner);
        }
    }
    return corners;
}


Foam::labelPair Foam::planarCells::axes(const polyMesh& mesh)
{
    const Vector<label>& dirs = mesh.geometricD();
    const label normal = dirs.x() < 0 ? 0 : dirs.y() < 0 ? 1 : 2;

    return labelPair((normal + 1) % 3, (normal + 2) % 3);
}


Foam::scalar Foam::planarCells::typicalVolume(const fvMesh& mesh)
{
    const scalarField& V = mesh.V();

    return gSum(sqr(V))/gSum(V);
}


Foam::scalar Foam::planarCells::typicalSize(const fvMesh& mesh)
{
    const planarCells cells(mesh);
    if (!cells.axial_.active())
    {
        return Foam::sqrt(typicalVolume(mesh)/cells.thickness_);
    }

    scalarField area(mesh.V());
    forAll(area, celli)
    {
        area[celli] /= cells.depth(mesh.C()[celli]);
    }
    return Foam::sqrt(gSum(sqr(area))/gSum(area));
}


Foam::labelList Foam::planarCells::turns
(
    const UList<point>& corners,
    const scalar smallest
)
{
    DynamicList<label> turns(corners.size());

    forAll(corners, i)
    {
        const vector before(corners[i] - corners[corners.rcIndex(i)]);
        const vector after(corners[corners.fcIndex(i)] - corners[i]);
        if
        (
            mag(before ^ after) > smallest*mag(before)*mag(after)
         || (before & after) < 0
        )
        {
            turns.append(i);
        }
    }
    return labelList(turns);
}


Foam::point Foam::planarCells::spread
(
    const UList<point>& corners,
    label& trial
) const
{
    const labelPair axes(planarCells::axes(mesh_));

    point lower(corners[0]), upper(corners[0]);
    for (const point& corner : corners)
    {
        lower = min(lower, corner);
        upper = max(upper, corner);
    }

    // Additive recurrence with the plastic number: the inverses of its powers
    // fill a square evenly
    const scalar plastic = 1.32471795724474602596;
    const vector size(upper - lower);

    vector part(Zero);
    point p(lower);
    do
    {
        ++trial;
        part[axes.first()] = std::fmod(0.5 + trial/plastic, 1);
        part[axes.second()] = std::fmod(0.5 + trial/sqr(plastic), 1);
        if (axial_.active())
        {
            scalar& radial = part[axial_.radial()];
            radial = axial_.evenly(radial, lower, upper);
        }
        p = lower + cmptMultiply(size, part);
    }
    while (!contains(axes, corners, p));

    return p;
}


bool Foam::planarCells::contains
(
    const labelPair& axes,
    const UList<point>& corners,
    const point& p
)
{
    // On the same side of all edges would do for a convex polygon only:
    // count crossings of a ray
    const direction i0 = axes.first(), i1 = axes.second();

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
