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

#include "errorEstimate.H"
#include "centreFit.H"
#include "checkedEntry.H"
#include "openfoamVersion.H"
#include "globalIndex.H"
#include "gravityMeshObject.H"
#include "zeroGradientFvPatchFields.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(errorEstimate, 0);
    addToRunTimeSelectionTable(functionObject, errorEstimate, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Distances of the solutions of two meshes by cell of the finer one, those
    //- of the microrotation negative where it is not compared
    static void differences
    (
        const planarFlow& fine,
        const planarFlow& coarse,
        const labelUList& cellToBlock,
        scalarField& ofU,
        scalarField& ofOmega
    )
    {
        const label n = coarse.geometry().nCells();
        const centreFit fit
        (
            fine.geometry(), fine.frame(), cellToBlock, n
        );
        const pointField& centres = coarse.geometry().centres();

        const scalarField dU
        (
            mag
            (
                coarse.velocity()
              - fit.values
                (
                    centres, fine.velocity(),
                    boolList(cellToBlock.size(), true),
                    fine.sideVelocity(), fine.sideVelocityFixed()
                )
            )
        );
        scalarField dOmega
        (
            mag
            (
                coarse.rotation()
              - fit.values
                (
                    centres, fine.rotation(), fine.rotates(),
                    fine.sideRotation(), fine.sideRotationFixed()
                )
            )
        );
        forAll(dOmega, block)
        {
            if (!coarse.rotates()[block])
            {
                dOmega[block] = -1;
            }
        }

        ofU = scalarField(dU, cellToBlock);
        ofOmega = scalarField(dOmega, cellToBlock);
    }


    //- The master works alone, and in silence, while this lives
    class alone
    {
        const bool parallel_;
        const int level_;
        const bool throwing_, throwingIO_;

    public:

        alone()
        :
            parallel_(Pstream::parRun()),
            level_(messageStream::level),
            throwing_(FatalError.throwExceptions()),
            throwingIO_(FatalIOError.throwExceptions())
        {
            setParallel(false);
            messageStream::level = 0;
        }

        ~alone()
        {
            setParallel(parallel_);
            messageStream::level = level_;
            FatalError.throwExceptions(throwing_);
            FatalIOError.throwExceptions(throwingIO_);
        }
    };
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::functionObjects::errorEstimate::estimate
Foam::functionObjects::errorEstimate::fromDifferences
(
    const scalarField& size,
    const scalarField& first,
    const scalarField& second,
    const bool jumps,
    const pointField& places
) const
{
    scalar sum = 0, d1 = 0, d2 = 0;
    forAll(size, celli)
    {
        if (first[celli] >= 0)
        {
            sum += size[celli];
            d1 += first[celli];
        }
        if (second.size() && second[celli] >= 0)
        {
            d2 += second[celli];
        }
    }

    estimate result;
    result.measured =
        d1 > 0 && d2 > 0 ? Foam::log(d2/d1)/Foam::log(scalar(2)) : 0;
    result.order =
        order_ > 0 ? order_
      : jumps ? 1
      : min(max(result.measured, scalar(2)), scalar(3));

    const scalar share = 1/(Foam::pow(scalar(2), result.order) - 1);
    result.difference = d1/max(sum, VSMALL);
    result.relative = share*result.difference;
    result.error = share*max(first, scalar(0));
    result.worst = 0;
    result.place = Zero;
    forAll(places, celli)
    {
        if (result.error[celli] > result.worst)
        {
            result.worst = result.error[celli];
            result.place = places[celli];
        }
    }

    return result;
}


void Foam::functionObjects::errorEstimate::estimateAll
(
    planarFlow& fine,
    estimate& U,
    estimate& omega
) const
{
    scalarField firstU, firstOmega, secondU, secondOmega;

    labelList cellToBlock;
    planarFlow coarse(fine, cellToBlock);
    coarse.solve();
    differences(fine, coarse, cellToBlock, firstU, firstOmega);

    if (order_ <= 0)
    {
        labelList blockToBlock;
        planarFlow coarser(coarse, blockToBlock);

        if (coarser.geometry().nCells() >= 4)
        {
            coarser.solve();
            scalarField dU, dOmega;
            differences(coarse, coarser, blockToBlock, dU, dOmega);
            secondU = scalarField(dU, cellToBlock);
            secondOmega = scalarField(dOmega, cellToBlock);
        }
    }

    const pointField& places = fine.geometry().centres();
    const bool jumps = fine.jumps();
    U = fromDifferences
    (
        mag(fine.velocity()), firstU, secondU, jumps, places
    );
    omega = fromDifferences
    (
        mag(fine.rotation()), firstOmega, secondOmega, jumps, places
    );
}


void Foam::functionObjects::errorEstimate::writeField
(
    const word& name,
    const dimensionSet& dims,
    const scalarField& error
) const
{
    // From the master to the processors
    scalarField all(error);
    sendToAll(all);

    volScalarField field
    (
        IOobject
        (
            "errorEstimate(" + name + ")",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedScalar(dims, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    field.primitiveFieldRef() = SubList<scalar>
    (
        all, mesh_.nCells(), globalIndex(mesh_.nCells()).localStart()
    );
    field.correctBoundaryConditions();
    field.write();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::errorEstimate::errorEstimate
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName, dict),
    order_(0)
{
    read(dict);

    if (Pstream::master())
    {
        writeHeader(file(), "Estimated error of discretisation");
        writeCommented(file(), "Time [s]");
        for
        (
            const char* column :
            {
                "Err(U)", "Err(omega)", "order(U)", "order(omega)",
                "measured order(U)", "measured order(omega)",
                "difference to half the cells(U)",
                "difference to half the cells(omega)",
                "worst(U) [m/s]", "x [m]", "y [m]", "z [m]",
                "worst(omega) [1/s]", "x [m]", "y [m]", "z [m]"
            }
        )
        {
            writeTabbed(file(), column);
        }
        file() << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::errorEstimate::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    order_ = 0;
    if (dict.found("order"))
    {
        const token given(dict.lookup("order"));

        if (given.isNumber() && given.number() > 0)
        {
            order_ = given.number();
        }
        else if (!given.isWord() || given.wordToken() != "measured")
        {
            OStringStream found;
            found << given;
            checkedEntry::refuse
            (
                dict, "order", found.str(), "measured, or a number above 0"
            );
        }
    }

    return true;
}


bool Foam::functionObjects::errorEstimate::write()
{
    // After a run, as postProcess, the flow is read
    autoPtr<materialFields> materials;
    autoPtr<creepingFlow> read;
    const creepingFlow* flow =
        mesh_.findObject<creepingFlow>(creepingFlow::typeName);

    if (!flow)
    {
        materials.reset(new materialFields(mesh_));
        if (materials->parts().has(sceneParts::GRAVITY))
        {
            meshObjects::gravity::New(time_);
        }
        materials->correct();
        read.reset(new creepingFlow(materials()));
        flow = &read();
    }

    const planarFrame frame(mesh_);
    planarFlow fine(*flow, frame);
    estimate U, omega;
    string failure;

    if (Pstream::master() && fine.geometry().otherThanQuads())
    {
        failure = "the mesh has cells that are no quadrilaterals";
    }
    else if (Pstream::master())
    {
        const alone now;
        try
        {
            estimateAll(fine, U, omega);
        }
        catch (const Foam::error& problem)
        {
            failure = problem.message();
        }
    }
    sendToAll(failure);

    if (failure.size())
    {
        WarningInFunction
            << "No estimate of the error at time " << time_.timeName()
            << ": " << failure.c_str() << endl;
        return true;
    }

    writeField("U", dimVelocity, U.error);
    writeField("omega", dimless/dimTime, omega.error);

    if (Pstream::master())
    {
        writeCurrentTime(file());
        for
        (
            const scalar value :
            {
                U.relative, omega.relative, U.order, omega.order,
                U.measured, omega.measured,
                U.difference, omega.difference,
                U.worst, U.place.x(), U.place.y(), U.place.z(),
                omega.worst, omega.place.x(), omega.place.y(),
                omega.place.z()
            }
        )
        {
            file() << token::TAB << value;
        }
        file() << endl;
    }

    OStringStream line;
    line.precision(3);
    line<< "error of U " << 100*U.relative << " % (order " << U.order
        << ", measured " << U.measured << "), of omega "
        << 100*omega.relative << " % (order " << omega.order
        << ", measured " << omega.measured << "); worst of U at " << U.place;
    Log << type() << ' ' << name() << ": " << line.str().c_str() << endl;

    return true;
}


// ************************************************************************* //
