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

#include "flowBoundary.H"
#include "checkedEntry.H"
#include "oneLayer.H"
#include "planarFrame.H"
#include "tangentialTractionFvPatchVectorField.H"
#include "coulombFrictionFvPatchVectorField.H"
#include "coupleTractionFvPatchScalarField.H"
#include "rollingFrictionFvPatchScalarField.H"
#include "jumpCyclicFvPatchField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Traction that a patch field gives, checked to be along the wall
    static tmp<vectorField> givenTraction
    (
        const fvPatchVectorField& Up,
        const vectorField& n
    )
    {
        tmp<vectorField> ttraction(new vectorField(Up.size(), Zero));
        vectorField& traction = ttraction.ref();
        if (isA<tangentialTractionFvPatchVectorField>(Up))
        {
            traction =
                refCast<const tangentialTractionFvPatchVectorField>(Up)
               .traction();

            if (gMax(mag(traction & n)) > 1e-6*gMax(mag(traction)))
            {
                FatalErrorInFunction
                    << "Patch " << Up.patch().name() << " of field U:"
                    << " the traction has a normal part of up to "
                    << gMax(mag(traction & n)) << " Pa" << nl
                    << "    Allowed: a tangential traction; the normal"
                    << " one is the wall's own" << exit(FatalError);
            }
        }
        return ttraction;
    }

    //- Couple traction that a patch field gives
    static tmp<scalarField> givenCouple(const fvPatchScalarField& wp)
    {
        tmp<scalarField> tcouple(new scalarField(wp.size(), Zero));
        if (isA<coupleTractionFvPatchScalarField>(wp))
        {
            tcouple.ref() =
                refCast<const coupleTractionFvPatchScalarField>(wp)
               .coupleTraction();
        }
        return tcouple;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::flowBoundary::checkValues
(
    const word& field,
    const word& patch,
    const scalarField& values
) const
{
    for (const scalar value : values)
    {
        if (!checkedEntry::inRange(value))
        {
            const Time& time = U_.time();

            FatalErrorInFunction
                << "Patch " << patch << " of field " << field << " ("
                << fileName(time.timeName())/field << ") has a value of "
                << value << " at time " << time.timeName() << nl
                << "    Allowed: up to " << checkedEntry::largest
                << exit(FatalError);
        }
    }
}


Foam::labelList Foam::flowBoundary::withFaces(const fvMesh& mesh)
{
    DynamicList<label> physical;

    for (const fvPatch& patch : mesh.boundary())
    {
        if
        (
            !patch.coupled() && !oneLayer::isPlane(patch.patch())
         && returnReduce(patch.size(), sumOp<label>())
        )
        {
            physical.append(patch.index());
        }
    }

    return labelList(std::move(physical));
}


void Foam::flowBoundary::updateJumps()
{
    if (jump_.empty())
    {
        return;
    }

    forAll(pressureMeaning_, patchi)
    {
        if (pressureMeaning_[patchi] == patchFieldTypes::JUMP)
        {
            auto& pp = refCast<jumpCyclicFvPatchField<scalar>>
            (
                pRgh_.boundaryFieldRef()[patchi]
            );
            pp.updateCoeffs();
            const scalar sign = pp.cyclicPatch().owner() ? 1 : -1;
            const scalarField jump(sign*pp.jump());

            checkValues("p_rgh", pp.patch().name(), mag(jump));
            SubList<scalar>(jump_, pp.size(), at(halo_.start(patchi))) = jump;
        }
    }
}


void Foam::flowBoundary::updateSliding(const label patchi)
{
    const fvPatchVectorField& Up = U_.boundaryField()[patchi];
    if (!isA<coulombFrictionFvPatchVectorField>(Up))
    {
        return;
    }

    const auto& wall = refCast<const coulombFrictionFvPatchVectorField>(Up);
    const vectorField U(wall.velocity());
    const vectorField n(Up.patch().nf());
    const label start = at(halo_.start(patchi));
    checkValues("U", Up.patch().name(), mag(U));

    forAll(U, facei)
    {
        const label i = start + facei;
        normalSpeed_[i] = n[facei] & U[facei];
        sliding_[i].set
        (
            wall.adhesion(), wall.mu(), wall.slipVelocity(),
            U[facei] & (n[facei] ^ frame_.e())
        );
    }
}


void Foam::flowBoundary::updateRolling(const label patchi)
{
    const fvPatchScalarField& wp = omega_.boundaryField()[patchi];
    if (rolling_.empty() || !isA<rollingFrictionFvPatchScalarField>(wp))
    {
        return;
    }

    const auto& wall = refCast<const rollingFrictionFvPatchScalarField>(wp);
    const scalarField omega(wall.rotation());
    const label start = at(halo_.start(patchi));
    checkValues("omega", wp.patch().name(), mag(omega));

    forAll(omega, facei)
    {
        rolling_[start + facei].set
        (
            0, wall.length()*wall.mu(), wall.slipRate(), omega[facei]
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowBoundary::flowBoundary
(
    const planarFrame& frame,
    const haloExchange& halo,
    volVectorField& U,
    volScalarField& pRgh,
    volScalarField& omega,
    const bool cosserat
)
:
    frame_(frame),
    halo_(halo),
    U_(U),
    pRgh_(pRgh),
    omega_(omega),
    patches_(withFaces(U.mesh())),
    velocityKind_(halo.size() - U.size(), char(VELOCITY)),
    rotationFixed_(velocityKind_.size(), false),
    pressureFixed_(velocityKind_.size(), false),
    u_(velocityKind_.size(), Zero),
    traction_(velocityKind_.size(), Zero),
    rotation_(traction_),
    couple_(traction_),
    pressure_(traction_),
    pressureMeaning_
    (
        U.mesh().boundary().size(), patchFieldTypes::RESULT
    ),
    curvature_(traction_),
    frictional_(false),
    anyVelocity_(false),
    anyOpen_(false),
    followsFlow_(false)
{
    for (const fvPatch& patch : U.mesh().boundary())
    {
        if (patch.coupled())
        {
            classifyCoupled(patch.index(), cosserat);
        }
    }

    for (const label patchi : patches_)
    {
        classifyVelocity(patchi);
        if (cosserat)
        {
            classifyRotation(patchi);
        }
        classifyPressure(patchi);
    }

    if (frictional_)
    {
        sliding_.setSize(velocityKind_.size());
        rolling_.setSize(velocityKind_.size());
        normalSpeed_.setSize(velocityKind_.size(), 0);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::flowBoundary::frictionByPressure() const
{
    bool follows = false;
    for (const label i : slidingAt_)
    {
        follows = follows || sliding_[i].byPressure();
    }
    for (const label i : rollingAt_)
    {
        follows = follows || rolling_[i].byPressure();
    }
    return returnReduce(follows, orOp<bool>());
}


bool Foam::flowBoundary::update()
{
    const scalar largestPressure = gMax(mag(pressure_));
    bool changed = false;

    for (const label patchi : patches_)
    {
        fvPatchVectorField& Up = U_.boundaryFieldRef()[patchi];
        fvPatchScalarField& wp = omega_.boundaryFieldRef()[patchi];
        fvPatchScalarField& pp = pRgh_.boundaryFieldRef()[patchi];

        Up.updateCoeffs();
        wp.updateCoeffs();
        if (patchFieldTypes::givesValue(pressureMeaning_[patchi]))
        {
            // Which makes it ask for new ones the next time
            pp.evaluate();
        }

        const vectorField n(Up.patch().nf());
        const bool mirror =
            patchFieldTypes::of(omega_.name(), wp.type())
         == patchFieldTypes::MIRROR;

        const vectorField traction(givenTraction(Up, n));
        const scalarField couple(givenCouple(wp));

        const label start = at(halo_.start(patchi));
        forAll(Up, facei)
        {
            const label i = start + facei;
            u_[i] = frame_.inPlane(Up[facei]);
            traction_[i] = traction[facei] & (n[facei] ^ frame_.e());
            rotation_[i] = mirror ? 0 : wp[facei];
            couple_[i] = couple[facei];
            changed = changed
             || mag(pp[facei] - pressure_[i]) > 1e-8*largestPressure;
            pressure_[i] = pp[facei];
        }

        updateSliding(patchi);
        updateRolling(patchi);

        // Others are results
        const word& name = Up.patch().name();
        checkValues("U", name, mag(traction));
        checkValues("omega", name, mag(couple));
        if (Up.fixesValue())
        {
            checkValues("U", name, mag(Up));
        }
        if (wp.fixesValue())
        {
            checkValues("omega", name, mag(wp));
        }
        if (patchFieldTypes::givesValue(pressureMeaning_[patchi]))
        {
            checkValues("p_rgh", name, mag(pp));
        }
    }
    updateJumps();

    return returnReduce(changed, orOp<bool>());
}


// ************************************************************************* //
