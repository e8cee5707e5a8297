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
#include "materialPointCloud.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::materialPoint* Foam::pointPopulation::split
(
    materialPointCloud& cloud,
    materialPoint& p,
    const point& position,
    const label celli
) const
{
    p.volume() *= 0.5;

    materialPoint* added = new materialPoint
    (
        mesh_, position, celli, p.material(), p.dye(), p.volume()
    );
    cloud.addParticle(added);

    return added;
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
    )
{
    if (minPointsPerCell_ < 0 || minPointsPerCell_ > pointsPerCell)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'minPointsPerCell' is " << minPointsPerCell_ << nl
            << "    Allowed: 0 to pointsPerCell, " << pointsPerCell
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::pointPopulation::refill(materialPointCloud& cloud) const
{
    if (minPointsPerCell_ == 0)
    {
        return 0;
    }

    labelList count(mesh_.nCells(), Zero);
    for (const materialPoint& p : cloud)
    {
        ++count[p.cell()];
    }

    // The points of cells that are low and of the neighbours of empty ones
    boolList low(mesh_.nCells(), false);
    bool any = false;
    forAll(count, celli)
    {
        if (count[celli] < minPointsPerCell_)
        {
            low[celli] = any = true;
            if (count[celli] == 0)
            {
                for (const label other : mesh_.cellCells()[celli])
                {
                    low[other] = true;
                }
            }
        }
    }

    label nAdded = 0;

    if (any)
    {
        Map<DynamicList<materialPoint*>> points;
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

            while (count[celli] > 0 && count[celli] < minPointsPerCell_)
            {
                materialPoint* largest = nullptr;
                for (materialPoint* p : points(celli))
                {
                    if (!largest || p->volume() > largest->volume())
                    {
                        largest = p;
                    }
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


// ************************************************************************* //
