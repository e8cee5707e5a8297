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

#include "pointCensus.H"
#include "cellPoints.H"
#include "materialPointCloud.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointCensus::pointCensus()
:
    nPoints_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointCensus::take(const materialPointCloud& cloud)
{
    const label nCells = cloud.pMesh().nCells();
    count_.setSize(nCells);
    count_ = 0;
    filled_.setSize(nCells);
    filled_ = 0;
    least_.setSize(nCells);
    least_ = GREAT;
    most_.setSize(nCells);
    most_ = 0;
    volume_.setSize(cloud.materials().size());
    volume_ = 0;

    for (const materialPoint& p : cloud)
    {
        const label celli = p.cell();
        const scalar V = p.volume();

        ++count_[celli];
        filled_[celli] += V;
        least_[celli] = min(least_[celli], V);
        most_[celli] = max(most_[celli], V);
        volume_[p.material()] += V;
    }

    nPoints_ = cloud.nPoints();
    reduce(volume_, sumOp<scalarField>());
}


void Foam::pointCensus::update(const cellPoints& points)
{
    forAllConstIters(points.asked(), iter)
    {
        const label celli = iter.key();
        count_[celli] = iter().size();
        filled_[celli] = 0;
        least_[celli] = GREAT;
        most_[celli] = 0;

        for (const materialPoint* p : iter())
        {
            const scalar V = p->volume();
            filled_[celli] += V;
            least_[celli] = min(least_[celli], V);
            most_[celli] = max(most_[celli], V);
        }
    }
}


// ************************************************************************* //
