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

#include "strainSoftening.H"
#include "checkedEntry.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::strainSoftening::strainSoftening(const dictionary& dict)
:
    field_(dict.get<word>("field")),
    from_(checkedEntry::nonNegative("from", dimless, dict).value()),
    to_(checkedEntry::positive("to", dimless, dict).value()),
    factor_(checkedEntry::positive("factor", dimless, dict).value())
{
    checkedEntry::only(dict, {"field", "from", "to", "factor"});
    if (to_ <= from_)
    {
        checkedEntry::refuse
        (
            dict, "to", Foam::name(to_), "more than from, " + Foam::name(from_)
        );
    }
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::strainSoftening> Foam::strainSoftening::New
(
    const dictionary& coeffs
)
{
    return autoPtr<strainSoftening>
    (
        coeffs.found("softening")
      ? new strainSoftening(coeffs.subDict("softening"))
      : nullptr
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::strainSoftening::strength
(
    const fvMesh& mesh
) const
{
    const volScalarField* strain = mesh.findObject<volScalarField>(field_);
    if (!strain)
    {
        FatalErrorInFunction
            << "No field " << field_ << ", of which softening is to be" << nl
            << "    Allowed: fields of the mesh, " << flatOutput
               (
                   mesh.sortedNames<volScalarField>()
               )
            << "; a pointProperty with onMesh makes one" << exit(FatalError);
    }

    tmp<scalarField> tstrength(new scalarField(strain->size()));
    forAll(tstrength(), celli)
    {
        const scalar share =
            min(max(((*strain)[celli] - from_)/(to_ - from_), 0.0), 1.0);
        tstrength.ref()[celli] = 1 + share*(factor_ - 1);
    }
    return tstrength;
}


void Foam::strainSoftening::print(Ostream& os) const
{
    os  << ", strength times 1 to " << factor_ << " at " << field_ << " "
        << from_ << " to " << to_;
}


// ************************************************************************* //
