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
#include "sparseFactorisation.H"
#include "globalIndex.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Linear function of the velocities of a cell (first) and of the cells
    //- around, two coefficients each, and last of the microrotation of the cell
    typedef DynamicList<scalar> velocityForm;

    static inline void addTo
    (
        velocityForm& sum,
        const scalar factor,
        const velocityForm& form
    )
    {
        forAll(sum, i)
        {
            sum[i] += factor*form[i];
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cosseratSystem::addFaceEntries
(
    const labelList& ids,
    sparseEntries& e
) const
{
    const label nb = cosserat_ ? 3 : 2;

    auto add = [&]
    (
        const label row, const label i, const label col, const label j,
        const scalar value
    )
    {
        e.add(nb*ids[row] + i, nb*ids[col] + j, value);
    };

    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            const label cells[] = {own_[f], nei_[f]};
            const scalar n[] = {n0_[f], n1_[f]}, t[] = {n1_[f], -n0_[f]};
            const scalar Kn = compressible_ ? 0.5*Kn_[f] : Kn_[f];

            for (label side = 0; side < 2 && cells[side] < nCells_; ++side)
            {
                const label P = cells[side], N = cells[1 - side];
                const scalar sign = side ? 1 : -1;

                for (label i = 0; i < 2; ++i)
                {
                    for (label j = 0; j < 2; ++j)
                    {
                        const scalar K = Kn*n[i]*n[j] + Kt_[f]*t[i]*t[j];
                        add(P, i, P, j, K);
                        add(P, i, N, j, -K);
                    }
                    if (cosserat_)
                    {
                        add(P, i, cells[0], 2, sign*KwP_[f]*t[i]);
                        add(P, i, cells[1], 2, sign*KwN_[f]*t[i]);
                    }
                }
                if (cosserat_)
                {
                    add(P, 2, P, 2, Km_[f]);
                    add(P, 2, N, 2, -Km_[f]);
                }
            }
        }
    }

    for (const label f : oneSided_)
    {
        const label P = own_[f];
        const scalar n[] = {n0_[f], n1_[f]}, t[] = {n1_[f], -n0_[f]};
        const auto kind = boundary_.velocity(f - nInternal_);
        const bool fixed = boundary_.rotationFixed(f - nInternal_);
        const scalar Kn =
            kind == flowBoundary::OPEN ? 0
          : compressible_ ? 0.5*Kn_[f] : Kn_[f];
        const scalar Kt = kind == flowBoundary::VELOCITY ? Kt_[f] : 0;

        for (label i = 0; i < 2; ++i)
        {
            for (label j = 0; j < 2; ++j)
            {
                add(P, i, P, j, Kn*n[i]*n[j] + Kt*t[i]*t[j]);
            }
            if (cosserat_)
            {
                const scalar Kw =
                    kind != flowBoundary::VELOCITY ? 0
                  : fixed ? KwP_[f] : KwP_[f] + KwN_[f];
                add(P, i, P, 2, -Kw*t[i]);
            }
        }
        if (cosserat_)
        {
            add(P, 2, P, 2, fixed ? Km_[f] : 0);
        }
    }
}


void Foam::cosseratSystem::addCellEntries
(
    const label celli,
    const labelUList& faces,
    const scalarField& tangentialWeight,
    const scalarField& compliance,
    const FixedList<scalar, 16>* jumpInverse,
    const jumpWall* wallAtJump,
    const labelList& ids,
    sparseEntries& e
) const
{
    const label nb = cosserat_ ? 3 : 2;
    const label m = faces.size();
    const label last = 2*(m + 1);
    const velocityForm zero(last + 1, Zero);

    // Gradient as calcGradient(), correctWalls() and weightGradient() make it
    velocityForm G[2][2] = {{zero, zero}, {zero, zero}};
    List<velocityForm> wall(2*m, zero);
    labelList around(m + 1, celli);

    for (label k = 0; k < m; ++k)
    {
        const label f = faces[k];
        const bool owner = own_[f] == celli;
        const bool twoSided = isTwoSided(f);
        const scalar n[] = {n0_[f], n1_[f]}, t[] = {n1_[f], -n0_[f]};
        const scalar S = (owner ? S_[f] : -S_[f])/V_[celli];

        scalar wn = 0, wt = 0, vn = 0, vt = 0, slope = 0;
        if (twoSided)
        {
            around[k + 1] = owner ? nei_[f] : own_[f];
            wn = owner ? wStiff_[f] : 1 - wStiff_[f];
            wt = owner ? tangentialWeight[f] : 1 - tangentialWeight[f];
            vn = 1 - wn;
            vt = 1 - wt;
        }
        else
        {
            const auto kind = boundary_.velocity(f - nInternal_);
            wt =
                kind == flowBoundary::VELOCITY ? 0
              : kind == flowBoundary::TRACTION ? wallGain(f) : 1;
            wn = kind == flowBoundary::OPEN ? 1 : 0;
            if (cosserat_ && kind == flowBoundary::TRACTION)
            {
                const scalar share =
                    boundary_.rotationFixed(f - nInternal_) ? wallShare(f) : 0;
                slope = -2*etaC_[celli]*(1 - share)*wallGain(f)
                   /(eta_[celli] + etaC_[celli]);
            }
        }

        for (label j = 0; j < 2; ++j)
        {
            for (label a = 0; a < 2; ++a)
            {
                const scalar here = n[j]*n[a]*wn + t[j]*t[a]*wt;
                const scalar there = n[j]*n[a]*vn + t[j]*t[a]*vt;
                for (label i = 0; i < 2; ++i)
                {
                    G[i][j][a] += S*n[i]*here;
                    G[i][j][2*(k + 1) + a] += S*n[i]*there;
                }
                if (!twoSided)
                {
                    wall[2*k + j][a] += dc_[f]*(here - (a == j));
                }
            }
            if (!twoSided)
            {
                wall[2*k + j][last] += t[j]*slope;
                G[0][j][last] += S*n[0]*t[j]*slope/dc_[f];
                G[1][j][last] += S*n[1]*t[j]*slope/dc_[f];
            }
        }
    }

    // What weightGradient() makes of it
    for (label k = 0; cosserat_ && k < m; ++k)
    {
        const label f = faces[k];
        if (compliance[f] > 0)
        {
            const scalar t[] = {n1_[f], -n0_[f]};
            const scalar own =
                compliance[f]*2*es_[celli]*(own_[f] == celli ? -1 : 1);
            scalar s[2];
            gradientVector(celli, f, s[0], s[1]);
            for (label i = 0; i < 2; ++i)
            {
                for (label j = 0; j < 2; ++j)
                {
                    G[i][j][last] += s[i]*t[j]*own;
                }
            }
        }
    }
    auto addProduct = [&]
    (
        const scalar factor, const FixedList<scalar, 16>& L,
        const velocityForm* g
    )
    {
        for (label j = 0; j < 4; ++j)
        {
            for (label l = 0; l < 4; ++l)
            {
                addTo(G[j/2][j % 2], factor*L[4*j + l], g[l]);
            }
        }
    };
    auto clear = [&]()
    {
        for (label j = 0; j < 4; ++j)
        {
            G[j/2][j % 2] = zero;
        }
    };
    if (jumpInverse)
    {
        const velocityForm g[] = {G[0][0], G[0][1], G[1][0], G[1][1]};
        clear();
        addProduct(1, *jumpInverse, g);
    }
    const velocityForm before[] = {G[0][0], G[0][1], G[1][0], G[1][1]};

    auto rotation = [&]()
    {
        velocityForm s(zero);
        s[last] = 1;
        addTo(s, -0.5, G[0][1]);
        addTo(s, 0.5, G[1][0]);
        return s;
    };

    for (label k = 0; k < m; ++k)
    {
        const label f = faces[k];
        if (isTwoSided(f))
        {
            continue;
        }
        const scalar n[] = {n0_[f], n1_[f]}, t[] = {n1_[f], -n0_[f]};

        if
        (
            cosserat_ && !rotationUndetermined(celli)
         && boundary_.velocity(f - nInternal_) == flowBoundary::TRACTION
        )
        {
            const scalar factor =
                (boundary_.rotationFixed(f - nInternal_) ? 2.0/3 : 8.0/3)
               *resolution(celli, f)*etaC_[celli]*wallGain(f)
               /(eta_[celli] + etaC_[celli]);
            const velocityForm s(rotation());
            for (label j = 0; j < 2; ++j)
            {
                addTo(wall[2*k + j], factor*t[j], s);
                for (label i = 0; i < 2; ++i)
                {
                    addTo
                    (
                        G[i][j],
                        factor*S_[f]/V_[celli]*n[i]*t[j]/dc_[f],
                        s
                    );
                }
            }
        }

        for (label j = 0; j < 2; ++j)
        {
            velocityForm c(wall[2*k + j]);
            addTo(c, -n[0], G[0][j]);
            addTo(c, -n[1], G[1][j]);
            addTo(G[0][j], n[0]/3, c);
            addTo(G[1][j], n[1]/3, c);
        }
    }

    if (wallAtJump)
    {
        const velocityForm g[] = {G[0][0], G[0][1], G[1][0], G[1][1]};
        clear();
        addProduct(1, wallAtJump->after, g);
        addProduct(-1, wallAtJump->before, before);
    }

    // u_n,t on a face, as tangentialGradientOfNormal()
    auto addGradientOfNormal = [&]
    (
        velocityForm& sum, const scalar factor, const label f
    )
    {
        const scalar n0 = n0_[f], n1 = n1_[f];
        addTo(sum, factor*n1*n0, G[0][0]);
        addTo(sum, factor*n1*n1, G[0][1]);
        addTo(sum, -factor*n0*n0, G[1][0]);
        addTo(sum, -factor*n0*n1, G[1][1]);
    };

    const velocityForm s(rotation());

    auto addForm = [&]
    (
        const label row, const label i, const scalar factor,
        const velocityForm& form
    )
    {
        const label r = nb*ids[row] + i;
        for (label k = 0; k < last; ++k)
        {
            e.add(r, nb*ids[around[k/2]] + k % 2, factor*form[k]);
        }
        if (cosserat_)
        {
            e.add(r, nb*ids[celli] + 2, factor*form[last]);
        }
    };

    // Forces on either side of the faces by u_n,t and s of this cell
    for (label k = 0; k < m; ++k)
    {
        const label f = faces[k];
        const bool owner = own_[f] == celli;
        const bool twoSided = isTwoSided(f);
        const scalar t[] = {n1_[f], -n0_[f]};

        const bool bears =
            twoSided
         || boundary_.velocity(f - nInternal_) == flowBoundary::VELOCITY;
        const scalar Kq =
            !bears ? 0 : !twoSided ? Kq_[f]
          : Kq_[f]*(owner ? wStiff_[f] : 1 - wStiff_[f]);

        velocityForm force(zero);
        addGradientOfNormal(force, Kq, f);

        if (cosserat_ && bears)
        {
            addTo(force, owner ? KsP_[f] : KsN_[f], s);
        }

        for (label side = 0; side < (twoSided ? 2 : 1); ++side)
        {
            const label row = side ? nei_[f] : own_[f];
            const scalar sign = side ? 1 : -1;
            for (label i = 0; i < 2; ++i)
            {
                addForm(row, i, sign*t[i], force);
            }
        }
    }

    if (cosserat_)
    {
        scalar K = 4*V_[celli]*etaC_[celli];
        for (const label f : faces)
        {
            if
            (
                !isTwoSided(f)
             && boundary_.rotationFixed(f - nInternal_)
            )
            {
                K -= 2*etaC_[celli]*S_[f]/dc_[f];
            }
        }
        addForm(celli, 2, K, s);
        e.add
        (
            nb*ids[celli] + 2, nb*ids[celli] + 2,
            rotationUndetermined(celli) ? V_[celli]*eta_[celli] : 0
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cosseratSystem::viscousEntries(sparseEntries& e) const
{
    // Global numbers of cells and of those behind coupled faces
    const globalIndex global(nCells_);
    scalarField number(halo_.size(), Zero);
    for (label celli = 0; celli < nCells_; ++celli)
    {
        number[celli] = global.toGlobal(celli);
    }
    halo_.swap("s", {&number});
    labelList ids(number.size());
    forAll(ids, i)
    {
        ids[i] = label(number[i] + 0.5);
    }

    scalarField tangentialWeight(w_), compliance(nFaces_, Zero);
    forAll(jump_, i)
    {
        tangentialWeight[jump_[i]] = jumpW_[i];
        compliance[jump_[i]] = jumpC_[i];
    }

    List<DynamicList<label>> faces(nCells_);
    for (const labelPair& range : twoSided_)
    {
        for (label f = range.first(); f < range.second(); ++f)
        {
            faces[own_[f]].append(f);
            if (nei_[f] < nCells_)
            {
                faces[nei_[f]].append(f);
            }
        }
    }
    for (const label f : oneSided_)
    {
        faces[own_[f]].append(f);
    }

    addFaceEntries(ids, e);
    corners_.addEntries(cosserat_ ? 3 : 2, e);

    // Against rigid motions that no wall holds, which others remove
    const label nb = cosserat_ ? 3 : 2;
    scalarField diag, face;
    for (label cmpt = 0; cmpt < 2; ++cmpt)
    {
        velocityBlock(cmpt, diag, face);
        for (label celli = 0; celli < nCells_; ++celli)
        {
            const label i = nb*ids[celli] + cmpt;
            e.add(i, i, 1e-10*diag[celli]);
        }
    }

    List<const FixedList<scalar, 16>*> jumpInverse(nCells_, nullptr);
    forAll(jumpCells_, i)
    {
        jumpInverse[jumpCells_[i]] = &jumpInverse_[i];
    }
    List<const jumpWall*> wallAtJump(nCells_, nullptr);
    for (const jumpWall& wall : jumpWalls_)
    {
        wallAtJump[wall.celli] = &wall;
    }

    for (label celli = 0; celli < nCells_; ++celli)
    {
        addCellEntries
        (
            celli, faces[celli], tangentialWeight, compliance,
            jumpInverse[celli], wallAtJump[celli], ids, e
        );
    }
}


// ************************************************************************* //
