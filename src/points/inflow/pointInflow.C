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

#include "pointInflow.H"
#include "checkedEntry.H"
#include "materialPointCloud.H"
#include "meshTools.H"
#include "noSlipFvPatchVectorField.H"
#include "zeroGradientFvPatchFields.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pointInflow::refuse(const label patchi) const
{
    const word& name = mesh_.boundary()[patchi].name();

    FatalIOErrorInFunction(dict_)
        << "Material flows in through patch " << name << " at time "
        << mesh_.time().timeName() << ", but entry 'inflow/" << name
        << "' is not there" << nl
        << "    Allowed: inflow { " << name
        << " { material <name>; } } in constant/materialPointsProperties"
        << exit(FatalIOError);
}


Foam::point Foam::pointInflow::place
(
    const label facei,
    const scalar fraction
) const
{
    pointField corners(mesh_.faces()[facei].points(mesh_.points()));
    for (point& corner : corners)
    {
        meshTools::constrainToMeshCentre(mesh_, corner);
    }

    // Its ends in the plane
    point end(corners[0]);
    for (const point& corner : corners)
    {
        if (magSqr(corner - corners[0]) > magSqr(end - corners[0]))
        {
            end = corner;
        }
    }

    const scalar part = axial_.evenly(fraction, corners[0], end);

    return (1 - part)*corners[0] + part*end;
}


void Foam::pointInflow::checkEntry
(
    const dictionary& inflow,
    const label patchi,
    const volVectorField& U
) const
{
    const fvPatchVectorField& Up = U.boundaryField()[patchi];

    if
    (
        Up.coupled() || isA<noSlipFvPatchVectorField>(Up)
     || !(Up.fixesValue() || isA<zeroGradientFvPatchVectorField>(Up))
    )
    {
        FatalIOErrorInFunction(inflow)
            << "Entry '" << Up.patch().name() << "' of inflow is a patch of"
            << " type " << Up.patch().type() << ", where U is " << Up.type()
            << nl
            << "    Allowed: patches where U is given or zeroGradient; nothing"
            << " comes in through others" << exit(FatalIOError);
    }
}


void Foam::pointInflow::readSums(const IOobject::readOption read)
{
    IOobject io
    (
        "inflowVolume", mesh_.time().timeName(), mesh_, read,
        IOobject::AUTO_WRITE
    );

    if
    (
        read == IOobject::NO_READ
     || io.typeHeaderOk<surfaceScalarField>(true)
    )
    {
        sum_.reset
        (
            new surfaceScalarField
            (
                io, mesh_, dimensionedScalar(dimVolume, Zero)
            )
        );
    }
}


bool Foam::pointInflow::letIn
(
    materialPointCloud& cloud,
    const pointVelocity& velocity,
    const openFaces& faces,
    const point& from,
    const label celli,
    const label material,
    const scalar volume,
    const scalar left
) const
{
    // Inside by a millionth of the way to the centre
    materialPoint p
    (
        mesh_,
        from + 1e-6*(mesh_.cellCentres()[celli] - from),
        celli,
        material,
        0,
        volume
    );

    cloud.properties().enter(p);
    cloud.properties().update(p, 0.5*left);
    particle moved(p.asParticle(mesh_));
    const scalar rest = moved.track(left*velocity.value(moved), 0);
    p.setPlace(moved);
    cloud.properties().update(p, 0.5*left);

    // Through a corner of the body in one step
    if (rest > 0 && moved.onBoundaryFace() && faces.out(moved.face()))
    {
        return false;
    }

    cloud.add(std::move(p));
    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointInflow::pointInflow
(
    const volVectorField& U,
    const wordList& materials,
    const dictionary& dict,
    const label pointsPerCell
)
:
    mesh_(U.mesh()),
    axial_(mesh_),
    dict_(dict),
    pointsPerCell_(pointsPerCell),
    material_(mesh_.boundary().size(), materials.size() > 1 ? -1 : 0),
    waiting_(0)
{
    const dictionary& inflow = dict.subOrEmptyDict("inflow");

    for (const entry& e : inflow)
    {
        const label patchi = mesh_.boundaryMesh().findPatchID(e.keyword());

        if (patchi < 0 || !e.isDict())
        {
            FatalIOErrorInFunction(inflow)
                << "Entry '" << e.keyword() << "' of inflow is "
                << (e.isDict() ? "no patch" : "no dictionary") << nl
                << "    Allowed: one dictionary a patch, of "
                << flatOutput(mesh_.boundaryMesh().names())
                << exit(FatalIOError);
        }
        checkEntry(inflow, patchi, U);

        checkedEntry::only(e.dict(), {"material"});
        material_[patchi] = materialPointCloud::findMaterial
        (
            e.dict().get<word>("material"), materials, e.dict()
        );
    }

    readSums(IOobject::READ_IF_PRESENT);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointInflow::check
(
    const volVectorField& U,
    const openFaces& faces
) const
{
    for (const fvPatch& patch : mesh_.boundary())
    {
        const label patchi = patch.index();

        if (material_[patchi] < 0 && U.boundaryField()[patchi].fixesValue())
        {
            forAll(patch, i)
            {
                if (faces.in(patch.start() + i))
                {
                    refuse(patchi);
                }
            }
        }
    }
}


void Foam::pointInflow::enter
(
    materialPointCloud& cloud,
    const pointVelocity& velocity,
    const volVectorField& U,
    const surfaceScalarField& phi,
    const scalar dt,
    label& nIn,
    scalar& volumeIn
)
{
    const openFaces faces(U, phi);
    check(U, faces);

    if (!sum_.valid())
    {
        if (!returnReduce(faces.anyIn(), orOp<bool>()))
        {
            return;
        }
        readSums(IOobject::NO_READ);
    }
    waiting_ = 0;

    // Sums of equal parts miss a whole by rounding
    auto whole = [](const scalar x) { return label(std::floor(x + 1e-6)); };

    const scalar golden = 0.5*(std::sqrt(5.0) - 1);

    for (const fvPatch& patch : mesh_.boundary())
    {
        const label patchi = patch.index();
        const scalarField& phip = phi.boundaryField()[patchi];
        scalarField& sums = sum_->boundaryFieldRef()[patchi];

        forAll(phip, i)
        {
            const label celli = patch.faceCells()[i];
            const scalar volume = mesh_.V()[celli]/pointsPerCell_;

            if (!faces.in(patch.start() + i))
            {
                waiting_ += sums[i] - whole(sums[i]/volume)*volume;
                continue;
            }

            const scalar before = sums[i]/volume;
            sums[i] -= phip[i]*dt;
            const scalar now = sums[i]/volume;

            for (label k = whole(before) + 1; k <= whole(now); ++k)
            {
                if (material_[patchi] < 0)
                {
                    refuse(patchi);
                }

                const point from
                (
                    place(patch.start() + i, std::fmod(k*golden, 1))
                );
                const scalar left =
                    dt*min(max((now - k)/(now - before), scalar(0)), scalar(1));

                if
                (
                    !letIn
                    (
                        cloud, velocity, faces, from, celli,
                        material_[patchi], volume, left
                    )
                )
                {
                    continue;
                }

                ++nIn;
                volumeIn += volume;
            }
            waiting_ += sums[i] - whole(now)*volume;
        }
    }
}


// ************************************************************************* //
