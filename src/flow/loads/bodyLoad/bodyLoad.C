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

#include "bodyLoad.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class FieldType>
Foam::autoPtr<FieldType> Foam::bodyLoad::read
(
    const word& name,
    const fvMesh& mesh,
    const dimensionSet& dims
)
{
    IOobject io
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::AUTO_WRITE
    );

    autoPtr<FieldType> field;

    if (io.template typeHeaderOk<FieldType>(true))
    {
        field.reset(new FieldType(io, mesh));

        if (field->dimensions() != dims)
        {
            FatalIOErrorInFunction(dictionary(fileName(io.objectPath())))
                << "Entry 'dimensions' is " << field->dimensions() << nl
                << "    Allowed: " << dims << exit(FatalIOError);
        }
    }

    return field;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyLoad::bodyLoad(const fvMesh& mesh)
:
    force_
    (
        read<volVectorField>
        (
            "bodyForce", mesh, dimForce/dimVolume
        )
    ),
    couple_
    (
        read<volScalarField>("bodyCouple", mesh, dimPressure)
    )
{}


// ************************************************************************* //
