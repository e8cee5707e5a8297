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

#include "refinedScene.H"
#include "materialNames.H"
#include "materialPointCloud.H"
#include "planarCells.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Fraction from which a material is in a cell
static const Foam::scalar smallestFraction = 1e-3;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static IOobject constantIO(const word& name, const fvMesh& mesh)
    {
        return IOobject
        (
            name, mesh.time().constant(), mesh, IOobject::MUST_READ,
            IOobject::NO_WRITE, false
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::refinedScene::readMaterials(const fvMesh& mesh)
{
    const wordList ofPoints(materialNames::read(mesh));
    if (ofPoints.size())
    {
        return ofPoints;
    }
    return
        IOdictionary(constantIO("materialProperties", mesh))
       .subDict("materials").toc();
}


bool Foam::refinedScene::seeded() const
{
    return !points_.size() && materialPointCloud::wanted(mesh_);
}


Foam::boolList Foam::refinedScene::holdsPoints(const label material) const
{
    boolList holds(mesh_.nCells(), false);
    boolList known(holds);
    for (label i = 0; i < points_.size(); ++i)
    {
        const label celli = points_.cell(i);
        known[celli] = true;
        holds[celli] = holds[celli] || points_.material(i) == material;
    }

    // Cells without a point are as those beside them, ring by ring
    DynamicList<label> front;
    do
    {
        front.clear();
        forAll(known, celli)
        {
            if (!known[celli])
            {
                bool reached = false;
                for (const label other : mesh_.cellCells()[celli])
                {
                    reached = reached || known[other];
                }
                if (reached)
                {
                    front.append(celli);
                }
            }
        }
        for (const label celli : front)
        {
            for (const label other : mesh_.cellCells()[celli])
            {
                holds[celli] =
                    holds[celli] || (known[other] && holds[other]);
            }
        }
        for (const label celli : front)
        {
            known[celli] = true;
        }
    } while (front.size());

    return holds;
}


Foam::boolList Foam::refinedScene::holdsSeeds(const label material) const
{
    const IOdictionary dict
    (
        constantIO(materialPointCloud::cloudName + "Properties", mesh_)
    );
    const pointSeeding seeding(mesh_, materials_, dict.subDict("seeding"));
    const planarCells cells(mesh_);

    boolList holds(mesh_.nCells(), false);
    forAll(holds, celli)
    {
        holds[celli] = seeding.materials(cells, celli).found(material);
    }
    return holds;
}


Foam::boolList Foam::refinedScene::holdsFraction(const label material) const
{
    const word name("alpha." + materials_[material]);
    if (!mesh_.foundObject<volScalarField>(name))
    {
        FatalErrorInFunction
            << "Nothing says where " << materials_[material] << " is" << nl
            << "    Allowed: points of time " << mesh_.time().timeName()
            << ", or constant/materialPointsProperties, or the field "
            << name << exit(FatalError);
    }

    const auto& alpha = mesh_.lookupObject<volScalarField>(name);
    boolList holds(mesh_.nCells());
    forAll(holds, celli)
    {
        holds[celli] = alpha[celli] > smallestFraction;
    }
    return holds;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::refinedScene::refinedScene(fvMesh& mesh)
:
    mesh_(mesh),
    refinement_(mesh),
    points_(mesh),
    materials_(readMaterials(mesh)),
    nPasses_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boolList Foam::refinedScene::holds(const label material) const
{
    return
        points_.size() ? holdsPoints(material)
      : seeded() ? holdsSeeds(material)
      : holdsFraction(material);
}


void Foam::refinedScene::addRings(boolList& chosen, const label n) const
{
    const labelListList& pointCells = mesh_.pointCells();
    for (label ring = 0; ring < n; ++ring)
    {
        const boolList before(chosen);
        for (const labelList& cells : pointCells)
        {
            bool near = false;
            for (const label celli : cells)
            {
                near = near || before[celli];
            }
            for (const label celli : cells)
            {
                chosen[celli] = chosen[celli] || near;
            }
        }
    }
}


void Foam::refinedScene::refine(const boolList& chosen)
{
    const autoPtr<mapPolyMesh> map(refinement_.refine(chosen));
    points_.update(map());
    ++nPasses_;
}


void Foam::refinedScene::write()
{
    refinement_.write();
    points_.write();
}


// ************************************************************************* //
