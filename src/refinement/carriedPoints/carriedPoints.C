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
#include "mathematicalConstants.H"
#include "openfoamVersion.H"
#include "OSspecific.H"
#include "passiveParticleCloud.H"
#include "planarCells.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Points of a part of a cell below which those of the cell are split
static const Foam::label fewest = 4;

//- How often the way to a new point that would be outside of the cell is
//- shortened, and by what: halves of halves would meet
static const Foam::label mostShorter = 20;
static const Foam::scalar shorter = 0.618;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::carriedPoints::partAt
(
    const planarCells& cells,
    const labelUList& parts,
    const point& p
) const
{
    for (const label celli : parts)
    {
        if (frame_.contains(cells.corners(celli), p))
        {
            return celli;
        }
    }
    return -1;
}


Foam::label Foam::carriedPoints::nearestPart
(
    const labelUList& parts,
    const point& p
) const
{
    label nearest = parts[0];
    for (const label celli : parts)
    {
        if
        (
            magSqr(mesh_.cellCentres()[celli] - p)
          < magSqr(mesh_.cellCentres()[nearest] - p)
        )
        {
            nearest = celli;
        }
    }
    return nearest;
}


void Foam::carriedPoints::split
(
    const planarCells& cells,
    const labelUList& parts,
    const label pointi,
    const label n
)
{
    const carried whole(points_[pointi]);
    const scalar depth = mesh_.bounds().span()[frame_.normalAxis()];
    const scalar size = Foam::sqrt(volume_[whole.from]*whole.share/depth);

    for (label i = 0; i < n; ++i)
    {
        carried part(whole);
        part.share /= n;
        part.added = whole.added || i > 0;

        const scalar angle = constant::mathematical::twoPi*(i + 0.5)/n;
        vector way
        (
            frame_.inSpace
            (
                Foam::cos(angle)*size*Foam::sqrt(2.0)/4,
                Foam::sin(angle)*size*Foam::sqrt(2.0)/4
            )
        );

        label celli = -1;
        for (label k = 0; k < mostShorter && celli < 0; ++k)
        {
            part.place = whole.place + way;
            celli = partAt(cells, parts, part.place);
            way *= shorter;
        }
        if (celli < 0)
        {
            // Of a point on the outline all ways may lead outside
            celli = nearestPart(parts, whole.place);
            way = mesh_.cellCentres()[celli] - whole.place;
            part.place = whole.place + (i + 1)*way/(2*(n + 1));
        }
        part.cell = celli;

        if (i == 0)
        {
            points_[pointi] = part;
        }
        else
        {
            points_.append(part);
        }
    }
}


void Foam::carriedPoints::shareOut
(
    const planarCells& cells,
    const labelUList& parts,
    const labelUList& ofCell
)
{
    for (const label pointi : ofCell)
    {
        carried& p = points_[pointi];
        const label at = partAt(cells, parts, p.place);
        p.cell = at >= 0 ? at : nearestPart(parts, p.place);
    }

    const label first = points_.size();
    if (ofCell.size() < fewest*parts.size())
    {
        for (const label pointi : ofCell)
        {
            split(cells, parts, pointi, parts.size());
        }
    }

    DynamicList<label> all(ofCell);
    for (label pointi = first; pointi < points_.size(); ++pointi)
    {
        all.append(pointi);
    }
    for (const label celli : parts)
    {
        const point& centre = mesh_.cellCentres()[celli];
        label nearest = -1;
        bool empty = true;
        for (const label pointi : all)
        {
            const carried& p = points_[pointi];
            empty = empty && p.cell != celli;
            if
            (
                nearest < 0
             || magSqr(p.place - centre)
              < magSqr(points_[nearest].place - centre)
            )
            {
                nearest = pointi;
            }
        }
        if (empty && nearest >= 0)
        {
            points_[nearest].share *= 0.5;
            carried half(points_[nearest]);
            half.place = centre;
            half.cell = celli;
            half.added = true;
            all.append(points_.size());
            points_.append(half);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::carriedPoints::carriedPoints(const fvMesh& mesh)
:
    mesh_(mesh),
    frame_(mesh),
    time_(mesh.time().timeName())
{
    const word& name = materialPointCloud::cloudName;
    if (!isDir(mesh.time().timePath()/cloud::prefix/name))
    {
        return;
    }

    const passiveParticleCloud cloud(mesh, name);
    points_.setCapacity(cloud.size());
    DynamicList<label> origProc(cloud.size()), origId(cloud.size());

    for (const passiveParticle& p : cloud)
    {
        points_.append
        (
            carried{p.position(), p.cell(), points_.size(), 1, false}
        );
        origProc.append(p.origProc());
        origId.append(p.origId());
    }
    origProc_.transfer(origProc);
    origId_.transfer(origId);
    material_ = IOField<label>
    (
        cloudFieldIO(cloud, "material", IOobject::MUST_READ)
    );
    volume_ = IOField<scalar>
    (
        cloudFieldIO(cloud, "volume", IOobject::MUST_READ)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::carriedPoints::update(const mapPolyMesh& map)
{
    if (!size())
    {
        return;
    }

    List<DynamicList<label>> parts(map.nOldCells()), ofCell(map.nOldCells());
    forAll(map.cellMap(), celli)
    {
        parts[map.cellMap()[celli]].append(celli);
    }
    forAll(points_, pointi)
    {
        ofCell[points_[pointi].cell].append(pointi);
    }

    const planarCells cells(mesh_);
    forAll(parts, i)
    {
        if (parts[i].size() > 1)
        {
            shareOut(cells, parts[i], ofCell[i]);
        }
        else
        {
            for (const label pointi : ofCell[i])
            {
                points_[pointi].cell = parts[i][0];
            }
        }
    }
}


// ************************************************************************* //
