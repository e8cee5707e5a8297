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

#include "carriedPoints.H"
#include "materialPointCloud.H"
#include "openfoamVersion.H"
#include "OSspecific.H"
#include "passiveParticleCloud.H"
#include "planarCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelListList Foam::carriedPoints::parts(const mapPolyMesh& map) const
{
    List<DynamicList<label>> parts(map.nOldCells());
    forAll(map.cellMap(), celli)
    {
        parts[map.cellMap()[celli]].append(celli);
    }

    labelListList lists(parts.size());
    forAll(parts, i)
    {
        lists[i].transfer(parts[i]);
    }
    return lists;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::carriedPoints::carriedPoints(const fvMesh& mesh)
:
    mesh_(mesh),
    time_(mesh.time().timeName())
{
    const word& name = materialPointCloud::cloudName;
    const IOobject io(cloud::prefix/name, time_, mesh);
    if (!isDir(io.objectPath()))
    {
        return;
    }

    const passiveParticleCloud cloud(mesh, name);
    const label n = cloud.size();
    places_.setSize(n);
    cells_.setSize(n);
    origProc_.setSize(n);
    origId_.setSize(n);

    label i = 0;
    for (const passiveParticle& p : cloud)
    {
        places_[i] = p.position();
        cells_[i] = p.cell();
        origProc_[i] = p.origProc();
        origId_[i] = p.origId();
        ++i;
    }
    material_ = IOField<label>
    (
        cloudFieldIO(cloud, "material", IOobject::MUST_READ)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::carriedPoints::update(const mapPolyMesh& map)
{
    if (!size())
    {
        return;
    }

    const labelListList parts(this->parts(map));
    const planarCells cells(mesh_);
    const labelPair axes(planarCells::axes(mesh_));

    forAll(places_, i)
    {
        const labelList& among = parts[cells_[i]];
        scalar nearest = GREAT;
        for (const label celli : among)
        {
            // On the line between two the nearer centre decides
            const scalar d =
                planarCells::contains(axes, cells.corners(celli), places_[i])
              ? -1
              : magSqr(mesh_.cellCentres()[celli] - places_[i]);
            if (d < nearest)
            {
                nearest = d;
                cells_[i] = celli;
            }
        }
    }
}


void Foam::carriedPoints::write() const
{
    if (!size())
    {
        return;
    }

    const word& name = materialPointCloud::cloudName;
    const fileName from(mesh_.time().path()/time_/cloud::prefix/name);
    const fileName to(mesh_.time().timePath()/cloud::prefix/name);
    if (from != to)
    {
        mkDir(to.path());
        cp(from, to.path());
    }

    particle::writeLagrangianPositions = true;
    passiveParticleCloud cloud(mesh_, name, IDLList<passiveParticle>());
    forAll(places_, i)
    {
        passiveParticle* p =
            new passiveParticle(mesh_, places_[i], cells_[i]);
        p->origProc() = origProc_[i];
        p->origId() = origId_[i];
        cloud.addParticle(p);
    }
    cloud.write();
}


// ************************************************************************* //
