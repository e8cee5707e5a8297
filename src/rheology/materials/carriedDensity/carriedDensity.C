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

#include "carriedDensity.H"
#include "smoothGradient.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Function>
void Foam::carriedDensity::forFaces
(
    const volScalarField& given,
    const Function& f
) const
{
    const volScalarField& eta = materials_.eta();
    const fvMesh& mesh = eta.mesh();
    const surfaceScalarField& S = mesh.magSf();
    const surfaceScalarField& d = mesh.nonOrthDeltaCoeffs();

    forAll(mesh.neighbour(), facei)
    {
        const label N = mesh.neighbour()[facei];
        f(mesh.owner()[facei], N, eta[N], given[N], S[facei]*d[facei]);
    }

    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (!patch.coupled())
        {
            continue;
        }
        const scalarField etaN
        (
            eta.boundaryField()[patchi].patchNeighbourField()
        );
        const scalarField givenN
        (
            given.boundaryField()[patchi].patchNeighbourField()
        );
        forAll(patch, i)
        {
            f
            (
                patch.faceCells()[i], -1, etaN[i], givenN[i],
                S.boundaryField()[patchi][i]*d.boundaryField()[patchi][i]
            );
        }
    }
}


Foam::tmp<Foam::volScalarField> Foam::carriedDensity::given() const
{
    const volScalarField& eta = materials_.eta();
    const fvMesh& mesh = eta.mesh();

    tmp<volScalarField> tgiven
    (
        new volScalarField
        (
            IOobject("given", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(dimMass, Zero),
            "zeroGradient"
        )
    );
    volScalarField& given = tgiven.ref();

    scalarField sum(eta.size(), Zero);
    forFaces
    (
        given,
        [&]
        (
            const label P, const label N, const scalar etaN, const scalar,
            const scalar K
        )
        {
            sum[P] += max(eta[P], etaN)*K;
            if (N >= 0)
            {
                sum[N] += max(eta[P], eta[N])*K;
            }
        }
    );

    // Not of the viscosities, which are those of the centres: of an interface
    // that leans they make stairs
    const volScalarField& mean = materials_.rho();
    const volVectorField n(smoothGradient(mean));
    const scalarField flowing(materials_.flowingDensity());
    const scalarField& rho = mean.primitiveField();

    forAll(given, celli)
    {
        const scalar nn = magSqr(n[celli]);
        const scalar along = nn > VSMALL ? sqr(n[celli] & down_)/nn : 0;
        given[celli] = mesh.V()[celli]*(rho[celli] - flowing[celli])
           *max(1 - along, 0)/max(sum[celli], VSMALL);
    }
    given.correctBoundaryConditions();

    return tgiven;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::carriedDensity::carriedDensity
(
    const materialFields& materials,
    const vector& g
)
:
    materials_(materials),
    down_(normalised(g))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::carriedDensity::density() const
{
    const volScalarField& eta = materials_.eta();
    const scalarField& V = eta.mesh().V();
    const volScalarField given(this->given());

    tmp<scalarField> trho(new scalarField(materials_.rho().primitiveField()));
    scalarField& rho = trho.ref();

    forFaces
    (
        given,
        [&]
        (
            const label P, const label N, const scalar etaN,
            const scalar givenN, const scalar K
        )
        {
            // From the softer to the stiffer, seen from either
            const scalar toN = K*max(etaN - eta[P], scalar(0))*given[P];
            const scalar toP = K*max(eta[P] - etaN, scalar(0))*givenN;
            rho[P] += (toP - toN)/V[P];
            if (N >= 0)
            {
                rho[N] += (toN - toP)/V[N];
            }
        }
    );

    return trho;
}


// ************************************************************************* //
