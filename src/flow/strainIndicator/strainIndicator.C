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

#include "strainIndicator.H"
#include "materialFields.H"
#include "oneLayer.H"
#include "planarCells.H"
#include "planarFit.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::strainIndicator::rotates() const
{
    const scalarField etaC(links_.values(materials_.etaC()));
    const scalarField M(links_.values(materials_.M()));

    boolList rotates(M.size());
    forAll(rotates, i)
    {
        rotates[i] = etaC[i] > 0 && M[i] > 0;
    }
    return rotates;
}


Foam::boolList Foam::strainIndicator::mixed() const
{
    boolList mixed(mesh_.nCells(), false);
    if (!materials_.parts().has(sceneParts::AVERAGES))
    {
        return mixed;
    }

    // A fraction of which neither the solution nor its error takes notice
    const scalar none = 1e-3;

    for (const word& name : materials_.names())
    {
        const auto& alpha = mesh_.lookupObject<volScalarField>
        (
            IOobject::groupName("alpha", name)
        );
        forAll(mixed, celli)
        {
            mixed[celli] =
                mixed[celli] || (alpha[celli] > none && alpha[celli] < 1 - none);
        }
    }
    return mixed;
}


Foam::List<Foam::strainIndicator::strain>
Foam::strainIndicator::strains
(
    const volTensorField& gradU,
    const volVectorField& gradOmega
) const
{
    const tensorField G(links_.values(gradU));
    const scalarField omega
    (
        links_.values(mesh_.lookupObject<volScalarField>("omega"))
    );
    const vectorField k(links_.values(gradOmega));

    List<strain> strains(G.size());
    forAll(strains, i)
    {
        const auto g = [&](const int j, const int l)
        {
            return frame_.component(G[i], j, l);
        };
        strains[i] = strain
        {
            g(0, 0) - g(1, 1),
            0.5*(g(0, 1) + g(1, 0)),
            g(0, 0) + g(1, 1),
            omega[i] - 0.5*(g(0, 1) - g(1, 0)),
            k[i][frame_.i0()],
            k[i][frame_.i1()]
        };
    }
    return strains;
}


Foam::strainIndicator::strain
Foam::strainIndicator::viscosities(const label celli) const
{
    const materialFields& m = materials_;
    const scalar
        eta = m.eta()[celli], etaC = m.etaC()[celli], M = m.M()[celli],
        invB = m.invB()[celli];

    return strain
    {
        eta, 4*eta, (invB > 0 ? 1/invB : 0) + (axial_ ? eta : 0), 4*etaC, M, M
    };
}


Foam::tmp<Foam::symmTensorField>
Foam::strainIndicator::moments() const
{
    auto tmoments = tmp<symmTensorField>::New(mesh_.nCells(), Zero);
    const planarCells cells(mesh_);
    const vector e(frame_.e());

    forAll(mesh_.C(), celli)
    {
        vectorField r(cells.corners(celli) - mesh_.C()[celli]);
        r -= (r & e)*e;

        symmTensor sum(Zero);
        scalar area = 0;
        forAll(r, i)
        {
            // The triangle of the centre and an edge
            const vector &a = r[i], &b = r[r.fcIndex(i)];
            const scalar A = 0.5*mag(a ^ b);
            sum += A/12*(sqr(a) + sqr(b) + sqr(a + b));
            area += A;
        }
        tmoments.ref()[celli] = sum/area;
    }
    return tmoments;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::strainIndicator::strainIndicator(const materialFields& materials)
:
    materials_(materials),
    mesh_(materials.mesh()),
    frame_(oneLayer::check(mesh_)),
    links_(mesh_, frame_),
    axial_(axialSymmetry(mesh_).active())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volVectorField>
Foam::strainIndicator::gradOmega() const
{
    const scalarField omega
    (
        links_.values(mesh_.lookupObject<volScalarField>("omega"))
    );
    const scalarField M(links_.values(materials_.M()));

    planarFit<1> fit(mesh_.nCells(), frame_.e());
    for (const cellLinks::link& link : links_.links())
    {
        const label P = link.celli, N = link.behind;
        const scalar share =
            link.boundary ? 1 : 2*M[N]/max(M[P] + M[N], VSMALL);
        fit.add(P, link.way, {share*(omega[N] - omega[P])});
    }

    auto tgrad = tmp<volVectorField>::New
    (
        IOobject("gradOmega", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimless/dimTime/dimLength, Zero),
        "zeroGradient"
    );
    forAll(mesh_.C(), celli)
    {
        tgrad.ref()[celli] = fit.at(celli).slope[0];
    }
    tgrad.ref().correctBoundaryConditions();
    return tgrad;
}


Foam::tmp<Foam::scalarField>
Foam::strainIndicator::power
(
    const volTensorField& gradU,
    const volVectorField& gradOmega
) const
{
    const List<strain> e(strains(gradU, gradOmega));
    const boolList free(rotates()), both(mixed());
    const scalarField a
    (
        links_.values((materials_.eta() + materials_.etaC())())
    );

    planarFit<6> fit(mesh_.nCells(), frame_.e(), 2);
    for (const cellLinks::link& link : links_.links())
    {
        const label P = link.celli, N = link.behind;
        const bool jump =
            max(a[P], a[N]) > 2*min(a[P], a[N]) || free[P] != free[N];

        if (!link.boundary && (both[P] || !jump))
        {
            strain delta;
            forAll(delta, k)
            {
                delta[k] = k < 3 || (free[P] && free[N]) ? e[N][k] - e[P][k] : 0;
            }
            fit.add(P, link.way, delta);
        }
    }

    const symmTensorField rr(moments());
    auto tpower = tmp<scalarField>::New(mesh_.nCells(), Zero);
    forAll(rr, celli)
    {
        const planarFit<6>::linear error(fit.at(celli));
        const strain viscosity(viscosities(celli));
        forAll(viscosity, k)
        {
            tpower.ref()[celli] +=
                mesh_.V()[celli]*viscosity[k]
               *(
                    sqr(error.value[k])
                  + (error.slope[k] & rr[celli] & error.slope[k])
                );
        }
    }
    return tpower;
}


// ************************************************************************* //
