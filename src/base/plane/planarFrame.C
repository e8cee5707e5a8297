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

#include "planarFrame.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planarFrame::planarFrame(const polyMesh& mesh)
{
    const Vector<label>& dirs = mesh.geometricD();
    normal_ = dirs.x() < 0 ? 0 : dirs.y() < 0 ? 1 : 2;
    i0_ = (normal_ + 1) % 3;
    i1_ = (normal_ + 2) % 3;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::planarFrame::contains
(
    const UList<point>& corners,
    const point& p
) const
{
    // On the same side of all edges would do for a convex polygon only:
    // count crossings of a ray
    bool inside = false;
    forAll(corners, i)
    {
        const point& a = corners[i];
        const point& b = corners[corners.fcIndex(i)];

        if ((a[i1_] > p[i1_]) != (b[i1_] > p[i1_]))
        {
            const scalar at =
                a[i0_] + (p[i1_] - a[i1_])/(b[i1_] - a[i1_])*(b[i0_] - a[i0_]);
            if (p[i0_] < at)
            {
                inside = !inside;
            }
        }
    }
    return inside;
}


// ************************************************************************* //
