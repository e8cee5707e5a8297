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

#include "materialPointCloud.H"
#include "checkedEntry.H"
#include "materialNames.H"
#include "pointFiles.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::materialPointCloud::checkStart() const
{
    const Time& time = mesh_.time();
    IOobject io("time", time.timeName(), "uniform", time);

    if (io.typeHeaderOk<IOdictionary>(false))
    {
        FatalErrorInFunction
            << "Time " << time.timeName() << " of " << time.path()
            << " has been written by a run, but there are no points in "
            << time.timeName()/cloud::prefix/cloudName << nl
            << "    Cures: start from another time; or, to seed points anew at"
            << " this one, delete " << time.timeName() << "/uniform"
            << exit(FatalError);
    }
}


void Foam::materialPointCloud::renumberMaterials()
{
    const wordList before(materialNames::read(mesh_));
    const bool restart = nPoints() > 0;
    if (restart && before.empty())
    {
        // As of programs that write a time without its folder 'uniform'
        Info<< "Time " << mesh_.time().timeName() << " does not name the"
            << " materials of its points: taken in the order of "
            << flatOutput(materials_) << nl << endl;
    }
    if (before.empty() || before == materials_)
    {
        return;
    }

    for (materialPoint& p : *this)
    {
        const label m = p.material();
        if (m < 0 || m >= before.size())
        {
            // Refused as it is
            continue;
        }

        p.setMaterial(materials_.find(before[m]));
        if (p.material() < 0)
        {
            FatalErrorInFunction
                << "Points of time " << mesh_.time().timeName()
                << " are of the material " << before[m]
                << ", which constant/materialProperties no longer has" << nl
                << "    Allowed: materials in any order, further ones, but all"
                << " those that points are of; found: "
                << flatOutput(materials_) << exit(FatalError);
        }
    }
}


void Foam::materialPointCloud::checkRead() const
{
    label i = 0;
    for (const materialPoint& p : *this)
    {
        const barycentric& y = p.coordinates();
        const label facei = p.tetFace();

        const bool inFace =
            p.cell() >= 0 && p.cell() < mesh_.nCells()
         && facei >= 0 && facei < mesh_.nFaces()
         && p.tetPt() >= 1 && p.tetPt() < mesh_.faces()[facei].size() - 1
         && (
                mesh_.faceOwner()[facei] == p.cell()
             || (
                    mesh_.isInternalFace(facei)
                 && mesh_.faceNeighbour()[facei] == p.cell()
                )
            );
        // But for the rounding of tracks
        const bool inside = cmptMin(y) > -0.1 && mag(cmptSum(y) - 1) < 1e-3;

        if
        (
            !inFace || !inside
         || p.material() < 0 || p.material() >= materials_.size()
         || !(p.volume() > 0 && checkedEntry::inRange(p.volume()))
        )
        {
            FatalErrorInFunction
                << "Point " << i << " of "
                << mesh_.time().timePath()/cloud::prefix/cloudName
                << " is in cell " << p.cell() << " at its coordinates " << y
                << ", of material " << p.material() << " and volume "
                << p.volume() << nl
                << "    Allowed: places in the " << mesh_.nCells()
                << " cells of this mesh, materials 0 to "
                << materials_.size() - 1 << " of "
                << flatOutput(materials_) << ", volumes above zero"
                << exit(FatalError);
        }
        ++i;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::materialPointCloud::writeFields() const
{
    // The same points, in other tetrahedra for a while
    files_.write
    (
        const_cast<materialPointCloud&>(*this),
        [&]() { pointFiles::write(*this); }
    );
    properties_.write(*this);
    materialNames::write(mesh_, materials_);
}


void Foam::materialPointCloud::writeObjects(objectRegistry& obr) const
{
    pointFiles::writeObjects(*this, obr);
    properties_.writeObjects(*this, obr);
}


// ************************************************************************* //
