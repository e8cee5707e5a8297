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

#include "factorised.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace flowPreconditioners
{
    defineTypeNameAndDebug(factorised, 0);
    addToRunTimeSelectionTable(flowPreconditioner, factorised, system);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowPreconditioners::factorised::factorised
(
    const cosseratSystem& system,
    const dictionary&
)
:
    flowPreconditioner(system),
    matrix_(system),
    factorisation_
    (
        sparseFactorisation::New
        (
            "mumps",
            system.faces().mesh().time(),
            matrix_.nBlocks()*system.nCells()
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::flowPreconditioners::factorised::update()
{
    flowPreconditioner::update();

    sparseEntries entries;
    matrix_.getEntries(entries);

    // Against rigid motions that no wall holds, which others remove: small
    // beside the operator, large beside its rounding
    scalarField diag, face;
    for (label cmpt = 0; cmpt < 2; ++cmpt)
    {
        system_.parts().velocityBlock(cmpt, diag, face);
        forAll(diag, celli)
        {
            const label i = matrix_.number(celli, cmpt);
            entries.add(i, i, 1e-10*diag[celli]);
        }
    }

    factorisation_->factorise(entries);
}


void Foam::flowPreconditioners::factorised::apply
(
    const scalarField& r,
    scalarField& z
) const
{
    const label n = system_.nCells();
    const scalarField p(pressureOf(r));
    scalarField left(r);
    z.setSize(r.size());

    system_.parts().addPressureForce(p, s_, left);

    scalarField b(matrix_.ordered(left));
    factorisation_->solve(b);
    matrix_.spread(b, z);
    SubList<scalar>(z, n, 2*n) = p;
}


// ************************************************************************* //
