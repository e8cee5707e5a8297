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

#include "materialPointList.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::materialPointList::drop(materialPoint& p)
{
    p.setGone();
    ++nGone_;
}


void Foam::materialPointList::closeUp()
{
    if (nGone_)
    {
        const auto isGone = [](const materialPoint& p) { return p.gone(); };
        points_.erase
        (
            std::remove_if(points_.begin(), points_.end(), isGone),
            points_.end()
        );
        nGone_ = 0;
    }
}


void Foam::materialPointList::clear()
{
    points_.clear();
    nGone_ = 0;
}


void Foam::materialPointList::exchange(materialPointList& other)
{
    points_.swap(other.points_);
    std::swap(nGone_, other.nGone_);
}


// ************************************************************************* //
