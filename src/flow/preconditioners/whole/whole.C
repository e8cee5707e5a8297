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

#include "whole.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace flowPreconditioners
{
    defineTypeNameAndDebug(whole, 0);
    addToRunTimeSelectionTable(flowPreconditioner, whole, system);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::flowPreconditioners::whole::factorise() const
{
    sparseEntries entries;
    matrix_.getEntries(entries);

    // Against rigid motions that no wall holds and the uniform pressure of a
    // closed body, which others remove: small beside the operator, large
    // beside its rounding
    const scalar share = 1e-10;
    scalarField diag, face;
    for (label cmpt = 0; cmpt < 2; ++cmpt)
    {
        system_.parts().velocityBlock(cmpt, diag, face);
        forAll(diag, celli)
        {
            const label i = matrix_.number(celli, cmpt);
            entries.add(i, i, share*diag[celli]);
        }
    }
    forAll(muByV(), celli)
    {
        const label i = matrix_.number(celli, 2);
        entries.add(i, i, share/muByV()[celli]);
    }

    factorisation_->factorise(entries);
    present_ = true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowPreconditioners::whole::whole
(
    const cosseratSystem& system,
    const dictionary& controls
)
:
    flowPreconditioner(system),
    matrix_(system, true),
    maxUses_(controls.getOrDefault<label>("maxUses", 0)),
    factorisation_
    (
        sparseFactorisation::New
        (
            "mumps",
            system.faces().mesh().time(),
            matrix_.nBlocks()*system.nCells()
        )
    ),
    present_(false),
    nUses_(-1)
{
    if (maxUses_ < 0)
    {
        checkedEntry::refuse
        (
            controls, "maxUses", name(maxUses_), "at least 0"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::flowPreconditioners::whole::update()
{
    flowPreconditioner::update();

    const bool first = nUses_ < 0;
    present_ = false;
    nUses_ = 0;
    if (first)
    {
        factorise();
    }
}


void Foam::flowPreconditioners::whole::apply
(
    const scalarField& r,
    scalarField& z
) const
{
    if (!present_ && nUses_ >= maxUses_)
    {
        factorise();
    }
    ++nUses_;

    scalarField b(matrix_.ordered(r));
    factorisation_->solve(b);
    z.setSize(r.size());
    matrix_.spread(b, z);
}


// ************************************************************************* //
