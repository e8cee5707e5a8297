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

#include "axialSymmetry.H"
#include "polyMesh.H"
#include "SubField.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Largest difference of the slopes of the two planes, and largest distance of
//- the axis from a coordinate axis, by the size of the mesh, that is a matter
//- of the digits of files
static const Foam::scalar largestTilt = 1e-6;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Normals and places of the planes of a wedge
    static void findPlanes
    (
        const polyMesh& mesh,
        DynamicList<vector>& n,
        DynamicList<point>& at
    )
    {
        for (const polyPatch& pp : mesh.boundaryMesh())
        {
            if (!isA<wedgePolyPatch>(pp))
            {
                continue;
            }
            const scalar area = gSum(mag(pp.faceAreas()));
            if (area > 0)
            {
                n.append(normalised(gSum(pp.faceAreas())));
                at.append(gSum(pp.faceCentres()*mag(pp.faceAreas()))/area);
            }
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::axialSymmetry::setAxis(const polyMesh& mesh)
{
    auto refuse = [&](const string& found)
    {
        FatalErrorInFunction
            << "The mesh is no wedge: " << found.c_str() << nl
            << "    Allowed: two patches of type wedge, mirror images of each"
            << " other in a coordinate plane, that meet in an axis along a"
            << " coordinate; all cells on one side of it"
            << exit(FatalError);
    };

    DynamicList<vector> n;
    DynamicList<point> at;
    findPlanes(mesh, n, at);
    if (n.size() != 2)
    {
        refuse(name(n.size()) + " patches of type wedge");
    }

    radial_ = (normal_ + 1) % 3;
    axis_ = (normal_ + 2) % 3;
    if (mag(n[0][axis_]) > mag(n[0][radial_]))
    {
        Swap(radial_, axis_);
    }

    // In either plane n_r (r - r_at) + n_e (e - e_at) = 0
    scalar slope[2], offset[2];
    for (label i = 0; i < 2; ++i)
    {
        if
        (
            mag(n[i][axis_]) > largestTilt
         || mag(n[i][normal_]) < largestTilt
         || mag(n[i][radial_]) < largestTilt
        )
        {
            refuse("the normal of a plane is along " + name(n[i]));
        }
        slope[i] = -n[i][radial_]/n[i][normal_];
        offset[i] = at[i][normal_] - slope[i]*at[i][radial_];
    }
    if (mag(slope[0] + slope[1]) > largestTilt)
    {
        refuse
        (
            "slopes of its planes of " + name(slope[0]) + " and "
          + name(slope[1])
        );
    }

    const scalar difference = slope[1] - slope[0];
    const scalar size = mesh.bounds().mag();
    origin_ = (offset[0] - offset[1])/difference;
    middle_ = (slope[1]*offset[0] - slope[0]*offset[1])/difference;

    // On a coordinate axis but for the digits of files
    origin_ = mag(origin_) < largestTilt*size ? 0 : origin_;
    middle_ = mag(middle_) < largestTilt*size ? 0 : middle_;
    angle_ = mag(difference);

    const scalar least = mesh.bounds().min()[radial_] - origin_;
    if (least < -largestTilt*size)
    {
        refuse("a corner at a distance of " + name(least) + " from the axis");
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::axialSymmetry::axialSymmetry(const polyMesh& mesh)
:
    active_(false),
    axis_(0),
    radial_(1),
    normal_(2),
    origin_(0),
    middle_(0),
    angle_(0)
{
    // Directions of wedges are solved for in space
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.geometricD()[d] < 0 && mesh.solutionD()[d] > 0)
        {
            active_ = true;
            normal_ = d;
        }
    }

    if (active_)
    {
        setAxis(mesh);
    }
}


// ************************************************************************* //
