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

#include "pointTracers.H"
#include "materialPointCloud.H"
#include "creepingFlow.H"
#include "interpolation.H"
#include "openfoamVersion.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(pointTracers, 0);
    addToRunTimeSelectionTable(functionObject, pointTracers, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Position, U, omega, p and the rate of strain, and last whether found
static const Foam::label nColumns = 10;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelPair Foam::functionObjects::pointTracers::nearest
(
    const point& place
) const
{
    const materialPointCloud& cloud =
        mesh_.lookupObject<materialPointCloud>(materialPointCloud::cloudName);

    // Of each processor: distance of its nearest point, and which it is
    scalarList distance(Pstream::nProcs(), GREAT);
    labelList proc(Pstream::nProcs(), -1), id(proc);
    const label me = Pstream::myProcNo();

    for (const materialPoint& p : cloud)
    {
        const scalar d = magSqr(p.position(mesh_) - place);
        if (d < distance[me])
        {
            distance[me] = d;
            proc[me] = p.origProc();
            id[me] = p.origId();
        }
    }

    Pstream::gatherList(distance);
    Pstream::gatherList(proc);
    Pstream::gatherList(id);

    const label first = findMin(distance);
    labelPair identity(proc[first], id[first]);
    sendToAll(identity);

    return identity;
}


void Foam::functionObjects::pointTracers::choose(const bool goOn)
{
    const label n = places_.size();
    identity_.setSize(n);
    number_.setSize(n);
    followed_.setSize(n);
    strainRate_.setSize(n, 0);
    rotationRate_.setSize(n, 0);
    strain_.setSize(n, 0);
    rotation_.setSize(n, 0);

    const label nBefore = goOn ? findBefore() : 0;
    label nNumbers = nBefore;

    forAll(places_, i)
    {
        if (!followed_[i])
        {
            identity_[i] = nearest(places_[i]);
            number_[i] = nNumbers++;
        }
    }
}


Foam::label Foam::functionObjects::pointTracers::findBefore()
{
    const labelList ids(getProperty<labelList>("identity", labelList()));
    const labelList numbers(getProperty<labelList>("number", labelList()));
    const pointField places(getProperty<pointField>("places", pointField()));
    const scalarList strain(getProperty<scalarList>("strain", scalarList()));
    const scalarList rotation
    (
        getProperty<scalarList>("rotation", scalarList())
    );
    const scalar nothing = 1e-9*mesh_.bounds().mag();
    label nNumbers = 0;

    forAll(places, j)
    {
        nNumbers = max(nNumbers, numbers[j] + 1);
        label found = -1;
        forAll(places_, i)
        {
            if
            (
                found < 0 && !followed_[i]
             && mag(places_[i] - places[j]) < nothing
            )
            {
                found = i;
            }
        }

        if (found < 0)
        {
            Info<< type() << ' ' << name() << ": the point of tracer"
                << numbers[j] << ", from " << places[j]
                << ", is no longer followed" << endl;
            continue;
        }
        identity_[found] = labelPair(ids[2*j], ids[2*j + 1]);
        number_[found] = numbers[j];
        strain_[found] = strain[j];
        rotation_[found] = rotation[j];
        followed_[found] = true;
    }

    return nNumbers;
}


void Foam::functionObjects::pointTracers::begin()
{
    creepingFlow::find(mesh_);

    if (!mesh_.foundObject<materialPointCloud>(materialPointCloud::cloudName))
    {
        FatalIOErrorInFunction(dict_)
            << "The case has no material points to follow" << nl
            << "    Allowed: with constant/materialPointsProperties only"
            << exit(FatalIOError);
    }

    // Of times already written strain and rotation count from the first one
    choose(!postProcess);

    if (Pstream::master())
    {
        files_.setSize(places_.size());
        forAll(places_, i)
        {
            const word file("tracer" + Foam::name(number_[i]));
            files_.set(i, newOutputFile(file).ptr());
            OFstream& os = files_[i];
            writeHeader
            (
                os,
                string("Material point ") + Foam::name(identity_[i].first())
              + ":" + Foam::name(identity_[i].second())
              + (followed_[i] ? ", followed further" : "")
            );
            writeCommented(os, "Time [s]");
            for
            (
                const char* column :
                {
                    "x [m]", "y [m]", "z [m]", "Ux [m/s]", "Uy [m/s]",
                    "Uz [m/s]", "omega [1/s]", "p [Pa]", "strain", "rotation"
                }
            )
            {
                writeTabbed(os, column);
            }
            os  << endl;
        }
    }
}


Foam::scalarField Foam::functionObjects::pointTracers::rows() const
{
    const materialPointCloud& cloud =
        mesh_.lookupObject<materialPointCloud>(materialPointCloud::cloudName);
    const creepingFlow& flow = creepingFlow::find(mesh_);
    const volScalarField& omega = mesh_.lookupObject<volScalarField>("omega");
    const volScalarField& p = mesh_.lookupObject<volScalarField>("p");

    const auto atU(interpolation<vector>::New(interpolation_, flow.U()));
    const auto atOmega(interpolation<scalar>::New(interpolation_, omega));
    const auto atP(interpolation<scalar>::New(interpolation_, p));
    const tmp<volTensorField> tgrad(flow.gradU());
    const tensorField& grad = tgrad().primitiveField();

    scalarField values(nColumns*places_.size(), Zero);

    for (const materialPoint& tracer : cloud)
    {
        const labelPair identity(tracer.origProc(), tracer.origId());

        forAll(identity_, i)
        {
            if (identity == identity_[i])
            {
                const label celli = tracer.cell();
                const point at(tracer.position(mesh_));
                const vector U(atU->interpolate(at, celli));
                scalar* row = &values[nColumns*i];

                for (direction d = 0; d < 3; ++d)
                {
                    row[d] = at[d];
                    row[3 + d] = U[d];
                }
                row[6] = atOmega->interpolate(at, celli);
                row[7] = atP->interpolate(at, celli);
                row[8] = Foam::sqrt(2*magSqr(symm(grad[celli])));
                row[9] = 1;
            }
        }
    }

    reduce(values, sumOp<scalarField>());
    return values;
}


void Foam::functionObjects::pointTracers::writeRows()
{
    const scalarField values(rows());
    const scalar now = time_.value();
    const scalar dt = now - lastTime_;

    forAll(identity_, i)
    {
        const scalar* row = &values[nColumns*i];

        if (identity_[i].first() < 0)
        {
            continue;
        }
        if (row[9] < 0.5)
        {
            identity_[i] = labelPair(-1, -1);
            if (Pstream::master())
            {
                writeCommented(files_[i], "Left or deleted by time ");
                files_[i] << now << endl;
            }
            continue;
        }

        if (dt > 0)
        {
            strain_[i] += 0.5*dt*(strainRate_[i] + row[8]);
            rotation_[i] += 0.5*dt*(rotationRate_[i] + row[6]);
        }
        strainRate_[i] = row[8];
        rotationRate_[i] = row[6];

        if (Pstream::master())
        {
            writeCurrentTime(files_[i]);
            for (label j = 0; j < 8; ++j)
            {
                files_[i] << token::TAB << row[j];
            }
            files_[i]
                << token::TAB << strain_[i] << token::TAB << rotation_[i]
                << endl;
        }
    }

    lastTime_ = now;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::pointTracers::pointTracers
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName, dict),
    lastTime_(GREAT)
{
    read(dict);

    // Where times already written are processed there is no flow yet
    if (!postProcess)
    {
        begin();
        writeRows();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::pointTracers::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    dict_ = dict;
    dict.readEntry("places", places_);
    interpolation_ = dict.getOrDefault<word>("interpolation", "cellPoint");

    return true;
}


bool Foam::functionObjects::pointTracers::execute()
{
    if (identity_.size() != places_.size())
    {
        begin();
    }
    writeRows();
    return true;
}


bool Foam::functionObjects::pointTracers::write()
{
    labelList ids(2*identity_.size());
    forAll(identity_, i)
    {
        ids[2*i] = identity_[i].first();
        ids[2*i + 1] = identity_[i].second();
    }
    setProperty("identity", ids);
    setProperty("number", number_);
    setProperty("places", places_);
    setProperty("strain", scalarList(strain_));
    setProperty("rotation", scalarList(rotation_));

    return true;
}


// ************************************************************************* //
