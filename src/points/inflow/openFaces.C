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

#include "openFaces.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Share of the speed below which a normal one counts as zero
static const Foam::scalar nothing = 1e-6;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::openFaces::openFaces
(
    const volVectorField& U,
    const surfaceScalarField& phi
)
:
    mesh_(U.mesh()),
    sign_(mesh_.nFaces() - mesh_.nInternalFaces(), 0)
{
    forAll(phi.boundaryField(), patchi)
    {
        const fvsPatchScalarField& phip = phi.boundaryField()[patchi];
        if (phip.coupled())
        {
            continue;
        }

        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const scalarField& magSf = phip.patch().magSf();
        const label start = phip.patch().start() - mesh_.nInternalFaces();

        forAll(phip, i)
        {
            if (mag(phip[i]) > nothing*mag(Up[i])*magSf[i])
            {
                sign_[start + i] = phip[i] > 0 ? 1 : -1;
            }
        }
    }
}


// ************************************************************************* //
