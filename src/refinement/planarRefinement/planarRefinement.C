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

#include "planarRefinement.H"
#include "polyTopoChange.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

Foam::planarRefinement::plan::plan
(
    const polyMesh& mesh,
    const boolList& refined
)
:
    loops(mesh),
    refined(refined),
    parts(mesh.nCells()),
    centre(mesh.nCells(), -1),
    split(mesh.nFaces(), false),
    middle(mesh.nFaces(), -1),
    front(loops.front())
{
    for (label half = 0; half < 2; ++half)
    {
        owner[half] = mesh.faceOwner();
        neighbour[half].setSize(mesh.nFaces(), -1);
        SubList<label>(neighbour[half], mesh.nInternalFaces()) =
            mesh.faceNeighbour();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::planarRefinement::balance
(
    const planarLoops& loops,
    boolList& refined
) const
{
    const label nInternal = mesh_.nInternalFaces();
    bool changed = true;

    while (changed)
    {
        changed = false;
        DynamicList<label> more;
        bitSet asked(mesh_.nFaces());

        auto ask = [&](const label facei, const label celli)
        {
            if (!refined[celli] && !loops.wholeSide(celli, facei))
            {
                more.append(celli);
            }
        };

        forAll(refined, celli)
        {
            if (!refined[celli])
            {
                continue;
            }
            const planarLoops::loop cell(loops.outline(celli));
            forAll(cell.corners, corneri)
            {
                const label facei = loops.middleOf(cell, corneri).face;
                if (facei >= nInternal)
                {
                    asked.set(facei);
                }
                else if (facei >= 0)
                {
                    const label own = mesh_.faceOwner()[facei];
                    ask
                    (
                        facei,
                        own == celli ? mesh_.faceNeighbour()[facei] : own
                    );
                }
            }
        }

        syncTools::swapFaceList(mesh_, asked);
        for (const polyPatch& pp : mesh_.boundaryMesh())
        {
            forAll(pp, i)
            {
                if (pp.coupled() && asked.test(pp.start() + i))
                {
                    ask(pp.start() + i, pp.faceCells()[i]);
                }
            }
        }

        for (const label celli : more)
        {
            refined[celli] = true;
            changed = true;
        }
    }
}


void Foam::planarRefinement::findSplits(plan& p) const
{
    forAll(p.refined, celli)
    {
        if (p.refined[celli])
        {
            const planarLoops::loop cell(p.loops.outline(celli));
            forAll(cell.corners, corneri)
            {
                const label facei = p.loops.middleOf(cell, corneri).face;
                if (facei >= 0)
                {
                    p.split[facei] = true;
                }
            }
        }
    }
    syncTools::syncFaceList(mesh_, p.split, orEqOp<bool>());
}


Foam::label Foam::planarRefinement::addPair
(
    plan& p,
    polyTopoChange& change,
    const point& back,
    const point& front,
    const label like
) const
{
    const label zone = mesh_.pointZones().whichZone(like);
    const label added = change.addPoint(back, like, zone, true);
    p.front.append(change.addPoint(front, p.front[like], zone, true));
    p.front.append(-1);

    return added;
}


void Foam::planarRefinement::addPoints(plan& p, polyTopoChange& change) const
{
    const pointField& points = mesh_.points();

    forAll(p.split, facei)
    {
        if (p.split[facei])
        {
            const label a = p.loops.ends(facei).first();
            const label b = p.loops.ends(facei).second();
            p.middle[facei] = addPair
            (
                p, change,
                0.5*(points[a] + points[b]),
                0.5*(points[p.front[a]] + points[p.front[b]]),
                a
            );
        }
    }

    forAll(p.refined, celli)
    {
        if (p.refined[celli])
        {
            const planarLoops::loop cell(p.loops.outline(celli));
            point back(Zero), front(Zero);
            for (const label i : cell.corners)
            {
                back += points[cell.points[i]]/cell.corners.size();
                front += points[p.front[cell.points[i]]]/cell.corners.size();
            }
            p.centre[celli] = addPair
            (
                p, change, back, front, cell.points[cell.corners[0]]
            );
        }
    }
}


void Foam::planarRefinement::addCells(plan& p, polyTopoChange& change) const
{
    forAll(p.refined, celli)
    {
        if (p.refined[celli])
        {
            const label n = p.loops.outline(celli).corners.size();
            if (n < 3)
            {
                FatalErrorInFunction
                    << "Cell " << celli << " at " << mesh_.cellCentres()[celli]
                    << " has " << n << " corners" << nl
                    << "    Allowed: 3 or more, at which its outline turns by"
                    << " 5 degrees" << exit(FatalError);
            }
            labelList& parts = p.parts[celli];
            parts.setSize(n, celli);
            for (label i = 1; i < n; ++i)
            {
                parts[i] = change.addCell
                (
                    -1, -1, -1, celli, mesh_.cellZones().whichZone(celli)
                );
            }
            assignParts(p, celli);
        }
    }
}


void Foam::planarRefinement::checkVolumes() const
{
    const scalarField& V = mesh_.cellVolumes();
    const label celli = findMin(V);
    if (celli >= 0 && !(V[celli] > 0))
    {
        FatalErrorInFunction
            << "A refined cell at " << mesh_.cellCentres()[celli]
            << " has the volume " << V[celli]
            << " m3: the one that it is of is not convex"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planarRefinement::planarRefinement(fvMesh& mesh)
:
    mesh_(mesh),
    level_
    (
        IOobject
        (
            "cellLevel",
            mesh.facesInstance(),
            polyMesh::meshSubDir,
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        ),
        labelList(mesh.nCells(), Zero)
    )
{
    if (level_.size() != mesh.nCells())
    {
        FatalErrorInFunction
            << level_.objectPath() << " has " << level_.size()
            << " levels, of another mesh: this one has " << mesh.nCells()
            << " cells" << nl << "    Cure: delete the file"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mapPolyMesh> Foam::planarRefinement::refine
(
    boolList refined
)
{
    polyTopoChange change(mesh_);
    {
        balance(planarLoops(mesh_), refined);
        plan p(mesh_, refined);

        findSplits(p);
        addPoints(p, change);
        addCells(p, change);
        changeUprightFaces(p, change);
        forAll(refined, celli)
        {
            changeCell(p, change, celli);
        }
    }

    autoPtr<mapPolyMesh> map(change.changeMesh(mesh_, false));
    mesh_.updateMesh(map());

    const labelList before(level_);
    level_.setSize(mesh_.nCells());
    forAll(level_, celli)
    {
        const label from = map().cellMap()[celli];
        level_[celli] = before[from] + refined[from];
    }
    checkVolumes();

    return map;
}


void Foam::planarRefinement::write()
{
    level_.instance() = mesh_.facesInstance();
    level_.write();
}


// ************************************************************************* //
