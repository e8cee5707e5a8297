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
    frame_(mesh),
    axial_(mesh),
    thickness_(mesh.bounds().span()[frame_.normalAxis()]),
    face_(mesh.nCells(), -1)
{
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
    pointField corners(outline(celli).points(mesh_.points()));
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
        part[frame_.i0()] = std::fmod(0.5 + trial/plastic, 1);
        part[frame_.i1()] = std::fmod(0.5 + trial/sqr(plastic), 1);
        if (axial_.active())
        {
            scalar& radial = part[axial_.radial()];
            radial = axial_.evenly(radial, lower, upper);
        }
        p = lower + cmptMultiply(size, part);
    }
    while (!frame_.contains(corners, p));

    return p;
}


// ************************************************************************* //
