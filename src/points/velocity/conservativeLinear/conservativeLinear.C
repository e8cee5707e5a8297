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

#include "conservativeLinear.H"
#include "leastSquaresGrad.H"
#include "linear.H"
#include "openFaces.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace pointVelocities
{
    defineTypeNameAndDebug(conservativeLinear, 0);
    addToRunTimeSelectionTable(pointVelocity, conservativeLinear, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointVelocities::conservativeLinear::conservativeLinear
(
    const dictionary& dict,
    const volVectorField& U,
    const surfaceScalarField& phi
)
:
    faceFlux(dict, U, phi),
    U_(U)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointVelocities::conservativeLinear::update()
{
    takeFluxes();

    const fvMesh& mesh = U_.mesh();
    const tmp<volTensorField> tgradU
    (
        fv::leastSquaresGrad<vector>(mesh).calcGrad(U_, "gradU")
    );
    const tensorField& gradU = tgradU().primitiveField();
    const surfaceTensorField grad(linearInterpolate(tgradU()));

    // Along closed faces the velocity has no slope normal to them
    const openFaces passed(U_, phi_);

    tensorField all(mesh.nFaces(), Zero);
    SubList<tensor>(all, mesh.nInternalFaces()) = grad.primitiveField();
    forAll(grad.boundaryField(), patchi)
    {
        const fvsPatchTensorField& gradp = grad.boundaryField()[patchi];
        const label start = mesh.boundaryMesh()[patchi].start();

        forAll(gradp, i)
        {
            if (gradp.coupled() || passed.open(start + i))
            {
                all[start + i] = gradp[i];
            }
        }
    }

    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        const label first = start_[celli];
        const label n = start_[celli + 1] - first;

        for (label i = 0; i < n; ++i)
        {
            // Along the edge, and outward with the same length
            const vector t
            (
                corners_[first + (i + 1) % n] - corners_[first + i]
            );
            vector outward(Zero);
            outward[i0_] = t[i1_];
            outward[i1_] = -t[i0_];

            slope_[first + i] = (t & all[faces_[first + i]]) & outward;
        }
    }

    forAll(fans_, i)
    {
        const tensor& G = gradU[fanCells_[i]];
        setFan(i, G[3*i0_ + i1_] - G[3*i1_ + i0_]);
    }
}


// ************************************************************************* //
