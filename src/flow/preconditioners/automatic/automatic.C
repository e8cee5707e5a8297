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
#include "StringStream.H"
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


void Foam::flowPreconditioners::automatic::choose(const bool direct) const
{
    direct_ = direct;

    if (direct && !available_)
    {
        return;
    }

    dictionary controls(controls_);
    controls.set("block", word(direct ? "whole" : "multigrid"));
    chosen_.clear();
    chosen_ = flowPreconditioner::New(system_, controls);
}


void Foam::flowPreconditioners::automatic::change
(
    const bool direct,
    const string& reason
) const
{
    available_ =
        !direct
     || sparseFactorisation::available("mumps", system_.faces().mesh().time());

    if (!available_)
    {
        WarningInFunction
            << reason << ": a sparse factorisation is wanted, but there is"
            << " no library of it (for MUMPS the package libmumps-dev when"
            << " this program is built); multigrid is tried" << endl;
    }
    else
    {
        Info<< "Preconditioner: "
            << (direct ? "sparse factorisation" : "multigrid")
            << " (" << reason.c_str() << ')' << endl;
    }
    choose(direct);
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
    jumpLimit_(controls.getOrDefault<scalar>("jumpLimit", 1e7)),
    maxUses_(controls.getOrDefault<label>("multigridUses", 150)),
    direct_(false),
    available_(true),
    tooMany_(false),
    nUses_(0)
{
    choose(false);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::flowPreconditioners::automatic::update()
{
    const bool direct = tooMany_ || needsFactorisation();
    if (direct != direct_)
    {
        OStringStream reason;
        reason
            << "largest etaC/eta " << system_.coefficients().largestCoupling()
            << ", largest jump of eta " << system_.coefficients().largestJump();
        change(direct, reason.str());
    }

    nUses_ = 0;
    chosen_->update();
}


void Foam::flowPreconditioners::automatic::apply
(
    const scalarField& r,
    scalarField& z
) const
{
    if (!direct_ && ++nUses_ > maxUses_)
    {
        tooMany_ = true;
        change
        (
            true,
            name(maxUses_) + " iterations by multigrid did not do"
        );
        chosen_->update();
    }
    chosen_->apply(r, z);
}


// ************************************************************************* //
