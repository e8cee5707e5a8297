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

#include "cellLinks.H"
#include "oneLayer.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellLinks::cellLinks(const fvMesh& mesh, const planarFrame& frame)
:
    mesh_(mesh),
    links_(2*mesh.nInternalFaces())
{
    const vector e(frame.e());
    const auto add =
    [&](const label celli, const label behind, vector way, const bool boundary)
    {
        way -= (way & e)*e;
        links_.append(link{celli, behind, way, boundary});
    };

    const vectorField& C = mesh.C();
    forAll(mesh.neighbour(), f)
    {
        const label P = mesh.owner()[f], N = mesh.neighbour()[f];
        add(P, N, C[N] - C[P], false);
        add(N, P, C[P] - C[N], false);
    }

    for (const fvPatch& patch : mesh.boundary())
    {
        if (oneLayer::isPlane(patch.patch()))
        {
            continue;
        }
        vectorField ways(patch.Cf() - patch.Cn());
        if (patch.coupled())
        {
            ways = patch.delta();
        }
        const label first =
            mesh.nCells() + patch.start() - mesh.nInternalFaces();
        forAll(ways, i)
        {
            add(patch.faceCells()[i], first + i, ways[i], !patch.coupled());
        }
    }
}


// ************************************************************************* //
