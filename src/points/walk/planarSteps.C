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

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Points of a batch: few enough that they and their cells stay in the cache
static const Foam::label mostPoints = 256;


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


void Foam::planarSteps::walk
(
    const label stage,
    const pointTracking& td
)
{
    const pointIntegration& scheme = td.integration;
    const bool last = stage == scheme.nStages() - 1;
    const scalar a = last ? 0 : scheme.a(stage), b = scheme.b(stage);

    td.velocity.inPlane(*walk_, at_, cells_, U_);

    forAll(points_, i)
    {
        if (!done_[i])
        {
            continue;
        }

        sum_[i] += b*U_[i];
        const vector2D way(td.dt*(last ? sum_[i] : a*U_[i]));
        const vector2D next(start_[i] + way);

        done_[i] =
            planarWalk::isFinite(way)
         && walk_->walk(cells_[i], at_[i], next);
        at_[i] = next;
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
        for (label stage = 0; stage < td.integration.nStages(); ++stage)
        {
            walk(stage, td);
        }
        forAll(points_, i)
        {
            // Resting points keep their bits
            if (done_[i] && magSqr(at_[i] - start_[i]) > sqr(td.nothing))
            {
                walk_->put(*points_[i], cells_[i], at_[i]);
            }
        }
    }

    const label i = next_++;

    return done_[i] || (td.courant[p.cell()] > 1 && walk_->step(p, td));
}


// ************************************************************************* //
