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

#include "rollingFrictionFvPatchScalarField.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField
    (
        fvPatchScalarField,
        rollingFrictionFvPatchScalarField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rollingFrictionFvPatchScalarField::
rollingFrictionFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedGradientFvPatchScalarField(p, iF),
    mu_(0),
    length_(0),
    slipRate_(0),
    rotation_()
{}


Foam::rollingFrictionFvPatchScalarField::
rollingFrictionFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    fixedGradientFvPatchScalarField(p, iF),
    mu_(checkedEntry::nonNegative("mu", dimless, dict).value()),
    length_(checkedEntry::nonNegative("length", dimLength, dict).value()),
    slipRate_
    (
        checkedEntry::positive("slipRate", dimless/dimTime, dict).value()
    ),
    rotation_(p.patch(), "rotation", dict, false)
{
    gradient() = Zero;

    if (dict.found("value"))
    {
        fvPatchScalarField::operator=(scalarField("value", dict, p.size()));
    }
    else
    {
        evaluate();
    }
}


Foam::rollingFrictionFvPatchScalarField::
rollingFrictionFvPatchScalarField
(
    const rollingFrictionFvPatchScalarField& ptf,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedGradientFvPatchScalarField(ptf, p, iF, mapper),
    mu_(ptf.mu_),
    length_(ptf.length_),
    slipRate_(ptf.slipRate_),
    rotation_(ptf.rotation_, p.patch(), mapper)
{}


Foam::rollingFrictionFvPatchScalarField::
rollingFrictionFvPatchScalarField
(
    const rollingFrictionFvPatchScalarField& ptf,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedGradientFvPatchScalarField(ptf, iF),
    mu_(ptf.mu_),
    length_(ptf.length_),
    slipRate_(ptf.slipRate_),
    rotation_(ptf.rotation_, this->patch().patch())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField>
Foam::rollingFrictionFvPatchScalarField::rotation() const
{
    return rotation_.value(*this);
}


void Foam::rollingFrictionFvPatchScalarField::autoMap
(
    const fvPatchFieldMapper& mapper
)
{
    fixedGradientFvPatchScalarField::autoMap(mapper);
    rotation_.autoMap(mapper);
}


void Foam::rollingFrictionFvPatchScalarField::rmap
(
    const fvPatchScalarField& ptf,
    const labelList& addr
)
{
    fixedGradientFvPatchScalarField::rmap(ptf, addr);

    rotation_.rmap
    (
        refCast<const rollingFrictionFvPatchScalarField>(ptf).rotation_,
        addr
    );
}


void Foam::rollingFrictionFvPatchScalarField::write(Ostream& os) const
{
    fvPatchScalarField::write(os);
    os.writeEntry("mu", mu_);
    os.writeEntry("length", length_);
    os.writeEntry("slipRate", slipRate_);
    rotation_.write(os);
    writeEntry("value", os);
}


// ************************************************************************* //
