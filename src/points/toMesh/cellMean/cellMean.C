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

#include "cellMean.H"
#include "materialPointCloud.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace pointAverages
{
    defineTypeNameAndDebug(cellMean, 0);
    addToRunTimeSelectionTable(pointAverage, cellMean, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::pointAverages::cellMean::weights
(
    const materialPointCloud& cloud
) const
{
    scalarField total(cloud.pMesh().nCells(), Zero);
    for (const materialPoint& p : cloud)
    {
        total[p.cell()] += p.volume();
    }

    tmp<scalarField> tweights(new scalarField(cloud.size()));
    scalarField& w = tweights.ref();
    label i = 0;

    for (const materialPoint& p : cloud)
    {
        w[i++] = p.volume()/total[p.cell()];
    }

    return tweights;
}


void Foam::pointAverages::cellMean::sum
(
    const materialPointCloud& cloud,
    PtrList<volScalarField>& sums
) const
{
    for (const materialPoint& p : cloud)
    {
        sums[p.material()][p.cell()] += p.volume();
    }
}


// ************************************************************************* //
