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
#include "cellPoints.H"
#include "materialPointCloud.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

namespace Foam
{
    //- Share of the mean volume of the points of a cell below which one is
    //- merged: three times what is promised
    static const scalar tinyShare = 0.03;

    //- By this much more than the largest volume points are not yet split:
    //- those of the start may be as large, but for rounding
    static const scalar margin = 1 + 1e-6;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::pointPopulation::compressible(const fvMesh& mesh)
{
    const volScalarField* invB = mesh.findObject<volScalarField>("invB");

    return invB && gMax(invB->primitiveField()) > 0;
}


Foam::label Foam::pointPopulation::splitLarge(materialPointCloud& cloud) const
{
    const scalarField& most = cloud.census().most();
    bitSet large(most.size());
    forAll(most, celli)
    {
        if (most[celli] > margin*largest_[celli])
        {
            large.set(celli);
        }
    }

    cellPoints points(cloud, large);
    label nAdded = 0;
    for (const label celli : large)
    {
        // Those added are looked at too
        DynamicList<materialPoint*>& here = points[celli];
        for (label i = 0; i < here.size(); ++i)
        {
            while (here[i]->volume() > margin*largest_[celli])
            {
                here.append(splitting_.split(cloud, *here[i], here));
                ++nAdded;
            }
        }
    }

    return nAdded;
}


Foam::label Foam::pointPopulation::mergeMany(materialPointCloud& cloud) const
{
    const pointCensus& census = cloud.census();
    const labelList& count = census.count();

    bitSet tiny(count.size()), many(count.size()), gathered(count.size());
    forAll(count, celli)
    {
        if
        (
            census.least()[celli]*count[celli]
          < tinyShare*census.filled()[celli]
        )
        {
            tiny.set(celli);
            for (const label pointi : surroundings_.corners(celli))
            {
                gathered.set(surroundings_.around(pointi));
            }
        }
        if (count[celli] > maxPointsPerCell_)
        {
            many.set(celli);
        }
    }
    gathered |= tiny;
    gathered |= many;

    cellPoints points(cloud, gathered);
    label nDeleted = 0;
    for (const label celli : tiny)
    {
        nDeleted += merging_.sweep(cloud, points, celli, tinyShare);
    }
    for (const label celli : many)
    {
        nDeleted += merging_.thin
        (
            cloud, points[celli], maxPointsPerCell_, largest_[celli]
        );
    }

    return nDeleted;
}


Foam::label Foam::pointPopulation::splitFew(materialPointCloud& cloud) const
{
    const labelList& count = cloud.census().count();
    bitSet few(count.size());
    forAll(count, celli)
    {
        if (count[celli] < minPointsPerCell_)
        {
            few.set(celli);
        }
    }

    cellPoints points(cloud, few);
    label nAdded = 0;
    for (const label celli : few)
    {
        DynamicList<materialPoint*>& here = points[celli];
        while (here.size() && here.size() < minPointsPerCell_)
        {
            materialPoint* largest = here[0];
            for (materialPoint* p : here)
            {
                largest = p->volume() > largest->volume() ? p : largest;
            }
            here.append(splitting_.split(cloud, *largest, here));
            ++nAdded;
        }
    }

    return nAdded;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointPopulation::pointPopulation
(
    const fvMesh& mesh,
    const dictionary& dict,
    const label pointsPerCell
)
:
    surroundings_(mesh),
    minPointsPerCell_
    (
        dict.getOrDefault<label>("minPointsPerCell", pointsPerCell/4)
    ),
    maxPointsPerCell_
    (
        dict.getOrDefault<label>("maxPointsPerCell", 2*pointsPerCell)
    ),
    splitting_(surroundings_),
    merging_(surroundings_),
    balance_(surroundings_)
{
    if (minPointsPerCell_ < 0 || minPointsPerCell_ > pointsPerCell)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'minPointsPerCell' is " << minPointsPerCell_ << nl
            << "    Allowed: 0 to pointsPerCell, " << pointsPerCell
            << exit(FatalIOError);
    }

    const label least = max(minPointsPerCell_, label(1));
    if (maxPointsPerCell_ < least)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'maxPointsPerCell' is " << maxPointsPerCell_ << nl
            << "    Allowed: minPointsPerCell, " << least
            << ", or more" << exit(FatalIOError);
    }

    if (minPointsPerCell_)
    {
        largest_ = surroundings_.smallestAround()/scalar(minPointsPerCell_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelPair Foam::pointPopulation::mend
(
    materialPointCloud& cloud,
    pointCensus& census
) const
{
    labelPair changed(0, 0);
    if (minPointsPerCell_ == 0)
    {
        return changed;
    }

    const auto note = [&](label& sum, const label n)
    {
        if (returnReduce(n, sumOp<label>()))
        {
            sum += returnReduce(n, sumOp<label>());
            census.take(cloud);
        }
    };

    note(changed.first(), splitLarge(cloud));
    scalarField filled(census.filled());
    note
    (
        changed.first(),
        balance_.apply(cloud, filled, compressible(surroundings_.mesh()))
    );
    note(changed.second(), mergeMany(cloud));
    note(changed.first(), splitFew(cloud));

    return changed;
}


// ************************************************************************* //
