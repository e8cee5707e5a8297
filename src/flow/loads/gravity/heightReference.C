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

#include "heightReference.H"
#include "checkedEntry.H"
#include "fvMesh.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::heightReference::heightReference(const fvMesh& mesh)
:
    middle_(mesh.bounds().midpoint()),
    hRef_(0),
    given_(false)
{
    const Time& time = mesh.time();

    IOobject io
    (
        "hRef", time.constant(), time,
        IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
    );
    given_ = io.typeHeaderOk<uniformDimensionedScalarField>(true);

    const uniformDimensionedScalarField hRef
    (
        io, dimensionedScalar(dimLength, Zero)
    );
    hRef_ = hRef.value();

    if (hRef.dimensions() != dimLength || !checkedEntry::inRange(mag(hRef_)))
    {
        const dictionary file(fileName(hRef.objectPath()));
        FatalIOErrorInFunction(file)
            << "Entry 'value' is " << hRef_ << " of dimensions "
            << hRef.dimensions() << nl
            << "    Allowed: a height of dimensions " << dimLength
            << ", up to " << checkedEntry::largest << exit(FatalIOError);
    }

    if (!mesh.foundObject<uniformDimensionedScalarField>("hRef"))
    {
        regIOobject::store
        (
            new uniformDimensionedScalarField
            (
                IOobject("hRef", time.constant(), mesh),
                dimensionedScalar("hRef", dimLength, hRef_)
            )
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::heightReference::ghRef(const vector& g) const
{
    return mag(g) > 0 ? (g & (cmptMag(g)/mag(g)))*hRef_ : 0;
}


// ************************************************************************* //
