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

#include "flowFields.H"
#include "checkedEntry.H"
#include "checkedText.H"
#include "systemResults.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static IOobject fieldIO
    (
        const word& name,
        const fvMesh& mesh,
        const IOobject::readOption read
    )
    {
        return IOobject
        (
            name, mesh.time().timeName(), mesh, read, IOobject::AUTO_WRITE
        );
    }

    //- Of a field that is read to be copied
    static IOobject inputIO
    (
        const word& name,
        const fvMesh& mesh,
        const IOobject::readOption read = IOobject::MUST_READ
    )
    {
        return IOobject
        (
            name, mesh.time().timeName(), mesh, read, IOobject::NO_WRITE, false
        );
    }

    //- A field of the start time. The log says which: not all errors of
    //- OpenFOAM do
    template<class Type>
    static GeometricField<Type, fvPatchField, volMesh> readField
    (
        const word& name,
        const fvMesh& mesh
    )
    {
        const IOobject io(inputIO(name, mesh));
        Info<< "Reading " << (io.instance()/name).c_str() << endl;
        const checkedText text(io.objectPath());

        return GeometricField<Type, fvPatchField, volMesh>(io, mesh);
    }

    //- The values beyond coupled patches; others are set by the system
    static void evaluateCoupled(volScalarField& field)
    {
        const Pstream::commsTypes type = Pstream::commsTypes::nonBlocking;
        const label startOfRequests = Pstream::nRequests();

        for (fvPatchScalarField& pf : field.boundaryFieldRef())
        {
            if (pf.coupled())
            {
                pf.initEvaluate(type);
            }
        }
        Pstream::waitRequests(startOfRequests);
        for (fvPatchScalarField& pf : field.boundaryFieldRef())
        {
            if (pf.coupled())
            {
                pf.evaluate(type);
            }
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::volScalarField Foam::flowFields::readOmega
(
    const materialFields& materials
)
{
    // Where nothing solves for it a file is read all the same, so that what
    // its patches ask for in vain can be told
    const fvMesh& mesh = materials.mesh();
    IOobject io(inputIO("omega", mesh));

    if
    (
        materials.parts().has(sceneParts::MICROROTATION)
     || io.typeHeaderOk<volScalarField>(true)
    )
    {
        return readField<scalar>("omega", mesh);
    }

    return volScalarField
    (
        inputIO("omega", mesh, IOobject::NO_READ),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero),
        "calculated"
    );
}


template<class FieldType>
void Foam::flowFields::checkField
(
    const FieldType& field,
    const dimensionSet& dims
) const
{
    const dictionary file(fileName(field.objectPath()));

    if (field.dimensions() != dims)
    {
        FatalIOErrorInFunction(file)
            << "Entry 'dimensions' is " << field.dimensions() << nl
            << "    Allowed: " << dims << exit(FatalIOError);
    }

    for (const auto& value : field.primitiveField())
    {
        if (!checkedEntry::inRange(mag(value)))
        {
            FatalIOErrorInFunction(file)
                << "Entry 'internalField' has the value " << value << nl
                << "    Allowed: up to " << checkedEntry::largest
                << exit(FatalIOError);
        }
    }
}


void Foam::flowFields::setPRgh
(
    const cosseratSystem& system,
    scalarField& x,
    operatorState& state
)
{
    SubField<scalar> p(x, system.nCells(), 2*system.nCells());
    const scalarField& from = system.loads().fromPRgh();

    // A restart has what p_rgh leaves of the pressure: so has the run that is
    // not stopped, as long as it leaves most of the digits
    const bool near = gMax(mag(from)) < 1e3*gMax(mag(p));
    bool changed = false;

    forAll(from, celli)
    {
        scalar& pRgh = pRgh_[celli];
        if (pRgh + from[celli] != p[celli])
        {
            pRgh = p[celli] - from[celli];
            const scalar left = pRgh + from[celli];
            changed = changed || left != p[celli];
            if (near)
            {
                p[celli] = left;
            }
        }
    }

    if (near && returnReduce(changed, orOp<bool>()))
    {
        scalarField r;
        system.residual(x, true, state, r);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowFields::flowFields(const materialFields& materials)
:
    U_
    (
        fieldIO("U", materials.mesh(), IOobject::NO_READ),
        readField<vector>("U", materials.mesh())
    ),
    pRgh_
    (
        fieldIO("p_rgh", materials.mesh(), IOobject::NO_READ),
        readField<scalar>("p_rgh", materials.mesh())
    ),
    p_
    (
        fieldIO("p", materials.mesh(), IOobject::NO_READ),
        materials.mesh(),
        dimensionedScalar(dimPressure, Zero),
        "calculated"
    ),
    omega_
    (
        fieldIO("omega", materials.mesh(), IOobject::NO_READ),
        readOmega(materials)
    ),
    phi_
    (
        fieldIO("phi", materials.mesh(), IOobject::NO_READ),
        materials.mesh(),
        dimensionedScalar(dimVolume/dimTime, Zero)
    )
{
    // Lest decomposing a written time leaves out the signs of turned faces
    phi_.setOriented();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::flowFields::check() const
{
    checkField(U_, dimVelocity);
    checkField(pRgh_, dimPressure);
    checkField(omega_, dimless/dimTime);
}


void Foam::flowFields::pack
(
    const cosseratSystem& system,
    scalarField& x
) const
{
    const planarFrame& frame = system.faces().frame();
    const label n = system.nCells();
    const bool first = x.size() != system.size();
    x.setSize(system.size());

    SubList<scalar>(x, n, 0) = U_.primitiveField().component(frame.i0())();
    SubList<scalar>(x, n, n) = U_.primitiveField().component(frame.i1())();
    if (first)
    {
        // A solution read is taken to the heights of the system; a uniform
        // field is none, and as good a guess there
        const scalarField& pRgh = pRgh_.primitiveField();
        SubField<scalar> p(x, n, 2*n);
        p = pRgh;
        if (gMax(pRgh) > gMin(pRgh))
        {
            p = pRgh + system.loads().fromPRgh();
        }
    }

    if (system.cosserat())
    {
        SubList<scalar>(x, n, 3*n) = omega_.primitiveField();
        for (label celli = 0; celli < n; ++celli)
        {
            if (system.rotationUndetermined(celli))
            {
                x[3*n + celli] = 0;
            }
        }
    }
}


void Foam::flowFields::unpack
(
    const cosseratSystem& system,
    const flowBoundary& boundary,
    scalarField& x,
    operatorState& state
)
{
    setPRgh(system, x, state);

    const fvMesh& mesh = U_.mesh();
    const planarFrame& frame = system.faces().frame();
    const haloExchange& halo = system.faces().halo();

    const label n = system.nCells();
    const systemResults results(system, state);

    forAll(U_, celli)
    {
        U_[celli] = frame.inSpace(state.u[celli]);
        omega_[celli] =
            system.cosserat() && !system.rotationUndetermined(celli)
          ? x[3*n + celli]
          : 0.5*state.curl(celli);
    }

    p_.primitiveFieldRef() =
        SubField<scalar>(x, n, 2*n) + system.loads().rhoGh();

    // Coupled patches by evaluation, then the others as the system has them
    U_.correctBoundaryConditions();
    omega_.correctBoundaryConditions();
    evaluateCoupled(pRgh_);
    p_.correctBoundaryConditions();

    for (const label patchi : boundary.patches())
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        const labelUList& cells = patch.faceCells();

        vectorField Ub(patch.size());
        scalarField omegab(patch.size()), pRghb(patch.size()), pb(patch.size());
        forAll(patch, i)
        {
            const label slot = halo.start(patchi) + i;
            Ub[i] = results.boundaryVelocity(slot);
            omegab[i] = omega_[cells[i]];
            if (system.cosserat())
            {
                // What is given stays so for the material that may come
                if (boundary.rotationFixed(boundary.at(slot)))
                {
                    omegab[i] = boundary.rotation(boundary.at(slot));
                }
                else if (!system.rotationUndetermined(cells[i]))
                {
                    omegab[i] = results.boundaryRotation(slot);
                }
            }
            const scalar p = results.boundaryPressure(slot);
            pb[i] = p + results.boundaryRhoGh(slot);
            pRghb[i] =
                boundary.pressureFixed(boundary.at(slot))
              ? boundary.pressure(boundary.at(slot))
              : p - system.loads().fromPRgh()[cells[i]];
        }

        U_.boundaryFieldRef()[patchi] == Ub;
        omega_.boundaryFieldRef()[patchi] == omegab;
        pRgh_.boundaryFieldRef()[patchi] == pRghb;
        p_.boundaryFieldRef()[patchi] == pb;
    }

    results.getFluxes(phi_);
}


// ************************************************************************* //
