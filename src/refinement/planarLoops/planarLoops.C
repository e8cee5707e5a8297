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

#include "planarLoops.H"
#include "oneLayer.H"
#include "planarCells.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Sine of the turn above which a point is a corner
static const Foam::scalar smallestTurn = Foam::sin(Foam::degToRad(5.0));

//- Part of a side, from either end, in which no point is its middle
static const Foam::scalar outerPart = 0.25;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::planarLoops::findEnds(const boolList& isBack)
{
    forAll(ends_, facei)
    {
        const face& f = mesh_.faces()[facei];
        label nBack = 0;
        forAll(f, i)
        {
            const label a = f[i], b = f.nextLabel(i);
            nBack += isBack[a];
            if (isBack[a] && isBack[b])
            {
                ends_[facei] = labelPair(a, b);
            }
            else if (isBack[a] && !isBack[b])
            {
                front_[a] = b;
            }
        }
        if (nBack == 0 || nBack == f.size())
        {
            ends_[facei] = labelPair(-1, -1);
        }
        else if (f.size() != 4 || nBack != 2)
        {
            FatalErrorInFunction
                << "Face " << facei << " at " << mesh_.faceCentres()[facei]
                << " stands on the plane and has " << f.size() << " points"
                << nl << "    Allowed: 4" << exit(FatalError);
        }
    }
}


void Foam::planarLoops::findEmptyFaces(const boolList& isBack)
{
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (oneLayer::isPlane(pp))
        {
            forAll(pp, i)
            {
                labelList& side = isBack[pp[i][0]] ? backFace_ : frontFace_;
                side[pp.faceCells()[i]] = pp.start() + i;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planarLoops::planarLoops(const polyMesh& mesh)
:
    mesh_(mesh),
    frame_(oneLayer::check(mesh)),
    ends_(mesh.nFaces()),
    front_(mesh.nPoints(), -1),
    backFace_(mesh.nCells(), -1),
    frontFace_(mesh.nCells(), -1)
{
    const direction normal = frame_.normalAxis();
    const scalar middle = mesh.bounds().centre()[normal];

    boolList isBack(mesh.nPoints());
    forAll(isBack, pointi)
    {
        isBack[pointi] = mesh.points()[pointi][normal] < middle;
    }
    findEnds(isBack);
    findEmptyFaces(isBack);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::planarLoops::loop Foam::planarLoops::outline(const label celli) const
{
    loop cell;
    cell.points = mesh_.faces()[backFace_[celli]];
    const label n = cell.points.size();
    cell.faces.setSize(n, -1);

    for (const label facei : mesh_.cells()[celli])
    {
        const label a = cell.points.find(ends_[facei].first());
        const label b = cell.points.find(ends_[facei].second());
        if (a >= 0 && b >= 0)
        {
            cell.faces[(a + 1) % n == b ? a : b] = facei;
        }
    }

    cell.corners = planarCells::turns
    (
        pointField(mesh_.points(), cell.points), smallestTurn
    );

    return cell;
}


Foam::planarLoops::middle Foam::planarLoops::middleOf
(
    const loop& cell,
    const label corneri
) const
{
    const pointField& points = mesh_.points();
    const label n = cell.points.size();
    const label first = cell.corners[corneri];
    const label last = cell.corners[cell.next(corneri)];
    const point& a = points[cell.points[first]];
    const vector way(points[cell.points[last]] - a);

    middle found{-1, -1};
    scalar nearest = 0.5 - outerPart, before = 0;
    label i = first;
    do
    {
        const label j = (i + 1) % n;
        const scalar t = ((points[cell.points[j]] - a) & way)/magSqr(way);
        if (before < 0.5 && t >= 0.5)
        {
            found.face = cell.faces[i];
        }
        if (j != last && mag(t - 0.5) < nearest)
        {
            nearest = mag(t - 0.5);
            found.at = j;
        }
        before = t;
        i = j;
    } while (i != last);

    if (found.at >= 0)
    {
        found.face = -1;
    }
    return found;
}


bool Foam::planarLoops::wholeSide
(
    const label celli,
    const label facei
) const
{
    const loop cell(outline(celli));
    const label i = cell.faces.find(facei);

    return
        cell.corners.found(i)
     && cell.corners.found((i + 1) % cell.points.size());
}


// ************************************************************************* //
