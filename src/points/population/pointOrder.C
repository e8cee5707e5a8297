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

#include "pointOrder.H"
#include "materialPointCloud.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Share of the points that may be apart from the one before them
static const Foam::scalar mostApart = 0.005;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pointOrder::sort(materialPointCloud& cloud)
{
    labelList next(cloud.pMesh().nCells() + 1, Zero);
    for (const materialPoint& p : cloud)
    {
        ++next[p.cell() + 1];
    }
    for (label celli = 1; celli < next.size(); ++celli)
    {
        next[celli] += next[celli - 1];
    }

    // Where each of them belongs
    labelList place(cloud.size());
    label n = 0;
    for (const materialPoint& p : cloud)
    {
        place[n++] = next[p.cell()]++;
    }

    // Each change puts one where it belongs
    const materialPointList::iterator points(cloud.begin());
    forAll(place, i)
    {
        while (place[i] != i)
        {
            const label j = place[i];
            std::swap(points[i], points[j]);
            Swap(place[i], place[j]);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointOrder::mend(materialPointCloud& cloud)
{
    if (cloud.census().apart() > mostApart*cloud.size())
    {
        sort(cloud);
    }
}


// ************************************************************************* //
