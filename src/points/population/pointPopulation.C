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
    //- merged: five times what is promised, since splitting follows
    static const scalar tinyShare = 0.05;

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


Foam::label Foam::pointPopulation::splitLarge(cellPoints& points) const
{
    materialPointCloud& cloud = points.cloud();
    const scalarField& most = cloud.census().most();

    DynamicList<materialPoint*> large;
    forAll(most, celli)
    {
        if (most[celli] > margin*largest_[celli])
        {
            large.append(points[celli]);
        }
    }

    // Those added are looked at too, in the cells where they are
    label nAdded = 0;
    for (label i = 0; i < large.size(); ++i)
    {
        materialPoint& p = *large[i];
        while (p.volume() > margin*largest_[p.cell()])
        {
            const label celli = p.cell();
            materialPoint& added = splitting_.spread(cloud, p, points[celli]);
            large.append(&added);
            points[added.cell()].append(&added);
            if (p.cell() != celli)
            {
                points.remove(celli, &p);
                points[p.cell()].append(&p);
            }
            ++nAdded;
        }
    }

    return nAdded;
}


Foam::label Foam::pointPopulation::mergeMany(cellPoints& points) const
{
    // Of before: merging makes cells around a tiny point no tinier
    const pointCensus& census = points.cloud().census();
    label nDeleted = 0;

    forAll(census.count(), celli)
    {
        const label n = census.count()[celli];
        if (census.least()[celli]*n < tinyShare*census.filled()[celli])
        {
            nDeleted += merging_.sweep(points, celli, tinyShare);
        }
        if (n > maxPointsPerCell_)
        {
            // Up to what will not be split again, where that is enough
            for (const scalar times : {1, 2})
            {
                nDeleted += merging_.thin
                (
                    points, celli, maxPointsPerCell_, times*largest_[celli]
                );
            }
        }
    }

    return nDeleted;
}


Foam::label Foam::pointPopulation::splitFew(cellPoints& points) const
{
    const labelList& count = points.cloud().census().count();
    label nAdded = 0;

    forAll(count, celli)
    {
        if (count[celli] >= minPointsPerCell_)
        {
            continue;
        }
        DynamicList<materialPoint*>& here = points[celli];
        while (here.size() && here.size() < minPointsPerCell_)
        {
            materialPoint* largest = here[0];
            for (materialPoint* p : here)
            {
                largest = p->volume() > cellSurroundings::more*largest->volume()
                  ? p : largest;
            }
            here.append(&splitting_.split(points.cloud(), *largest, here));
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

    cellPoints points(cloud);
    const auto note = [&](label& sum, const label n)
    {
        sum += n;
        if (n)
        {
            census.update(points);
        }
    };

    note(changed.first(), splitLarge(points));
    note
    (
        changed.first(),
        balance_.apply(points, compressible(surroundings_.mesh()))
    );
    note(changed.second(), mergeMany(points));
    note(changed.first(), splitFew(points));

    cloud.closeUp();

    reduce(changed.first(), sumOp<label>());
    reduce(changed.second(), sumOp<label>());
    census.changeBy(changed.first() - changed.second());

    return changed;
}


// ************************************************************************* //
