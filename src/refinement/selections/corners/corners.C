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

#include "corners.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "haloExchange.H"
#include "wallCorner.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace cellSelections
{
    defineTypeNameAndDebug(corners, 0);
    addToRunTimeSelectionTable(cellSelection, corners, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Part of the larger velocity from which a difference of two is a jump
static const Foam::scalar smallestJump = 0.5;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellSelections::corners::addCorners
(
    DynamicList<point>& places
) const
{
    fvMesh& mesh = scene_.mesh();
    const planarFrame frame(mesh);
    const haloExchange halo(mesh, frame);

    // Where omega has no file nothing asks for it
    volScalarField none
    (
        IOobject("none", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero)
    );
    const flowBoundary boundary
    (
        frame,
        halo,
        mesh.lookupObjectRef<volVectorField>("U"),
        mesh.lookupObjectRef<volScalarField>("p_rgh"),
        none,
        false
    );

    for
    (
        const wallCorner& corner : wallCorner::find(mesh, frame, halo, boundary)
    )
    {
        places.append(frame.inSpace(corner.vertex()));
    }
}


void Foam::cellSelections::corners::addJumps(DynamicList<point>& places) const
{
    const fvMesh& mesh = scene_.mesh();
    const planarFrame frame(mesh);
    const auto& U = mesh.lookupObject<volVectorField>("U");

    // Velocities given on either side of a point
    Map<vector> before;
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        if
        (
            patchFieldTypes::of("U", pf.type()) != patchFieldTypes::VALUE
        )
        {
            continue;
        }
        const polyPatch& pp = pf.patch().patch();
        forAll(pf, i)
        {
            for (const label pointi : pp[i])
            {
                if (!before.insert(pointi, pf[i]))
                {
                    const vector& u = before[pointi];
                    const scalar larger = max(mag(u), mag(pf[i]));
                    if (mag(u - pf[i]) > smallestJump*larger)
                    {
                        point place(mesh.points()[pointi]);
                        place[frame.normalAxis()] = 0;
                        places.append(place);
                    }
                }
            }
        }
    }
}


Foam::boolList Foam::cellSelections::corners::place() const
{
    const fvMesh& mesh = scene_.mesh();
    const direction normal = planarFrame(mesh).normalAxis();

    DynamicList<point> places;
    addCorners(places);
    addJumps(places);

    boolList chosen(mesh.nCells(), false);
    label n = 0;
    forAll(mesh.points(), pointi)
    {
        point p(mesh.points()[pointi]);
        p[normal] = 0;
        for (const point& corner : places)
        {
            point q(corner);
            q[normal] = within_.centre()[normal];
            if (mag(p - corner) < SMALL + 1e-9*mesh.bounds().mag())
            {
                if (within_.contains(q))
                {
                    ++n;
                    for (const label celli : mesh.pointCells()[pointi])
                    {
                        chosen[celli] = true;
                    }
                }
            }
        }
    }
    if (!n)
    {
        Info<< "    corners: none found" << nl;
    }

    scene_.addRings(chosen, rings_ - 1);
    return chosen;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellSelections::corners::corners
(
    const dictionary& dict,
    const refinedScene& scene
)
:
    cellSelection(dict, scene),
    rings_(number(dict, "rings", 1, 1000, 4)),
    within_
    (
        dict.getOrDefault<boundBox>
        (
            "within", boundBox(point::uniform(-GREAT), point::uniform(GREAT))
        )
    )
{
    checkedEntry::only(dict, {"type", "levels", "rings", "within"});
    for (const char* name : {"U", "p_rgh"})
    {
        if (!scene.mesh().thisDb().found(name))
        {
            FatalIOErrorInFunction(dict)
                << "There is no field " << name << " of time "
                << scene.mesh().time().timeName()
                << ", by which corners are found" << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
