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

#include "cutCells.H"
#include "wallFvPatch.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Cosine of the angle between a wall's normal and that of what faces it
static const Foam::scalar towards = 0.5;

//- Viscosity, by that of a stiffer material, of what stands in for empty space
static const Foam::scalar air = 1.0/300;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::cutCells::stiffnessAtRest(const label m) const
{
    const viscosityLaw& law = materials_[m].law();
    const scalar eta = law.eta().value();
    const scalar etaC = law.M().value() > 0 ? law.etaC().value() : 0;
    return eta + (law.followsFlow() ? etaC : min(etaC, eta));
}


Foam::Pair<Foam::label> Foam::cutCells::softestAndStiffest
(
    const label celli
) const
{
    // At rest: grains that yield may be as soft as 300 times the air
    const scalarField& fraction = fraction_[row_[celli]];
    Pair<label> found(centre_[celli], centre_[celli]);
    forAll(fraction, m)
    {
        if (fraction[m] > smallestCut)
        {
            const scalar a = stiffnessAtRest(m);
            if (a < stiffnessAtRest(found.first()))
            {
                found.first() = m;
            }
            if (a > stiffnessAtRest(found.second()))
            {
                found.second() = m;
            }
        }
    }
    return found;
}


bool Foam::cutCells::onAir(const label celli) const
{
    const Pair<label> found(softestAndStiffest(celli));
    return
        found.second() == centre_[celli]
     && stiffnessAtRest(found.first()) < air*stiffnessAtRest(found.second());
}


bool Foam::cutCells::yieldsOnAir(const label celli) const
{
    const Pair<label> found(softestAndStiffest(celli));
    const material& gas = materials_[found.first()];
    const material& body = materials_[found.second()];
    return
        body.law().followsFlow()
     && stiffnessAtRest(found.first()) < air*stiffnessAtRest(found.second())
     && gas.rho().value() < air*body.rho().value();
}


void Foam::cutCells::setMixed(const fvMesh& mesh)
{
    forAll(row_, celli)
    {
        mixed_[celli] = row_[celli] >= 0 && yieldsOnAir(celli);
    }
    for (const fvPatch& patch : mesh.boundary())
    {
        if (isA<wallFvPatch>(patch))
        {
            const vectorField n(patch.nf());
            forAll(n, i)
            {
                const label celli = patch.faceCells()[i], row = row_[celli];
                const label m = centre_[celli];
                if
                (
                    row >= 0
                 && (normal_[row][m] & n[i]) > towards
                 && onAir(celli)
                )
                {
                    mixed_[celli] = true;
                }
            }
        }
    }
}


Foam::cutCells::layers Foam::cutCells::mixture(const label celli) const
{
    const scalarField& fraction = fraction_[row_[celli]];
    scalar eta = 0, etaC = 0, es = 0, M = 0;
    forAll(fraction, m)
    {
        const layers l(pure(m, celli));
        eta += fraction[m]*l.eta;
        etaC += fraction[m]*l.etaC;
        es += fraction[m]*l.es;
        M += fraction[m]*l.M;
    }

    return composed(eta, es, etaC, M);
}


// ************************************************************************* //
