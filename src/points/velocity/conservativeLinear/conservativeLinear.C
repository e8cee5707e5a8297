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
#include "extrapolatedCalculatedFvPatchFields.H"
#include "gaussGrad.H"
#include "leastSquaresGrad.H"
#include "oneLayer.H"
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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::volTensorField>
Foam::pointVelocities::conservativeLinear::gradientInPlane() const
{
    const fvMesh& mesh = U_.mesh();
    const vectorField& C = mesh.C();

    // Sums of d d/d^2 and d dU/d^2 over the neighbours of each cell
    tensorField dd(mesh.nCells(), Zero), dU(mesh.nCells(), Zero);
    auto add = [&](const label celli, const vector& d, const vector& change)
    {
        dd[celli] += d*d/magSqr(d);
        dU[celli] += d*change/magSqr(d);
    };

    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        add(P, C[N] - C[P], U_[N] - U_[P]);
        add(N, C[P] - C[N], U_[P] - U_[N]);
    }
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (oneLayer::isPlane(patch.patch()))
        {
            continue;
        }

        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        const vectorField d(patch.delta());
        const vectorField beyond
        (
            Up.coupled() ? Up.patchNeighbourField() : tmp<vectorField>(Up)
        );
        forAll(patch, i)
        {
            const label celli = patch.faceCells()[i];
            add(celli, d[i], beyond[i] - U_[celli]);
        }
    }

    tmp<volTensorField> tgradU
    (
        volTensorField::New
        (
            "gradU", mesh, dimensionedTensor(dimless/dimTime, Zero),
            extrapolatedCalculatedFvPatchTensorField::typeName
        )
    );
    volTensorField& gradU = tgradU.ref();
    const vector e(frame_.e());
    forAll(dd, celli)
    {
        gradU[celli] = inv(dd[celli] + e*e) & dU[celli];
    }
    gradU.correctBoundaryConditions();
    fv::gaussGrad<vector>::correctBoundaryConditions(U_, gradU);

    return tgradU;
}


Foam::List<Foam::tensorField>
Foam::pointVelocities::conservativeLinear::onBoundary
(
    const volTensorField& gradU
) const
{
    const fvMesh& mesh = U_.mesh();
    const openFaces passed(U_, phi_);

    List<tensorField> onBoundary(mesh.boundary().size());
    forAll(onBoundary, patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (oneLayer::isPlane(patch.patch()))
        {
            continue;
        }

        const fvPatchTensorField& gradp = gradU.boundaryField()[patchi];
        tensorField& G = onBoundary[patchi];
        if (gradp.coupled())
        {
            G =
                patch.weights()*gradp.patchInternalField()
              + (1.0 - patch.weights())*gradp.patchNeighbourField();
            continue;
        }

        G = gradp;
        forAll(G, i)
        {
            if (!passed.open(patch.start() + i))
            {
                G[i] = Zero;
            }
        }
    }

    return onBoundary;
}


Foam::scalarField Foam::pointVelocities::conservativeLinear::slopes
(
    const volTensorField& gradU
) const
{
    const fvMesh& mesh = U_.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const label nInternal = mesh.nInternalFaces();
    const scalarField& weights = mesh.weights();
    const List<tensorField> boundary(onBoundary(gradU));

    auto on = [&](const label facei)
    {
        if (facei < nInternal)
        {
            const tensor& GN = gradU[mesh.faceNeighbour()[facei]];
            const tensor& GP = gradU[mesh.faceOwner()[facei]];
            return tensor(weights[facei]*(GP - GN) + GN);
        }
        const label patchi = patches.whichPatch(facei);
        return boundary[patchi][facei - patches[patchi].start()];
    };

    // A face has the same from both of its cells
    scalarField slopes(mesh.nFaces(), Zero);
    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        for (label i = start_[celli]; i < start_[celli + 1]; ++i)
        {
            if (faces_[i] >= 0 && mesh.faceOwner()[faces_[i]] == celli)
            {
                // Along the edge, and outward with the same length
                const vector t(edge(celli, i - start_[celli]));
                const vector outward
                (
                    frame_.inSpace(planarFrame::tangent(frame_.inPlane(t)))
                );
                slopes[faces_[i]] = (t & on(faces_[i])) & outward;
            }
        }
    }

    return slopes;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointVelocities::conservativeLinear::conservativeLinear
(
    const dictionary& dict,
    const volVectorField& U,
    const surfaceScalarField& phi
)
:
    faceFlux(dict, U, phi)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointVelocities::conservativeLinear::update()
{
    takeFluxes();

    const tmp<volTensorField> tgradU
    (
        axial_.active()
      ? gradientInPlane()
      : fv::leastSquaresGrad<vector>(U_.mesh()).calcGrad(U_, "gradU")
    );
    const volTensorField& gradU = tgradU();
    setSlopes(slopes(gradU));

    forAll(fans_, i)
    {
        const tensor& G = gradU[fanCells_[i]];
        setFan(i, frame_.component(G, 0, 1) - frame_.component(G, 1, 0));
    }
}


// ************************************************************************* //
