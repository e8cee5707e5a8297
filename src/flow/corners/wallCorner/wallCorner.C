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

#include "wallCorner.H"
#include "globalIndex.H"
#include "mergePoints.H"
#include "openfoamVersion.H"
#include "SortableList.H"
#include "mathematicalConstants.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

using Foam::constant::mathematical::pi;
using Foam::constant::mathematical::twoPi;

//- Angle from which walls make a corner, of one kind and where one holds the
//- fluid and the other lets it slip
static const Foam::scalar smallestAngle = Foam::degToRad(210.0);
static const Foam::scalar smallestMixedAngle = Foam::degToRad(100.0);

//- Part of a face within which places are one
static const Foam::scalar together = 1e-6;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Cross product in the plane
    static inline scalar cross(const vector2D& a, const vector2D& b)
    {
        return a.x()*b.y() - a.y()*b.x();
    }

    //- A wall face: its ends, its outward normal, what it is
    struct wallFace
    {
        vector2D ends[2], normal;
        wallCorner::wall wall;
    };

    //- The ends in the plane of a face that stands on it
    static void findEnds
    (
        const face& f,
        const pointField& points,
        const planarFrame& frame,
        vector2D* ends
    )
    {
        ends[1] = frame.inPlane(points[f[0]]);
        for (label i = 0; i < 2; ++i)
        {
            const vector2D from(ends[1 - i]);
            ends[i] = from;
            for (const label pointi : f)
            {
                const vector2D p(frame.inPlane(points[pointi]));
                if (magSqr(p - from) > magSqr(ends[i] - from))
                {
                    ends[i] = p;
                }
            }
        }
    }

    //- Lists of all processors, on all of them
    static List<scalarList> gathered(const scalarList& mine)
    {
        List<scalarList> lists(Pstream::nProcs());
        lists[Pstream::myProcNo()] = mine;
        Pstream::gatherList(lists);
        sendToAll(lists);
        return lists;
    }

    //- Wall faces of all processors
    static DynamicList<wallFace> findWalls
    (
        const fvMesh& mesh,
        const planarFrame& frame,
        const haloExchange& halo,
        const flowBoundary& boundary
    )
    {
        DynamicList<scalar> mine;
        for (const label patchi : boundary.patches())
        {
            const polyPatch& pp = mesh.boundaryMesh()[patchi];
            forAll(pp, i)
            {
                const label facei = boundary.at(halo.start(patchi) + i);
                const auto kind = boundary.velocity(facei);
                if (kind != flowBoundary::OPEN)
                {
                    vector2D ends[2];
                    findEnds(pp[i], mesh.points(), frame, ends);
                    const vector2D n(frame.inPlane(pp.faceAreas()[i]));
                    for
                    (
                        const scalar s :
                        {
                            ends[0].x(), ends[0].y(), ends[1].x(), ends[1].y(),
                            n.x(), n.y(),
                            scalar(kind == flowBoundary::VELOCITY),
                            scalar(facei)
                        }
                    )
                    {
                        mine.append(s);
                    }
                }
            }
        }

        const List<scalarList> all(gathered(scalarList(mine)));
        DynamicList<wallFace> walls;
        forAll(all, proci)
        {
            for (label i = 0; i < all[proci].size(); i += 8)
            {
                const scalar* s = &all[proci][i];
                wallFace w;
                w.ends[0] = vector2D(s[0], s[1]);
                w.ends[1] = vector2D(s[2], s[3]);
                w.normal = vector2D(s[4], s[5]);
                w.wall.holds = s[6] > 0.5;
                w.wall.proc = proci;
                w.wall.face = label(s[7] + 0.5);
                w.wall.middle = vector2D(0, 0);
                walls.append(w);
            }
        }
        return walls;
    }

    //- Corners between two walls that meet, sorted; atEnd: numbers of the ends
    //- of walls at each place
    static List<wallCorner> between
    (
        const UList<wallFace>& walls,
        const labelListList& atEnd,
        const scalar tolerance
    )
    {
        DynamicList<wallCorner> corners;
        for (const labelList& pair : atEnd)
        {
            if (pair.size() == 2)
            {
                wallCorner::wall w[2];
                for (label side = 0; side < 2; ++side)
                {
                    const wallFace& face = walls[pair[side]/2];
                    const label end = pair[side] % 2;
                    w[side] = face.wall;
                    w[side].middle = 0.5*(face.ends[1 - end] - face.ends[end]);
                }
                const wallFace& face = walls[pair[0]/2];
                const wallCorner corner
                (
                    face.ends[pair[0] % 2], w[0], w[1], face.normal
                );
                const scalar smallest =
                    w[0].holds != w[1].holds
                  ? smallestMixedAngle : smallestAngle;
                if (corner.angle() > smallest)
                {
                    corners.append(corner);
                }
            }
        }

        std::sort
        (
            corners.begin(), corners.end(),
            [&](const wallCorner& a, const wallCorner& b)
            {
                const vector2D d(a.vertex() - b.vertex());
                return mag(d.x()) > tolerance ? d.x() < 0 : d.y() < 0;
            }
        );

        return List<wallCorner>(corners);
    }

    //- Cells of this processor at each vertex
    static List<DynamicList<label>> vertexCells
    (
        const fvMesh& mesh,
        const planarFrame& frame,
        const List<wallCorner>& corners,
        const scalar tolerance
    )
    {
        const pointField& points = mesh.points();

        // Corners are sorted by their first coordinate
        auto before = [&](const wallCorner& c, const scalar x)
        {
            return c.vertex().x() < x;
        };

        List<DynamicList<label>> cells(corners.size());
        forAll(points, pointi)
        {
            const vector2D p(frame.inPlane(points[pointi]));
            const scalar from = p.x() - 2*tolerance;
            const scalar to = p.x() + 2*tolerance;
            for
            (
                auto iter = std::lower_bound
                (
                    corners.begin(), corners.end(), from, before
                );
                iter != corners.end() && iter->vertex().x() < to;
                ++iter
            )
            {
                if (mag(iter->from(p)) < tolerance)
                {
                    DynamicList<label>& at = cells[iter - corners.begin()];
                    for (const label celli : mesh.pointCells()[pointi])
                    {
                        if (!at.found(celli))
                        {
                            at.append(celli);
                        }
                    }
                }
            }
        }
        return cells;
    }

    //- The same, as the numbers of a cell: vertex, processor, label, label in
    //- the whole mesh, centre from the vertex, and the ways along its two
    //- sides there
    static scalarList cellsAt
    (
        const fvMesh& mesh,
        const planarFrame& frame,
        const List<wallCorner>& corners,
        const scalar tolerance
    )
    {
        const List<DynamicList<label>> cells
        (
            vertexCells(mesh, frame, corners, tolerance)
        );
        const pointField& points = mesh.points();
        const globalIndex global(mesh.nCells());
        const pointField& C = mesh.cellCentres();
        DynamicList<scalar> mine;

        forAll(corners, i)
        {
            const wallCorner& corner = corners[i];
            for (const label celli : cells[i])
            {
                const vector2D centre
                (
                    corner.from(frame.inPlane(C[celli]))
                );
                DynamicList<scalar> row;
                row.append(i);
                row.append(Pstream::myProcNo());
                row.append(celli);
                row.append(global.toGlobal(celli));
                row.append(centre.x());
                row.append(centre.y());

                for (const label facei : mesh.cells()[celli])
                {
                    vector2D ends[2];
                    findEnds(mesh.faces()[facei], points, frame, ends);
                    for (label end = 0; end < 2; ++end)
                    {
                        const vector& n = mesh.faceAreas()[facei];
                        if
                        (
                            mag(n & frame.e()) < 0.5*mag(n)
                         && mag(corner.from(ends[end])) < tolerance
                        )
                        {
                            const vector2D way(ends[1 - end] - ends[end]);
                            row.append(way.x());
                            row.append(way.y());
                        }
                    }
                }
                if (row.size() == 10)
                {
                    mine.append(row);
                }
            }
        }

        return scalarList(mine);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::wallCorner::setCells(const UList<scalarList>& found)
{
    SortableList<scalar> thetas(found.size());
    forAll(found, i)
    {
        thetas[i] = theta(vector2D(found[i][4], found[i][5]));
    }
    thetas.sort();

    cells_.setSize(found.size());
    size_ = 0;
    scalar filled = 0;

    forAll(cells_, i)
    {
        const scalarList& s = found[thetas.indices()[i]];
        cell& c = cells_[i];
        c.proc = label(s[1] + 0.5);
        c.local = label(s[2] + 0.5);
        c.global = label(s[3] + 0.5);
        c.r = mag(vector2D(s[4], s[5]));
        c.theta = thetas[i];
        size_ += c.r/cells_.size();

        // Its sides, one on either hand of the centre
        const vector2D centre(s[4], s[5]);
        scalar start = 0, end = 0;
        for (label side = 6; side < 10; side += 2)
        {
            const vector2D way(s[side], s[side + 1]);
            const scalar turn = Foam::atan2(cross(centre, way), centre & way);
            start = min(start, turn);
            end = max(end, turn);
        }
        c.end = c.theta + end;
        filled += end - start;
    }

    const bool full = cells_.size() && mag(filled - angle_) < 1e-3;
    if (full)
    {
        cells_.last().end = angle_;
    }
    return full;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallCorner::wallCorner
(
    const vector2D& vertex,
    const wall& a,
    const wall& b,
    const vector2D& normalA
)
:
    vertex_(vertex),
    size_(0)
{
    // The fluid is to the left of the first wall, seen from the vertex
    const bool aFirst = cross(a.middle, normalA) < 0;
    walls_[0] = aFirst ? a : b;
    walls_[1] = aFirst ? b : a;
    const vector2D& first = walls_[0].middle;
    const vector2D& second = walls_[1].middle;

    direction_ = Foam::atan2(first.y(), first.x());
    angle_ = Foam::atan2(cross(first, second), first & second);
    if (angle_ < together)
    {
        angle_ += twoPi;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::wallCorner> Foam::wallCorner::find
(
    const fvMesh& mesh,
    const planarFrame& frame,
    const haloExchange& halo,
    const flowBoundary& boundary
)
{
    const DynamicList<wallFace> walls
    (
        findWalls(mesh, frame, halo, boundary)
    );
    if (walls.empty())
    {
        return List<wallCorner>();
    }

    pointField ends(2*walls.size());
    scalar shortest = GREAT;
    const vector2D origin(walls[0].ends[0]);
    forAll(walls, i)
    {
        for (label end = 0; end < 2; ++end)
        {
            const vector2D p(walls[i].ends[end] - origin);
            ends[2*i + end] = vector(p.x(), p.y(), 0);
        }
        shortest = min(shortest, mag(walls[i].ends[1] - walls[i].ends[0]));
    }

    const scalar tolerance = together*shortest;
    labelList unique;
    const label nEnds = mergePoints(ends, tolerance, false, unique);
    labelListList atEnd(nEnds);
    forAll(unique, i)
    {
        atEnd[unique[i]].append(i);
    }

    const List<wallCorner> corners
    (
        between(walls, atEnd, tolerance)
    );

    List<DynamicList<scalarList>> cells(corners.size());
    const List<scalarList> all
    (
        gathered
        (
            cellsAt(mesh, frame, corners, tolerance)
        )
    );
    for (const scalarList& mine : all)
    {
        for (label i = 0; i < mine.size(); i += 10)
        {
            cells[label(mine[i] + 0.5)].append
            (
                scalarList(SubList<scalar>(mine, 10, i))
            );
        }
    }

    DynamicList<wallCorner> filled;
    forAll(corners, i)
    {
        wallCorner corner(corners[i]);
        if (corner.setCells(List<scalarList>(cells[i])))
        {
            filled.append(corner);
        }
    }
    return List<wallCorner>(filled);
}


Foam::scalar Foam::wallCorner::theta(const vector2D& way) const
{
    scalar t = Foam::atan2(way.y(), way.x()) - direction_;
    while (t < 0)
    {
        t += twoPi;
    }
    while (t >= twoPi)
    {
        t -= twoPi;
    }
    return t > 0.5*(angle_ + twoPi) ? t - twoPi : t;
}


// ************************************************************************* //
