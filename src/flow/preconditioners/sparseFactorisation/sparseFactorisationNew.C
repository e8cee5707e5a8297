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

#include "sparseFactorisation.H"
#include "openfoamVersion.H"
#include "Time.H"
#include "dlLibraryTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(sparseFactorisation, 0);
    defineRunTimeSelectionTable(sparseFactorisation, size);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

bool Foam::sparseFactorisation::available(const word& name, const Time& time)
{
    // The table is there with its first entry
    auto known = [&]()
    {
        return
            sizeConstructorTablePtr_ && sizeConstructorTablePtr_->found(name);
    };

    if (!known())
    {
        const_cast<Time&>(time).libs().open
        (
            "lib" + name + "Factorisation.so", false
        );
    }
    return known();
}


Foam::autoPtr<Foam::sparseFactorisation> Foam::sparseFactorisation::New
(
    const word& name,
    const Time& time,
    const label nLocal
)
{
    if (!available(name, time))
    {
        FatalErrorInFunction
            << "No factorisation " << name << ": lib" << name
            << "Factorisation.so cannot be opened" << nl
            << "    It is built where its headers are found (for MUMPS the"
            << " package libmumps-dev). Allowed without: block multigrid in"
            << " system/fvSolution, creepingFlow" << exit(FatalError);
    }

    return selectedConstructor(sparseFactorisation, size, name)(nLocal);
}


// ************************************************************************* //
