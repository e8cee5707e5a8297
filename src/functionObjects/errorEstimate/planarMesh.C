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

#include "planarMesh.H"
#include "processorCyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "mergePoints.H"
#include "globalIndex.H"
#include "volFields.H"

#include <map>
#include <tuple>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::planarMesh::setGeometry(const vector& e)
{
    centres_.setSize(nCells());
    areas_.setSize(nCells());

    forAll(loops_, celli)
    {
        const labelList& loop = loops_[celli];
        const point& start = points_[loop[0]];
        scalar area = 0;
        vector moment(Zero);

        for (label i = 1; i < loop.size() - 1; ++i)
        {
            const vector a(points_[loop[i]] - start);
            const vector b(points_[loop[i + 1]] - start);
            const scalar part = 0.5*(e & (a ^ b));
            area += part;
            moment += part*(a + b)/3;
        }
        areas_[celli] = area;
        centres_[celli] = start + moment/area;
    }
}


void Foam::planarMesh::setSides(EdgeMap<label>& where)
{
    DynamicList<side> sides(3*nCells());
    cellSides_.setSize(nCells());

    forAll(loops_, celli)
    {
        const labelList& loop = loops_[celli];
        cellSides_[celli].setSize(loop.size());

        forAll(loop, i)
        {
            const label a = loop[i], b = loop[loop.fcIndex(i)];
            const auto known = where.cfind(edge(a, b));

            if (!known.found())
            {
                where.insert(edge(a, b), sides.size());
                cellSides_[celli][i] = sides.size();
                sides.append(side{a, b, celli, -1, -1, -1});
            }
            else
            {
                cellSides_[celli][i] = *known;
                sides[*known].neighbour = celli;
            }
        }
    }
    sides_.transfer(sides);
}


void Foam::planarMesh::setPartners
(
    const labelUList& cellBehind,
    const boolUList& ownerHalf
)
{
    // By cell, cell behind, and half: a cell may be its own neighbour
    typedef std::tuple<label, label, bool> key;
    std::map<key, label> known;

    forAll(patchSides_, i)
    {
        if (cellBehind[i] >= 0)
        {
            const label sidei = patchSides_[i];
            known[key(sides_[sidei].owner, cellBehind[i], ownerHalf[i])] =
                sidei;
        }
    }
    forAll(patchSides_, i)
    {
        if (cellBehind[i] >= 0)
        {
            side& s = sides_[patchSides_[i]];
            s.partner = known.at(key(cellBehind[i], s.owner, !ownerHalf[i]));
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planarMesh::planarMesh(const fvMesh& mesh, const planarFrame& frame)
{
    const label me = Pstream::myProcNo();
    const label n = Pstream::nProcs();

    // What this processor has: loops by local points, records of patch faces
    labelListList loops(mesh.nCells());
    labelList compact(mesh.nPoints(), -1);
    DynamicList<point> points;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!isA<emptyPolyPatch>(pp))
        {
            continue;
        }
        forAll(pp, i)
        {
            if ((pp.faceAreas()[i] & frame.e()) > 0)
            {
                labelList& loop = loops[pp.faceCells()[i]];
                loop = pp[i];
                for (label& pointi : loop)
                {
                    if (compact[pointi] < 0)
                    {
                        compact[pointi] = points.size();
                        points.append(mesh.points()[pointi]);
                    }
                    pointi = compact[pointi];
                }
            }
        }
    }

    // The number of each cell among those of all, to know who is behind a
    // cyclic patch
    const label offset = globalIndex(mesh.nCells()).localStart();

    volScalarField number
    (
        IOobject("number", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero)
    );
    forAll(number, celli)
    {
        number[celli] = offset + celli;
    }
    number.correctBoundaryConditions();

    DynamicList<edge> ends;
    DynamicList<label> patches, behind;
    DynamicList<bool> half;

    for (const fvPatch& patch : mesh.boundary())
    {
        const polyPatch& pp = patch.patch();
        if (!counts(pp))
        {
            continue;
        }
        const auto* split = isA<processorCyclicPolyPatch>(pp);
        const label patchi = split ? split->referPatchID() : pp.index();

        scalarField across(pp.size(), -1);
        bool owner = false;
        if (patch.coupled())
        {
            across =
                number.boundaryField()[pp.index()].patchNeighbourField();
            owner = refCast<const cyclicPolyPatch>
            (
                mesh.boundaryMesh()[patchi]
            ).owner();
        }

        forAll(pp, i)
        {
            edge front(-1, -1);
            for (const label pointi : pp[i])
            {
                if (compact[pointi] >= 0)
                {
                    front[front[0] < 0 ? 0 : 1] = compact[pointi];
                }
            }
            ends.append(front);
            patches.append(patchi);
            behind.append(label(across[i] + (across[i] < 0 ? -0.5 : 0.5)));
            half.append(owner);
        }
    }

    List<pointField> allPoints(n);
    List<labelListList> allLoops(n);
    List<List<edge>> allEnds(n);
    labelListList allPatches(n), allBehind(n);
    List<boolList> allHalf(n);

    allPoints[me] = pointField(std::move(points));
    allLoops[me].transfer(loops);
    allEnds[me] = std::move(ends);
    allPatches[me] = std::move(patches);
    allBehind[me] = std::move(behind);
    allHalf[me] = std::move(half);

    Pstream::gatherList(allPoints);
    Pstream::gatherList(allLoops);
    Pstream::gatherList(allEnds);
    Pstream::gatherList(allPatches);
    Pstream::gatherList(allBehind);
    Pstream::gatherList(allHalf);

    if (!Pstream::master())
    {
        return;
    }

    labelList shift(n + 1, 0);
    label nCellsOfAll = 0;
    forAll(allPoints, proci)
    {
        shift[proci + 1] = shift[proci] + allPoints[proci].size();
        nCellsOfAll += allLoops[proci].size();
    }
    loops_.setSize(nCellsOfAll);
    points_.setSize(shift[n]);
    nCellsOfAll = 0;
    scalar shortest = GREAT;

    forAll(allLoops, proci)
    {
        SubList<point>(points_, allPoints[proci].size(), shift[proci]) =
            allPoints[proci];
        for (labelList& loop : allLoops[proci])
        {
            forAll(loop, i)
            {
                shortest = min
                (
                    shortest,
                    mag
                    (
                        allPoints[proci][loop[i]]
                      - allPoints[proci][loop[loop.fcIndex(i)]]
                    )
                );
            }
            for (label& pointi : loop)
            {
                pointi += shift[proci];
            }
            loops_[nCellsOfAll++].transfer(loop);
        }
    }

    // Between processors points are there twice
    labelList merged(identity(points_.size()));
    if (n > 1)
    {
        pointField unique
        (
            mergePoints(points_, 1e-3*shortest, false, merged)
        );
        forAll(points_, i)
        {
            unique[merged[i]] = points_[i];
        }
        points_.transfer(unique);
        for (labelList& loop : loops_)
        {
            for (label& pointi : loop)
            {
                pointi = merged[pointi];
            }
        }
    }

    EdgeMap<label> where(4*loops_.size());
    setSides(where);

    DynamicList<label> found, cellBehind;
    DynamicList<bool> ownerHalf;
    forAll(allEnds, proci)
    {
        forAll(allEnds[proci], i)
        {
            const edge& front = allEnds[proci][i];
            const label sidei = where[edge
            (
                merged[front[0] + shift[proci]],
                merged[front[1] + shift[proci]]
            )];
            sides_[sidei].patch = allPatches[proci][i];
            found.append(sidei);
            cellBehind.append(allBehind[proci][i]);
            ownerHalf.append(allHalf[proci][i]);
        }
    }
    patchSides_.transfer(found);
    setPartners(cellBehind, ownerHalf);
    setGeometry(frame.e());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::planarMesh::counts(const polyPatch& patch)
{
    return
        !isA<emptyPolyPatch>(patch)
     && (
            !isA<processorPolyPatch>(patch)
         || isA<processorCyclicPolyPatch>(patch)
        );
}


bool Foam::planarMesh::otherThanQuads() const
{
    for (const labelList& loop : loops_)
    {
        if (loop.size() != 4)
        {
            return true;
        }
    }
    return false;
}


// ************************************************************************* //
