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

#include "planarFlow.H"
#include "centreGeometry.H"
#include "patchFieldTypes.H"
#include "tangentialTractionFvPatchVectorField.H"
#include "coupleTractionFvPatchScalarField.H"
#include "processorPolyPatch.H"
#include "StringStream.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Values of the cells of all processors on the master
    template<class Type>
    static Field<Type> gathered(const UList<Type>& mine)
    {
        List<List<Type>> all(Pstream::nProcs());
        all[Pstream::myProcNo()] = mine;
        Pstream::gatherList(all);

        DynamicList<Type> values;
        if (Pstream::master())
        {
            for (const List<Type>& part : all)
            {
                values.append(part);
            }
        }
        return Field<Type>(std::move(values));
    }


    //- Patch values of all processors on the sides of a mesh. valueOf gives
    //- those of a patch
    template<class Type, class ValuesOfPatch>
    static Field<Type> gatheredOnSides
    (
        const fvMesh& mesh,
        const planarMesh& geometry,
        const ValuesOfPatch& valuesOf
    )
    {
        DynamicList<Type> mine;
        for (const fvPatch& patch : mesh.boundary())
        {
            if (planarMesh::counts(patch.patch()))
            {
                mine.append(Field<Type>(valuesOf(patch)));
            }
        }
        const Field<Type> all(gathered<Type>(mine));

        Field<Type> values(geometry.sides().size(), Zero);
        forAll(all, i)
        {
            values[geometry.patchSides()[i]] = all[i];
        }
        return values;
    }


    //- Means over blocks
    template<class Type>
    static Field<Type> means
    (
        const Field<Type>& values,
        const scalarField& weights,
        const labelUList& to,
        const label n
    )
    {
        Field<Type> sum(n, Zero);
        scalarField weight(n, Zero);
        forAll(values, i)
        {
            if (to[i] >= 0)
            {
                sum[to[i]] += weights[i]*values[i];
                weight[to[i]] += weights[i];
            }
        }
        return sum/max(weight, VSMALL);
    }


    template<class Type>
    static void setEntry
    (
        dictionary& dict,
        const word& key,
        const Field<Type>& values
    )
    {
        OStringStream os;
        os.precision(17);
        values.writeEntry(key, os);
        IStringStream is(os.str());
        dict.merge(dictionary(is));
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>>
Foam::planarFlow::newField
(
    const GeometricField<Type, fvPatchField, volMesh>& like,
    const fvMesh& mesh,
    const labelListList& patchFaceSides,
    const Field<Type>& internal,
    const Field<Type>& sideValues,
    const word& tractionType,
    const word& tractionEntry,
    const Field<Type>& sideTractions
) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    dictionary patches;
    for (const fvPatch& patch : mesh.boundary())
    {
        const fvPatchField<Type>& pf = like.boundaryField()[patch.index()];
        dictionary dict;

        const bool jump =
            patchFieldTypes::of(like.name(), pf.type())
         == patchFieldTypes::JUMP;
        const bool constraint = polyPatch::constraintType(patch.type());

        if (constraint && !jump)
        {
            dict.add("type", patch.type());
        }
        else
        {
            OStringStream os;
            os.precision(17);
            pf.write(os);
            IStringStream is(os.str());
            dict = dictionary(is);
        }

        if (jump)
        {
            // A result, of the sizes there
            dict.remove("value");
        }
        else if (!constraint)
        {
            const labelList& sides = patchFaceSides[patch.index()];
            setEntry(dict, "value", Field<Type>(sideValues, sides));
            if (pf.type() == tractionType)
            {
                setEntry
                (
                    dict, tractionEntry, Field<Type>(sideTractions, sides)
                );
            }
        }
        patches.add(patch.name(), dict);
    }

    dictionary dict;
    dict.add("dimensions", like.dimensions());
    setEntry(dict, "internalField", Field<Type>(internal.size(), Zero));
    dict.add("boundaryField", patches);

    tmp<fieldType> tfield
    (
        new fieldType
        (
            IOobject
            (
                like.name(),
                mesh.time().timeName(),
                mesh,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh,
            dict
        )
    );
    tfield.ref().primitiveFieldRef() = internal;

    return tfield;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planarFlow::planarFlow
(
    const creepingFlow& flow,
    const planarFrame& frame
)
:
    origin_(flow),
    mesh_(flow.materials().mesh()),
    frame_(frame),
    geometry_(mesh_, frame),
    jumps_(false),
    U_(gathered<vector>(U().primitiveField())),
    omega_(gathered<scalar>(omega().primitiveField())),
    pRgh_(gathered<scalar>(pRgh().primitiveField()))
{
    const scalarField etaC
    (
        gathered<scalar>(flow.materials().etaC().primitiveField())
    );
    const bool cosserat =
        flow.materials().parts().has(sceneParts::MICROROTATION);
    rotates_.setSize(etaC.size());
    forAll(etaC, celli)
    {
        rotates_[celli] = cosserat && etaC[celli] > 0;
    }

    if (flow.materials().parts().has(sceneParts::AVERAGES))
    {
        const scalarField a
        (
            etaC + gathered<scalar>(flow.materials().eta().primitiveField())
        );
        const scalarField rho
        (
            gathered<scalar>(flow.materials().rho().primitiveField())
        );
        scalar lowest = GREAT, highest = -GREAT;
        for (const scalar value : rho)
        {
            lowest = min(lowest, value);
            highest = max(highest, value);
        }
        const bool heavy =
            flow.materials().parts().has(sceneParts::GRAVITY)
         && highest > lowest;

        for (const planarMesh::side& s : geometry_.sides())
        {
            const label P = s.owner, N = s.neighbour;
            if (N >= 0)
            {
                jumps_ =
                    jumps_
                 || max(a[P], a[N]) > 2*min(a[P], a[N])
                 || (heavy && mag(rho[P] - rho[N]) > 0.5*(highest - lowest));
            }
        }

        for (const word& name : flow.materials().names())
        {
            fractions_.append
            (
                gathered<scalar>
                (
                    mesh_.lookupObject<volScalarField>
                    (
                        IOobject::groupName("alpha", name)
                    ).primitiveField()
                )
            );
        }
    }
    if (const auto* force = mesh_.findObject<volVectorField>("bodyForce"))
    {
        force_ = gathered<vector>(force->primitiveField());
    }
    if (const auto* couple = mesh_.findObject<volScalarField>("bodyCouple"))
    {
        couple_ = gathered<scalar>(couple->primitiveField());
    }

    sideU_ = gatheredOnSides<vector>
    (
        mesh_, geometry_,
        [&](const fvPatch& patch)
        {
            return vectorField(U().boundaryField()[patch.index()]);
        }
    );
    sideOmega_ = gatheredOnSides<scalar>
    (
        mesh_, geometry_,
        [&](const fvPatch& patch)
        {
            return scalarField(omega().boundaryField()[patch.index()]);
        }
    );
    sideP_ = gatheredOnSides<scalar>
    (
        mesh_, geometry_,
        [&](const fvPatch& patch)
        {
            return scalarField(pRgh().boundaryField()[patch.index()]);
        }
    );
    sideTraction_ = gatheredOnSides<vector>
    (
        mesh_, geometry_,
        [&](const fvPatch& patch)
        {
            const auto* given = isA<tangentialTractionFvPatchVectorField>
            (
                U().boundaryField()[patch.index()]
            );
            return
                given
              ? vectorField(given->traction())
              : vectorField(patch.size(), Zero);
        }
    );
    sideCouple_ = gatheredOnSides<scalar>
    (
        mesh_, geometry_,
        [&](const fvPatch& patch)
        {
            const auto* given = isA<coupleTractionFvPatchScalarField>
            (
                omega().boundaryField()[patch.index()]
            );
            return
                given
              ? scalarField(given->coupleTraction())
              : scalarField(patch.size(), Zero);
        }
    );

    sideUFixed_.setSize(geometry_.sides().size(), false);
    sideOmegaFixed_ = sideUFixed_;
    forAll(sideUFixed_, sidei)
    {
        const label patchi = geometry_.sides()[sidei].patch;
        if (patchi >= 0)
        {
            sideUFixed_[sidei] = U().boundaryField()[patchi].fixesValue();
            sideOmegaFixed_[sidei] =
                cosserat && omega().boundaryField()[patchi].fixesValue();
        }
    }
}


Foam::planarFlow::planarFlow
(
    const planarFlow& fine,
    labelList& cellToBlock
)
:
    origin_(fine.origin_),
    mesh_(fine.mesh_),
    frame_(fine.frame_),
    jumps_(fine.jumps_)
{
    labelList sideToSide;
    geometry_ =
        fine.geometry_.coarsened(frame_.e(), cellToBlock, sideToSide);

    const label n = geometry_.nCells(), nSides = geometry_.sides().size();
    const scalarField& areas = fine.geometry_.areas();
    scalarField lengths(fine.geometry_.sides().size());
    forAll(lengths, sidei)
    {
        lengths[sidei] = fine.geometry_.length(sidei);
    }

    U_ = means(fine.U_, areas, cellToBlock, n);
    omega_ = means(fine.omega_, areas, cellToBlock, n);
    pRgh_ = means(fine.pRgh_, areas, cellToBlock, n);

    fractions_.setSize(fine.fractions_.size());
    forAll(fractions_, m)
    {
        fractions_[m] = means(fine.fractions_[m], areas, cellToBlock, n);
    }
    if (fine.force_.size())
    {
        force_ = means(fine.force_, areas, cellToBlock, n);
    }
    if (fine.couple_.size())
    {
        couple_ = means(fine.couple_, areas, cellToBlock, n);
    }

    rotates_.setSize(n, true);
    forAll(cellToBlock, celli)
    {
        if (!fine.rotates_[celli])
        {
            rotates_[cellToBlock[celli]] = false;
        }
    }

    sideU_ = means(fine.sideU_, lengths, sideToSide, nSides);
    sideOmega_ = means(fine.sideOmega_, lengths, sideToSide, nSides);
    sideP_ = means(fine.sideP_, lengths, sideToSide, nSides);
    sideTraction_ = means(fine.sideTraction_, lengths, sideToSide, nSides);
    sideCouple_ = means(fine.sideCouple_, lengths, sideToSide, nSides);

    sideUFixed_.setSize(nSides, false);
    sideOmegaFixed_ = sideUFixed_;
    forAll(sideToSide, sidei)
    {
        if (sideToSide[sidei] >= 0)
        {
            sideUFixed_[sideToSide[sidei]] = fine.sideUFixed_[sidei];
            sideOmegaFixed_[sideToSide[sidei]] = fine.sideOmegaFixed_[sidei];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::planarFlow::solve()
{
    labelListList patchFaceSides;
    autoPtr<fvMesh> mesh
    (
        geometry_.toMesh(mesh_, frame_, patchFaceSides)
    );
    centreGeometry(mesh());

    // GAMG counts on cells of every processor, and refuses a mesh that would
    // leave too few to each
    if (Pstream::nProcs() > 1)
    {
        dictionary& controls = static_cast<fvSolution&>(mesh());
        controls.subDictOrAdd("creepingFlow").subDictOrAdd("preconditioner")
       .add("nCellsInCoarsestLevel", max(1, 10/Pstream::nProcs()));
    }

    // Loads are taken from the mesh
    autoPtr<volVectorField> force;
    autoPtr<volScalarField> couple;
    if (force_.size())
    {
        force.reset
        (
            new volVectorField
            (
                IOobject("bodyForce", mesh->time().timeName(), mesh()),
                mesh(),
                dimensionedVector(dimForce/dimVolume, Zero),
                "zeroGradient"
            )
        );
        force->primitiveFieldRef() = force_;
    }
    if (couple_.size())
    {
        couple.reset
        (
            new volScalarField
            (
                IOobject("bodyCouple", mesh->time().timeName(), mesh()),
                mesh(),
                dimensionedScalar(dimPressure, Zero),
                "zeroGradient"
            )
        );
        couple->primitiveFieldRef() = couple_;
    }

    materialFields materials(mesh(), false);
    forAll(fractions_, m)
    {
        materials.fractions()[m].primitiveFieldRef() = fractions_[m];
        materials.fractions()[m].correctBoundaryConditions();
    }
    materials.correct();

    creepingFlow flow
    (
        materials,
        newField
        (
            U(), mesh(), patchFaceSides, U_, sideU_,
            tangentialTractionFvPatchVectorField::typeName, "traction",
            sideTraction_
        )(),
        newField
        (
            pRgh(), mesh(), patchFaceSides, pRgh_, sideP_, word::null,
            word::null, sideP_
        )(),
        newField
        (
            omega(), mesh(), patchFaceSides, omega_, sideOmega_,
            coupleTractionFvPatchScalarField::typeName, "coupleTraction",
            sideCouple_
        )()
    );
    flow.solve();

    U_ = flow.U().primitiveField();
    omega_ =
        mesh->lookupObject<volScalarField>("omega").primitiveField();
}


// ************************************************************************* //
