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

#include "pointPopulation.H"
#include "bitSet.H"
#include "coupledPolyPatch.H"
#include "materialPointCloud.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Rotate what came through a coupled face, as points that cross it are
    static void turn(materialPoint& p, const polyMesh& mesh, const label facei)
    {
        const polyBoundaryMesh& patches = mesh.boundaryMesh();
        const coupledPolyPatch& pp =
            refCast<const coupledPolyPatch>(patches[patches.whichPatch(facei)]);

        if (!pp.parallel())
        {
            const tensorField& T = pp.forwardT();
            p.transformProperties(T[T.size() == 1 ? 0 : pp.whichFace(facei)]);
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarList Foam::pointPopulation::halve
(
    const materialPointCloud& cloud,
    materialPoint& p
)
{
    p.volume() *= 0.5;
    cloud.properties().split(p);

    return p.handsOn();
}


Foam::materialPoint* Foam::pointPopulation::split
(
    materialPointCloud& cloud,
    materialPoint& p,
    const point& position,
    const label celli
) const
{
    materialPoint* added = new materialPoint
    (
        mesh_, position, celli, halve(cloud, p)
    );
    cloud.addParticle(added);

    return added;
}


void Foam::pointPopulation::fillAcross
(
    materialPointCloud& cloud,
    const labelList& before,
    labelList& count,
    label& nAdded
) const
{
    // Cells that need a point, asked of those behind coupled faces
    bool any = false;
    for (const label n : count)
    {
        any = any || n == 0;
    }
    if (!returnReduce(any, orOp<bool>()))
    {
        return;
    }

    const label nBoundary = mesh_.nFaces() - mesh_.nInternalFaces();
    const label first = mesh_.nInternalFaces();
    labelList otherCount;
    syncTools::swapBoundaryCellList(mesh_, before, otherCount);

    // One face asks for each empty cell
    labelList asked(nBoundary, Zero);
    labelList faceOf(mesh_.nCells(), -1);
    forAll(count, celli)
    {
        if (count[celli] > 0)
        {
            continue;
        }
        for (const label facei : mesh_.cells()[celli])
        {
            if
            (
                facei >= first
             && mesh_.boundaryMesh()
                [
                    mesh_.boundaryMesh().whichPatch(facei)
                ].coupled()
             && otherCount[facei - first] > 0
            )
            {
                faceOf[celli] = facei;
                asked[facei - first] = 1;
                break;
            }
        }
        if (faceOf[celli] < 0)
        {
            FatalErrorInFunction
                << "Cell " << celli << " at " << mesh_.cellCentres()[celli]
                << " has no material point and its neighbours have none"
                << " either, time " << mesh_.time().timeName() << nl
                << "    Cures: more pointsPerCell or minPointsPerCell, a"
                << " smaller maxCo" << exit(FatalError);
        }
    }

    syncTools::swapBoundaryFaceList(mesh_, asked);

    bitSet giving(mesh_.nCells());
    forAll(asked, b)
    {
        if (asked[b])
        {
            giving.set(mesh_.faceOwner()[first + b]);
        }
    }
    Map<DynamicList<materialPoint*>> points;
    if (giving.any())
    {
        for (materialPoint& p : cloud)
        {
            if (giving[p.cell()])
            {
                points(p.cell()).append(&p);
            }
        }
    }

    // Their largest points give half of their volume
    List<scalarList> numbers
    (
        materialPoint::nOwnNumbers + cloud.properties().nValues(),
        scalarList(nBoundary, Zero)
    );
    forAll(asked, b)
    {
        // Also the faces of this side that ask have no point to give
        const label celli = mesh_.faceOwner()[first + b];
        if (!asked[b] || before[celli] == 0)
        {
            continue;
        }
        materialPoint* largest = nullptr;
        for (materialPoint* p : points(celli))
        {
            if (!largest || p->volume() > largest->volume())
            {
                largest = p;
            }
        }
        const scalarList given(halve(cloud, *largest));
        forAll(given, k)
        {
            numbers[k][b] = given[k];
        }
    }

    for (scalarList& each : numbers)
    {
        syncTools::swapBoundaryFaceList(mesh_, each);
    }

    forAll(faceOf, celli)
    {
        if (faceOf[celli] >= 0)
        {
            const label facei = faceOf[celli];
            scalarList given(numbers.size());
            forAll(given, k)
            {
                given[k] = numbers[k][facei - first];
            }

            materialPoint* added = new materialPoint
            (
                mesh_, mesh_.cellCentres()[celli], celli, given
            );
            turn(*added, mesh_, facei);
            cloud.addParticle(added);
            ++count[celli];
            ++nAdded;
        }
    }
}


Foam::materialPoint* Foam::pointPopulation::dense
(
    const UList<materialPoint*>& points
)
{
    materialPoint* smaller = nullptr;

    for (const bool sameDye : {true, false})
    {
        scalar nearest = GREAT;
        forAll(points, i)
        {
            for (label j = 0; j < i; ++j)
            {
                materialPoint& a = *points[i];
                materialPoint& b = *points[j];
                const scalar distance = magSqr(a.position() - b.position());
                if
                (
                    a.material() == b.material()
                 && (!sameDye || a.dye() == b.dye())
                 && distance < nearest
                )
                {
                    nearest = distance;
                    smaller = a.volume() < b.volume() ? &a : &b;
                }
            }
        }
        if (smaller)
        {
            break;
        }
    }

    return smaller;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointPopulation::pointPopulation
(
    const fvMesh& mesh,
    const dictionary& dict,
    const label pointsPerCell
)
:
    mesh_(mesh),
    minPointsPerCell_
    (
        dict.getOrDefault<label>("minPointsPerCell", pointsPerCell/4)
    ),
    maxPointsPerCell_(dict.getOrDefault<label>("maxPointsPerCell", 0))
{
    if (minPointsPerCell_ < 0 || minPointsPerCell_ > pointsPerCell)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'minPointsPerCell' is " << minPointsPerCell_ << nl
            << "    Allowed: 0 to pointsPerCell, " << pointsPerCell
            << exit(FatalIOError);
    }

    const label least = max(minPointsPerCell_, label(1));
    if (dict.found("maxPointsPerCell") && maxPointsPerCell_ < least)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'maxPointsPerCell' is " << maxPointsPerCell_ << nl
            << "    Allowed: minPointsPerCell, " << least
            << ", or more; no entry: none are deleted" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::pointPopulation::refill(materialPointCloud& cloud) const
{
    if (minPointsPerCell_ == 0)
    {
        return 0;
    }

    const labelList& before = cloud.census().count();
    labelList count(before);

    // The points of cells that are low and of the neighbours of empty ones
    bitSet low(mesh_.nCells());
    bool any = false;
    forAll(count, celli)
    {
        if (count[celli] < minPointsPerCell_)
        {
            low.set(celli);
            any = true;
            if (count[celli] == 0)
            {
                for (const label other : mesh_.cellCells()[celli])
                {
                    low.set(other);
                }
            }
        }
    }

    label nAdded = 0;
    Map<DynamicList<materialPoint*>> points;

    if (any)
    {
        for (materialPoint& p : cloud)
        {
            if (low[p.cell()])
            {
                points(p.cell()).append(&p);
            }
        }

        forAll(count, celli)
        {
            if (count[celli] == 0)
            {
                const point& centre = mesh_.cellCentres()[celli];
                materialPoint* nearest = nullptr;

                for (const label other : mesh_.cellCells()[celli])
                {
                    if (before[other] == 0)
                    {
                        continue;
                    }
                    for (materialPoint* p : points(other))
                    {
                        if
                        (
                            !nearest
                         || magSqr(p->position() - centre)
                          < magSqr(nearest->position() - centre)
                        )
                        {
                            nearest = p;
                        }
                    }
                }

                if (nearest)
                {
                    points(celli).append
                    (
                        split(cloud, *nearest, centre, celli)
                    );
                    ++count[celli];
                    ++nAdded;
                }
            }
        }
    }

    fillAcross(cloud, before, count, nAdded);

    if (any)
    {
        forAll(count, celli)
        {
            while (low[celli] && count[celli] < minPointsPerCell_)
            {
                materialPoint* largest = nullptr;
                for (materialPoint* p : points(celli))
                {
                    if (!largest || p->volume() > largest->volume())
                    {
                        largest = p;
                    }
                }

                // One filled across is split further in the next step
                if (!largest)
                {
                    break;
                }

                // A tenth of the way to the centre: inside a convex cell
                const point position
                (
                    0.9*largest->position()
                  + 0.1*mesh_.cellCentres()[celli]
                );
                points(celli).append
                (
                    split(cloud, *largest, position, celli)
                );
                ++count[celli];
                ++nAdded;
            }
        }
    }

    return returnReduce(nAdded, sumOp<label>());
}


Foam::label Foam::pointPopulation::thin(materialPointCloud& cloud) const
{
    if (maxPointsPerCell_ == 0)
    {
        return 0;
    }

    // Cells that were filled have no more than the minimum
    const labelList& count = cloud.census().count();
    Map<DynamicList<materialPoint*>> points;

    if (max(count) > maxPointsPerCell_)
    {
        for (materialPoint& p : cloud)
        {
            if (count[p.cell()] > maxPointsPerCell_)
            {
                points(p.cell()).append(&p);
            }
        }
    }

    label nDeleted = 0;
    forAllIters(points, iter)
    {
        DynamicList<materialPoint*>& here = *iter;

        while (here.size() > maxPointsPerCell_)
        {
            materialPoint* gone = dense(here);
            if (!gone)
            {
                break;
            }

            DynamicList<materialPoint*> rest;
            scalar volume = 0;
            for (materialPoint* p : here)
            {
                if (p != gone)
                {
                    rest.append(p);
                    volume +=
                        p->material() == gone->material() ? p->volume() : 0;
                }
            }
            const scalar growth = 1 + gone->volume()/volume;
            for (materialPoint* p : rest)
            {
                if (p->material() == gone->material())
                {
                    p->volume() *= growth;
                    cloud.properties().merge(*p, *gone, 1 - 1/growth);
                }
            }

            here.transfer(rest);
            cloud.deleteParticle(*gone);
            ++nDeleted;
        }
    }

    return returnReduce(nDeleted, sumOp<label>());
}


// ************************************************************************* //
