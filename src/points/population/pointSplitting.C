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

#include "pointSplitting.H"
#include "materialPointCloud.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::point> Foam::pointSplitting::places
(
    const UList<materialPoint*>& points
) const
{
    List<point> places(points.size());
    forAll(points, i)
    {
        places[i] = points[i]->position(surroundings_.mesh());
    }

    return places;
}


Foam::vector Foam::pointSplitting::way
(
    const materialPoint& p,
    const UList<materialPoint*>& others
) const
{
    const label celli = p.cell();
    const point middle(p.position(surroundings_.mesh()));
    const label nAngles = 8, nLengths = 5;

    const List<point> at(places(others));

    // The sequence of golden parts: no two splits of a cell look the same way
    const scalar golden = 0.61803398874989485;
    const scalar first = std::fmod(golden*others.size(), 1);

    scalar length = 0.25*surroundings_.size(p.volume(), middle);
    for (label l = 0; l < nLengths; ++l)
    {
        vector best(Zero);
        scalar farthest = 0;

        for (label a = 0; a < nAngles; ++a)
        {
            const vector d
            (
                surroundings_.inPlane
                (
                    length,
                    constant::mathematical::pi*(a + first)/nAngles
                )
            );
            if
            (
                !surroundings_.contains(celli, middle + d)
             || !surroundings_.contains(celli, middle - d)
            )
            {
                continue;
            }

            scalar nearest = GREAT;
            forAll(others, i)
            {
                if (others[i] != &p)
                {
                    nearest = min(nearest, magSqr(at[i] - middle - d));
                    nearest = min(nearest, magSqr(at[i] - middle + d));
                }
            }
            if (nearest > cellSurroundings::more*farthest)
            {
                farthest = nearest;
                best = d;
            }
        }

        if (farthest > 0)
        {
            return best;
        }
        length *= 0.5;
    }

    return Zero;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::materialPoint& Foam::pointSplitting::spread
(
    materialPointCloud& cloud,
    materialPoint& p,
    const UList<materialPoint*>& here
) const
{
    const fvMesh& mesh = surroundings_.mesh();
    const label nAngles = 4, nLengths = 4;

    p.volume() *= 0.5;
    cloud.properties().split(p);

    // Directions by chance, the same for the same place
    const point from(p.position(mesh));
    const scalar size = surroundings_.size(p.volume(), from);
    const scalar golden = 0.61803398874989485;
    scalar angle =
        constant::mathematical::pi
       *std::fmod(mag(golden*(from & vector(7, 11, 13))/size), 1);

    scalar length = 0.3*size;
    for (label l = 0; l < nLengths; ++l)
    {
        for (label a = 0; a < nAngles; ++a)
        {
            const vector d(surroundings_.inPlane(length, angle));
            materialPoint plus(p), minus(p);
            if (plus.track(mesh, d) == 0 && minus.track(mesh, -d) == 0)
            {
                p.track(mesh, -d);
                return cloud.add
                (
                    materialPoint
                    (
                        mesh, plus.position(mesh), plus.cell(), p.handsOn()
                    )
                );
            }
            angle += constant::mathematical::pi/nAngles;
        }
        length *= 0.5;
    }

    // In a corner: inward
    const point to(surroundings_.inward(p.cell(), from, places(here)));

    return cloud.add(materialPoint(mesh, to, p.cell(), p.handsOn()));
}


Foam::materialPoint& Foam::pointSplitting::split
(
    materialPointCloud& cloud,
    materialPoint& p,
    const UList<materialPoint*>& here
) const
{
    const fvMesh& mesh = surroundings_.mesh();
    const point from(p.position(mesh));
    const vector d(way(p, here));

    p.volume() *= 0.5;
    cloud.properties().split(p);

    point to(from + d);
    if (magSqr(d) > 0)
    {
        p.trackToFace(mesh, -d);
    }
    else
    {
        to = surroundings_.inward(p.cell(), from, places(here));
    }

    return cloud.add(materialPoint(mesh, to, p.cell(), p.handsOn()));
}


// ************************************************************************* //
