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

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Mean differences in number of cells that share a face: on a structured mesh
//  of a layer four rows of cells
static const Foam::scalar farMeans = 8;

//- Cells whose data are in the cache at once, half a megabyte, which points
//  may come to in any order
static const Foam::label inCache = 1000;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pointCensus::clear(const label celli)
{
    count_[celli] = 0;
    filled_[celli] = 0;
    least_[celli] = GREAT;
    most_[celli] = 0;
}


void Foam::pointCensus::add(const label celli, const scalar volume)
{
    ++count_[celli];
    filled_[celli] += volume;
    least_[celli] = min(least_[celli], volume);
    most_[celli] = max(most_[celli], volume);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointCensus::pointCensus(const polyMesh& mesh)
:
    nPoints_(0),
    reach_(0),
    apart_(0)
{
    const label nFaces = mesh.nInternalFaces();
    scalar sum = 0;
    for (label facei = 0; facei < nFaces; ++facei)
    {
        sum += mag(mesh.faceNeighbour()[facei] - mesh.faceOwner()[facei]);
    }
    reach_ = max(label(farMeans*sum/max(nFaces, 1)), inCache);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointCensus::take(const materialPointCloud& cloud)
{
    const label nCells = cloud.pMesh().nCells();
    count_.setSize(nCells);
    filled_.setSize(nCells);
    least_.setSize(nCells);
    most_.setSize(nCells);
    for (label celli = 0; celli < nCells; ++celli)
    {
        clear(celli);
    }
    volume_.setSize(cloud.materials().size());
    volume_ = 0;

    apart_ = 0;
    label before = -1;
    for (const materialPoint& p : cloud)
    {
        apart_ += mag(p.cell() - before) > reach_;
        before = p.cell();
        add(p.cell(), p.volume());
        volume_[p.material()] += p.volume();
    }

    nPoints_ = cloud.nPoints();
    reduce(volume_, sumOp<scalarField>());
}


void Foam::pointCensus::update(const cellPoints& points)
{
    forAllConstIters(points.asked(), iter)
    {
        clear(iter.key());
        for (const materialPoint* p : iter())
        {
            add(iter.key(), p->volume());
        }
    }
}


Foam::labelList Foam::pointCensus::starts() const
{
    labelList starts(count_.size() + 1);
    starts[0] = 0;
    forAll(count_, celli)
    {
        starts[celli + 1] = starts[celli] + count_[celli];
    }
    return starts;
}


// ************************************************************************* //
