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
    const word velocityType(name(dict));

    auto constructor =
        selectedConstructor(pointVelocity, dictionary, velocityType);

    if (constructor)
    {
        return constructor(dict, U, phi);
    }

    if (!selectedConstructor(interpolation<vector>, dictionary, velocityType))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'velocity' is " << velocityType << nl
            << "    Allowed: "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << ", and of OpenFOAM "
            << flatOutput
               (
                   interpolation<vector>::dictionaryConstructorTablePtr_
                 ->sortedToc()
               )
            << exit(FatalIOError);
    }

    return autoPtr<pointVelocity>
    (
        new pointVelocities::fieldInterpolation(velocityType, U)
    );
}


// ************************************************************************* //
