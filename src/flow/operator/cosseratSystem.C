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

#include "cosseratSystem.H"
#include "carriedDensity.H"
#include "SVD.H"
#include "unitConversion.H"
#include "coupledPolyPatch.H"
#include "surfaceFields.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- The numbers of a 4 x 4 matrix, row by row
    static FixedList<scalar, 16> listed(const scalarRectangularMatrix& M)
    {
        FixedList<scalar, 16> list;
        forAll(list, i)
        {
            list[i] = M(i/4, i % 4);
        }
        return list;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cosseratSystem::setGeometry()
{
    const surfaceVectorField& Sf = mesh_.Sf();
    const surfaceScalarField& magSf = mesh_.magSf();
    const surfaceScalarField& dc = mesh_.nonOrthDeltaCoeffs();
    const surfaceScalarField& w = mesh_.weights();
    const surfaceVectorField delta(mesh_.delta());
    const volVectorField& C = mesh_.C();

    const label i0 = frame_.i0(), i1 = frame_.i1();

    own_.setSize(nFaces_);
    nei_.setSize(nFaces_);
    for
    (
        scalarField* field :
        {&n0_, &n1_, &S_, &dc_, &w_, &m0_, &m1_, &k0_, &k1_, &s0_, &s1_}
    )
    {
        field->setSize(nFaces_);
    }

    // Squares
    scalar largestAngle = 0, largestSkewness = 0;

    auto setFace = [&]
    (
        const label f,
        const vector& S,
        const scalar magS,
        const scalar dcf,
        const scalar wf,
        const vector& d,
        const vector& s
    )
    {
        n0_[f] = S[i0]/magS;
        n1_[f] = S[i1]/magS;
        S_[f] = magS;
        dc_[f] = dcf;
        w_[f] = wf;
        m0_[f] = dcf*d[i0];
        m1_[f] = dcf*d[i1];
        k0_[f] = n0_[f] - m0_[f];
        k1_[f] = n1_[f] - m1_[f];
        s0_[f] = s[i0];
        s1_[f] = s[i1];
        largestAngle = max(largestAngle, sqr(k0_[f]) + sqr(k1_[f]));
        largestSkewness =
            max(largestSkewness, (sqr(s0_[f]) + sqr(s1_[f]))*sqr(dcf));
    };

    for (label f = 0; f < nInternal_; ++f)
    {
        own_[f] = mesh_.owner()[f];
        nei_[f] = mesh_.neighbour()[f];
        setFace
        (
            f, Sf[f], magSf[f], dc[f], w[f], delta[f],
            mesh_.Cf()[f] - C[own_[f]] - (1 - w[f])*delta[f]
        );
    }

    DynamicList<labelPair> ranges;
    DynamicList<label> oneSided;
    ranges.append(labelPair(0, nInternal_));

    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const label start = nInternal_ + halo_.start(patchi) - nCells_;

        forAll(patch, i)
        {
            const label f = start + i;
            const vector& S = Sf.boundaryField()[patchi][i];
            const vector out
            (
                mesh_.Cf().boundaryField()[patchi][i] - C[patch.faceCells()[i]]
            );
            const scalar magS = magSf.boundaryField()[patchi][i];

            own_[f] = patch.faceCells()[i];
            nei_[f] = halo_.start(patchi) + i;

            if (patch.coupled())
            {
                const scalar wf = w.boundaryField()[patchi][i];
                const vector& d = delta.boundaryField()[patchi][i];
                setFace
                (
                    f, S, magS, dc.boundaryField()[patchi][i], wf, d,
                    out - (1 - wf)*d
                );
            }
            else
            {
                setFace
                (
                    f, S, magS, magS/(S & out), 1, out, vector(Zero)
                );
                oneSided.append(f);
            }
        }

        if (patch.coupled() && patch.size())
        {
            ranges.append(labelPair(start, start + patch.size()));
        }
    }

    twoSided_ = ranges;
    oneSided_ = oneSided;
    oneSidedFace_.setSize(nFaces_ - nInternal_, false);
    for (const label f : oneSided_)
    {
        oneSidedFace_[f - nInternal_] = true;
    }
    lambda_ = 1 - w_;

    skewed_ = returnReduce(largestSkewness, maxOp<scalar>()) > 1e-10;
    nonOrthogonal_ =
        skewed_ || returnReduce(largestAngle, maxOp<scalar>()) > 1e-10;

    adjoint_ = returnReduce(largestSkewness, maxOp<scalar>()) > sqr(0.1);

    if (skewed_)
    {
        setExactness();
    }
}


void Foam::cosseratSystem::setExactness()
{
    const label i0 = frame_.i0(), i1 = frame_.i1();

    // The sums of calcGradient() for the coordinates themselves
    for (scalarField* X : {&X00_, &X01_, &X10_, &X11_})
    {
        X->setSize(nCells_);
        *X = 0;
    }

    auto add = [&]
    (
        const label celli, const scalar S, const label f, const vector& d
    )
    {
        const scalar s0 = S*n0_[f], s1 = S*n1_[f];
        X00_[celli] += s0*d[i0];
        X01_[celli] += s0*d[i1];
        X10_[celli] += s1*d[i0];
        X11_[celli] += s1*d[i1];
    };

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const vector d(frame_.inSpace(m0_[f], m1_[f])/dc_[f]);
            add(own_[f], S_[f], f, (1 - w_[f])*d);
            if (nei_[f] < nCells_)
            {
                add(nei_[f], -S_[f], f, -w_[f]*d);
            }
        }
    }
    for (const label f : oneSided_)
    {
        add(own_[f], S_[f], f, frame_.inSpace(m0_[f], m1_[f])/dc_[f]);
    }

    for (label celli = 0; celli < nCells_; ++celli)
    {
        const scalar a = X00_[celli], b = X01_[celli];
        const scalar c = X10_[celli], d = X11_[celli];
        const scalar det = (a*d - b*c)/V_[celli];
        X00_[celli] = d/det;
        X01_[celli] = -b/det;
        X10_[celli] = -c/det;
        X11_[celli] = a/det;
    }
}


void Foam::cosseratSystem::setReconstruction()
{
    for (scalarField* T : {&T00_, &T01_, &T10_, &T11_})
    {
        T->setSize(nCells_);
        *T = 0;
    }

    auto add = [&](const label celli, const label f, const scalar share)
    {
        const scalar s = share*S_[f]/dc_[f];
        T00_[celli] += s*n0_[f]*m0_[f];
        T01_[celli] += s*n0_[f]*m1_[f];
        T10_[celli] += s*n1_[f]*m0_[f];
        T11_[celli] += s*n1_[f]*m1_[f];
    };

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            add(own_[f], f, 1 - w_[f]);
            if (nei_[f] < nCells_)
            {
                add(nei_[f], f, w_[f]);
            }
        }
    }
    for (const label f : oneSided_)
    {
        if (boundary_.pressureFixed(f - nInternal_))
        {
            add(own_[f], f, 1);
        }
    }

    // Inverse, or the pseudo-inverse for a cell with a single face that counts
    for (label celli = 0; celli < nCells_; ++celli)
    {
        const scalar a = T00_[celli], b = T01_[celli];
        const scalar c = T10_[celli], d = T11_[celli];
        const scalar norm = a*a + b*b + c*c + d*d;
        const scalar det = a*d - b*c;

        if (mag(det) > 1e-6*norm)
        {
            T00_[celli] = d/det;
            T01_[celli] = -b/det;
            T10_[celli] = -c/det;
            T11_[celli] = a/det;
        }
        else if (norm > 0)
        {
            T00_[celli] = a/norm;
            T01_[celli] = c/norm;
            T10_[celli] = b/norm;
            T11_[celli] = d/norm;
        }
    }
}


void Foam::cosseratSystem::setMaterials
(
    const scalarField& eta,
    const scalarField& etaC,
    const scalarField& M
)
{
    SubList<scalar>(eta_, nCells_) = eta;
    SubList<scalar>(etaC_, nCells_) = etaC;
    SubList<scalar>(M_, nCells_) = M;
    halo_.swap("sss", {&eta_, &etaC_, &M_});

    // Slots of walls are not read; they must not divide by zero either
    for (const label f : oneSided_)
    {
        eta_[nei_[f]] = eta_[own_[f]];
        etaC_[nei_[f]] = etaC_[own_[f]];
        M_[nei_[f]] = M_[own_[f]];
    }

    es_ = min(etaC_, eta_);
    a_ = eta_ + es_;
    b_ = eta_ - es_;

    setFaceCoefficients();
    setRAU();
}


void Foam::cosseratSystem::setRAU()
{
    scalarField diag[2], face;
    velocityBlock(0, diag[0], face);
    velocityBlock(1, diag[1], face);

    scalarField rAU(halo_.size());
    SubList<scalar>(rAU, nCells_) = V_/(0.5*diag[0] + 0.5*diag[1]);
    halo_.swap("s", {&rAU});

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label P = own_[f], N = nei_[f];
            rAUf_[f] =
                (w_[f]*rAU[P] + (1 - w_[f])*rAU[N])
               *4*eta_[P]*eta_[N]/sqr(eta_[P] + eta_[N]);
        }
    }
    for (const label f : oneSided_)
    {
        rAUf_[f] = rAU[own_[f]];
    }
}


void Foam::cosseratSystem::setCorners
(
    const scalarField& eta,
    const scalarField& etaC,
    const scalarField& M
)
{
    corners_.setMaterials(eta, etaC, M, materials_.invB().primitiveField());

    scalarField etaAround(eta), etaCAround(etaC), MAround(M);
    while (corners_.takeJobs(etaAround, etaCAround, MAround))
    {
        setMaterials(etaAround, etaCAround, MAround);
        corners_.doJobs
        (
            [this](const scalarField& x, scalarField& r)
            {
                plainResidual(x, r);
            }
        );
    }
}


void Foam::cosseratSystem::checkCouples() const
{
    for (const label f : oneSided_)
    {
        const scalar couple = boundary_.couple(f - nInternal_);
        if (couple != 0 && M_[own_[f]] <= 0)
        {
            FatalErrorInFunction
                << "A coupleTraction of " << couple << " Pa m acts on the wall"
                << " of cell " << own_[f] << " at " << mesh_.C()[own_[f]]
                << ", whose bending viscosity M is 0" << nl
                << "    Allowed: coupleTraction 0 or zeroGradient, or a"
                << " material with etaC and R above zero there"
                << exit(FatalError);
        }
    }
}


void Foam::cosseratSystem::setFaceCoefficients()
{
    for (scalarField* field : {&Kn_, &Kt_, &Kq_})
    {
        field->setSize(nFaces_);
    }
    if (cosserat_)
    {
        for (scalarField* field : {&KwP_, &KwN_, &KsP_, &KsN_, &Km_})
        {
            field->setSize(nFaces_);
        }
    }
    if (compressible_)
    {
        Kb_.setSize(nFaces_);
    }

    DynamicList<label> jump;
    DynamicList<scalar> jumpW, jumpC;
    wStiff_ = w_;
    wSoft_ = w_;

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label P = own_[f], N = nei_[f];
            const scalar lP = lambda_[f], lN = 1 - lP;
            const scalar a = 1/(lP/a_[P] + lN/a_[N]);
            const scalar eta = 1/(lP/eta_[P] + lN/eta_[N]);

            Kn_[f] = 2*eta*dc_[f]*S_[f];
            Kt_[f] = a*dc_[f]*S_[f];
            Kq_[f] = a*S_[f]*(lP*b_[P]/a_[P] + lN*b_[N]/a_[N]);

            if (cosserat_)
            {
                KwP_[f] = a*S_[f]*lP*2*es_[P]/a_[P];
                KwN_[f] = a*S_[f]*lN*2*es_[N]/a_[N];
                KsP_[f] = a*S_[f]*lP*relativeCoefficient(P, f)/a_[P];
                KsN_[f] = a*S_[f]*lN*relativeCoefficient(N, f)/a_[N];

                Km_[f] = 0;
                if (M_[P] > 0 && M_[N] > 0)
                {
                    const scalar M = 1/(lP/M_[P] + lN/M_[N]);
                    const scalar es = 1/(lP/es_[P] + lN/es_[N]);
                    const scalar kappa = es*(2*es + eta)/(3*(eta + es));
                    Km_[f] = dc_[f]*S_[f]*M/(1 + kappa/(M*sqr(dc_[f])));
                }
            }
            if (compressible_)
            {
                Kb_[f] = eta*S_[f];
            }

            if
            (
                mag(a_[P] - a_[N]) > 1e-12*a_[P]
             || mag(b_[P] - b_[N]) > 1e-12*a_[P]
            )
            {
                const scalar kP = a_[P]/lP, kN = a_[N]/lN;
                const scalar wP = w_[f], wN = 1 - wP;
                jump.append(f);
                jumpW.append(kP/(kP + kN));
                wStiff_[f] = wP*eta_[P]/(wP*eta_[P] + wN*eta_[N]);
                wSoft_[f] = wP*eta_[N]/(wP*eta_[N] + wN*eta_[P]);
                jumpC.append(1/(dc_[f]*(kP + kN)));
            }
        }
    }

    for (const label f : oneSided_)
    {
        const label P = own_[f];
        Kn_[f] = 2*eta_[P]*dc_[f]*S_[f];
        Kt_[f] = a_[P]*dc_[f]*S_[f];
        Kq_[f] = b_[P]*S_[f];
        if (cosserat_)
        {
            KwN_[f] = 2*es_[P]*S_[f]*wallShare(f);
            KwP_[f] = 2*es_[P]*S_[f] - KwN_[f];
            KsP_[f] = relativeCoefficient(P, f)*S_[f];
            KsN_[f] = 0;
            Km_[f] = M_[P]*dc_[f]*S_[f];
        }
        if (compressible_)
        {
            Kb_[f] = eta_[P]*S_[f];
        }
    }

    r0_ = s0_ + (w_ - wStiff_)/dc_*k0_;
    r1_ = s1_ + (w_ - wStiff_)/dc_*k1_;
    jump_ = jump;
    jumpW_ = jumpW;
    jumpC_ = jumpC;
    anyJump_ = returnReduce(jump_.size() > 0, orOp<bool>());

    setJumpCells();
}


void Foam::cosseratSystem::setJumpCells()
{
    // Row of a cell in the list, by cell
    labelList row(nCells_, -1);
    DynamicList<label> cells;
    DynamicList<scalarSquareMatrix> systems;

    forAll(jump_, i)
    {
        const label f = jump_[i];
        const label P = own_[f], N = nei_[f];
        const scalar n[] = {n0_[f], n1_[f]}, t[] = {n1_[f], -n0_[f]};

        for (const label celli : {P, N})
        {
            if (celli >= nCells_)
            {
                continue;
            }
            if (row[celli] < 0)
            {
                row[celli] = cells.size();
                cells.append(celli);
                systems.append(scalarSquareMatrix(4, Identity<scalar>()));
            }
            scalarSquareMatrix& A = systems[row[celli]];
            scalar s[2];
            gradientVector(celli, f, s[0], s[1]);

            // G_ij += s_i v_j, v = n vn + t vt: u_n,t = t_k G_kl n_l of two
            // layers in vt, and in both the way k to the normal
            const scalar q = jumpC_[i]*(b_[N] - b_[P]);
            const scalar kn = (w_[f] - wStiff_[f])/dc_[f];
            const scalar kt = (w_[f] - jumpW_[i])/dc_[f];
            const scalar k[] = {k0_[f], k1_[f]};
            for (label ij = 0; ij < 4; ++ij)
            {
                const label m = ij % 2;
                for (label kl = 0; kl < 4; ++kl)
                {
                    const label l = kl % 2;
                    A(ij, kl) -= s[ij/2]*
                    (
                        t[m]*q*t[kl/2]*n[l]
                      + k[kl/2]*(kn*n[m]*n[l] + kt*t[m]*t[l])
                    );
                }
            }
        }
    }

    jumpCells_ = cells;
    jumpInverse_.setSize(cells.size());
    forAll(systems, i)
    {
        jumpInverse_[i] = listed(SVDinv(systems[i]));
        systems[i] = scalarSquareMatrix(4, Identity<scalar>()) - systems[i];
    }
    setJumpWalls(systems);
}


void Foam::cosseratSystem::setJumpWalls
(
    const UList<scalarSquareMatrix>& jumps
)
{
    // The correction at walls, G -> W G + ..., face by face
    Map<scalarSquareMatrix> walls;
    labelHashSet beside(jumpCells_);
    for (const label f : oneSided_)
    {
        const label P = own_[f];
        if (!beside.found(P))
        {
            continue;
        }
        walls.insert(P, scalarSquareMatrix(4, Identity<scalar>()));

        const scalar n[] = {n0_[f], n1_[f]};
        const scalar m[] = {n0_[f] - k0_[f], n1_[f] - k1_[f]};
        scalarSquareMatrix W(4, Identity<scalar>());
        for (label ij = 0; ij < 4; ++ij)
        {
            for (label l = 0; l < 2; ++l)
            {
                W(ij, 2*l + ij % 2) -= n[ij/2]*m[l]/3;
            }
        }
        scalarSquareMatrix& product = walls[P];
        product = scalarSquareMatrix(W*product);
    }

    // G = W (g + K G) + ..., of (1 - K)^-1 g before and its W after
    jumpWalls_.setSize(walls.size());
    label n = 0;
    forAll(jumpCells_, i)
    {
        if (walls.found(jumpCells_[i]))
        {
            const scalarSquareMatrix WK(walls[jumpCells_[i]]*jumps[i]);
            const scalarSquareMatrix after
            (
                SVDinv(scalarSquareMatrix(4, Identity<scalar>()) - WK)
            );
            jumpWalls_[n].celli = jumpCells_[i];
            jumpWalls_[n].after = listed(after);
            jumpWalls_[n].before = listed(after*WK);
            ++n;
        }
    }
}


Foam::vector Foam::cosseratSystem::gravity() const
{
    return
        materials_.parts().has(sceneParts::GRAVITY)
      ? mesh_.time().lookupObject<uniformDimensionedVectorField>("g").value()
      : vector(Zero);
}


Foam::tmp<Foam::vectorField> Foam::cosseratSystem::bodyForce() const
{
    tmp<vectorField> tforce(rho_*gravity());
    if (load_.force())
    {
        tforce.ref() += load_.force()->primitiveField();
    }
    return tforce;
}


void Foam::cosseratSystem::setLoad()
{
    if (load_.force())
    {
        const vectorField& force = load_.force()->primitiveField();
        const label i0 = frame_.i0(), i1 = frame_.i1();
        scalarField b0(halo_.size()), b1(halo_.size());

        SubList<scalar>(b0, nCells_) = force.component(i0)();
        SubList<scalar>(b1, nCells_) = force.component(i1)();
        halo_.swap("v", {&b0, &b1});

        for (const labelPair& range : twoSided_)
        {
            for (label f = range.first(); f < range.second(); ++f)
            {
                const label P = own_[f], N = nei_[f];
                const scalar wP = w_[f], wN = 1 - wP;
                gravity_[f] +=
                    m0_[f]*(wP*b0[P] + wN*b0[N])
                  + m1_[f]*(wP*b1[P] + wN*b1[N]);
            }
        }
        for (const label f : oneSided_)
        {
            gravity_[f] += m0_[f]*b0[own_[f]] + m1_[f]*b1[own_[f]];
        }
    }

    if (load_.couple())
    {
        const scalarField& couple = load_.couple()->primitiveField();
        forAll(couple, celli)
        {
            if (couple[celli] != 0 && (!cosserat_ || M_[celli] <= 0))
            {
                FatalErrorInFunction
                    << "A bodyCouple of " << couple[celli] << " Pa acts on"
                    << " cell " << celli << " at " << mesh_.C()[celli]
                    << ", whose bending viscosity M is 0" << nl
                    << "    Allowed: bodyCouple 0, or a material with etaC"
                    << " and R above zero there" << exit(FatalError);
            }
        }
    }
}


void Foam::cosseratSystem::setGravity()
{
    gravity_.setSize(nFaces_);
    gravity_ = 0;

    const vector gCyclic(periodicGravity());
    gradientGravity_ = gravity() - gCyclic;
    setHeights(gCyclic);

    if (!materials_.parts().has(sceneParts::GRAVITY))
    {
        return;
    }

    const vector& gRest = gradientGravity_;
    const point& middle = height_.middle();

    scalarField rhoExt(halo_.size());
    SubList<scalar>(rhoExt, nCells_) = rho_;
    halo_.swap("s", {&rhoExt});

    const label i0 = frame_.i0(), i1 = frame_.i1();

    auto setFace = [&](const label f, const vector& Cf)
    {
        const label P = own_[f], N = nei_[f];
        gravity_[f] =
            (w_[f]*rhoExt[P] + (1 - w_[f])*rhoExt[N])
           *(gCyclic[i0]*m0_[f] + gCyclic[i1]*m1_[f])
          - (gRest & (Cf - middle))*dc_[f]*(rhoExt[N] - rhoExt[P]);
    };

    const surfaceVectorField& Cf = mesh_.Cf();
    for (label f = 0; f < nInternal_; ++f)
    {
        setFace(f, Cf[f]);
    }
    for (const label patchi : halo_.coupledPatches())
    {
        const label start = nInternal_ + halo_.start(patchi) - nCells_;
        forAll(Cf.boundaryField()[patchi], i)
        {
            setFace(start + i, Cf.boundaryField()[patchi][i]);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cosseratSystem::cosseratSystem
(
    const fvMesh& mesh,
    const planarFrame& frame,
    const haloExchange& halo,
    const flowBoundary& boundary,
    const materialFields& materials,
    const bool wantCorners
)
:
    mesh_(mesh),
    frame_(frame),
    halo_(halo),
    boundary_(boundary),
    materials_(materials),
    load_(mesh),
    height_(mesh),
    stabilisation_(mesh, frame, halo),
    corners_(mesh, frame, halo, boundary, wantCorners),
    cosserat_(materials.parts().has(sceneParts::MICROROTATION)),
    compressible_(materials.parts().has(sceneParts::COMPRESSIBILITY)),
    pressureFloats_(false),
    nonOrthogonal_(false),
    skewed_(false),
    adjoint_(false),
    nCells_(mesh.nCells()),
    nInternal_(mesh.nInternalFaces()),
    nFaces_(nInternal_ + halo.size() - nCells_),
    V_(mesh.V()),
    anyJump_(false),
    gradientGravity_(Zero),
    rhoGh_(nCells_, Zero)
{
    setGeometry();
    setReconstruction();

    for
    (
        scalarField* field :
        {&eta_, &etaC_, &M_, &u0_, &u1_, &p_, &omega_,
         &G00_, &G01_, &G10_, &G11_, &f0_, &f1_}
    )
    {
        field->setSize(halo_.size());
        *field = 0;
    }

    if (cosserat_ && nonOrthogonal_)
    {
        for (scalarField* field : {&g0_, &g1_})
        {
            field->setSize(halo_.size());
            *field = 0;
        }
    }

    for (scalarField* field : {&ff_, &phi_, &rAUf_, &gravity_})
    {
        field->setSize(nFaces_);
        *field = 0;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cosseratSystem::update()
{
    const scalarField& eta = materials_.eta().primitiveField();
    const scalarField& M = materials_.M().primitiveField();
    scalarField etaC(materials_.etaC().primitiveField());

    // Without bending viscosity the moment balance is s = 0: no effect of etaC
    forAll(etaC, celli)
    {
        if (M[celli] <= 0)
        {
            etaC[celli] = 0;
        }
    }

    // A compressible material may be nowhere
    pressureFloats_ =
        boundary_.closed() && !(compressible_ && compliance() > 0);

    stabilisation_.update(materials_.rho(), gravity());
    rho_ =
        materials_.layered() && gravity() != vector(Zero)
      ? carriedDensity(materials_, gravity()).density()
      : tmp<scalarField>(new scalarField(materials_.rho().primitiveField()));

    if (corners_.active())
    {
        setCorners(eta, etaC, M);
    }
    setMaterials(eta, etaC, M);
    checkCouples();
    setGravity();
    setLoad();
}


void Foam::cosseratSystem::velocityBlock
(
    const label cmpt,
    scalarField& diag,
    scalarField& face
) const
{
    diag = scalarField(nCells_, Zero);
    face.setSize(nFaces_);

    const scalarField& n = cmpt ? n1_ : n0_;

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const scalar nn = sqr(n[f]);
            face[f] = Kn_[f]*nn + Kt_[f]*(1 - nn);
            diag[own_[f]] += face[f];
            if (nei_[f] < nCells_)
            {
                diag[nei_[f]] += face[f];
            }
        }
    }

    for (const label f : oneSided_)
    {
        const flowBoundary::velocityKind kind =
            boundary_.velocity(f - nInternal_);
        const scalar nn = sqr(n[f]);

        face[f] = 0;
        if (kind != flowBoundary::OPEN)
        {
            diag[own_[f]] += Kn_[f]*nn;
        }
        if (kind == flowBoundary::VELOCITY)
        {
            diag[own_[f]] += Kt_[f]*(1 - nn);
        }
    }

    if (stabilisation_.active())
    {
        for (label celli = 0; celli < nCells_; ++celli)
        {
            diag[celli] += V_[celli]*stabilisation_.diagonal(celli, cmpt);
        }
    }
}


void Foam::cosseratSystem::rotationBlock
(
    scalarField& diag,
    scalarField& face
) const
{
    diag = 4*V_*scalarField(SubList<scalar>(etaC_, nCells_));
    face.setSize(nFaces_);

    for (label celli = 0; celli < nCells_; ++celli)
    {
        if (rotationUndetermined(celli))
        {
            diag[celli] = V_[celli]*eta_[celli];
        }
    }

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            face[f] = Km_[f];
            diag[own_[f]] += face[f];
            if (nei_[f] < nCells_)
            {
                diag[nei_[f]] += face[f];
            }
        }
    }

    for (const label f : oneSided_)
    {
        face[f] = 0;
        if (boundary_.rotationFixed(f - nInternal_))
        {
            diag[own_[f]] += Km_[f];
        }
    }
}


Foam::scalar Foam::cosseratSystem::largestCoupling() const
{
    scalar largest = 0;
    for (label celli = 0; celli < nCells_; ++celli)
    {
        largest = max(largest, etaC_[celli]/eta_[celli]);
    }
    return returnReduce(largest, maxOp<scalar>());
}


Foam::scalar Foam::cosseratSystem::largestJump() const
{
    scalar largest = 1;
    for (const label f : jump_)
    {
        const scalar ratio = eta_[own_[f]]/eta_[nei_[f]];
        largest = max(largest, max(ratio, 1/ratio));
    }
    return returnReduce(largest, maxOp<scalar>());
}


Foam::scalar Foam::cosseratSystem::largestAspect() const
{
    scalarField smallest(nCells_, GREAT), most(nCells_, Zero);
    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            for (const label celli : {own_[f], nei_[f]})
            {
                if (celli < nCells_)
                {
                    smallest[celli] = min(smallest[celli], dc_[f]);
                    most[celli] = max(most[celli], dc_[f]);
                }
            }
        }
    }
    return gMax(scalarField(most/smallest));
}


Foam::scalar Foam::cosseratSystem::largestAngle() const
{
    scalar tangent = 0;
    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            tangent = max(tangent, Foam::hypot(k0_[f], k1_[f]));
        }
    }
    return radToDeg(atan(returnReduce(tangent, maxOp<scalar>())));
}


Foam::tmp<Foam::scalarField> Foam::cosseratSystem::pressureViscosity() const
{
    return 1/
    (
        1/scalarField(SubList<scalar>(eta_, nCells_))
      + materials_.invB().primitiveField()
    );
}


// ************************************************************************* //
