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
#include "oneLayer.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planarFrame::planarFrame(const polyMesh& mesh)
:
    normal_(0)
{
    const Vector<label>& dirs = mesh.geometricD();
    label nAcross = 0;

    for (direction d = 0; d < 3; ++d)
    {
        if (dirs[d] < 0)
        {
            normal_ = d;
            ++nAcross;
        }
    }

    if (nAcross != 1)
    {
        FatalErrorInFunction
            << "The mesh is not planar: it has " << 3 - nAcross
            << " directions in which it is solved, patch types "
            << mesh.boundaryMesh().types() << nl
            << "    Allowed: two, that is one cell across, with patches of"
            << " type empty in front and back, or of type wedge"
            << exit(FatalError);
    }

    oneLayer::check(mesh, normal_);
}


// ************************************************************************* //
