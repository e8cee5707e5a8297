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

#include "flowPreconditioner.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(flowPreconditioner, 0);
    defineRunTimeSelectionTable(flowPreconditioner, system);
}


// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Pressure over viscosity times rate of expansion: 2 for uniform constants,
//- less where the solve for the velocity is not exact (measured,
//- docs/discretisation.md, section 12)
static const Foam::scalar pressureShare = 1.4;


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::flowPreconditioner::pressureOf
(
    const scalarField& r
) const
{
    const scalarField& V = system_.faces().V();
    tmp<scalarField> tp(pressureShare*muByV_*system_.layout().p(r));
    if (!system_.closed())
    {
        return tp;
    }

    // Both at once, for it is done in each iteration
    vector2D sums(sum(V*tp()), sum(system_.layout().p(r)));
    reduce(sums, sumOp<vector2D>());

    tp.ref() -= sums.x()/sumV_;
    if (!system_.pressureFloats())
    {
        tp.ref() += sums.y()/compliance_;
    }
    return tp;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowPreconditioner::flowPreconditioner(const cosseratSystem& system)
:
    sumV_(gSum(system.faces().V())),
    compliance_(0),
    system_(system),
    s_(system.newState())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::flowPreconditioner::update()
{
    muByV_ =
        system_.pressureViscosity(system_.parts().heldViscosity())
       /system_.faces().V();
    compliance_ = system_.compliance();
}


// ************************************************************************* //
