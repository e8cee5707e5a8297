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

#include "coupleTractionFvPatchScalarField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField
    (
        fvPatchScalarField,
        coupleTractionFvPatchScalarField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupleTractionFvPatchScalarField::coupleTractionFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedGradientFvPatchScalarField(p, iF),
    couple_()
{}


Foam::coupleTractionFvPatchScalarField::coupleTractionFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    fixedGradientFvPatchScalarField(p, iF),
    couple_(p.patch(), "coupleTraction", dict)
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


Foam::coupleTractionFvPatchScalarField::coupleTractionFvPatchScalarField
(
    const coupleTractionFvPatchScalarField& ptf,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedGradientFvPatchScalarField(ptf, p, iF, mapper),
    couple_(ptf.couple_, p.patch(), mapper)
{}


Foam::coupleTractionFvPatchScalarField::coupleTractionFvPatchScalarField
(
    const coupleTractionFvPatchScalarField& ptf,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedGradientFvPatchScalarField(ptf, iF),
    couple_(ptf.couple_, this->patch().patch())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField>
Foam::coupleTractionFvPatchScalarField::coupleTraction() const
{
    return couple_.value(*this);
}


void Foam::coupleTractionFvPatchScalarField::autoMap
(
    const fvPatchFieldMapper& mapper
)
{
    fixedGradientFvPatchScalarField::autoMap(mapper);
    couple_.autoMap(mapper);
}


void Foam::coupleTractionFvPatchScalarField::rmap
(
    const fvPatchScalarField& ptf,
    const labelList& addr
)
{
    fixedGradientFvPatchScalarField::rmap(ptf, addr);

    couple_.rmap
    (
        refCast<const coupleTractionFvPatchScalarField>(ptf).couple_,
        addr
    );
}


void Foam::coupleTractionFvPatchScalarField::write(Ostream& os) const
{
    fvPatchScalarField::write(os);
    couple_.write(os);
    writeEntry("value", os);
}


// ************************************************************************* //
