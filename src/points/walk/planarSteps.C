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

#include "planarSteps.H"
#include "planarWalk.H"
#include "pointVelocity.H"
#include "pointIntegration.H"
#include "trackedPoint.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Points of a batch: few enough that they and their cells stay in the cache
static const Foam::label mostPoints = 256;

//- Parts of the rest of a step; more are for OpenFOAM to track
static const Foam::label mostParts = 1000;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::planarSteps::take
(
    materialPointList::iterator& next,
    const materialPointList::iterator& end,
    const pointTracking& td
)
{
    points_.setSize(mostPoints);
    cells_.setSize(mostPoints);
    start_.setSize(mostPoints);

    label n = 0;
    for (; n < mostPoints && next != end; ++next)
    {
        materialPoint& p = *next;
        points_[n] = &p;
        cells_[n] = p.cell();
        start_[n] = walk_->place(p);
        ++n;
    }

    points_.setSize(n);
    cells_.setSize(n);
    start_.setSize(n);
    at_ = start_;
    edges_.setSize(n);
    U_.setSize(n);
    sum_.setSize(n);
    sum_ = Zero;

    // Parts of a step are for points one by one
    done_.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        done_[i] = td.courant[cells_[i]] <= 1;
    }
}


inline bool Foam::planarSteps::walk
(
    const stage& k,
    const vector2D& start,
    const vector2D& U,
    vector2D& sum,
    label& celli,
    label& edge,
    vector2D& at
) const
{
    sum += k.b*U;
    const vector2D way(k.dt*(k.last ? sum : k.a*U));
    const vector2D next(start + way);

    const bool done =
        planarWalk::isFinite(way) && walk_->walk(celli, at, next, edge);
    at = next;

    return done;
}


inline void Foam::planarSteps::put
(
    materialPoint& p,
    const vector2D& start,
    const label celli,
    const label edge,
    const vector2D& at,
    const pointTracking& td
) const
{
    // Resting points keep their bits
    if (magSqr(at - start) > sqr(td.nothing))
    {
        walk_->put(p, celli, edge, at);
    }
}


void Foam::planarSteps::stepAll(const pointTracking& td)
{
    for (label i = 0; i < td.integration.nStages(); ++i)
    {
        const stage k(td.integration, i, td.dt);
        td.velocity.inPlane(*walk_, at_, cells_, U_);
        forAll(points_, j)
        {
            done_[j] =
                done_[j]
             && walk
                (
                    k, start_[j], U_[j], sum_[j], cells_[j], edges_[j], at_[j]
                );
        }
    }
    forAll(points_, j)
    {
        if (done_[j])
        {
            put(*points_[j], start_[j], cells_[j], edges_[j], at_[j], td);
        }
    }
}


bool Foam::planarSteps::inParts
(
    materialPoint& p,
    const pointTracking& td
) const
{
    const vector2D start(walk_->place(p));
    vector2D at(start);
    label celli = p.cell(), edge = -1;

    scalar begin = 0;
    while (begin < 1 - 1e-10)
    {
        if (!(std::ceil((1 - begin)*td.courant[celli]) < mostParts))
        {
            return false;
        }
        const scalar part = trackedPoint::partOf(1 - begin, td.courant[celli]);

        const vector2D origin(at);
        vector2D U, sum(Zero);
        for (label i = 0; i < td.integration.nStages(); ++i)
        {
            const stage k(td.integration, i, part*td.dt);
            UList<vector2D> one(&U, 1);
            td.velocity.inPlane
            (
                *walk_, UList<vector2D>(&at, 1), labelUList(&celli, 1), one
            );
            if (!walk(k, origin, U, sum, celli, edge, at))
            {
                return false;
            }
        }
        begin += part;
    }
    put(p, start, celli, edge, at, td);

    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::planarSteps::step
(
    materialPointList& points,
    const pointTracking& td,
    const std::function<void(materialPoint&)>& other
)
{
    if (!walk_)
    {
        for (materialPoint& p : points)
        {
            other(p);
        }
        return;
    }

    materialPointList::iterator next(points.begin());
    const materialPointList::iterator end(points.end());
    while (next != end)
    {
        take(next, end, td);
        stepAll(td);
        forAll(points_, j)
        {
            materialPoint& p = *points_[j];
            if (!done_[j] && !(td.courant[p.cell()] > 1 && inParts(p, td)))
            {
                other(p);
            }
        }
    }
}


// ************************************************************************* //
