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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cosseratSystem::unpack
(
    const scalarField& x,
    const bool driven
) const
{
    const label n = nCells_;
    SubList<scalar>(u0_, n) = SubList<scalar>(x, n, 0);
    SubList<scalar>(u1_, n) = SubList<scalar>(x, n, n);
    SubList<scalar>(p_, n) = SubList<scalar>(x, n, 2*n);

    if (cosserat_)
    {
        SubList<scalar>(omega_, n) = SubList<scalar>(x, n, 3*n);
        halo_.swap("vss", {&u0_, &u1_, &p_, &omega_});
    }
    else
    {
        halo_.swap("vs", {&u0_, &u1_, &p_});
    }

    setBoundaryValues(driven);
}


void Foam::cosseratSystem::setBoundaryValues(const bool driven) const
{
    for (const label f : oneSided_)
    {
        const label i = f - nInternal_;
        const label P = own_[f], b = nei_[f];

        if (cosserat_)
        {
            omega_[b] = driven ? boundary_.rotation(i) : 0;

            if (!boundary_.rotationFixed(i))
            {
                omega_[b] = omega_[P];
                if (driven && M_[P] > 0)
                {
                    omega_[b] += boundary_.couple(i)/(M_[P]*dc_[f]);
                }
            }
        }

        switch (boundary_.velocity(i))
        {
            case flowBoundary::VELOCITY:
            {
                u0_[b] = driven ? boundary_.u0(i) : 0;
                u1_[b] = driven ? boundary_.u1(i) : 0;
                break;
            }
            case flowBoundary::TRACTION:
            {
                // Tangential gradient such that the wall bears the traction,
                // with u_n,t = -curvature u_t. The mean of omega on the way
                // makes it the mean gradient, so u_b is of second order
                const scalar t0 = n1_[f], t1 = -n0_[f];
                const scalar traction = driven ? boundary_.traction(i) : 0;
                const scalar mean =
                    omega_[P] + wallShare(f)*(omega_[b] - omega_[P]);
                const scalar slope =
                    (traction - 2*etaC_[P]*mean)/(eta_[P] + etaC_[P]);
                const scalar ut = wallGain(f)*
                    (u0_[P]*t0 + u1_[P]*t1 + slope/dc_[f]);

                u0_[b] = ut*t0;
                u1_[b] = ut*t1;
                break;
            }
            case flowBoundary::OPEN:
            {
                u0_[b] = u0_[P];
                u1_[b] = u1_[P];
                break;
            }
        }
    }
}


void Foam::cosseratSystem::calcGradient() const
{
    for (scalarField* G : {&G00_, &G01_, &G10_, &G11_})
    {
        *G = 0;
    }

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label P = own_[f], N = nei_[f];
            const scalar s0 = S_[f]*n0_[f], s1 = S_[f]*n1_[f];
            const scalar v0 = w_[f]*u0_[P] + (1 - w_[f])*u0_[N];
            const scalar v1 = w_[f]*u1_[P] + (1 - w_[f])*u1_[N];

            // What a slot gets here is overwritten by swap()
            addToGradient(P, s0, s1, v0, v1);
            addToGradient(N, -s0, -s1, v0, v1);
        }
    }

    for (const label f : oneSided_)
    {
        const label b = nei_[f];
        addToGradient(own_[f], S_[f]*n0_[f], S_[f]*n1_[f], u0_[b], u1_[b]);
    }

    normaliseGradient(G00_, G10_);
    normaliseGradient(G01_, G11_);
}


void Foam::cosseratSystem::normaliseGradient
(
    scalarField& G0,
    scalarField& G1
) const
{
    if (!skewed_)
    {
        for (label celli = 0; celli < nCells_; ++celli)
        {
            G0[celli] /= V_[celli];
            G1[celli] /= V_[celli];
        }
        return;
    }

    for (label celli = 0; celli < nCells_; ++celli)
    {
        const scalar a = G0[celli]/V_[celli], b = G1[celli]/V_[celli];
        G0[celli] = X00_[celli]*a + X01_[celli]*b;
        G1[celli] = X10_[celli]*a + X11_[celli]*b;
    }
}


void Foam::cosseratSystem::calcRotationGradient() const
{
    g0_ = 0;
    g1_ = 0;

    auto add = [&]
    (
        const label celli, const scalar S, const label f, const scalar v
    )
    {
        // Differences, so that the faces left out do not matter
        g0_[celli] += S*n0_[f]*(v - omega_[celli]);
        g1_[celli] += S*n1_[f]*(v - omega_[celli]);
    };

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            // No couple passes where M is zero on one side, nor has omega a
            // meaning there
            if (Km_[f] > 0)
            {
                const label P = own_[f], N = nei_[f];
                const scalar v = w_[f]*omega_[P] + (1 - w_[f])*omega_[N];
                add(P, S_[f], f, v);
                add(N, -S_[f], f, v);
            }
        }
    }
    for (const label f : oneSided_)
    {
        add(own_[f], S_[f], f, omega_[nei_[f]]);
    }

    normaliseGradient(g0_, g1_);
    halo_.swap("v", {&g0_, &g1_});
}


void Foam::cosseratSystem::correctWalls() const
{
    for (const label f : oneSided_)
    {
        const label i = f - nInternal_;
        const label P = own_[f], b = nei_[f];
        const scalar n0 = n0_[f], n1 = n1_[f], d = 1/dc_[f];

        if (cosserat_ && !rotationUndetermined(P))
        {
            // d^2 omega,nn by the moment balance
            const scalar curvature = 4*relativeRotation(P)*resolution(P, f);

            scalar change = 0;
            if (!boundary_.rotationFixed(i))
            {
                change = -0.5*curvature;
                if (nonOrthogonal_)
                {
                    change -= d*(k0_[f]*g0_[P] + k1_[f]*g1_[P]);
                }
                omega_[b] += change;
            }
            if (boundary_.velocity(i) == flowBoundary::TRACTION)
            {
                addWallSpeed
                (
                    f,
                    d*etaC_[P]*(curvature/6 - change)/(eta_[P] + etaC_[P])
                );
            }
        }

        // From the foot of the normal through the centre to the face centre
        if
        (
            nonOrthogonal_
         && boundary_.velocity(i) == flowBoundary::TRACTION
        )
        {
            addWallSpeed
            (
                f,
              - d*(k0_[f]*(G00_[P]*n1 - G01_[P]*n0)
                 + k1_[f]*(G10_[P]*n1 - G11_[P]*n0))
            );
        }

        // The Gauss gradient has the slopes of quarter and inner face by
        // halves; two thirds and one third are right at the centre
        scalar c0 = (u0_[b] - u0_[P])/d - n0*G00_[P] - n1*G10_[P];
        scalar c1 = (u1_[b] - u1_[P])/d - n0*G01_[P] - n1*G11_[P];
        if (nonOrthogonal_)
        {
            c0 += k0_[f]*G00_[P] + k1_[f]*G10_[P];
            c1 += k0_[f]*G01_[P] + k1_[f]*G11_[P];
        }
        addToGradient(P, n0, n1, c0/3, c1/3);
    }
}


void Foam::cosseratSystem::weightGradient() const
{
    // Faces first, without what the gradient of the cell itself adds
    forAll(jump_, i)
    {
        const label f = jump_[i];
        const label P = own_[f], N = nei_[f];
        const scalar d0 = u0_[N] - u0_[P], d1 = u1_[N] - u1_[P];
        const scalar vn =
            (w_[f] - wStiff_[f])*(d0*n0_[f] + d1*n1_[f]);
        scalar vt = (w_[f] - jumpW_[i])*(d0*n1_[f] - d1*n0_[f]);
        if (cosserat_)
        {
            vt += jumpC_[i]*2*(es_[N]*omega_[N] - es_[P]*omega_[P]);
        }

        for (const label celli : {P, N})
        {
            if (celli < nCells_)
            {
                scalar s0, s1;
                gradientVector(celli, f, s0, s1);
                addToGradient
                (
                    celli, s0, s1,
                    vn*n0_[f] + vt*n1_[f], vn*n1_[f] - vt*n0_[f]
                );
            }
        }
    }

    // Then that
    forAll(jumpCells_, i)
    {
        transformGradient(jumpCells_[i], jumpInverse_[i]);
    }
}


void Foam::cosseratSystem::weightWallGradient
(
    const List<FixedList<scalar, 4>>& before
) const
{
    forAll(jumpWalls_, i)
    {
        const jumpWall& wall = jumpWalls_[i];
        const FixedList<scalar, 4>& g = before[i];
        transformGradient(wall.celli, wall.after);
        for (label j = 0; j < 4; ++j)
        {
            scalar sum = 0;
            for (label l = 0; l < 4; ++l)
            {
                sum += wall.before[4*j + l]*g[l];
            }
            gradient(j)[wall.celli] -= sum;
        }
    }
}


void Foam::cosseratSystem::addStabilisation() const
{
    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label P = own_[f], N = nei_[f];
            ff_[f] += stabilisation_.along(m0_[f], m1_[f])*
            (
                w_[f]*stabilisation_.change(P, u0_[P], u1_[P])
              + (1 - w_[f])*stabilisation_.change(N, u0_[N], u1_[N])
            );
        }
    }
}


void Foam::cosseratSystem::calcForce
(
    const bool driven,
    const bool moving
) const
{
    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            ff_[f] = -dc_[f]*(p_[nei_[f]] - p_[own_[f]]);
        }
        if (driven)
        {
            for (label f = range.first(); f < range.second(); ++f)
            {
                ff_[f] += gravity_[f];
            }
        }
    }
    if (driven)
    {
        forAll(boundary_.jump(), i)
        {
            ff_[nInternal_ + i] += dc_[nInternal_ + i]*boundary_.jump()[i];
        }
    }

    for (const label f : oneSided_)
    {
        const label i = f - nInternal_;
        ff_[f] = 0;
        if (boundary_.pressureFixed(i))
        {
            const scalar pb = driven ? givenPressure(i) : 0;
            ff_[f] = -dc_[f]*(pb - p_[own_[f]]) + driven*gravity_[f];
        }
    }

    if (moving && stabilisation_.active())
    {
        addStabilisation();
    }

    reconstruct();
}


void Foam::cosseratSystem::reconstruct() const
{
    f0_ = 0;
    f1_ = 0;

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label P = own_[f], N = nei_[f];
            const scalar s = S_[f]*ff_[f]/dc_[f];
            const scalar sP = s*(1 - w_[f]), sN = s*w_[f];
            f0_[P] += sP*n0_[f];
            f1_[P] += sP*n1_[f];
            f0_[N] += sN*n0_[f];
            f1_[N] += sN*n1_[f];
        }
    }

    for (const label f : oneSided_)
    {
        const scalar s = S_[f]*ff_[f]/dc_[f];
        f0_[own_[f]] += s*n0_[f];
        f1_[own_[f]] += s*n1_[f];
    }

    for (label celli = 0; celli < nCells_; ++celli)
    {
        const scalar s0 = f0_[celli], s1 = f1_[celli];
        f0_[celli] = T00_[celli]*s0 + T01_[celli]*s1;
        f1_[celli] = T10_[celli]*s0 + T11_[celli]*s1;
    }

    if (anyJump_)
    {
        weightForce();
    }
}


void Foam::cosseratSystem::weightForce() const
{
    forAll(jump_, i)
    {
        const label f = jump_[i];
        const label P = own_[f], N = nei_[f];
        const scalar change = (wSoft_[f] - w_[f])*ff_[f]/dc_[f];

        for (const label celli : {P, N})
        {
            if (celli < nCells_)
            {
                scalar s0, s1;
                gradientVector(celli, f, s0, s1);
                f0_[celli] -= change*s0;
                f1_[celli] -= change*s1;
            }
        }
    }
}


void Foam::cosseratSystem::addAdjointForce(scalarField& r) const
{
    // Work of the pressure differences on the part of the fluxes that the
    // gradients of cells make
    scalarField B00(halo_.size(), Zero), B01(B00), B10(B00), B11(B00);

    auto add = [&](const label celli, const label f, const scalar work)
    {
        const scalar b0 = work*r0_[f], b1 = work*r1_[f];
        B00[celli] += b0*n0_[f];
        B01[celli] += b0*n1_[f];
        B10[celli] += b1*n0_[f];
        B11[celli] += b1*n1_[f];
    };

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const scalar work = S_[f]*ff_[f]/dc_[f];
            add(own_[f], f, wStiff_[f]*work);
            add(nei_[f], f, (1 - wStiff_[f])*work);
        }
    }
    addGradientAdjoint(B00, B01, B10, B11, r);

    const label n = nCells_;
    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label P = own_[f], N = nei_[f];
            const scalar work = S_[f]*ff_[f]/dc_[f];
            const scalar vP = wStiff_[f]*work, vN = work - vP;

            r[P] += vP*n0_[f];
            r[n + P] += vP*n1_[f];
            if (N < n)
            {
                r[N] += vN*n0_[f];
                r[n + N] += vN*n1_[f];
            }
        }
    }
    for (const label f : oneSided_)
    {
        const scalar F = S_[f]*ff_[f]/dc_[f];
        r[own_[f]] += F*n0_[f];
        r[n + own_[f]] += F*n1_[f];
    }
}


void Foam::cosseratSystem::addGradientAdjoint
(
    scalarField& B00,
    scalarField& B01,
    scalarField& B10,
    scalarField& B11,
    scalarField& r
) const
{
    const label n = nCells_;

    // Back through the systems of cells beside jumps, but for what walls and
    // jumps of one cell know of each other
    forAll(jumpCells_, i)
    {
        const label c = jumpCells_[i];
        const FixedList<scalar, 16>& L = jumpInverse_[i];
        scalar* B[] = {&B00[c], &B01[c], &B10[c], &B11[c]};
        const scalar b[] = {*B[0], *B[1], *B[2], *B[3]};
        for (label j = 0; j < 4; ++j)
        {
            *B[j] =
                L[j]*b[0] + L[4 + j]*b[1] + L[8 + j]*b[2] + L[12 + j]*b[3];
        }
    }

    // and the sum over faces
    for (label celli = 0; celli < n; ++celli)
    {
        const scalar a = B00[celli]/V_[celli], b = B01[celli]/V_[celli];
        const scalar c = B10[celli]/V_[celli], d = B11[celli]/V_[celli];
        B00[celli] = X00_[celli]*a + X10_[celli]*c;
        B01[celli] = X00_[celli]*b + X10_[celli]*d;
        B10[celli] = X01_[celli]*a + X11_[celli]*c;
        B11[celli] = X01_[celli]*b + X11_[celli]*d;
    }
    halo_.swap("t", {&B00, &B01, &B10, &B11});

    auto onFace = [&](const label f, scalar& b0, scalar& b1)
    {
        const label P = own_[f], N = nei_[f];
        const scalar n0 = n0_[f], n1 = n1_[f];
        b0 = S_[f]*(n0*(B00[P] - B00[N]) + n1*(B10[P] - B10[N]));
        b1 = S_[f]*(n0*(B01[P] - B01[N]) + n1*(B11[P] - B11[N]));
    };

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label P = own_[f], N = nei_[f];
            const scalar wP = w_[f], wN = 1 - wP;
            scalar b0, b1;
            onFace(f, b0, b1);

            r[P] += wP*b0;
            r[n + P] += wP*b1;
            if (N < n)
            {
                r[N] += wN*b0;
                r[n + N] += wN*b1;
            }
        }
    }

    // Weights of jumps instead of linear ones; not on microrotations
    forAll(jump_, i)
    {
        const label f = jump_[i];
        const label P = own_[f], N = nei_[f];
        scalar b0, b1;
        onFace(f, b0, b1);

        const scalar bt = b0*n1_[f] - b1*n0_[f];
        const scalar cn =
            (w_[f] - wStiff_[f])*(b0*n0_[f] + b1*n1_[f]);
        const scalar ct = (w_[f] - jumpW_[i])*bt;
        const scalar c0 = cn*n0_[f] + ct*n1_[f];
        const scalar c1 = cn*n1_[f] - ct*n0_[f];

        r[P] -= c0;
        r[n + P] -= c1;
        if (N < n)
        {
            r[N] += c0;
            r[n + N] += c1;
        }
    }
}


void Foam::cosseratSystem::addForce(scalarField& r) const
{
    if (adjoint_)
    {
        addAdjointForce(r);
        return;
    }

    for (label celli = 0; celli < nCells_; ++celli)
    {
        r[celli] += V_[celli]*f0_[celli];
        r[nCells_ + celli] += V_[celli]*f1_[celli];
    }
}


void Foam::cosseratSystem::viscousForce
(
    const label f,
    const scalar d0,
    const scalar d1,
    scalar& F0,
    scalar& F1
) const
{
    const label P = own_[f], N = nei_[f];
    const scalar n0 = n0_[f], n1 = n1_[f];
    const scalar wP = wStiff_[f], wN = 1 - wP;

    const scalar q =
        wP*tangentialGradientOfNormal(P, f)
      + wN*tangentialGradientOfNormal(N, f);

    scalar Fn = Kn_[f]*(d0*n0 + d1*n1);
    scalar Ft = Kt_[f]*(d0*n1 - d1*n0) + Kq_[f]*q;

    if (cosserat_)
    {
        Ft += KwP_[f]*omega_[P] + KwN_[f]*omega_[N]
           + KsP_[f]*relativeRotation(P) + KsN_[f]*relativeRotation(N);
        if (skewed_)
        {
            Ft += s0_[f]*(KwP_[f]*g0_[P] + KwN_[f]*g0_[N])
                + s1_[f]*(KwP_[f]*g1_[P] + KwN_[f]*g1_[N]);
        }
    }
    if (compressible_)
    {
        // -eta tr(D), with the compact normal gradient as in F_n
        const scalar utt =
            wP*(G00_[P]*n1*n1 - (G01_[P] + G10_[P])*n0*n1 + G11_[P]*n0*n0)
          + wN*(G00_[N]*n1*n1 - (G01_[N] + G10_[N])*n0*n1 + G11_[N]*n0*n0);
        Fn -= 0.5*Kn_[f]*(d0*n0 + d1*n1) + Kb_[f]*utt;
    }

    F0 = Fn*n0 + Ft*n1;
    F1 = Fn*n1 - Ft*n0;
}


void Foam::cosseratSystem::wallForce
(
    const label f,
    const bool driven,
    scalar& F0,
    scalar& F1
) const
{
    const label i = f - nInternal_;
    const label P = own_[f], b = nei_[f];
    const scalar n0 = n0_[f], n1 = n1_[f];
    const flowBoundary::velocityKind kind = boundary_.velocity(i);

    if (kind == flowBoundary::OPEN)
    {
        F0 = F1 = 0;
        return;
    }

    scalar d0 = u0_[b] - u0_[P];
    scalar d1 = u1_[b] - u1_[P];

    if (nonOrthogonal_)
    {
        d0 += (k0_[f]*G00_[P] + k1_[f]*G10_[P])/dc_[f];
        d1 += (k0_[f]*G01_[P] + k1_[f]*G11_[P])/dc_[f];
    }

    scalar Fn = Kn_[f]*(d0*n0 + d1*n1);
    scalar Ft = 0;

    if (kind == flowBoundary::TRACTION)
    {
        Ft = driven ? boundary_.traction(i)*S_[f] : 0;
    }
    else
    {
        // The difference is the gradient halfway to the wall; the balance of
        // momentum takes the traction to the wall
        Ft = Kt_[f]*(d0*n1 - d1*n0)
           + Kq_[f]*tangentialGradientOfNormal(P, f)
           - 0.5*S_[f]/dc_[f]*(f0_[P]*n1 - f1_[P]*n0);
        if (cosserat_)
        {
            Ft += KwP_[f]*omega_[P] + KwN_[f]*omega_[b]
               + KsP_[f]*relativeRotation(P);
        }
    }
    if (compressible_)
    {
        const scalar utt =
            G00_[P]*n1*n1 - (G01_[P] + G10_[P])*n0*n1 + G11_[P]*n0*n0;
        Fn -= 0.5*Kn_[f]*(d0*n0 + d1*n1) + Kb_[f]*utt;
    }

    F0 = Fn*n0 + Ft*n1;
    F1 = Fn*n1 - Ft*n0;
}


Foam::scalar Foam::cosseratSystem::wallCouple
(
    const label f,
    const bool driven
) const
{
    const label i = f - nInternal_;

    const label P = own_[f];
    const scalar etaC = etaC_[P];

    if (!boundary_.rotationFixed(i))
    {
        // Reduced as M on faces, for what their correction leaves at its end
        const scalar es = es_[P];
        const scalar kappa = es*(4*es + eta_[P])/(6*(eta_[P] + es));

        return
            driven && M_[P] > 0
          ? boundary_.couple(i)*S_[f]/(1 + 4*kappa/(M_[P]*sqr(dc_[f])))
          : 0;
    }

    // The difference is the gradient halfway to the wall; the moment balance
    // M omega,nn = 4 etaC s takes it to the wall
    scalar d = omega_[nei_[f]] - omega_[P];
    if (nonOrthogonal_)
    {
        d += (k0_[f]*g0_[P] + k1_[f]*g1_[P])/dc_[f];
    }

    return
        Km_[f]*d
      + 2*etaC*relativeRotation(P)*S_[f]/dc_[f];
}


void Foam::cosseratSystem::addTwoSided(scalarField& r) const
{
    const label n = nCells_;
    const bool offset = skewed_ || (nonOrthogonal_ && anyJump_);

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label P = own_[f], N = nei_[f];
            const scalar n0 = n0_[f], n1 = n1_[f];
            const scalar wP = wStiff_[f], wN = 1 - wP;
            const scalar sP = wSoft_[f], sN = 1 - sP;

            scalar d0, d1, F0, F1;
            difference(f, d0, d1);
            viscousForce(f, d0, d1, F0, F1);

            scalar u0 = wP*u0_[P] + wN*u0_[N];
            scalar u1 = wP*u1_[P] + wN*u1_[N];
            if (offset)
            {
                addOffset(f, u0, u1);
            }

            phi_[f] = S_[f]*
            (
                u0*n0 + u1*n1
              + rAUf_[f]*
                (
                    ff_[f]
                  - (sP*f0_[P] + sN*f0_[N])*m0_[f]
                  - (sP*f1_[P] + sN*f1_[N])*m1_[f]
                )
            );

            r[P] += F0;
            r[n + P] += F1;
            r[2*n + P] -= phi_[f];

            const scalar couple = cosserat_ ? faceCouple(f) : 0;
            if (cosserat_)
            {
                r[3*n + P] += couple;
            }

            if (N < n)
            {
                r[N] -= F0;
                r[n + N] -= F1;
                r[2*n + N] += phi_[f];
                if (cosserat_)
                {
                    r[3*n + N] -= couple;
                }
            }
        }
    }
}


void Foam::cosseratSystem::addOneSided
(
    scalarField& r,
    const bool driven
) const
{
    const label n = nCells_;

    for (const label f : oneSided_)
    {
        const label P = own_[f], b = nei_[f];

        scalar F0, F1;
        wallForce(f, driven, F0, F1);

        phi_[f] = S_[f]*(u0_[b]*n0_[f] + u1_[b]*n1_[f]);
        if
        (
            boundary_.velocity(f - nInternal_) == flowBoundary::OPEN
         && boundary_.pressureFixed(f - nInternal_)
        )
        {
            phi_[f] += S_[f]*rAUf_[f]*
                (ff_[f] - f0_[P]*m0_[f] - f1_[P]*m1_[f]);
        }

        r[P] += F0;
        r[n + P] += F1;
        r[2*n + P] -= phi_[f];
        if (cosserat_)
        {
            r[3*n + P] += wallCouple(f, driven);
        }
    }
}


void Foam::cosseratSystem::addCells
(
    scalarField& r,
    const bool driven
) const
{
    const label n = nCells_;

    addForce(r);

    if (cosserat_)
    {
        for (label celli = 0; celli < n; ++celli)
        {
            if (rotationUndetermined(celli))
            {
                r[3*n + celli] = -V_[celli]*eta_[celli]*omega_[celli];
            }
            else
            {
                r[3*n + celli] -=
                    4*V_[celli]*etaC_[celli]*relativeRotation(celli);
            }
        }
    }

    if (driven && cosserat_ && load_.couple())
    {
        const scalarField& couple = load_.couple()->primitiveField();
        for (label celli = 0; celli < n; ++celli)
        {
            // Zero where there is no equation for omega
            r[3*n + celli] += V_[celli]*couple[celli];
        }
    }

    if (compressible_)
    {
        const scalarField& invB = materials_.invB().primitiveField();
        for (label celli = 0; celli < n; ++celli)
        {
            r[2*n + celli] -= V_[celli]*invB[celli]*
                (p_[celli] + driven*rhoGh_[celli]);
        }
    }
}


void Foam::cosseratSystem::calcTerms
(
    const scalarField& x,
    const bool driven,
    const bool moving
) const
{
    unpack(x, driven);
    calcGradient();
    if (cosserat_ && nonOrthogonal_)
    {
        calcRotationGradient();
    }
    weightGradient();
    List<FixedList<scalar, 4>> before(jumpWalls_.size());
    forAll(before, i)
    {
        for (label j = 0; j < 4; ++j)
        {
            before[i][j] = gradient(j)[jumpWalls_[i].celli];
        }
    }
    correctWalls();
    weightWallGradient(before);
    calcForce(driven, moving);
    halo_.swap("tv", {&G00_, &G01_, &G10_, &G11_, &f0_, &f1_});
}


void Foam::cosseratSystem::addTerms(scalarField& r, const bool driven) const
{
    r.setSize(size());
    r = 0;
    addTwoSided(r);
    addOneSided(r, driven);
    addCells(r, driven);
}


void Foam::cosseratSystem::plainResidual
(
    const scalarField& x,
    scalarField& r
) const
{
    calcTerms(x, false, false);
    addTerms(r, false);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cosseratSystem::residual
(
    const scalarField& x,
    scalarField& r,
    const bool driven
) const
{
    calcTerms(x, driven, true);
    addTerms(r, driven);
    if (corners_.active())
    {
        corners_.addForce(u0_, u1_, driven, r);
    }
}


void Foam::cosseratSystem::addPressureForce
(
    const scalarField& p,
    scalarField& r
) const
{
    SubList<scalar>(p_, nCells_) = p;
    halo_.swap("s", {&p_});
    calcForce(false);
    addForce(r);
}


void Foam::cosseratSystem::addRotationForce
(
    const scalarField& omega,
    scalarField& r
) const
{
    const label n = nCells_;
    SubList<scalar>(omega_, n) = omega;
    halo_.swap("s", {&omega_});

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label P = own_[f], N = nei_[f];
            const scalar Ft =
                (KwP_[f] + KsP_[f])*omega_[P] + (KwN_[f] + KsN_[f])*omega_[N];

            r[P] += Ft*n1_[f];
            r[n + P] -= Ft*n0_[f];
            if (N < n)
            {
                r[N] -= Ft*n1_[f];
                r[n + N] += Ft*n0_[f];
            }
        }
    }

    for (const label f : oneSided_)
    {
        if (boundary_.velocity(f - nInternal_) == flowBoundary::VELOCITY)
        {
            const label P = own_[f];
            const scalar Ft = (KwP_[f] + KsP_[f])*omega_[P];
            r[P] += Ft*n1_[f];
            r[n + P] -= Ft*n0_[f];
        }
    }
}


void Foam::cosseratSystem::addDivergence
(
    const scalarField& x,
    scalarField& r
) const
{
    const label n = nCells_;
    SubList<scalar>(u0_, n) = SubList<scalar>(x, n, 0);
    SubList<scalar>(u1_, n) = SubList<scalar>(x, n, n);
    halo_.swap("v", {&u0_, &u1_});

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label P = own_[f], N = nei_[f];
            const scalar w = wStiff_[f];
            const scalar flux = S_[f]*
            (
                (w*u0_[P] + (1 - w)*u0_[N])*n0_[f]
              + (w*u1_[P] + (1 - w)*u1_[N])*n1_[f]
            );
            r[2*n + P] -= flux;
            if (N < n)
            {
                r[2*n + N] += flux;
            }
        }
    }

    for (const label f : oneSided_)
    {
        const label P = own_[f];
        if (boundary_.velocity(f - nInternal_) == flowBoundary::OPEN)
        {
            r[2*n + P] -= S_[f]*(u0_[P]*n0_[f] + u1_[P]*n1_[f]);
        }
    }
}


void Foam::cosseratSystem::addCurl
(
    const scalarField& x,
    scalarField& r
) const
{
    const label n = nCells_;
    SubList<scalar>(u0_, n) = SubList<scalar>(x, n, 0);
    SubList<scalar>(u1_, n) = SubList<scalar>(x, n, n);
    SubList<scalar>(omega_, n) = 0;
    halo_.swap("vs", {&u0_, &u1_, &omega_});
    setBoundaryValues(false);
    calcGradient();

    for (label celli = 0; celli < n; ++celli)
    {
        r[3*n + celli] +=
            2*V_[celli]*etaC_[celli]*(G01_[celli] - G10_[celli]);
    }
}


// ************************************************************************* //
