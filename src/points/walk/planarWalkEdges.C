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

#include "planarWalk.H"
#include "tetIndices.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Parts of the span that the cells may differ from a flat layer by rounding
static const Foam::scalar flat = 1e-9;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::planarWalk::setHalf
(
    const label celli,
    const label facei,
    const vector2D& end,
    half& h
) const
{
    const direction normal = frame_.normalAxis();
    const pointField& points = mesh_.points();
    const scalar near = flat*mesh_.bounds().mag();

    const label nTets = mesh_.faces()[facei].size() - 2;
    for (label tetPti = 1; tetPti <= nTets; ++tetPti)
    {
        const triFace tri
        (
            tetIndices(celli, facei, tetPti).faceTriIs(mesh_)
        );

        FixedList<bool, 3> here, front;
        label nHere = 0;
        forAll(tri, i)
        {
            const vector2D q(frame_.inPlane(points[tri[i]]) - end);
            here[i] = mag(q.x()) + mag(q.y()) < near;
            front[i] = points[tri[i]][normal] > middle_[normal];
            nHere += here[i];
        }
        if (nHere != 2)
        {
            continue;
        }

        h.tetPt = tetPti;
        h.farther = here[0] ? (here[1] ? 2 : 1) : 0;
        const direction i = (h.farther + 1) % 3, j = (h.farther + 2) % 3;
        h.same = front[i] == front[h.farther] ? i : j;
        h.opposite = h.same == i ? j : i;

        return front[h.same] != front[h.opposite];
    }

    return false;
}


bool Foam::planarWalk::setSlopes
(
    const label celli,
    vector2D& from,
    vector2D& to,
    edgeOfCell& e
) const
{
    const scalar near = flat*mesh_.bounds().mag();

    const vector2D& c = centres_[celli];
    vector2D a(from - c), b(to - c);
    scalar twoA = a.x()*b.y() - a.y()*b.x();
    if (twoA < 0)
    {
        Swap(a, b);
        Swap(from, to);
        twoA = -twoA;
    }
    if (!(twoA > SMALL*sqr(near)) || !std::isfinite(1/twoA))
    {
        return false;
    }

    e.a = vector2D(b.y()/twoA, -b.x()/twoA);
    e.b = vector2D(-a.y()/twoA, a.x()/twoA);
    return true;
}


bool Foam::planarWalk::setAxisEdge
(
    const label celli,
    const label facei,
    edgeOfCell& e,
    scalar& lean
) const
{
    const direction normal = frame_.normalAxis();
    const pointField& points = mesh_.points();
    const scalar near = flat*mesh_.bounds().mag();

    const label nTets = mesh_.faces()[facei].size() - 2;
    for (label tetPti = 1; tetPti <= nTets; ++tetPti)
    {
        const triFace tri(tetIndices(celli, facei, tetPti).faceTriIs(mesh_));

        DynamicList<direction> on(3);
        direction off = 0;
        forAll(tri, i)
        {
            if (mag(points[tri[i]][normal] - middle_[normal]) < near)
            {
                on.append(i);
            }
            else
            {
                off = i;
            }
        }
        if (on.size() != 2)
        {
            continue;
        }

        e.face = facei;
        e.beyond = -1;
        lean = -1;
        e.corners[0] = e.corners[1] = -1;
        const vector2D first(frame_.inPlane(points[tri[on[0]]]));
        vector2D from(first), to(frame_.inPlane(points[tri[on[1]]]));
        if (!setSlopes(celli, from, to, e))
        {
            return false;
        }

        half& h = e.ends[0];
        h.tetPt = tetPti;
        h.same = off;
        h.opposite = from == first ? on[0] : on[1];
        h.farther = from == first ? on[1] : on[0];
        e.ends[1] = h;
        return true;
    }

    return false;
}


bool Foam::planarWalk::setEdge
(
    const label celli,
    const label facei,
    edgeOfCell& e,
    scalar& lean
) const
{
    const direction normal = frame_.normalAxis();
    const face& f = mesh_.faces()[facei];
    const pointField& points = mesh_.points();
    const scalar near = flat*mesh_.bounds().mag();

    // Its ends are what two corners on the same side of the plane are, or one
    // on the axis
    DynamicList<vector2D> ends(2);
    DynamicList<scalar> depths(2);
    DynamicList<label> corners(2);
    scalar sum = 0;
    for (const label pointi : f)
    {
        const scalar depth = points[pointi][normal] - middle_[normal];
        sum += depth;
        if (depth > -near)
        {
            ends.append(frame_.inPlane(points[pointi]));
            depths.append(depth > near ? depth : 0);
            corners.append(pointi);
        }
    }
    if (ends.size() != 2 || f.size() > 4 || mag(sum) > near)
    {
        return false;
    }

    vector2D from(ends[0]), to(ends[1]);
    if (!setSlopes(celli, from, to, e))
    {
        return false;
    }
    if (from != ends[0])
    {
        Swap(depths[0], depths[1]);
        Swap(corners[0], corners[1]);
    }

    lean = depths[0] > 0 ? depths[1]/depths[0] : VGREAT;
    e.face = facei;
    e.corners[0] = corners[0];
    e.corners[1] = corners[1];
    e.beyond = -1;
    if (mesh_.isInternalFace(facei))
    {
        const label P = mesh_.faceOwner()[facei];
        e.beyond = P == celli ? mesh_.faceNeighbour()[facei] : P;
    }

    return
        (depths[0] <= 0 || setHalf(celli, facei, from, e.ends[0]))
     && (depths[1] <= 0 || setHalf(celli, facei, to, e.ends[1]));
}


// ************************************************************************* //
