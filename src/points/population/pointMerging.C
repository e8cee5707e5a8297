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

#include "pointMerging.H"
#include "cellPoints.H"
#include "closestPair.H"
#include "materialPointCloud.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Of other points the one to merge with: by least spread, of the same
    //- kind, or of the same material only; null: none
    static materialPoint* partner
    (
        const polyMesh& mesh,
        const materialPoint& p,
        const UList<materialPoint*>& others,
        const bool anyDye
    )
    {
        materialPoint* best = nullptr;
        scalar least = GREAT;
        for (materialPoint* other : others)
        {
            if
            (
                other != &p
             && (
                    anyDye
                  ? other->material() == p.material()
                  : closestPair::sameKind(*other, p)
                )
            )
            {
                const scalar s = closestPair::spread
                (
                    p,
                    *other,
                    magSqr(p.position(mesh) - other->position(mesh))
                );
                if (cellSurroundings::more*s < least)
                {
                    least = s;
                    best = other;
                }
            }
        }

        return best;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pointMerging::merge
(
    materialPointCloud& cloud,
    materialPoint& stays,
    materialPoint& goes,
    const bool moves
) const
{
    const polyMesh& mesh = surroundings_.mesh();
    const scalar part = goes.volume()/(stays.volume() + goes.volume());
    if (moves)
    {
        const vector way(goes.position(mesh) - stays.position(mesh));
        stays.trackToFace(mesh, part*way);
    }
    cloud.properties().merge(stays, goes, part);
    stays.volume() += goes.volume();
    cloud.drop(goes);
}


Foam::DynamicList<Foam::materialPoint*> Foam::pointMerging::pointsAround
(
    cellPoints& points,
    const label celli
) const
{
    labelHashSet cells;
    for (const label pointi : surroundings_.corners(celli))
    {
        cells.insert(surroundings_.around(pointi));
    }
    cells.erase(celli);

    DynamicList<materialPoint*> all;
    for (const label around : cells.sortedToc())
    {
        all.append(points[around]);
    }

    return all;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::pointMerging::thin
(
    cellPoints& points,
    const label celli,
    const label most,
    const scalar largest
) const
{
    const DynamicList<materialPoint*>& here = points[celli];
    const label before = here.size();
    if (before <= most)
    {
        return 0;
    }

    closestPair closest(surroundings_.mesh(), here, largest);
    while (here.size() > most)
    {
        const label later = closest.later();
        if (later < 0)
        {
            break;
        }
        const label earlier = closest.earlier(later);
        const bool first = here[later]->volume() < here[earlier]->volume();
        const label stays = first ? earlier : later;
        const label goes = first ? later : earlier;

        materialPoint& kept = *here[stays];
        materialPoint& gone = *here[goes];
        points.remove(celli, &gone);
        merge(points.cloud(), kept, gone, true);
        closest.update(stays, goes);
    }

    return before - here.size();
}


Foam::label Foam::pointMerging::sweep
(
    cellPoints& points,
    const label celli,
    const scalar share
) const
{
    const polyMesh& mesh = surroundings_.mesh();
    const DynamicList<materialPoint*>& here = points[celli];
    label nMerged = 0;

    while (here.size())
    {
        scalar volume = 0;
        materialPoint* tiny = here[0];
        for (materialPoint* p : here)
        {
            volume += p->volume();
            tiny = p->volume() < tiny->volume() ? p : tiny;
        }
        if (tiny->volume() >= share*volume/here.size())
        {
            break;
        }

        materialPoint* other = partner(mesh, *tiny, here, false);
        const bool moves = other;
        if (!other)
        {
            const DynamicList<materialPoint*> around
            (
                pointsAround(points, celli)
            );
            other = partner(mesh, *tiny, around, false);
            other = other ? other : partner(mesh, *tiny, here, true);
            other = other ? other : partner(mesh, *tiny, around, true);
        }
        if (!other)
        {
            break;
        }

        points.remove(celli, tiny);
        merge(points.cloud(), *other, *tiny, moves);
        ++nMerged;
    }

    return nMerged;
}


// ************************************************************************* //
