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

#include "pointSeeding.H"
#include "checkedEntry.H"
#include "materialPointCloud.H"
#include "planarCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::pointSeeding::places
(
    const planarCells& cells,
    const label celli
) const
{
    const pointField allCorners(cells.corners(celli));
    const pointField corners(allCorners, planarCells::turns(allCorners));
    const label n = pointsPerCell_;
    pointField places(n);
    const label k = label(std::lround(std::sqrt(scalar(n))));

    if (corners.size() == 4 && k*k == n)
    {
        const axialSymmetry& axial = cells.axial();
        const point sides[4] =
        {
            0.5*(corners[3] + corners[0]), 0.5*(corners[1] + corners[2]),
            0.5*(corners[0] + corners[1]), 0.5*(corners[2] + corners[3])
        };

        for (label i = 0; i < n; ++i)
        {
            const scalar xi = axial.evenly((i % k + 0.5)/k, sides[0], sides[1]);
            const scalar eta = axial.evenly((i/k + 0.5)/k, sides[2], sides[3]);

            places[i] =
                (1 - eta)*((1 - xi)*corners[0] + xi*corners[1])
              + eta*((1 - xi)*corners[3] + xi*corners[2]);
        }
        return places;
    }

    label trial = 0;
    for (point& p : places)
    {
        p = cells.spread(corners, trial);
    }

    return places;
}


Foam::label Foam::pointSeeding::region(const point& p) const
{
    for (label i = regions_.size() - 1; i >= 0; --i)
    {
        if (regions_[i].contains(p))
        {
            return i;
        }
    }

    FatalErrorInFunction
        << "The point " << p << " is in none of the " << regions_.size()
        << " regions of constant/materialPointsProperties" << nl
        << "    Cure: a first region of type all" << exit(FatalError);

    return -1;
}


Foam::label Foam::pointSeeding::dye
(
    const point& p,
    const label material
) const
{
    for (label i = dyes_.size() - 1; i >= 0; --i)
    {
        if (dyeMaterial_[i] < 0 || dyeMaterial_[i] == material)
        {
            const label mark = dyes_[i].mark(p);
            if (mark)
            {
                return mark;
            }
        }
    }
    return 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointSeeding::pointSeeding
(
    const fvMesh& mesh,
    const wordList& materials,
    const dictionary& dict
)
:
    mesh_(mesh),
    pointsPerCell_(dict.getOrDefault<label>("pointsPerCell", 16))
{
    checkedEntry::only(dict, {"pointsPerCell", "regions", "dye"});

    if (pointsPerCell_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'pointsPerCell' is " << pointsPerCell_ << nl
            << "    Allowed: 1 or more" << exit(FatalIOError);
    }

    const scalar nPoints =
        scalar(pointsPerCell_)*returnReduce(mesh.nCells(), sumOp<label>());
    if (nPoints > labelMax)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'pointsPerCell' is " << pointsPerCell_
            << ", which makes " << nPoints << " points" << nl
            << "    Allowed: up to " << labelMax << " points"
            << exit(FatalIOError);
    }

    // Not a List: those of v1912 leak as they read dictionaries
    PtrList<dictionary> regions;
    dict.readEntry("regions", regions);
    regions_.setSize(regions.size());
    regionMaterial_.setSize(regions.size());

    forAll(regions, i)
    {
        regions_.set(i, pointRegion::New(regions[i], mesh));
        regionMaterial_[i] = materialPointCloud::findMaterial
        (
            regions[i].get<word>("material"), materials, regions[i]
        );
    }

    PtrList<dictionary> dyes;
    dict.readIfPresent("dye", dyes);
    dyes_.setSize(dyes.size());
    dyeMaterial_.setSize(dyes.size());

    forAll(dyes, i)
    {
        dyes_.set(i, dyePattern::New(dyes[i]));
        dyeMaterial_[i] =
            dyes_[i].material().empty()
          ? -1
          : materialPointCloud::findMaterial
            (
                dyes_[i].material(), materials, dyes[i]
            );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::pointSeeding::materials
(
    const planarCells& cells,
    const label celli
) const
{
    DynamicList<label> found;
    for (const point& p : places(cells, celli))
    {
        const label m = regionMaterial_[region(p)];
        if (!found.found(m))
        {
            found.append(m);
        }
    }
    return labelList(std::move(found));
}


void Foam::pointSeeding::seed(materialPointCloud& cloud) const
{
    const planarCells cells(mesh_);
    const scalarField& V = mesh_.V();
    labelList nIn(regions_.size(), Zero);

    forAll(V, celli)
    {
        for (const point& p : places(cells, celli))
        {
            const label r = region(p);
            const label m = regionMaterial_[r];
            ++nIn[r];

            materialPoint& seeded = cloud.add
            (
                materialPoint
                (
                    mesh_, p, celli, m, dye(p, m), V[celli]/pointsPerCell_
                )
            );
            cloud.properties().start(seeded);
        }
    }

    Pstream::listCombineGather(nIn, plusEqOp<label>());
    forAll(nIn, i)
    {
        if (nIn[i] == 0)
        {
            Info<< "Region " << i << " of constant/materialPointsProperties ("
                << regions_[i].type() << ") holds no point: it is outside the"
                << " mesh, between points, or later ones prevail" << nl;
        }
    }
}


// ************************************************************************* //
