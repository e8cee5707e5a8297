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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::pointTracers::choose()
{
    const materialPointCloud& cloud =
        mesh_.lookupObject<materialPointCloud>(materialPointCloud::cloudName);

    identity_.setSize(places_.size());

    forAll(places_, i)
    {
        // Distance of the nearest point of each processor, and which it is
        scalarList distance(Pstream::nProcs(), GREAT);
        List<labelPair> identity(Pstream::nProcs(), labelPair(-1, -1));
        const label me = Pstream::myProcNo();

        for (const materialPoint& p : cloud)
        {
            const scalar d = magSqr(p.position() - places_[i]);
            if (d < distance[me])
            {
                distance[me] = d;
                identity[me] = labelPair(p.origProc(), p.origId());
            }
        }

        Pstream::gatherList(distance);
        Pstream::gatherList(identity);
        identity_[i] = identity[findMin(distance)];
    }

    sendToAll(identity_);

    strainRate_.setSize(places_.size(), 0);
    rotationRate_.setSize(places_.size(), 0);
    strain_.setSize(places_.size(), 0);
    rotation_.setSize(places_.size(), 0);
}


bool Foam::functionObjects::pointTracers::restart()
{
    const labelList ids(getProperty<labelList>("identity", labelList()));

    if (ids.size() != 2*places_.size())
    {
        return false;
    }

    forAll(places_, i)
    {
        identity_[i] = labelPair(ids[2*i], ids[2*i + 1]);
    }
    const scalarList strain(getProperty<scalarList>("strain", scalarList()));
    const scalarList rotation
    (
        getProperty<scalarList>("rotation", scalarList())
    );
    strain_ = strain;
    rotation_ = rotation;

    return true;
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

    choose();
    // Of times already written strain and rotation count from the first one
    const bool again = !postProcess && restart();

    if (Pstream::master())
    {
        files_.setSize(places_.size());
        forAll(places_, i)
        {
            files_.set(i, newOutputFile("tracer" + Foam::name(i)).ptr());
            OFstream& os = files_[i];
            writeHeader
            (
                os,
                string("Material point ") + Foam::name(identity_[i].first())
              + ":" + Foam::name(identity_[i].second())
              + (again ? ", followed further" : "")
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


void Foam::functionObjects::pointTracers::writeRows()
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

    // Position, U, omega, p and the rate of strain, and last whether found
    const label n = 10;
    scalarField values(n*places_.size(), Zero);

    for (const materialPoint& tracer : cloud)
    {
        const labelPair identity(tracer.origProc(), tracer.origId());

        forAll(identity_, i)
        {
            if (identity == identity_[i])
            {
                const label celli = tracer.cell();
                const point at(tracer.position());
                const vector U(atU->interpolate(at, celli));
                scalar* row = &values[n*i];

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

    const scalar now = time_.value();
    const scalar dt = now - lastTime_;

    forAll(identity_, i)
    {
        const scalar* row = &values[n*i];

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
    setProperty("strain", scalarList(strain_));
    setProperty("rotation", scalarList(rotation_));

    return true;
}


// ************************************************************************* //
