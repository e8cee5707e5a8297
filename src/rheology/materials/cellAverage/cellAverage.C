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

#include "cellAverage.H"
#include "checkedEntry.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::cellAverage::rule>
Foam::cellAverage::names
({
    { rule::ARITHMETIC, "arithmetic" },
    { rule::GEOMETRIC, "geometric" },
    { rule::HARMONIC, "harmonic" },
    { rule::LAYERED, "layered" }
});


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::cellAverage::rule Foam::cellAverage::read
(
    const dictionary& dict,
    const word& key,
    const rule standard,
    const UList<rule>& allowed
)
{
    const word chosen
    (
        dict.getOrDefault<word>(key, names[standard])
    );

    if
    (
        !names.found(chosen)
     || !allowed.found(names[chosen])
    )
    {
        wordList labels;
        for (const rule one : allowed)
        {
            labels.append(names[one]);
        }
        OStringStream os;
        os  << flatOutput(labels);
        checkedEntry::refuse(dict, key, chosen, os.str());
    }

    return names[chosen];
}


void Foam::cellAverage::average
(
    const PtrList<volScalarField>& alphas,
    volScalarField& field,
    const UPtrList<const materialProperty>& values,
    const rule by
)
{
    scalarField& q = field.primitiveFieldRef();
    q = by == rule::GEOMETRIC ? 1 : 0;
    scalar largest = 0;

    forAll(alphas, m)
    {
        largest = max(largest, values[m].largest());
        const scalarField& alpha = alphas[m].primitiveField();
        const materialProperty& value = values[m];

        forAll(q, celli)
        {
            switch (by)
            {
                case rule::ARITHMETIC:
                {
                    q[celli] += alpha[celli]*value[celli];
                    break;
                }
                case rule::GEOMETRIC:
                {
                    q[celli] *= Foam::pow(value[celli], alpha[celli]);
                    break;
                }
                case rule::HARMONIC:
                {
                    // A material without the property leaves none to the cell
                    q[celli] += alpha[celli]/max(value[celli], VSMALL);
                    break;
                }
                case rule::LAYERED:
                {
                    // cutCells
                    break;
                }
            }
        }
    }

    if (by == rule::HARMONIC)
    {
        for (scalar& value : q)
        {
            value = largest > 0 && largest*value <= 1/SMALL ? 1/value : 0;
        }
    }

    field.correctBoundaryConditions();
}


// ************************************************************************* //
