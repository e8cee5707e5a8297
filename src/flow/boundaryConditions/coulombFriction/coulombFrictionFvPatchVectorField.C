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

#include "coulombFrictionFvPatchVectorField.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField
    (
        fvPatchVectorField,
        coulombFrictionFvPatchVectorField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coulombFrictionFvPatchVectorField::
coulombFrictionFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fvPatchVectorField(p, iF),
    mu_(0),
    adhesion_(0),
    slipVelocity_(0),
    velocity_()
{}


Foam::coulombFrictionFvPatchVectorField::
coulombFrictionFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fvPatchVectorField(p, iF, dict, false),
    mu_(checkedEntry::nonNegative("mu", dimless, dict).value()),
    adhesion_
    (
        checkedEntry::nonNegative("adhesion", dimPressure, dict).value()
    ),
    slipVelocity_
    (
        checkedEntry::positive("slipVelocity", dimVelocity, dict).value()
    ),
    velocity_(p.patch(), "velocity", dict, false)
{
    if (dict.found("value"))
    {
        fvPatchVectorField::operator=(vectorField("value", dict, p.size()));
    }
    else
    {
        evaluate();
    }
}


Foam::coulombFrictionFvPatchVectorField::
coulombFrictionFvPatchVectorField
(
    const coulombFrictionFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fvPatchVectorField(ptf, p, iF, mapper),
    mu_(ptf.mu_),
    adhesion_(ptf.adhesion_),
    slipVelocity_(ptf.slipVelocity_),
    velocity_(ptf.velocity_, p.patch(), mapper)
{}


Foam::coulombFrictionFvPatchVectorField::
coulombFrictionFvPatchVectorField
(
    const coulombFrictionFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    fvPatchVectorField(ptf, iF),
    mu_(ptf.mu_),
    adhesion_(ptf.adhesion_),
    slipVelocity_(ptf.slipVelocity_),
    velocity_(ptf.velocity_, this->patch().patch())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::vectorField>
Foam::coulombFrictionFvPatchVectorField::velocity() const
{
    return velocity_.value(*this);
}


void Foam::coulombFrictionFvPatchVectorField::autoMap
(
    const fvPatchFieldMapper& mapper
)
{
    fvPatchVectorField::autoMap(mapper);
    velocity_.autoMap(mapper);
}


void Foam::coulombFrictionFvPatchVectorField::rmap
(
    const fvPatchVectorField& ptf,
    const labelList& addr
)
{
    fvPatchVectorField::rmap(ptf, addr);

    velocity_.rmap
    (
        refCast<const coulombFrictionFvPatchVectorField>(ptf).velocity_,
        addr
    );
}


void Foam::coulombFrictionFvPatchVectorField::evaluate
(
    const Pstream::commsTypes commsType
)
{
    if (!this->updated())
    {
        this->updateCoeffs();
    }

    const vectorField n(patch().nf());
    const vectorField Ut(patchInternalField());

    fvPatchVectorField::operator=(Ut + n*(n & (velocity() - Ut)));
    fvPatchVectorField::evaluate(commsType);
}


void Foam::coulombFrictionFvPatchVectorField::write(Ostream& os) const
{
    fvPatchVectorField::write(os);
    os.writeEntry("mu", mu_);
    os.writeEntry("adhesion", adhesion_);
    os.writeEntry("slipVelocity", slipVelocity_);
    velocity_.write(os);
    writeEntry("value", os);
}


// ************************************************************************* //
