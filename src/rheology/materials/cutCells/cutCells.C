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
#include "smoothGradient.H"
#include "surfaceFields.H"
#include "oneLayer.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Call f(cell, normal, value of the cell behind) for all cells and faces
    //- with a cell behind
    template<class Type, class Function>
    static void forNeighbours
    (
        const GeometricField<Type, fvPatchField, volMesh>& q,
        const Function& f
    )
    {
        const fvMesh& mesh = q.mesh();
        const labelUList& own = mesh.owner();
        const labelUList& nei = mesh.neighbour();

        forAll(nei, facei)
        {
            const vector n(normalised(mesh.Sf()[facei]));
            f(own[facei], n, q[nei[facei]]);
            f(nei[facei], n, q[own[facei]]);
        }
        forAll(mesh.boundary(), patchi)
        {
            const fvPatch& patch = mesh.boundary()[patchi];
            if (patch.coupled())
            {
                const Field<Type> behind
                (
                    q.boundaryField()[patchi].patchNeighbourField()
                );
                const vectorField n(patch.nf());
                forAll(behind, i)
                {
                    f(patch.faceCells()[i], n[i], behind[i]);
                }
            }
        }
    }


    template<class Type>
    static GeometricField<Type, fvPatchField, volMesh> zeroField
    (
        const fvMesh& mesh
    )
    {
        return GeometricField<Type, fvPatchField, volMesh>
        (
            IOobject("cut", mesh.time().timeName(), mesh),
            mesh,
            dimensioned<Type>("zero", dimless, Zero),
            "zeroGradient"
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::cutCells::layers Foam::cutCells::pure
(
    const label m,
    const label celli
) const
{
    const viscosityLaw& law = materials_[m].law();
    const scalar eta = law.eta()[celli];
    const scalar etaC = law.M().value() > 0 ? law.etaC()[celli] : 0;
    const scalar es = law.followsFlow() ? etaC : min(etaC, eta);

    return composed(eta, es, etaC, law.M()[celli]);
}


void Foam::cutCells::setCut(const PtrList<volScalarField>& alphas)
{
    const label nCells = alphas[0].size(), nMaterials = alphas.size();
    centre_.setSize(nCells);
    row_.setSize(nCells);
    mixed_ = boolList(nCells, false);
    fraction_.clear();

    DynamicList<scalarField> fractions;
    for (label celli = 0; celli < nCells; ++celli)
    {
        scalarField fraction(nMaterials);
        forAll(alphas, m)
        {
            fraction[m] = alphas[m][celli];
        }
        label& centre = centre_[celli];
        centre = 0;
        forAll(fraction, m)
        {
            // The stiffer of equal ones
            const scalar more = fraction[m] - fraction[centre];
            if
            (
                more > smallestCut
             || (more > -smallestCut && pure(m, celli).a > pure(centre, celli).a)
            )
            {
                centre = m;
            }
        }
        row_[celli] = -1;
        if (fraction[centre] < 1 - smallestCut)
        {
            row_[celli] = fractions.size();
            fractions.append(fraction);
        }
    }
    fraction_ = fractions;
    normal_.setSize(fraction_.size());
    normal_ = vectorField(nMaterials);
    distance_.setSize(fraction_.size());
    distance_ = scalarField(nMaterials);
}


Foam::DynamicList<Foam::vector> Foam::cutCells::ways
(
    const fvMesh& mesh,
    const label celli
) const
{
    DynamicList<vector> ways;
    for (const label facei : mesh.cells()[celli])
    {
        const label patchi =
            mesh.isInternalFace(facei)
          ? -1 : mesh.boundaryMesh().whichPatch(facei);
        if (patchi < 0 || !oneLayer::isPlane(mesh.boundaryMesh()[patchi]))
        {
            ways.append(mesh.faceCentres()[facei] - mesh.cellCentres()[celli]);
        }
    }
    return ways;
}


Foam::scalar Foam::cutCells::distance
(
    const scalar alpha,
    const vector& n,
    const UList<vector>& ways
)
{
    // Half the extents along n of the two sides, a >= b
    scalar sum = 0, squares = 0;
    for (const vector& way : ways)
    {
        sum += 2*mag(way & n)/ways.size();
        squares += 2*sqr(way & n)/ways.size();
    }
    const scalar difference = sqrt(max(2*squares - sqr(sum), scalar(0)));
    const scalar a = 0.5*(sum + difference);
    const scalar b = max(0.5*(sum - difference), scalar(0));

    // The section has a constant width between two ramps
    const scalar less = min(alpha, 1 - alpha);
    const scalar d =
        2*a*less < b ? sqrt(8*a*b*less) - a - b : (2*less - 1)*a;
    return alpha < 0.5 ? d : -d;
}


void Foam::cutCells::setPlanes(const label m, const volScalarField& alpha)
{
    const fvMesh& mesh = alpha.mesh();
    const volVectorField gradient(smoothGradient(alpha));

    forAll(row_, celli)
    {
        if (cut(celli))
        {
            const label i = row_[celli];
            normal_[i][m] =
                -gradient[celli]/max(mag(gradient[celli]), VSMALL);
            distance_[i][m] = distance
            (
                alpha[celli], normal_[i][m], ways(mesh, celli)
            );
        }
    }
}


void Foam::cutCells::setThickness(const fvMesh& mesh)
{
    thickness_ = scalarField(row_.size(), 1);
    forAll(row_, celli)
    {
        for (label m = 0; cut(celli) && m < materials_.size(); ++m)
        {
            if (pure(m, celli).a < pure(centre_[celli], celli).a)
            {
                thickness_[celli] -= fraction_[row_[celli]][m];
            }
        }
    }
    forAll(materials_, m)
    {
        addCarried(m, mesh);
    }
}


void Foam::cutCells::addCarried(const label m, const fvMesh& mesh)
{
    volScalarField holds(zeroField<scalar>(mesh));
    forAll(centre_, celli)
    {
        holds[celli] = centre_[celli] == m;
    }
    holds.correctBoundaryConditions();

    auto carries = [&](const label celli)
    {
        return cut(celli) && pure(m, celli).a > pure(centre_[celli], celli).a;
    };

    scalarField sum(row_.size(), Zero);
    forNeighbours
    (
        holds,
        [&](const label celli, const vector& n, const scalar held)
        {
            if (carries(celli))
            {
                sum[celli] += held*sqr(normal_[row_[celli]][m] & n);
            }
        }
    );

    // Of which the square along n is what passes
    volVectorField carried(zeroField<vector>(mesh));
    forAll(row_, celli)
    {
        if (carries(celli))
        {
            const label i = row_[celli];
            // Thinned by the softer one's pressure, as it is stretched
            const scalar ratio =
                pure(centre_[celli], celli).eta/pure(m, celli).eta;
            const scalar stretched =
                2*max(1 - ratio, scalar(0))*fraction_[i][m];
            carried[celli] =
                sqrt(stretched/max(sum[celli], scalar(0.5)))*normal_[i][m];
        }
    }
    carried.correctBoundaryConditions();

    forNeighbours
    (
        carried,
        [&](const label celli, const vector& n, const vector& c)
        {
            if (centre_[celli] == m)
            {
                thickness_[celli] += sqr(c & n);
            }
        }
    );
}


Foam::scalarField Foam::cutCells::shares
(
    const label celli,
    const vector& way
) const
{
    const label i = row_[celli];
    const scalar rounding = 1e-9*mag(way);
    scalarField s(materials_.size(), Zero);

    forAll(s, m)
    {
        if (fraction_[i][m] > 0)
        {
            const scalar d = distance_[i][m], out = way & normal_[i][m];
            if (mag(out) < rounding)
            {
                s[m] = mag(d) < rounding ? 0.5 : d > 0;
            }
            else
            {
                const scalar t = min(max(d/out, scalar(0)), scalar(1));
                s[m] = out > 0 ? t : 1 - t;
            }
        }
    }

    // Planes of three materials may leave a gap, or overlap
    const scalar total = sum(s);
    return total > ROOTVSMALL ? scalarField(s/total) : fraction_[i];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cutCells::cutCells(const PtrList<material>& materials)
:
    materials_(materials)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cutCells::update(const PtrList<volScalarField>& alphas)
{
    setCut(alphas);
    forAll(alphas, m)
    {
        setPlanes(m, alphas[m]);
    }
    setMixed(alphas[0].mesh());
    setThickness(alphas[0].mesh());
}


Foam::cutCells::layers Foam::cutCells::at(const label celli) const
{
    if (mixed_[celli])
    {
        return mixture(celli);
    }

    const scalar k = thickness_[celli];
    const layers l(pure(centre_[celli], celli));
    return {k*l.eta, k*l.a, k*l.b, k*l.es, k*l.etaC, k*l.M, -1, 1};
}


Foam::cutCells::layers Foam::cutCells::along
(
    const label celli,
    const vector& way,
    const vector& n
) const
{
    const scalarField s(shares(celli, way));
    layers sum = {0, 0, 0, 0, 0, 0, 0, 0};
    bool bends = true;

    forAll(s, m)
    {
        if (s[m] > 0)
        {
            const layers l(m == centre_[celli] ? at(celli) : pure(m, celli));
            sum.eta += s[m]/l.eta;
            sum.a += s[m]/l.a;
            sum.b += s[m]*l.b/l.a;
            sum.es += s[m]*l.es/l.a;
            sum.etaC += s[m]*l.etaC/l.a;
            bends = bends && l.M > 0;
            sum.M += bends ? s[m]/l.M : 0;
            sum.own += m == centre_[celli] ? s[m]/l.a : 0;
        }
    }

    return
    {
        1/sum.eta, 1/sum.a, sum.b/sum.a, sum.es/sum.a, sum.etaC/sum.a,
        bends ? 1/sum.M : 0,
        sqr(n & normal_[row_[celli]][centre_[celli]]),
        sum.own/sum.a
    };
}


// ************************************************************************* //
