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

#include "wallCurvature.H"
#include "fvMesh.H"
#include "PatchTools.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::wallCurvature
(
    const fvPatch& patch,
    const planarFrame& frame
)
{
    const polyPatch& pp = patch.patch();
    const pointField normals
    (
        PatchTools::pointNormals(pp.boundaryMesh().mesh(), pp)
    );
    const vectorField nf(patch.nf());
    const scalar corner = Foam::tan(degToRad(15.0));

    tmp<scalarField> tcurvature(new scalarField(pp.size(), Zero));
    scalarField& curvature = tcurvature.ref();

    forAll(pp, facei)
    {
        const vector& n = nf[facei];
        const vector t(n ^ frame.e());
        const face& points = pp.localFaces()[facei];

        scalar sum = 0, first = GREAT, last = -GREAT;
        label nSmooth = 0;
        for (const label pointi : points)
        {
            const scalar s =
                t & (pp.localPoints()[pointi] - pp.faceCentres()[facei]);
            const scalar angle =
                (normals[pointi] & t)/(normals[pointi] & n);

            first = min(first, s);
            last = max(last, s);
            if (mag(angle) < corner)
            {
                sum += sign(s)*angle;
                ++nSmooth;
            }
        }
        if (nSmooth)
        {
            curvature[facei] = 2*sum/(nSmooth*(last - first));
        }
    }

    return tcurvature;
}


// ************************************************************************* //
