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

#include "fileCentres.H"
#include "axialCentres.H"
#include "axialSymmetry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::fileCentres::places
(
    const materialPointList& points
) const
{
    pointField places(points.size());
    label i = 0;
    for (const materialPoint& p : points)
    {
        places[i++] = p.position(mesh_);
    }

    return places;
}


void Foam::fileCentres::put
(
    materialPointList& points,
    const planarWalk& walk,
    const pointField& places
)
{
    label i = 0;
    for (materialPoint& p : points)
    {
        walk.put(p, places[i++]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fileCentres::fileCentres(const polyMesh& mesh)
:
    mesh_(mesh)
{
    if (!axialSymmetry(mesh).active())
    {
        return;
    }

    run_.reset(new planarWalk(mesh));
    {
        const volumeCentres files(mesh);
        file_.reset(new planarWalk(mesh));
    }

    // Cells of other shapes than those of a wedge
    if (!run_->possible() || !file_->possible())
    {
        run_.clear();
        file_.clear();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fileCentres::read(materialPointList& points) const
{
    if (!file_)
    {
        return;
    }

    pointField at;
    {
        const volumeCentres files(mesh_);
        at = places(points);
    }
    put(points, *run_, at);
}


void Foam::fileCentres::write
(
    materialPointList& points,
    const std::function<void()>& act
) const
{
    if (!file_)
    {
        act();
        return;
    }

    pointField at(places(points));
    {
        const volumeCentres files(mesh_);
        put(points, *file_, at);
        act();
        at = places(points);
    }
    put(points, *run_, at);
}


// ************************************************************************* //
