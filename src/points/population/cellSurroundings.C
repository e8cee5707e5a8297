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

#include "cellSurroundings.H"
#include "coupledPolyPatch.H"
#include "oneLayer.H"
#include "meshTools.H"
#include "syncTools.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::point Foam::cellSurroundings::towards
(
    const label celli,
    const point& from,
    const scalar part,
    const UList<point>& others
) const
{
    const pointField polygon(cells_.corners(celli));

    // The same few again, where no point has moved, may all be taken
    const label nTrials = 4, mostTrials = 100;
    point best(mesh_.cellCentres()[celli]);
    const scalar apart = sqr(0.001*size(mesh_.cellVolumes()[celli], best));

    scalar farthest = -1;

    label trial = others.size();
    for
    (
        label i = 0;
        i < nTrials || (farthest < apart && i < mostTrials);
        ++i
    )
    {
        const point p
        (
            (1 - part)*from + part*cells_.spread(polygon, trial)
        );

        scalar nearest = GREAT;
        for (const point& other : others)
        {
            nearest = min(nearest, magSqr(other - p));
        }
        if (nearest > more*farthest)
        {
            farthest = nearest;
            best = p;
        }
    }

    return best;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellSurroundings::cellSurroundings(const fvMesh& mesh)
:
    mesh_(mesh),
    cells_(mesh),
    front_(mesh.nCells(), -1),
    excluded_(mesh.nPoints(), true)
{
    const direction normal = cells_.frame().normalAxis();
    const scalar middle = mesh.bounds().midpoint()[normal];

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (oneLayer::isPlane(pp))
        {
            forAll(pp, i)
            {
                if (pp.faceCentres()[i][normal] > middle)
                {
                    front_[pp.faceCells()[i]] = pp.start() + i;
                    excluded_.unset(pp[i]);
                }
            }
        }
    }
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if
        (
            isA<coupledPolyPatch>(pp)
         && !refCast<const coupledPolyPatch>(pp).parallel()
        )
        {
            excluded_.set(pp.meshPoints());
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::cellSurroundings::smallestAround() const
{
    const scalarField& V = mesh_.V();

    scalarField atPoints(mesh_.nPoints(), GREAT);
    forAll(V, celli)
    {
        for (const label pointi : corners(celli))
        {
            atPoints[pointi] = min(atPoints[pointi], V[celli]);
        }
    }
    syncTools::syncPointList(mesh_, atPoints, minEqOp<scalar>(), GREAT);

    tmp<scalarField> tsmallest(new scalarField(V));
    scalarField& smallest = tsmallest.ref();
    forAll(V, celli)
    {
        for (const label pointi : corners(celli))
        {
            smallest[celli] = min(smallest[celli], atPoints[pointi]);
        }
    }

    return tsmallest;
}


Foam::vector Foam::cellSurroundings::inPlane
(
    const scalar length,
    const scalar angle
) const
{
    return cells_.frame().inSpace
    (
        length*Foam::cos(angle), length*Foam::sin(angle)
    );
}


bool Foam::cellSurroundings::contains(const label celli, const point& p) const
{
    return cells_.frame().contains(cells_.corners(celli), p);
}


// ************************************************************************* //
