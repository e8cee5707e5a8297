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

#include "tangentialTractionFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField
    (
        fvPatchVectorField,
        tangentialTractionFvPatchVectorField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tangentialTractionFvPatchVectorField::
tangentialTractionFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fvPatchVectorField(p, iF),
    traction_()
{}


Foam::tangentialTractionFvPatchVectorField::
tangentialTractionFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fvPatchVectorField(p, iF, dict, false),
    traction_(p.patch(), "traction", dict)
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


Foam::tangentialTractionFvPatchVectorField::
tangentialTractionFvPatchVectorField
(
    const tangentialTractionFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fvPatchVectorField(ptf, p, iF, mapper),
    traction_(ptf.traction_, p.patch(), mapper)
{}


Foam::tangentialTractionFvPatchVectorField::
tangentialTractionFvPatchVectorField
(
    const tangentialTractionFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    fvPatchVectorField(ptf, iF),
    traction_(ptf.traction_, this->patch().patch())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::vectorField>
Foam::tangentialTractionFvPatchVectorField::traction() const
{
    return traction_.value(*this);
}


void Foam::tangentialTractionFvPatchVectorField::autoMap
(
    const fvPatchFieldMapper& mapper
)
{
    fvPatchVectorField::autoMap(mapper);
    traction_.autoMap(mapper);
}


void Foam::tangentialTractionFvPatchVectorField::rmap
(
    const fvPatchVectorField& ptf,
    const labelList& addr
)
{
    fvPatchVectorField::rmap(ptf, addr);

    traction_.rmap
    (
        refCast<const tangentialTractionFvPatchVectorField>(ptf).traction_,
        addr
    );
}


void Foam::tangentialTractionFvPatchVectorField::evaluate
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

    fvPatchVectorField::operator=(Ut - n*(n & Ut));
    fvPatchVectorField::evaluate(commsType);
}


void Foam::tangentialTractionFvPatchVectorField::write(Ostream& os) const
{
    fvPatchVectorField::write(os);
    traction_.write(os);
    writeEntry("value", os);
}


// ************************************************************************* //
