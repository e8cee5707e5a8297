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

#include "volumeBalance.H"
#include "cellPoints.H"
#include "materialPointCloud.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Fills that call for a change, and the least difference of two
    static const scalar low = 0.6, high = 1.7, differ = 0.05;

    //- Fills of which those that are equal but for rounding are equal
    static tmp<scalarField> rounded(const tmp<scalarField>& fill)
    {
        tmp<scalarField> tresult(new scalarField(fill));
        for (scalar& f : tresult.ref())
        {
            f = 1e-9*std::round(1e9*f);
        }
        return tresult;
    }

    static bool anyCoupled(const polyMesh& mesh)
    {
        for (const polyPatch& pp : mesh.boundaryMesh())
        {
            if (pp.coupled())
            {
                return true;
            }
        }
        return false;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type, class CombineOp>
void Foam::volumeBalance::sync
(
    List<Type>& values,
    const CombineOp& op,
    const Type& none
) const
{
    if (coupled_)
    {
        syncTools::syncPointList(surroundings_.mesh(), values, op, none);
    }
}


bool Foam::volumeBalance::gives
(
    const scalar lower,
    const scalar upper,
    const bool compressible
)
{
    return
        compressible
      ? lower == 0 && upper > 0
      : (lower < low || upper > high) && upper - lower > differ;
}


Foam::DynamicList<Foam::volumeBalance::meeting>
Foam::volumeBalance::meetings
(
    const scalarField& fill,
    const bool compressible
) const
{
    const label nPoints = surroundings_.mesh().nPoints();

    scalarList lower(nPoints, GREAT), upper(nPoints, -GREAT);
    forAll(fill, celli)
    {
        for (const label pointi : surroundings_.corners(celli))
        {
            lower[pointi] = min(lower[pointi], fill[celli]);
            upper[pointi] = max(upper[pointi], fill[celli]);
        }
    }
    sync(lower, minEqOp<scalar>(), scalar(GREAT));
    sync(upper, maxEqOp<scalar>(), scalar(-GREAT));

    // Of cells of the same fill that of the lowest number
    labelList taker(nPoints, labelMax), giver(nPoints, labelMax);
    forAll(fill, celli)
    {
        const label number = numbers_.toGlobal(celli);
        for (const label pointi : surroundings_.corners(celli))
        {
            if (fill[celli] == lower[pointi])
            {
                taker[pointi] = min(taker[pointi], number);
            }
            if (fill[celli] == upper[pointi])
            {
                giver[pointi] = min(giver[pointi], number);
            }
        }
    }
    sync(taker, minEqOp<label>(), label(labelMax));
    sync(giver, minEqOp<label>(), label(labelMax));

    DynamicList<meeting> found;
    for (label pointi = 0; pointi < nPoints; ++pointi)
    {
        if
        (
            !surroundings_.excluded(pointi)
         && gives(lower[pointi], upper[pointi], compressible)
        )
        {
            found.append
            (
                meeting
                {
                    pointi, taker[pointi], giver[pointi], lower[pointi],
                    upper[pointi]
                }
            );
        }
    }

    return found;
}


Foam::label Foam::volumeBalance::local(const label number) const
{
    return numbers_.isLocal(number) ? numbers_.toLocal(number) : -1;
}


bool Foam::volumeBalance::isTaken
(
    const UList<materialPoint*>& points,
    const UList<point>& coming,
    const materialPoint& own,
    const point& place
) const
{
    const fvMesh& mesh = surroundings_.mesh();
    const scalar V = mesh.V()[own.cell()];
    const scalar apart = 1e-3*surroundings_.size(V, place);

    for (const materialPoint* p : points)
    {
        if (p != &own && mag(p->position(mesh) - place) < apart)
        {
            return true;
        }
    }
    for (const point& p : coming)
    {
        if (mag(p - place) < apart)
        {
            return true;
        }
    }

    return false;
}


Foam::scalarList Foam::volumeBalance::give
(
    materialPointCloud& cloud,
    const DynamicList<materialPoint*>& points,
    const UList<point>& coming,
    const scalar volume,
    const point& place
) const
{
    const polyMesh& mesh = surroundings_.mesh();

    // The nearest that has twice the volume, else the largest
    materialPoint* giver = points[0];
    bool enough = false;
    scalar nearest = GREAT;
    for (materialPoint* p : points)
    {
        const scalar distance = magSqr(p->position(mesh) - place);
        if
        (
            cellSurroundings::more*p->volume() >= 2*volume
         && cellSurroundings::more*distance < nearest
        )
        {
            nearest = distance;
            giver = p;
            enough = true;
        }
        else if
        (
            !enough
         && p->volume() > cellSurroundings::more*giver->volume()
        )
        {
            giver = p;
        }
    }

    const point from(giver->position(mesh));
    const label celli = giver->cell();
    scalar part = min(volume/giver->volume(), scalar(0.5));
    point to(from - part/(1 - part)*(place - from));

    // Places of a sequence are a lattice: what is opposite to one of them, seen
    // from another, may be a third
    const label mostTrials = 10;
    for
    (
        label i = 0;
        i < mostTrials && isTaken(points, coming, *giver, to);
        ++i
    )
    {
        part *= 0.9;
        to = from - part/(1 - part)*(place - from);
    }

    scalarList numbers(giver->handsOn());
    numbers[2] = part*giver->volume();
    giver->volume() -= numbers[2];
    cloud.properties().split(*giver);
    if (surroundings_.contains(celli, to))
    {
        giver->trackToFace(mesh, to - from);
    }

    return numbers;
}


void Foam::volumeBalance::findPlaces
(
    cellPoints& points,
    const UList<meeting>& meetings,
    scalarList& volume,
    List<scalarList>& place,
    Map<DynamicList<point>>& taken
) const
{
    const scalarField& V = surroundings_.mesh().V();

    for (const meeting& at : meetings)
    {
        const scalar half = 0.5*(at.high - at.low);
        for (const label number : {at.taker, at.giver})
        {
            const label celli = local(number);
            if (celli >= 0)
            {
                volume[at.pointi] = min
                (
                    volume[at.pointi],
                    half*V[celli]/surroundings_.corners(celli).size()
                );
            }
        }

        const label celli = local(at.taker);
        if (celli >= 0)
        {
            DynamicList<point>& others = taken(celli);
            if (others.empty())
            {
                for (const materialPoint* p : points[celli])
                {
                    others.append(p->position(surroundings_.mesh()));
                }
            }
            const point p(surroundings_.place(celli, others));
            others.append(p);
            for (direction d = 0; d < 3; ++d)
            {
                place[d][at.pointi] = p[d];
            }
        }
    }
    sync(volume, minEqOp<scalar>(), scalar(GREAT));
    for (scalarList& each : place)
    {
        sync(each, plusEqOp<scalar>(), scalar(0));
    }
}


Foam::label Foam::volumeBalance::handOn
(
    cellPoints& points,
    const UList<meeting>& meetings,
    scalarField& filled
) const
{
    materialPointCloud& cloud = points.cloud();
    const fvMesh& mesh = surroundings_.mesh();

    // What is handed on by point of the mesh, and where it goes; places of
    // points of the takers, those to come too
    const label nPoints = mesh.nPoints();
    scalarList volume(nPoints, GREAT);
    List<scalarList> place(3, scalarList(nPoints, Zero));
    Map<DynamicList<point>> taken;
    findPlaces(points, meetings, volume, place, taken);

    List<scalarList> numbers
    (
        materialPoint::nOwnNumbers + cloud.properties().nValues(),
        scalarList(nPoints, Zero)
    );
    for (const meeting& at : meetings)
    {
        const label celli = local(at.giver);
        if (celli >= 0)
        {
            const label pointi = at.pointi;
            const scalarList given
            (
                give
                (
                    cloud,
                    points[celli],
                    taken(celli),
                    volume[pointi],
                    point(place[0][pointi], place[1][pointi], place[2][pointi])
                )
            );
            forAll(given, k)
            {
                numbers[k][pointi] = given[k];
            }
            filled[celli] -= given[2];
        }
    }
    for (scalarList& each : numbers)
    {
        sync(each, plusEqOp<scalar>(), scalar(0));
    }

    label nAdded = 0;
    for (const meeting& at : meetings)
    {
        const label celli = local(at.taker);
        if (celli >= 0)
        {
            const label pointi = at.pointi;
            scalarList handed(numbers.size());
            forAll(handed, k)
            {
                handed[k] = numbers[k][pointi];
            }
            materialPoint& added = cloud.add
            (
                materialPoint
                (
                    mesh,
                    point(place[0][pointi], place[1][pointi], place[2][pointi]),
                    celli,
                    handed
                )
            );
            points[celli].append(&added);
            filled[celli] += handed[2];
            ++nAdded;
        }
    }

    return nAdded;
}


void Foam::volumeBalance::checkReach(const scalarField& fill) const
{
    const fvMesh& mesh = surroundings_.mesh();
    const scalar large = 0.5*planarCells::typicalVolume(mesh);

    scalarList upper(mesh.nPoints(), Zero);
    forAll(fill, celli)
    {
        for (const label pointi : surroundings_.corners(celli))
        {
            upper[pointi] = max(upper[pointi], fill[celli]);
        }
    }
    sync(upper, maxEqOp<scalar>(), scalar(0));

    forAll(fill, celli)
    {
        // A hole of small cells is filled from its rim inward
        if (fill[celli] > 0 || mesh.V()[celli] < large)
        {
            continue;
        }
        bool reached = false;
        for (const label pointi : surroundings_.corners(celli))
        {
            reached = reached
             || (upper[pointi] > 0 && !surroundings_.excluded(pointi));
        }
        if (!reached)
        {
            FatalErrorInFunction
                << "Cell " << celli << " at " << mesh.cellCentres()[celli]
                << " has no material point and its neighbours have none"
                << " either, time " << mesh.time().timeName() << nl
                << "    Cures: more pointsPerCell or minPointsPerCell, a"
                << " smaller maxCo" << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::volumeBalance::volumeBalance(const cellSurroundings& surroundings)
:
    surroundings_(surroundings),
    coupled_(returnReduce(anyCoupled(surroundings.mesh()), orOp<bool>())),
    numbers_(surroundings.mesh().nCells())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::volumeBalance::apply
(
    cellPoints& points,
    const bool compressible
) const
{
    const scalarField& V = surroundings_.mesh().V();
    scalarField filled(points.cloud().census().filled());
    const label nPasses = 60;
    label nAdded = 0;

    for (label pass = 0; pass < nPasses; ++pass)
    {
        // Most steps end here: no cell to be mended
        const scalarField fill(rounded(filled/V));
        const scalar least = gMin(fill);
        if
        (
            compressible ? least > 0 : least >= low && gMax(fill) <= high
        )
        {
            break;
        }

        if (pass == 0)
        {
            checkReach(fill);
        }

        // Cells may be too empty where none around has more to give
        const DynamicList<meeting> places(meetings(fill, compressible));
        if (!returnReduce(places.size() > 0, orOp<bool>()))
        {
            break;
        }
        nAdded += handOn(points, places, filled);
    }

    return nAdded;
}


// ************************************************************************* //
