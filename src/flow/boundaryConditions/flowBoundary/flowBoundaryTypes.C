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
#include "wallCurvature.H"
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


// ************************************************************************* //
