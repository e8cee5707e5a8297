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
#include "coupleTractionFvPatchScalarField.H"
#include "basicSymmetryFvPatchFields.H"
#include "symmetryFvPatch.H"
#include "symmetryPlaneFvPatch.H"
#include "symmetryPlaneFvPatchFields.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static bool isMirror(const fvPatch& patch)
    {
        return isA<symmetryFvPatch>(patch) || isA<symmetryPlaneFvPatch>(patch);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::flowBoundary::refuse
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const label patchi,
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
        << "Entry 'type' is " << field.boundaryField()[patchi].type() << nl
        << "    Allowed: " << allowed.c_str() << nl
        << exit(FatalIOError);
}


void Foam::flowBoundary::classifyVelocity(const label patchi)
{
    const fvPatchVectorField& pf = U_.boundaryField()[patchi];
    velocityKind kind = VELOCITY;

    if
    (
        isA<tangentialTractionFvPatchVectorField>(pf)
     || isA<basicSymmetryFvPatchVectorField>(pf)
     || isA<symmetryPlaneFvPatchVectorField>(pf)
    )
    {
        kind = TRACTION;
    }
    else if (isA<zeroGradientFvPatchVectorField>(pf))
    {
        kind = OPEN;
        anyOpen_ = true;
    }
    else if (pf.fixesValue())
    {
        anyVelocity_ = anyVelocity_ || pf.size();
    }
    else
    {
        refuse
        (
            U_, patchi,
            "types that fix the value (fixedValue, noSlip, ...), slip,"
            " symmetry, symmetryPlane, tangentialTraction, zeroGradient"
        );
    }

    const label start = at(halo_.start(patchi));
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
    const fvPatchScalarField& pf = omega_.boundaryField()[patchi];
    bool fixed = true;

    if
    (
        isA<coupleTractionFvPatchScalarField>(pf)
     || isA<zeroGradientFvPatchScalarField>(pf)
    )
    {
        fixed = false;
    }
    else if (!pf.fixesValue() && !isMirror(pf.patch()))
    {
        refuse
        (
            omega_, patchi,
            "types that fix the value (fixedValue, ...), symmetry,"
            " symmetryPlane, zeroGradient, coupleTraction"
        );
    }

    const label start = at(halo_.start(patchi));
    forAll(pf, facei)
    {
        rotationFixed_[start + facei] = fixed;
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
    velocityKind_(halo.size() - U.size(), char(VELOCITY)),
    rotationFixed_(velocityKind_.size(), false),
    pressureFixed_(velocityKind_.size(), false),
    u0_(velocityKind_.size(), Zero),
    u1_(u0_),
    traction_(u0_),
    rotation_(u0_),
    couple_(u0_),
    pressure_(u0_),
    curvature_(u0_),
    anyVelocity_(false),
    anyOpen_(false),
    anyPressure_(false)
{
    for (const label patchi : patches())
    {
        classifyVelocity(patchi);
        if (cosserat)
        {
            classifyRotation(patchi);
        }

        const bool fixed = pRgh.boundaryField()[patchi].fixesValue();
        const label start = at(halo.start(patchi));
        forAll(pRgh.boundaryField()[patchi], facei)
        {
            pressureFixed_[start + facei] = fixed;
        }

        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        if (fixed && !isA<zeroGradientFvPatchVectorField>(Up))
        {
            refuse
            (
                pRgh, patchi,
                "zeroGradient and others that fix no value, since U is of type "
              + Up.type() + "; a pressure is given where that is zeroGradient"
            );
        }
        anyPressure_ = anyPressure_ || fixed;
    }

    reduce(anyVelocity_, orOp<bool>());
    reduce(anyOpen_, orOp<bool>());
    reduce(anyPressure_, orOp<bool>());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::flowBoundary::patches() const
{
    DynamicList<label> physical;

    for (const fvPatch& patch : U_.mesh().boundary())
    {
        if (!patch.coupled() && patch.type() != "empty")
        {
            physical.append(patch.index());
        }
    }

    return labelList(std::move(physical));
}


void Foam::flowBoundary::update()
{
    for (const label patchi : patches())
    {
        fvPatchVectorField& Up = U_.boundaryFieldRef()[patchi];
        fvPatchScalarField& wp = omega_.boundaryFieldRef()[patchi];
        fvPatchScalarField& pp = pRgh_.boundaryFieldRef()[patchi];

        Up.updateCoeffs();
        wp.updateCoeffs();
        if (pp.fixesValue())
        {
            pp.updateCoeffs();
        }

        const vectorField n(Up.patch().nf());
        const bool mirror = isMirror(Up.patch());

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
                    << "    Allowed: a tangential traction; the wall takes"
                    << " the normal one" << exit(FatalError);
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
            u0_[i] = Up[facei][frame_.i0()];
            u1_[i] = Up[facei][frame_.i1()];
            traction_[i] = traction[facei] & (n[facei] ^ frame_.e());
            rotation_[i] = mirror ? 0 : wp[facei];
            couple_[i] = couple[facei];
            pressure_[i] = pp[facei];
        }

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
        if (pp.fixesValue())
        {
            checkValues("p_rgh", name, mag(pp));
        }
    }
}


// ************************************************************************* //
