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
#include "materialNames.H"
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

        p.material() = materials_.find(before[m]);
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
    Cloud<materialPoint>(U.mesh(), cloudName, false),
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

    // ParaView and other readers look for positions, this code for coordinates
    particle::writeLagrangianPositions = true;

    materialPoint::readFields(*this);
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


Foam::pointTracking Foam::materialPointCloud::track
(
    const scalar dt
)
{
    velocity_->update();

    const openFaces open(coupling_->U(), coupling_->phi());
    pointTracking td
    (
        mesh_, *velocity_, *integration_, walk_.get(), open, dt, courant(dt)
    );

    properties_.update(*this, 0.5*dt);
    Cloud<materialPoint>::move(*this, td, dt);
    properties_.update(*this, 0.5*dt);

    return td;
}


void Foam::materialPointCloud::predict
(
    const scalar dt,
    PtrList<volScalarField>& fractions
)
{
    PtrList<materialPoint> start(this->size());
    label i = 0;
    for (const materialPoint& p : *this)
    {
        start.set(i++, new materialPoint(p));
    }

    takeFlow(dt);
    track(0.5*dt);
    census_.take(*this);
    population_.mend(*this, census_);
    average(fractions);

    this->clear();
    forAll(start, i)
    {
        addParticle(start.set(i, nullptr).ptr());
    }
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


void Foam::materialPointCloud::writeFields() const
{
    // The same points, in other tetrahedra for a while
    files_.write
    (
        const_cast<materialPointCloud&>(*this),
        [&]() { materialPoint::writeFields(*this); }
    );
    properties_.write(*this);
    materialNames::write(mesh_, materials_);
}


void Foam::materialPointCloud::writeObjects(objectRegistry& obr) const
{
    materialPoint::writeObjects(*this, obr);
    properties_.writeObjects(*this, obr);
}


// ************************************************************************* //
