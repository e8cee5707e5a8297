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

#include "fieldInterpolation.H"
#include "meshTools.H"
#include "planarWalk.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointVelocities::fieldInterpolation::fieldInterpolation
(
    const word& name,
    const volVectorField& U
)
:
    name_(name),
    U_(U),
    interpolation_(interpolation<vector>::New(name, U))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointVelocities::fieldInterpolation::update()
{
    // Schemes with point values compute them when constructed
    interpolation_ = interpolation<vector>::New(name_, U_);
}


Foam::vector Foam::pointVelocities::fieldInterpolation::value
(
    const particle& p
) const
{
    vector U
    (
        interpolation_->interpolate(p.coordinates(), p.currentTetIndices())
    );

    // Of a wedge it has a part across the mid-plane
    meshTools::constrainDirection(U_.mesh(), U_.mesh().geometricD(), U);

    return U;
}


void Foam::pointVelocities::fieldInterpolation::inPlane
(
    const planarWalk& walk,
    const UList<vector2D>& places,
    const labelUList& cells,
    UList<vector2D>& U
) const
{
    forAll(places, i)
    {
        const label edge = walk.edgeOf(cells[i], places[i]);
        barycentric y;
        const tetIndices tet(walk.find(cells[i], edge, places[i], y));

        U[i] = walk.frame().inPlane(interpolation_->interpolate(y, tet));
    }
}


// ************************************************************************* //
