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


bool Foam::planarWalk::walkOut
(
    label& celli,
    const vector2D& from,
    const vector2D& to,
    label& edge
) const
{
    for (label n = 0; n < mostEdges; ++n)
    {
        const label i = exitEdge(celli, from, to);
        if (i < 0 || edges_[i].beyond < 0)
        {
            return false;
        }
        celli = edges_[i].beyond;

        bool atWall;
        if (holds(celli, to, atWall, edge))
        {
            return !atWall;
        }
    }

    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planarWalk::planarWalk(const polyMesh& mesh)
:
    mesh_(mesh),
    points_(mesh.points()),
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
    DynamicList<scalar> leans;
    bool leaning = false;
    forAll(centres_, celli)
    {
        centres_[celli] = frame_.inPlane(mesh.cellCentres()[celli]);
        for (const label facei : mesh.cells()[celli])
        {
            edgeOfCell e;
            scalar lean = 1;
            if (side[facei])
            {
                possible_ = possible_ && setEdge(celli, facei, e, lean);
            }
            else if
            (
                !axial.active()
             || mesh.faceCentres()[facei][normal] <= middle_[normal]
             || !setAxisEdge(celli, facei, e, lean)
            )
            {
                continue;
            }
            edges.append(e);
            leans.append(lean);
            leaning = leaning || lean != 1;
        }
        start_[celli + 1] = edges.size();
    }
    edges_.transfer(edges);
    if (leaning)
    {
        lean_.transfer(leans);
    }

    reduce(possible_, andOp<bool>());
}


// ************************************************************************* //
