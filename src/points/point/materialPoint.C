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

#include "materialPointCloud.H"
#include "pointVelocity.H"
#include "pointIntegration.H"
#include "planarWalk.H"
#include "coupledPolyPatch.H"
#include "wedgePolyPatch.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTemplateTypeNameAndDebug(Cloud<materialPoint>, 0);
}


// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Cells in one step above which a point is not tracked
static const Foam::scalar mostCells = 1e6;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::materialPoint::startPart(const scalar begin, const scalar courant)
{
    const scalar left = 1 - begin;

    // Not a number neither; parts would get lost in the rounding of the step
    if (!(courant < mostCells))
    {
        lost("the way of its step is more than a million cells");
    }

    begin_ = begin;
    part_ = partOf(left, courant);
    stage_ = -1;
    travelled_ = Zero;
    sum_ = Zero;
}


void Foam::materialPoint::startStage(const trackingData& td)
{
    const pointIntegration& scheme = td.integration;
    const vector U(td.velocity.value(*this));

    if (!std::isfinite(mag(U)))
    {
        lost("the velocity is not a number");
    }

    ++stage_;
    sum_ += scheme.b(stage_)*U;
    displacement_ =
        part_*td.dt*(stage_ < scheme.nStages() - 1 ? scheme.a(stage_)*U : sum_)
      - travelled_;

    if (!std::isfinite(mag(displacement_)))
    {
        lost("the way of its step is not a number");
    }
}


void Foam::materialPoint::lost(const string& why) const
{
    FatalErrorInFunction
        << "Material point " << origProc() << ":" << origId() << " at "
        << position() << " in cell " << cell() << ", time "
        << mesh().time().timeName() << ": " << why.c_str()
        << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materialPoint::materialPoint
(
    const polyMesh& mesh,
    const point& position,
    const label celli,
    const label material,
    const label dye,
    const scalar volume
)
:
    particle(mesh, position, celli),
    material_(material),
    dye_(dye),
    volume_(volume)
{
    startStep();
}


Foam::materialPoint::materialPoint
(
    const polyMesh& mesh,
    const point& position,
    const label celli,
    const UList<scalar>& numbers
)
:
    particle(mesh, position, celli),
    material_(label(numbers[0])),
    dye_(label(numbers[1])),
    volume_(numbers[2])
{
    startStep();
    values_ =
        SubList<scalar>(numbers, numbers.size() - nOwnNumbers, nOwnNumbers);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarList Foam::materialPoint::handsOn() const
{
    scalarList numbers(nOwnNumbers + values_.size());
    numbers[0] = material_;
    numbers[1] = dye_;
    numbers[2] = volume_;
    forAll(values_, i)
    {
        numbers[nOwnNumbers + i] = values_[i];
    }

    return numbers;
}


void Foam::materialPoint::startStep()
{
    startPart(0, 0);
    displacement_ = Zero;
    nTracks_ = 0;
}


void Foam::materialPoint::setPlace
(
    const barycentric& y,
    const label celli,
    const label facei,
    const label tetPti
)
{
    // OpenFOAM has no other way to set them but by tracking
    const_cast<barycentric&>(coordinates()) = y;
    cell() = celli;
    tetFace() = facei;
    tetPt() = tetPti;
    face() = -1;
}


bool Foam::materialPoint::move
(
    materialPointCloud& cloud,
    trackingData& td,
    const scalar trackTime
)
{
    td.switchProcessor = false;
    td.keepParticle = true;

    // Only a whole step: the cloud calls those that have done it again while
    // others change processor
    const bool atStart = stepFraction() == 0 && stage_ < 0;
    if (td.walk && atStart && td.walk->step(*this, td))
    {
        stepFraction() = 1;
        return true;
    }

    const label n = td.integration.nStages();

    // A point crosses few faces in a step; many mean that it cannot move on
    const label maxTracks = 10000;

    while (td.keepParticle && !td.switchProcessor && stepFraction() < 1)
    {
        const scalar stageEnd = begin_ + part_*scalar(stage_ + 1)/n;

        // Sums of parts of the step miss its end by rounding
        if (stage_ < 0 || stepFraction() > stageEnd - 1e-10)
        {
            if (stage_ == n - 1)
            {
                if (stageEnd > 1 - 1e-10)
                {
                    stepFraction() = 1;
                    break;
                }
                startPart(stageEnd, td.courant[cell()]);
            }
            else if (stage_ < 0)
            {
                startPart(begin_, td.courant[cell()]);
            }

            startStage(td);
            continue;
        }

        // Without a way its rounding would be tracked, for ever in a corner
        if (mag(displacement_) < td.nothing)
        {
            stepFraction() = stageEnd;
            continue;
        }

        const scalar before = stepFraction();
        const scalar rest = stageEnd - before;
        const vector way(displacement_);

        // Tracking lets the point leave the mid-plane by rounding
        trackToFace(n*rest/part_*way - deviationFromMeshCentre(), rest);
        travelled_ += n*(stepFraction() - before)/part_*way;
        hitFace(way, cloud, td);

        if (++nTracks_ > maxTracks)
        {
            lost("not at the end of its step after 10000 faces");
        }
    }

    if (td.keepParticle && !td.switchProcessor)
    {
        startStep();
    }

    return td.keepParticle;
}


bool Foam::materialPoint::hitPatch(materialPointCloud&, trackingData& td)
{
    const polyPatch& pp = mesh().boundaryMesh()[patch()];

    if (isA<coupledPolyPatch>(pp))
    {
        return false;
    }

    if (td.open.out(face()))
    {
        td.keepParticle = false;
        ++td.nOut[patch()];
        td.volumeOut[patch()] += volume_;
    }
    else
    {
        // Along the wall, and off it by more than the rounding of the way,
        // which would end at the wall again and again where that is oblique
        vector n(normal());
        if (isA<wedgePolyPatch>(pp))
        {
            // Met at the axis only
            const vector& e = refCast<const wedgePolyPatch>(pp).centreNormal();
            n = normalised(n - (n & e)*e);
        }
        displacement_ -=
            (max(displacement_ & n, scalar(0)) + 1e-12*mag(displacement_))*n;
    }

    return true;
}


void Foam::materialPoint::hitProcessorPatch
(
    materialPointCloud&,
    trackingData& td
)
{
    td.switchProcessor = true;
}


void Foam::materialPoint::transformProperties(const tensor& T)
{
    particle::transformProperties(T);
    displacement_ = transform(T, displacement_);
    travelled_ = transform(T, travelled_);
    sum_ = transform(T, sum_);

    if (values_.size())
    {
        mesh().lookupObject<materialPointCloud>
        (
            materialPointCloud::cloudName
        ).properties().transform(*this, T);
    }
}


void Foam::materialPoint::transformProperties(const vector& separation)
{
    particle::transformProperties(separation);
}


// ************************************************************************* //
