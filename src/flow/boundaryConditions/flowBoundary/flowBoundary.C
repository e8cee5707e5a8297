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
#include "wallCurvature.H"
#include "planarFrame.H"
#include "tangentialTractionFvPatchVectorField.H"
#include "coulombFrictionFvPatchVectorField.H"
#include "coupleTractionFvPatchScalarField.H"
#include "rollingFrictionFvPatchScalarField.H"
#include "jumpCyclicFvPatchField.H"
#include "processorCyclicPolyPatch.H"
#include "StringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::flowBoundary::refuse
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const label patchi,
    const string& remark,
    const string& allowed
) const
{
    const dictionary where
    (
        fileName
        (
            field.objectPath() + ".boundaryField."
          + field.mesh().boundary()[patchi].name()
        )
    );

    FatalIOErrorInFunction(where)
        << "Entry 'type' is " << field.boundaryField()[patchi].type()
        << remark.c_str() << nl
        << "    Allowed: " << allowed.c_str() << nl
        << "    All types and what they mean: docs/patchFields.md"
        << exit(FatalIOError);
}


template<class Type>
Foam::patchFieldTypes::meaning Foam::flowBoundary::meaningOf
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const label patchi,
    const bool coupled
) const
{
    typedef patchFieldTypes types;

    const fvPatchField<Type>& pf = field.boundaryField()[patchi];
    const word& name = field.name();
    const types::row* r = types::find(name, pf.type());
    types::meaning is = types::of(name, pf.type());
    string why(r ? r->remark : "");

    // What the types of the mesh's patches ask for
    if (is != types::REFUSED && coupled != (is == types::COUPLED))
    {
        is = coupled && is == types::JUMP ? is : types::REFUSED;
        why = "the patch of the mesh is of type " + pf.patch().type();
    }

    // Of which a profile makes one that follows the flow
    if (pf.type() == "flowRateInletVelocity")
    {
        OStringStream os;
        pf.write(os);
        const dictionary dict(IStringStream(os.str())());

        if (dict.getOrDefault<Switch>("extrapolateProfile", false))
        {
            is = types::REFUSED;
            why = "with extrapolateProfile its value follows the flow";
        }
    }

    if (is == types::REFUSED)
    {
        refuse
        (
            field, patchi, why.empty() ? why : " (" + why + ")",
            coupled
          ? string(pf.patch().type() + (name == pRgh_.name() ? ", and on"
            " cyclic patches fixedJump, uniformJump" : ""))
          : types::allowed(name)
        );
    }

    return is;
}


void Foam::flowBoundary::classifyVelocity(const label patchi)
{
    const fvPatchVectorField& pf = U_.boundaryField()[patchi];
    const label start = at(halo_.start(patchi));
    velocityKind kind = TRACTION;

    switch (meaningOf(U_, patchi))
    {
        case patchFieldTypes::FRICTION:
        {
            // It holds what it can
            frictional_ = true;
            anyVelocity_ = true;
            forAll(pf, facei)
            {
                slidingAt_.append(start + facei);
            }
            break;
        }
        case patchFieldTypes::VALUE:
        {
            kind = VELOCITY;
            anyVelocity_ = true;
            break;
        }
        case patchFieldTypes::OPEN:
        {
            kind = OPEN;
            anyOpen_ = true;
            break;
        }
        default:
        {}
    }

    forAll(pf, facei)
    {
        velocityKind_[start + facei] = kind;
    }
    if (kind == TRACTION)
    {
        SubList<scalar>(curvature_, pf.size(), start) =
            wallCurvature(pf.patch(), frame_);
    }
}


void Foam::flowBoundary::classifyRotation(const label patchi)
{
    const patchFieldTypes::meaning is = meaningOf(omega_, patchi);
    const bool rolls = is == patchFieldTypes::FRICTION;
    const bool fixed = is != patchFieldTypes::COUPLE && !rolls;
    frictional_ = frictional_ || rolls;

    const label start = at(halo_.start(patchi));
    forAll(omega_.boundaryField()[patchi], facei)
    {
        rotationFixed_[start + facei] = fixed;
        if (rolls)
        {
            rollingAt_.append(start + facei);
        }
    }
}


void Foam::flowBoundary::classifyPressure(const label patchi)
{
    typedef patchFieldTypes types;

    const types::meaning is = meaningOf(pRgh_, patchi);
    const bool fixed = types::givesValue(is);
    const fvPatchVectorField& Up = U_.boundaryField()[patchi];
    const bool open = types::of(U_.name(), Up.type()) == types::OPEN;

    if (fixed != open)
    {
        refuse
        (
            pRgh_, patchi, ", but U there is " + Up.type(),
            open
          ? "types that give p_rgh or p, since no velocity is given:"
            " fixedValue, prghPressure, ..."
          : "zeroGradient and others that fix no value, since the velocity is"
            " given; a pressure is given where U is zeroGradient"
        );
    }

    pressureMeaning_[patchi] = is;
    followsFlow_ = followsFlow_ || types::followsFlow(is);

    const label start = at(halo_.start(patchi));
    forAll(pRgh_.boundaryField()[patchi], facei)
    {
        pressureFixed_[start + facei] = fixed;
    }
}


void Foam::flowBoundary::classifyCoupled
(
    const label patchi,
    const bool cosserat
)
{
    meaningOf(U_, patchi, true);
    if (cosserat)
    {
        meaningOf(omega_, patchi, true);
    }

    pressureMeaning_[patchi] = meaningOf(pRgh_, patchi, true);
    if (pressureMeaning_[patchi] == patchFieldTypes::JUMP)
    {
        jump_.setSize(velocityKind_.size(), Zero);
    }

    const polyPatch& pp = U_.mesh().boundaryMesh()[patchi];
    if (isA<processorCyclicPolyPatch>(pp))
    {
        const label cyclic =
            refCast<const processorCyclicPolyPatch>(pp).referPatchID();

        if
        (
            patchFieldTypes::of
            (
                pRgh_.name(), pRgh_.boundaryField()[cyclic].type()
            ) == patchFieldTypes::JUMP
        )
        {
            refuse
            (
                pRgh_, cyclic,
                ", and the two sides of some faces are on two processors",
                "one processor for both: preservePatches in decomposeParDict"
            );
        }
    }
}


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
            !patch.coupled() && patch.type() != "empty"
         && patch.type() != "wedge"
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

        vectorField traction(Up.size(), Zero);
        if (isA<tangentialTractionFvPatchVectorField>(Up))
        {
            traction =
                refCast<tangentialTractionFvPatchVectorField>(Up).traction();

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

        scalarField couple(wp.size(), Zero);
        if (isA<coupleTractionFvPatchScalarField>(wp))
        {
            couple =
                refCast<coupleTractionFvPatchScalarField>(wp)
               .coupleTraction();
        }

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
