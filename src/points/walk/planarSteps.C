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

#include "materialPoint.H"
#include "planarWalk.H"
#include "pointVelocity.H"
#include "pointIntegration.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Points of a batch: few enough that they and their cells stay in the cache
static const Foam::label mostPoints = 256;

//- Parts of the rest of a step; more are for OpenFOAM to track
static const Foam::label mostParts = 1000;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::planarSteps::take
(
    materialPoint& first,
    const pointTracking& td
)
{
    points_.setSize(mostPoints);
    cells_.setSize(mostPoints);
    start_.setSize(mostPoints);

    label n = 0;
    for (materialPoint* p = &first; p && n < mostPoints; p = p->following())
    {
        if (p->atRest() && p->stepFraction() < 1)
        {
            points_[n] = p;
            cells_[n] = p->cell();
            start_[n] = walk_->place(*p);
            ++n;
        }
    }

    points_.setSize(n);
    cells_.setSize(n);
    start_.setSize(n);
    at_ = start_;
    U_.setSize(n);
    sum_.setSize(n);
    sum_ = Zero;
    next_ = 0;

    // Parts of a step are for points one by one
    done_.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        done_[i] = td.courant[cells_[i]] <= 1;
    }
}


bool Foam::planarSteps::walk
(
    const label stage,
    const scalar dt,
    const pointTracking& td,
    const vector2D& start,
    const vector2D& U,
    vector2D& sum,
    label& celli,
    vector2D& at
) const
{
    const pointIntegration& scheme = td.integration;
    const bool last = stage == scheme.nStages() - 1;

    sum += scheme.b(stage)*U;
    const vector2D way(dt*(last ? sum : scheme.a(stage)*U));
    const vector2D next(start + way);

    const bool done =
        planarWalk::isFinite(way) && walk_->walk(celli, at, next);
    at = next;

    return done;
}


void Foam::planarSteps::stepAll(const pointTracking& td)
{
    for (label stage = 0; stage < td.integration.nStages(); ++stage)
    {
        td.velocity.inPlane(*walk_, at_, cells_, U_);
        forAll(points_, i)
        {
            done_[i] =
                done_[i]
             && walk
                (
                    stage, td.dt, td,
                    start_[i], U_[i], sum_[i], cells_[i], at_[i]
                );
        }
    }
    forAll(points_, i)
    {
        if (done_[i])
        {
            put(*points_[i], start_[i], cells_[i], at_[i], td);
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
    label celli = p.cell();

    scalar begin = 0;
    while (begin < 1 - 1e-10)
    {
        if (!(std::ceil((1 - begin)*td.courant[celli]) < mostParts))
        {
            return false;
        }
        const scalar part = materialPoint::partOf(1 - begin, td.courant[celli]);

        const vector2D origin(at);
        vector2D U, sum(Zero);
        for (label stage = 0; stage < td.integration.nStages(); ++stage)
        {
            UList<vector2D> one(&U, 1);
            td.velocity.inPlane
            (
                *walk_, UList<vector2D>(&at, 1), labelUList(&celli, 1), one
            );
            if (!walk(stage, part*td.dt, td, origin, U, sum, celli, at))
            {
                return false;
            }
        }
        begin += part;
    }
    put(p, start, celli, at, td);

    return true;
}


void Foam::planarSteps::put
(
    materialPoint& p,
    const vector2D& start,
    const label celli,
    const vector2D& at,
    const pointTracking& td
) const
{
    // Resting points keep their bits
    if (magSqr(at - start) > sqr(td.nothing))
    {
        walk_->put(p, celli, at);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::planarSteps::step
(
    materialPoint& p,
    const pointTracking& td
)
{
    if (!walk_)
    {
        return false;
    }

    if (next_ >= points_.size() || points_[next_] != &p)
    {
        take(p, td);
        stepAll(td);
    }

    const label i = next_++;

    return done_[i] || (td.courant[p.cell()] > 1 && inParts(p, td));
}


// ************************************************************************* //
