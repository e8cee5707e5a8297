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


#include "pointProperty.H"
#include "FlatOutput.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::pointProperty> Foam::pointProperty::New
(
    const word& name,
    const dictionary& dict,
    const fvMesh& mesh,
    const label first
)
{
    const word propertyType(dict.get<word>("type"));

    auto constructor =
        selectedConstructor(pointProperty, dictionary, propertyType);

    if (!constructor)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'type' of the property " << name << " is "
            << propertyType << nl
            << "    Allowed: "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }

    return constructor(name, dict, mesh, first);
}


// ************************************************************************* //
