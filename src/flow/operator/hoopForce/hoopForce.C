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

#include "hoopForce.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::hoopForce::bending() const
{
    const label n = mesh_.nCells();
    scalarField sum(n, Zero), weight(n, Zero);

    auto add = [&](const label celli, const label f)
    {
        // None where no couple passes
        const planarFace& face = mesh_[f];
        const scalar M = K_.rotation(f).Km/(face.dc*face.S);
        if (celli < n && M > 0)
        {
            const scalar across = mesh_.edge(f)*sqr(face.n & mesh_.radial());
            sum[celli] += across*M;
            weight[celli] += across;
        }
    };
    mesh_.forTwoSided
    (
        [&](const label f)
        {
            add(mesh_[f].own, f);
            add(mesh_[f].nei, f);
        }
    );
    for (const label f : mesh_.oneSided())
    {
        add(mesh_[f].own, f);
    }

    tmp<scalarField> tM(new scalarField(n));
    forAll(sum, celli)
    {
        tM.ref()[celli] =
            weight[celli] > 0 ? sum[celli]/weight[celli] : K_.M(celli);
    }
    return tM;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::hoopForce::hoopForce
(
    const faceGeometry& mesh,
    const viscousCoefficients& K
)
:
    mesh_(mesh),
    K_(K)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::hoopForce::update()
{
    if (!active())
    {
        return;
    }

    const label n = mesh_.nCells();
    Ku_.setSize(n);
    Kb_ = scalarField(K_.compressible() ? n : 0, Zero);
    for (label celli = 0; celli < n; ++celli)
    {
        const scalar r = mesh_.radius(celli);
        Ku_[celli] = 2*K_.eta(celli)*mesh_.V()[celli]/sqr(r);
        if (K_.compressible(celli))
        {
            Ku_[celli] /= 2;
            Kb_[celli] = K_.eta(celli)*mesh_.V()[celli]/r;
        }
    }

    if (K_.cosserat())
    {
        Komega_ = bending();
        for (label celli = 0; celli < n; ++celli)
        {
            Komega_[celli] *=
                K_.rotationUndetermined(celli)
              ? 0 : mesh_.V()[celli]/sqr(mesh_.radius(celli));
        }
    }
}


Foam::scalar Foam::hoopForce::force
(
    const operatorState& s,
    const label celli
) const
{
    scalar F = -Ku_[celli]*(s.u[celli] & mesh_.radial());
    if (Kb_.size())
    {
        F += Kb_[celli]*tr(s.G[celli]);
    }
    return F;
}


void Foam::hoopForce::add
(
    const operatorState& s,
    const unknowns& all,
    scalarField& r
) const
{
    if (!active())
    {
        return;
    }

    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        all.addForce(r, celli, force(s, celli)*mesh_.radial());
        if (K_.cosserat())
        {
            all.addCouple(r, celli, couple(s, celli));
        }
    }
}


void Foam::hoopForce::addVelocityDiagonal
(
    const label cmpt,
    scalarField& diag
) const
{
    if (active() && mesh_.radial()[cmpt] > 0)
    {
        diag += Ku_;
    }
}


void Foam::hoopForce::addRotationDiagonal(scalarField& diag) const
{
    if (active())
    {
        diag += Komega_;
    }
}


// ************************************************************************* //
