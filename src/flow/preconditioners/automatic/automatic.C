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

#include "automatic.H"
#include "sparseFactorisation.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace flowPreconditioners
{
    defineTypeNameAndDebug(automatic, 0);
    addToRunTimeSelectionTable(flowPreconditioner, automatic, system);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::flowPreconditioners::automatic::needsFactorisation() const
{
    const scalar share = direct_ ? 0.5 : 1;

    return
        system_.coefficients().largestCoupling() > share*couplingLimit_
     || system_.coefficients().largestJump() > share*jumpLimit_;
}


void Foam::flowPreconditioners::automatic::choose(const bool direct)
{
    direct_ = direct;

    if (direct && !available_)
    {
        return;
    }

    dictionary controls(controls_);
    controls.set("block", word(direct ? "direct" : "multigrid"));
    chosen_.clear();
    chosen_ = flowPreconditioner::New(system_, controls);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowPreconditioners::automatic::automatic
(
    const cosseratSystem& system,
    const dictionary& controls
)
:
    flowPreconditioner(system),
    controls_(controls),
    couplingLimit_(controls.getOrDefault<scalar>("couplingLimit", 3)),
    jumpLimit_
    (
        controls.getOrDefault<scalar>
        (
            "jumpLimit", system.cosserat() ? 1e5 : 1e7
        )
    ),
    direct_(false),
    available_(true)
{
    choose(false);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::flowPreconditioners::automatic::update()
{
    const bool direct = needsFactorisation();
    if (direct != direct_)
    {
        const scalar coupling = system_.coefficients().largestCoupling();
        const scalar jump = system_.coefficients().largestJump();

        available_ = !direct || sparseFactorisation::available
        (
            "mumps", system_.faces().mesh().time()
        );
        if (!available_)
        {
            WarningInFunction
                << "Largest etaC/eta " << coupling << ", largest jump of eta "
                << jump << ": a sparse factorisation is wanted, but there is"
                << " no library of it (for MUMPS the package libmumps-dev when"
                << " this program is built); multigrid is tried" << endl;
        }
        else
        {
            Info<< "Velocity and microrotation: "
                << (direct ? "sparse factorisation" : "multigrid")
                << " (largest etaC/eta " << coupling
                << ", largest jump of eta " << jump << ')' << endl;
        }
        choose(direct);
    }

    chosen_->update();
}


void Foam::flowPreconditioners::automatic::apply
(
    const scalarField& r,
    scalarField& z
) const
{
    chosen_->apply(r, z);
}


// ************************************************************************* //
