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

#include "multigridBlock.H"
#include "haloExchange.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::multigridBlock::multigridBlock
(
    const word& name,
    const haloExchange& halo,
    const dictionary& controls
)
:
    halo_(halo),
    controls_(controls),
    field_
    (
        IOobject
        (
            name,
            halo.mesh().time().timeName(),
            halo.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        halo.mesh(),
        dimensionedScalar(dimless, Zero),
        "zeroGradient"
    ),
    interfaces_(field_.boundaryField().scalarInterfaces()),
    matrix_(halo.mesh()),
    bouCoeffs_(halo.mesh().boundary().size()),
    intCoeffs_(halo.mesh().boundary().size())
{
    const fvMesh& mesh = halo.mesh();

    forAll(mesh.boundary(), patchi)
    {
        const label n =
            mesh.boundary()[patchi].coupled()
          ? mesh.boundary()[patchi].size()
          : 0;
        bouCoeffs_.set(patchi, new scalarField(n, Zero));
        intCoeffs_.set(patchi, new scalarField(n, Zero));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::multigridBlock::set
(
    const scalarField& diag,
    const scalarField& face
)
{
    const fvMesh& mesh = field_.mesh();
    const label nInternal = mesh.nInternalFaces();

    cycle_.clear();
    solver_.clear();

    matrix_.diag() = diag;
    matrix_.upper() = -scalarField(SubList<scalar>(face, nInternal));

    for (const label patchi : halo_.coupledPatches())
    {
        bouCoeffs_[patchi] = SubList<scalar>
        (
            face,
            mesh.boundary()[patchi].size(),
            nInternal + halo_.start(patchi) - mesh.nCells()
        );
        intCoeffs_[patchi] = bouCoeffs_[patchi];
    }

    dictionary solverDict;
    solverDict.add("solver", word("PCG"));
    solverDict.add("preconditioner", controls_);

    solver_ = lduMatrix::solver::New
    (
        field_.name(), matrix_, bouCoeffs_, intCoeffs_, interfaces_, solverDict
    );
    cycle_ = lduMatrix::preconditioner::New(solver_(), solverDict);
}


void Foam::multigridBlock::apply
(
    scalarField& z,
    const scalarField& r
) const
{
    cycle_->precondition(z, r, 0);
}


// ************************************************************************* //
