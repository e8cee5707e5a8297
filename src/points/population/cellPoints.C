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

#include "cellPoints.H"
#include "materialPointCloud.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellPoints::sort()
{
    start_ = cloud_.census().starts();
    sorted_.setSize(start_.last());
    labelList next(start_);
    label i = 0;
    for (const materialPoint& p : cloud_)
    {
        sorted_[next[p.cell()]++] = i++;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::DynamicList<Foam::materialPoint*>& Foam::cellPoints::operator[]
(
    const label celli
)
{
    if (start_.empty())
    {
        sort();
    }

    auto iter = asked_.find(celli);
    if (iter.found())
    {
        return *iter;
    }

    DynamicList<materialPoint*>& here = asked_(celli);
    for (label i = start_[celli]; i < start_[celli + 1]; ++i)
    {
        here.append(&cloud_.begin()[sorted_[i]]);
    }

    return here;
}


void Foam::cellPoints::remove(const label celli, const materialPoint* p)
{
    DynamicList<materialPoint*>& here = operator[](celli);
    label n = 0;
    for (materialPoint* each : here)
    {
        if (each != p)
        {
            here[n++] = each;
        }
    }
    here.setSize(n);
}


// ************************************************************************* //
