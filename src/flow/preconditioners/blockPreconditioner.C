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

#include "blockPreconditioner.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Largest etaC/eta, and jump of eta from cell to cell with and without a
//- microrotation, that multigrid is chosen for
static const Foam::scalar couplingLimit = 3, jumpLimits[] = {1e5, 1e7};


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::blockPreconditioner::choice>
Foam::blockPreconditioner::choiceNames
({
    { choice::AUTOMATIC, "automatic" },
    { choice::MULTIGRID, "multigrid" },
    { choice::DIRECT, "direct" }
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::blockPreconditioner::needsFactorisation() const
{
    if (choice_ != AUTOMATIC)
    {
        return choice_ == DIRECT;
    }

    return
        system_.largestCoupling() > couplingLimit
     || system_.largestJump() > jumpLimits[system_.cosserat() ? 0 : 1];
}


void Foam::blockPreconditioner::solveDirectly
(
    const scalarField& r,
    scalarField& z
) const
{
    const label n = system_.nCells();
    const label nb = system_.nBlocks() - 1;
    const label start[] = {0, n, 3*n};
    scalarField b(nb*n);

    for (label k = 0; k < nb; ++k)
    {
        for (label celli = 0; celli < n; ++celli)
        {
            b[nb*celli + k] = r[start[k] + celli];
        }
    }

    factorisation_->solve(b);

    for (label k = 0; k < nb; ++k)
    {
        for (label celli = 0; celli < n; ++celli)
        {
            z[start[k] + celli] = b[nb*celli + k];
        }
    }
}


void Foam::blockPreconditioner::cycle
(
    const label block,
    const label unknown,
    const scalarField& r,
    scalarField& z
) const
{
    const label n = system_.nCells();
    ri_ = SubList<scalar>(r, n, unknown*n);
    blocks_[block].apply(zi_, ri_);
    SubList<scalar>(z, n, unknown*n) = zi_;
}


Foam::tmp<Foam::scalarField> Foam::blockPreconditioner::pressureOf
(
    const scalarUList& r
) const
{
    tmp<scalarField> tp(2*muByV_*r);
    if (system_.closed())
    {
        const scalarField& V = system_.mesh().V();
        tp.ref() -= gSum(V*tp())/gSum(V);
    }
    return tp;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::blockPreconditioner::blockPreconditioner
(
    cosseratSystem& system,
    const haloExchange& halo,
    const dictionary& controls
)
:
    system_(system),
    blocks_(system.cosserat() ? 3 : 2),
    choice_
    (
        choiceNames.getOrDefault("block", controls, choice::AUTOMATIC)
    ),
    direct_(false),
    ri_(system.nCells()),
    zi_(system.nCells())
{
    const char* names[] = {"U0", "U1", "omega"};

    forAll(blocks_, i)
    {
        blocks_.set
        (
            i,
            new multigridBlock(names[i], system.mesh(), halo, controls)
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::blockPreconditioner::update()
{
    const label n = system_.nCells();
    const scalarField& V = system_.mesh().V();

    const bool direct = needsFactorisation();
    if (direct != direct_)
    {
        Info<< "Velocity and microrotation: "
            << (direct ? "sparse factorisation" : "multigrid")
            << " (largest etaC/eta " << system_.largestCoupling()
            << ", largest jump of eta " << system_.largestJump() << ')'
            << endl;
        direct_ = direct;
    }

    weights_.setSize(system_.size());
    scalarField diag, face;

    for (label cmpt = 0; cmpt < 2; ++cmpt)
    {
        system_.velocityBlock(cmpt, diag, face);
        system_.corners().addDiagonal(cmpt, diag);
        if (!direct_)
        {
            blocks_[cmpt].set(diag, face);
        }
        SubList<scalar>(weights_, n, cmpt*n) = 1/sqrt(diag);
    }

    if (direct_)
    {
        if (!factorisation_)
        {
            factorisation_ = sparseFactorisation::New
            (
                "mumps",
                system_.mesh().time(),
                (system_.nBlocks() - 1)*n
            );
        }
        sparseEntries entries;
        system_.viscousEntries(entries);
        factorisation_->factorise(entries);
    }

    muByV_ = system_.pressureViscosity()/V;
    SubList<scalar>(weights_, n, 2*n) = sqrt(muByV_);

    if (system_.cosserat())
    {
        system_.rotationBlock(diag, face);
        if (!direct_)
        {
            blocks_[2].set(diag, face);
        }
        SubList<scalar>(weights_, n, 3*n) = 1/sqrt(diag);
    }
}


void Foam::blockPreconditioner::apply
(
    const scalarField& r,
    scalarField& z
) const
{
    const label n = system_.nCells();
    work_ = r;
    z.setSize(r.size());

    scalarField p(pressureOf(SubList<scalar>(r, n, 2*n)));
    if (system_.closed() && !system_.pressureFloats())
    {
        p += gSum(SubList<scalar>(r, n, 2*n))/system_.compliance();
    }

    if (direct_)
    {
        system_.addPressureForce(p, work_);
        solveDirectly(work_, z);
    }
    else
    {
        if (system_.cosserat())
        {
            cycle(2, 3, work_, z);
            system_.addRotationForce
            (
                scalarField(SubList<scalar>(z, n, 3*n)), work_
            );
        }
        system_.addPressureForce(p, work_);
        cycle(0, 0, work_, z);
        cycle(1, 1, work_, z);
    }

    system_.addDivergence(z, work_);
    SubList<scalar>(z, n, 2*n) =
        scalarField(p + pressureOf(SubList<scalar>(work_, n, 2*n)));

    if (system_.cosserat() && !direct_)
    {
        system_.addCurl(z, work_);
        cycle(2, 3, work_, z);
    }
}


// ************************************************************************* //
