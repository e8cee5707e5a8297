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
#include "coupledPolyPatch.H"
#include "wedgePolyPatch.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    // As the files of the points have it
    defineTemplateTypeNameAndDebugWithName
    (
        Cloud<trackedPoint>,
        "Cloud<materialPoint>",
        0
    );
}


// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Cells in one step above which a point is not tracked
static const Foam::scalar mostCells = 1e6;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::trackedPoint::startPart(const scalar begin, const scalar courant)
{
    const scalar left = 1 - begin;

    // Not a number neither; parts would get lost in the rounding of the step
    if (!(courant < mostCells))
    {
        lost("the way of its step is more than a million cells");
    }

    const label nTracks = step_.nTracks;
    step_ = stepState();
    step_.nTracks = nTracks;
    step_.begin = begin;
    step_.part = partOf(left, courant);
}


void Foam::trackedPoint::startStage(const pointTracking& td)
{
    const pointIntegration& scheme = td.integration;
    const vector U(td.velocity.value(*this));

    if (!std::isfinite(mag(U)))
    {
        lost("the velocity is not a number");
    }

    stepState& s = step_;
    ++s.stage;
    s.sum += scheme.b(s.stage)*U;
    s.displacement =
        s.part*td.dt
       *(s.stage < scheme.nStages() - 1 ? scheme.a(s.stage)*U : s.sum)
      - s.travelled;

    if (!std::isfinite(mag(s.displacement)))
    {
        lost("the way of its step is not a number");
    }
}


void Foam::trackedPoint::trackStep
(
    materialPointCloud& cloud,
    pointTracking& td
)
{
    stepState& s = step_;
    const label n = td.integration.nStages();

    // A point crosses few faces in a step; many mean that it cannot move on
    const label maxTracks = 10000;

    while (td.keepParticle && !td.switchProcessor && stepFraction() < 1)
    {
        const scalar stageEnd = s.begin + s.part*scalar(s.stage + 1)/n;

        // Sums of parts of the step miss its end by rounding
        if (s.stage < 0 || stepFraction() > stageEnd - 1e-10)
        {
            if (s.stage == n - 1)
            {
                if (stageEnd > 1 - 1e-10)
                {
                    stepFraction() = 1;
                    break;
                }
                startPart(stageEnd, td.courant[cell()]);
            }
            else if (s.stage < 0)
            {
                startPart(s.begin, td.courant[cell()]);
            }

            startStage(td);
            continue;
        }

        // Without a way its rounding would be tracked, for ever in a corner
        if (mag(s.displacement) < td.nothing)
        {
            stepFraction() = stageEnd;
            continue;
        }

        const scalar before = stepFraction();
        const scalar rest = stageEnd - before;
        const vector way(s.displacement);

        // Tracking lets the point leave the mid-plane by rounding
        trackToFace(n*rest/s.part*way - deviationFromMeshCentre(), rest);
        s.travelled += n*(stepFraction() - before)/s.part*way;
        hitFace(way, cloud, td);

        if (++s.nTracks > maxTracks)
        {
            lost("not at the end of its step after 10000 faces");
        }
    }
}


void Foam::trackedPoint::lost(const string& why) const
{
    FatalErrorInFunction
        << "Material point " << origProc() << ":" << origId() << " at "
        << position() << " in cell " << cell() << ", time "
        << mesh().time().timeName() << ": " << why.c_str()
        << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::trackedPoint::trackedPoint(const polyMesh& mesh, materialPoint&& p)
:
    particle(p.asParticle(mesh)),
    point_(std::move(p)),
    waiting_(-1)
{}


Foam::trackedPoint::trackedPoint
(
    const polyMesh& mesh,
    Istream& is,
    bool readFields,
    bool newFormat
)
:
    particle(mesh, is, readFields, newFormat),
    point_(*this, 0, 0, 0),
    waiting_(-1)
{
    if (readFields)
    {
        label material, dye;
        scalar volume;
        is  >> material >> dye >> volume;
        point_ = materialPoint(*this, material, dye, volume);
        point_.values() = scalarList(is);

        is  >> step_.stage >> step_.nTracks >> step_.part >> step_.begin
            >> step_.displacement >> step_.travelled >> step_.sum;
    }

    is.check(FUNCTION_NAME);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::trackedPoint::move
(
    materialPointCloud& cloud,
    trackingData& td,
    const scalar
)
{
    td.switchProcessor = waiting_ >= 0;
    td.keepParticle = true;

    if (td.switchProcessor)
    {
        // The cloud has put all to the start of the step
        stepFraction() = waiting_;
        return true;
    }

    trackStep(cloud, td);

    return td.keepParticle;
}


bool Foam::trackedPoint::hitPatch(materialPointCloud&, trackingData& td)
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
        td.volumeOut[patch()] += point_.volume();
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
        vector& way = step_.displacement;
        way -= (max(way & n, scalar(0)) + 1e-12*mag(way))*n;
    }

    return true;
}


void Foam::trackedPoint::hitProcessorPatch
(
    materialPointCloud&,
    trackingData& td
)
{
    td.switchProcessor = true;
    waiting_ = stepFraction();
}


void Foam::trackedPoint::transformProperties(const tensor& T)
{
    particle::transformProperties(T);
    for (vector* v : {&step_.displacement, &step_.travelled, &step_.sum})
    {
        *v = transform(T, *v);
    }

    if (point_.values().size())
    {
        mesh().lookupObject<materialPointCloud>
        (
            materialPointCloud::cloudName
        ).properties().transform(point_, T);
    }
}


void Foam::trackedPoint::transformProperties(const vector& separation)
{
    particle::transformProperties(separation);
}


// * * * * * * * * * * * * * * * IOstream Operators  * * * * * * * * * * * * //

Foam::Ostream& Foam::operator<<(Ostream& os, const trackedPoint& p)
{
    os  << static_cast<const particle&>(p)
        << token::SPACE << p.point_.material()
        << token::SPACE << p.point_.dye()
        << token::SPACE << p.point_.volume()
        << token::SPACE << p.point_.values().list()
        << token::SPACE << p.step_.stage
        << token::SPACE << p.step_.nTracks
        << token::SPACE << p.step_.part
        << token::SPACE << p.step_.begin
        << token::SPACE << p.step_.displacement
        << token::SPACE << p.step_.travelled
        << token::SPACE << p.step_.sum;

    os.check(FUNCTION_NAME);
    return os;
}


// ************************************************************************* //
