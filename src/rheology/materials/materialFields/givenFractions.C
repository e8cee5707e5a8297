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

#include "givenFractions.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Largest miss that is clipped, also in the sum of the fractions
static const Foam::scalar largestMiss = 1e-6;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static void refuse(const volScalarField& alpha, const label celli)
    {
        FatalIOErrorInFunction(dictionary(fileName(alpha.objectPath())))
            << "Entry 'internalField' has the value " << alpha[celli]
            << " in cell " << celli << " at " << alpha.mesh().C()[celli] << nl
            << "    Allowed: fractions from 0 to 1" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::givenFractions::check(PtrList<volScalarField>& fractions)
{
    label nClipped = 0;
    scalar largest = 0;

    for (volScalarField& alpha : fractions)
    {
        forAll(alpha, celli)
        {
            const scalar clipped = min(max(alpha[celli], scalar(0)), scalar(1));
            const scalar miss = mag(alpha[celli] - clipped);

            // Not so where it is not a number
            if (!(miss <= largestMiss))
            {
                refuse(alpha, celli);
            }
            if (miss > 0)
            {
                ++nClipped;
                largest = max(largest, miss);
                alpha[celli] = clipped;
            }
        }
        alpha.correctBoundaryConditions();
    }

    reduce(nClipped, sumOp<label>());
    reduce(largest, maxOp<scalar>());

    if (nClipped)
    {
        Info<< "Fractions read: " << nClipped << " values below 0 or above 1,"
            << " by " << largest << " at most, are clipped" << nl << endl;
    }
}


// ************************************************************************* //
