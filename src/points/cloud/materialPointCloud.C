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
#include "fvcSurfaceIntegrate.H"
#include "planarSteps.H"
#include "pointFiles.H"
#include "pointOrder.H"
#include "ListOps.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::word Foam::materialPointCloud::cloudName("materialPoints");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static IOobject propertiesIO(const fvMesh& mesh)
    {
        return IOobject
        (
            materialPointCloud::cloudName + "Properties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::materialPointCloud::takeFlow(const scalar dt)
{
    coupling_->update(dt);
    properties_.takeFlow();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materialPointCloud::materialPointCloud
(
    const wordList& materials,
    const volVectorField& U,
    const surfaceScalarField& phi,
    const volScalarField& omega,
    const pointFlow::gradient& gradU
)
:
    Cloud<trackedPoint>(U.mesh(), cloudName, IDLList<trackedPoint>()),
    mesh_(U.mesh()),
    materials_(materials),
    dict_(propertiesIO(mesh_)),
    seeding_(mesh_, materials, dict_.subDict("seeding")),
    integration_(pointIntegration::New(dict_)),
    average_(pointAverage::New(dict_)),
    coupling_(flowCoupling::New(dict_, U, phi)),
    properties_(mesh_, dict_, *coupling_, gradU, omega),
    census_(mesh_),
    population_(mesh_, dict_, seeding_.pointsPerCell()),
    velocity_(pointVelocity::New(dict_, coupling_->U(), coupling_->phi())),
    walk_(),
    files_(mesh_),
    inflow_(U, materials, dict_, seeding_.pointsPerCell()),
    correction_(dict_),
    account_()
{
    if (dict_.getOrDefault<bool>("planarWalk", true) && velocity_->byPlace())
    {
        walk_.reset(new planarWalk(mesh_));
        if (!walk_->possible())
        {
            walk_.clear();
        }
    }

    checkedEntry::reportUnread
    (
        dict_,
        {
            "seeding", "velocity", "integration", "coupling", "average",
            "minPointsPerCell", "maxPointsPerCell", "volumeCorrection",
            "inflow", "properties", "planarWalk"
        }
    );

    pointFiles::read(*this);
    files_.read(*this);
    renumberMaterials();
    checkRead();
    properties_.read(*this);

    const bool restart = nPoints() > 0;
    if (!restart)
    {
        checkStart();
        seeding_.seed(*this);
    }

    Info<< "Material points: " << nPoints()
        << (restart ? " read" : " seeded")
        << ", velocity " << pointVelocity::name(dict_)
        << ", integration " << integration_->type()
        << ", coupling " << coupling_->type()
        << ", average " << average_->type()
        << ", minPointsPerCell " << population_.minPointsPerCell()
        << ", maxPointsPerCell " << population_.maxPointsPerCell()
        << ", volumeCorrection " << correction_.active()
        << ", planarWalk " << Switch(bool(walk_))
        << nl << endl;
    properties_.report();

    census_.take(*this);
    account_.open(*this);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::materialPointCloud::wanted(const fvMesh& mesh)
{
    IOobject io(propertiesIO(mesh));
    return io.typeHeaderOk<IOdictionary>(true);
}


Foam::label Foam::materialPointCloud::findMaterial
(
    const word& name,
    const wordList& materials,
    const dictionary& dict
)
{
    const label i = materials.find(name);

    if (i < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'material' is " << name << nl
            << "    Allowed: " << flatOutput(materials)
            << ", the materials of constant/materialProperties"
            << exit(FatalIOError);
    }

    return i;
}


Foam::tmp<Foam::scalarField> Foam::materialPointCloud::courant
(
    const scalar dt
) const
{
    tmp<scalarField> tcourant(new scalarField(mesh_.nCells()));
    scalarField& courant = tcourant.ref();
    courant =
        0.5*dt/mesh_.V()
       *fvc::surfaceSum(mag(coupling_->phi()))().primitiveField();

    // Points do the step in one part then
    if (gMax(courant) <= 1)
    {
        return tcourant;
    }

    // Points ahead of smaller cells cross those as well
    const scalarField own(courant);
    scalarList beyond;
    syncTools::swapBoundaryCellList(mesh_, own, beyond);
    const label nInternal = mesh_.nInternalFaces();
    forAll(mesh_.faceOwner(), facei)
    {
        const label P = mesh_.faceOwner()[facei];
        if (facei < nInternal)
        {
            const label N = mesh_.faceNeighbour()[facei];
            courant[P] = max(courant[P], own[N]);
            courant[N] = max(courant[N], own[P]);
        }
        else
        {
            courant[P] = max(courant[P], beyond[facei - nInternal]);
        }
    }

    return tcourant;
}


void Foam::materialPointCloud::track(materialPoint& p, pointTracking& td)
{
    autoPtr<trackedPoint> tracked(new trackedPoint(mesh_, std::move(p)));
    tracked->move(*this, td, td.dt);

    if (td.keepParticle && !td.switchProcessor)
    {
        p = tracked->release();
        return;
    }

    drop(p);
    if (td.keepParticle)
    {
        addParticle(tracked.ptr());
    }
}


Foam::pointTracking Foam::materialPointCloud::track
(
    const scalar dt
)
{
    velocity_->update();

    const openFaces open(coupling_->U(), coupling_->phi());
    pointTracking td
    (
        mesh_, *velocity_, *integration_, open, dt, courant(dt)
    );

    properties_.update(*this, 0.5*dt);
    planarSteps(walk_.get()).step
    (
        *this,
        td,
        [&](materialPoint& p) { track(p, td); }
    );
    if (Pstream::parRun())
    {
        Cloud<trackedPoint>& onTheirWay = *this;
        onTheirWay.move(*this, td, dt);
        for (trackedPoint& p : onTheirWay)
        {
            add(p.release());
        }
        onTheirWay.clear();
    }
    closeUp();
    properties_.update(*this, 0.5*dt);

    return td;
}


void Foam::materialPointCloud::predict
(
    const scalar dt,
    PtrList<volScalarField>& fractions
)
{
    materialPointList start(*this);

    takeFlow(dt);
    track(0.5*dt);
    census_.take(*this);
    population_.mend(*this, census_);
    average(fractions);

    exchange(start);
}


void Foam::materialPointCloud::move(const scalar dt)
{
    takeFlow(dt);
    const pointTracking td(track(dt));

    label nIn = 0;
    scalar volumeIn = 0;
    inflow_.enter
    (
        *this, *velocity_, coupling_->U(), coupling_->phi(), dt, nIn, volumeIn
    );

    census_.take(*this);
    const labelPair changed(population_.mend(*this, census_));

    account_.close
    (
        *this, nIn, volumeIn, changed.first(), changed.second(), td.nOut,
        td.volumeOut
    );
    account_.compare(*this, inflow_.waiting());
    pointOrder::mend(*this);
}


void Foam::materialPointCloud::checkInflow
(
    const volVectorField& U,
    const surfaceScalarField& phi
) const
{
    inflow_.check(U, openFaces(U, phi));
}


void Foam::materialPointCloud::average
(
    PtrList<volScalarField>& fractions
)
{
    // A scene of one material has none
    if (fractions.size())
    {
        average_->fractions(*this, fractions);
        correction_.apply(*this, fractions);
    }
    properties_.average(*this);
}


Foam::tmp<Foam::scalarField> Foam::materialPointCloud::average
(
    const UList<scalar>& values
) const
{
    return average_->average(*this, values);
}


Foam::label Foam::materialPointCloud::nPoints() const
{
    return returnReduce(this->size(), sumOp<label>());
}


void Foam::materialPointCloud::report() const
{
    account_.report(*this);
}


void Foam::materialPointCloud::summary
(
    const PtrList<volScalarField>& fractions
) const
{
    const scalarField& V = mesh_.V();
    Info<< "Volume at the end: points " << sum(census_.volume())
        << " m3 in a mesh of " << gSum(V) << " m3";
    forAll(fractions, m)
    {
        Info<< (m ? ", " : ", by points and on the mesh: ")
            << materials_[m] << ' ' << census_.volume()[m] << " and "
            << gSum(V*fractions[m].primitiveField()) << " m3";
    }
    Info<< endl;
}


// ************************************************************************* //
