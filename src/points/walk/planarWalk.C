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
#include "axialSymmetry.H"
#include "oneLayer.H"
#include "meshTools.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Edges that a way crosses at most; more are a circle by rounding
static const Foam::label mostEdges = 1000;

//- Distance from a face of the boundary, beside that of the cell centre, at
//  which a place is on it: only OpenFOAM's tracking slides points along walls
static const Foam::scalar touching = 1e-9;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::planarWalk::exitEdge
(
    const label celli,
    const vector2D& from,
    const vector2D& to
) const
{
    const vector2D& c = centres_[celli];
    const vector2D d(from - c), way(to - from);

    label leaves = -1;
    scalar first = GREAT;
    scalar middle = -GREAT;
    for (label i = start_[celli]; i < start_[celli + 1]; ++i)
    {
        const edgeOfCell& e = edges_[i];
        const scalar a = e.a & way;
        const scalar b = e.b & way;
        if (a + b <= 0)
        {
            continue;
        }

        const scalar atA = e.a & d;
        const scalar atB = e.b & d;
        const scalar t = (1 - atA - atB)/(a + b);

        // Of edges that the way meets at once, as in a row with hanging nodes
        // and at corners, the one within whose ends it does
        const scalar within = min(atA + t*a, atB + t*b);
        const bool atOnce = mag(t - first) < 1e-9*(1 + mag(t));
        if (atOnce ? within > middle : t < first)
        {
            leaves = i;
            first = t;
            middle = within;
        }
    }

    return leaves;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planarWalk::planarWalk(const polyMesh& mesh)
:
    mesh_(mesh),
    frame_(mesh),
    start_(mesh.nCells() + 1, Zero),
    centres_(mesh.nCells()),
    middle_(Zero),
    possible_(mesh.nGeometricD() == 2)
{
    if (!possible_)
    {
        return;
    }

    meshTools::constrainToMeshCentre(mesh, middle_);
    const axialSymmetry axial(mesh);
    const direction normal = frame_.normalAxis();

    bitSet side(mesh.nFaces(), true);
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (oneLayer::isPlane(pp))
        {
            side.unset(labelRange(pp.start(), pp.size()));
        }
    }

    DynamicList<edgeOfCell> edges;
    forAll(centres_, celli)
    {
        centres_[celli] = frame_.inPlane(mesh.cellCentres()[celli]);
        for (const label facei : mesh.cells()[celli])
        {
            edgeOfCell e;
            if (side[facei])
            {
                possible_ = possible_ && setEdge(celli, facei, e);
                edges.append(e);
            }
            else if
            (
                axial.active()
             && mesh.faceCentres()[facei][normal] > middle_[normal]
             && setAxisEdge(celli, facei, e)
            )
            {
                edges.append(e);
            }
        }
        start_[celli + 1] = edges.size();
    }
    edges_.transfer(edges);

    reduce(possible_, andOp<bool>());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector2D Foam::planarWalk::place(const materialPoint& p) const
{
    const barycentric& y = p.coordinates();
    const label celli = p.cell();

    for (label i = start_[celli]; i < start_[celli + 1]; ++i)
    {
        const edgeOfCell& e = edges_[i];
        if (e.face != p.tetFace() || e.lean < 0)
        {
            continue;
        }
        // Ends on the axis have none
        const bool first = e.lean < VGREAT && e.ends[0].tetPt == p.tetPt();
        if (!first && (e.lean == 0 || e.ends[1].tetPt != p.tetPt()))
        {
            break;
        }
        const half& h = e.ends[first ? 0 : 1];

        // As position() has it, to the last bit: points may be seeded on the
        // edges of what velocities are linear in
        const pointField& points = mesh_.points();
        const vector2D a(frame_.inPlane(points[e.corners[0]]));
        const vector2D b(frame_.inPlane(points[e.corners[1]]));
        FixedList<vector2D, 3> at(first ? a : b);
        at[h.farther] = first ? b : a;

        return
            y[0]*centres_[celli] + y[1]*at[0] + y[2]*at[1] + y[3]*at[2];
    }

    return frame_.inPlane(p.position());
}


bool Foam::planarWalk::walk
(
    label& celli,
    const vector2D& from,
    const vector2D& to
) const
{
    for (label n = 0; n < mostEdges; ++n)
    {
        const vector2D& c = centres_[celli];
        const vector2D d(to - c);

        bool inside = true, atWall = false;
        for (label i = start_[celli]; i < start_[celli + 1]; ++i)
        {
            const edgeOfCell& e = edges_[i];
            const scalar a = e.a & d;
            const scalar b = e.b & d;
            if (e.beyond < 0)
            {
                atWall = atWall || a + b > 1 - touching;
            }
            else if (a + b > 1)
            {
                inside = false;
                break;
            }
        }
        if (inside)
        {
            return !atWall;
        }

        const label i = exitEdge(celli, from, to);
        if (i < 0 || edges_[i].beyond < 0)
        {
            return false;
        }
        celli = edges_[i].beyond;
    }

    return false;
}


Foam::planarWalk::placeInTet Foam::planarWalk::find
(
    const label celli,
    const vector2D& at
) const
{
    const vector2D& c = centres_[celli];
    const vector2D d(at - c);

    // The triangle that holds it, or the nearest by rounding
    label in = start_[celli];
    scalar best = -GREAT, lA = 0, lB = 0;
    for (label i = start_[celli]; i < start_[celli + 1]; ++i)
    {
        const edgeOfCell& e = edges_[i];
        const scalar a = e.a & d;
        const scalar b = e.b & d;
        if (min(a, b) > best)
        {
            best = min(a, b);
            in = i;
            lA = a;
            lB = b;
        }
    }
    lA = max(lA, scalar(0));
    lB = max(lB, scalar(0));

    const edgeOfCell& e = edges_[in];
    FixedList<scalar, 3> l;
    label end = 0;
    if (e.lean < 0)
    {
        l[e.ends[0].same] = 0;
        l[e.ends[0].opposite] = lA;
        l[e.ends[0].farther] = lB;
    }
    else
    {
        end = e.lean < VGREAT && lA >= e.lean*lB ? 0 : 1;
        const scalar nearer = end ? lB : lA, farther = end ? lA : lB;
        const scalar lean = farther*(end ? 1/e.lean : e.lean);

        l[e.ends[end].same] = 0.5*(nearer - lean);
        l[e.ends[end].opposite] = 0.5*(nearer + lean);
        l[e.ends[end].farther] = farther;
    }

    return placeInTet
    {
        barycentric(1 - lA - lB, l[0], l[1], l[2]),
        e.face,
        e.ends[end].tetPt
    };
}


void Foam::planarWalk::put
(
    materialPoint& p,
    const label celli,
    const vector2D& at
) const
{
    const placeInTet t(find(celli, at));
    p.setPlace(t.y, celli, t.face, t.tetPt);
}


// ************************************************************************* //
