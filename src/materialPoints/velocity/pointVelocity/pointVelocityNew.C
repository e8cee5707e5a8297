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

#include "pointVelocity.H"
#include "fieldInterpolation.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::pointVelocity> Foam::pointVelocity::New
(
    const dictionary& dict,
    const volVectorField& U,
    const surfaceScalarField& phi
)
{
    const word name(dict.getOrDefault<word>("velocity", "conservativeLinear"));

    auto constructor = selectedConstructor(pointVelocity, dictionary, name);

    if (constructor)
    {
        return constructor(dict, U, phi);
    }

    // Otherwise one of OpenFOAM's interpolation schemes, or an error there
    // that lists them
    return autoPtr<pointVelocity>
    (
        new pointVelocities::fieldInterpolation(name, U)
    );
}


// ************************************************************************* //
