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

#include "viscousCoefficients.H"
#include "HashSet.H"
#include "Map.H"
#include "SVD.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- The numbers of a 4 x 4 matrix, row by row
    static gradientMatrix listed(const scalarRectangularMatrix& M)
    {
        gradientMatrix list;
        forAll(list, i)
        {
            list[i] = M(i/4, i % 4);
        }
        return list;
    }

    static scalarSquareMatrix unit()
    {
        return scalarSquareMatrix(4, Identity<scalar>());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::viscousCoefficients::jumps(const label f) const
{
    const label P = mesh_[f].own, N = mesh_[f].nei;
    // Beyond rounding
    const scalar least = 1e-12*a(P);

    auto differ = [&](const scalar aP, const scalar bP, const label i)
    {
        return mag(aP - a(i)) > least || mag(bP - b(i)) > least;
    };

    const scalar rest =
        overRest_.size() ? overRest_[N]/overRest_[P] : 1;
    if (differ(a(N)/rest, b(N)/rest, P))
    {
        return true;
    }
    if (sides_.empty())
    {
        return false;
    }
    const cutCells::layers& sP = sides_[f][0];
    const cutCells::layers& sN = sides_[f][1];
    return differ(sP.a, sP.b, P) || differ(sN.a, sN.b, N);
}


Foam::scalar Foam::viscousCoefficients::stiffShare(const label f) const
{
    scalar facing = 0;
    label n = 0;
    for (label k = 0; k < 2 && sides_.size(); ++k)
    {
        if (sides_[f][k].facing >= 0)
        {
            facing += sides_[f][k].facing;
            ++n;
        }
    }
    return n ? pow4(facing/n) : 1;
}


Foam::jumpFace Foam::viscousCoefficients::setJump(const label f)
{
    const planarFace& face = mesh_[f];
    viscousFace& K = faces_[f];
    const scalar wP = face.w, wN = 1 - wP;
    const scalar etaP = eta_[face.own], etaN = eta_[face.nei];
    K.wStiff = wP*etaP/(wP*etaP + wN*etaN);
    K.wSoft = wP*etaN/(wP*etaN + wN*etaP);
    const scalar x = stiffShare(f);
    K.wq = x*K.wStiff + (1 - x)*K.wSoft;

    // Along the path
    const scalar l[] = {1 - face.w, face.w};
    scalar a = 0, eta = 0, b = 0, e[2];
    for (label k = 0; k < 2; ++k)
    {
        const cutCells::layers side(this->side(f, k));
        a += l[k]/side.a;
        eta += l[k]/side.eta;
        b += l[k]*side.b/side.a;
        e[k] = 2*l[k]*side.es/side.a;
    }

    jumpFace jump;
    jump.f = f;
    for (label k = 0; k < 2; ++k)
    {
        const label celli = k ? face.nei : face.own;
        const cutCells::layers side(this->side(f, k));
        const cutCells::layers own(this->a(celli) > side.a ? at(celli) : side);

        // From the cell to the face, u changes by these shares
        const scalar n = l[k]/(own.eta*eta), t = l[k]/(own.a*a);
        const scalar sign = k ? -1 : 1;
        jumpSide& take = jump.sides[k];
        take.wn = k ? n : 1 - n;
        take.wt = k ? t : 1 - t;
        take.q = sign*(t*b - l[k]*own.b/own.a)/face.dc;

        scalar omega[] = {t*e[0], t*e[1]};
        omega[k] -= 2*l[k]*own.es/own.a;
        take.omegaP = sign*omega[0]/face.dc;
        take.omegaN = sign*omega[1]/face.dc;
    }
    return jump;
}


void Foam::viscousCoefficients::keepJumps()
{
    keptWeights_.setSize(jumps_.size());
    forAll(jumps_, i)
    {
        const viscousFace& K = faces_[jumps_[i].f];
        keptWeights_[i] = {K.wStiff, K.wSoft, K.wq};
    }
    keptJumps_ = jumps_;
    keptCells_ = jumpCells_;
    keptWalls_ = jumpWalls_;
    held_ = true;
}


void Foam::viscousCoefficients::takeKept()
{
    jumps_ = keptJumps_;
    jumpCells_ = keptCells_;
    jumpWalls_ = keptWalls_;
    forAll(jumps_, i)
    {
        viscousFace& K = faces_[jumps_[i].f];
        K.wStiff = keptWeights_[i].wStiff;
        K.wSoft = keptWeights_[i].wSoft;
        K.wq = keptWeights_[i].wq;
    }
}


void Foam::viscousCoefficients::addJump
(
    const jumpFace& jump,
    const label celli,
    scalarSquareMatrix& A
) const
{
    const planarFace& face = mesh_[jump.f];
    const vector2D s(mesh_.gradientVector(celli, jump.f));
    const vector2D n(face.n), t(face.t()), k(face.k());

    // G_ij += s_i v_j, v = n vn + t vt: u_n,t = t_k G_kl n_l of two layers in
    // vt, and in both the way k to the normal
    const jumpSide& side = jump.sides[celli == face.own ? 0 : 1];
    const scalar q = side.q;
    const scalar kn = (face.w - side.wn)/face.dc;
    const scalar kt = (face.w - side.wt)/face.dc;

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


void Foam::viscousCoefficients::setJumpCells()
{
    // Row of a cell in the lists, by cell
    Map<label> row;
    DynamicList<label> cells;
    DynamicList<scalarSquareMatrix> systems;

    for (const jumpFace& jump : jumps_)
    {
        for (const label celli : {mesh_[jump.f].own, mesh_[jump.f].nei})
        {
            if (celli >= mesh_.nCells())
            {
                continue;
            }
            if (row.insert(celli, cells.size()))
            {
                cells.append(celli);
                systems.append(unit());
            }
            addJump(jump, celli, systems[row[celli]]);
        }
    }

    jumpCells_.setSize(cells.size());
    forAll(systems, i)
    {
        jumpCells_[i].celli = cells[i];
        jumpCells_[i].inverse = listed(SVDinv(systems[i]));
        systems[i] = unit() - systems[i];
    }
    setJumpWalls(systems);
}


Foam::scalarSquareMatrix Foam::viscousCoefficients::wallCorrection
(
    const label f
) const
{
    const planarFace& face = mesh_[f];
    scalarSquareMatrix W(unit());
    for (label ij = 0; ij < 4; ++ij)
    {
        for (label l = 0; l < 2; ++l)
        {
            W(ij, 2*l + ij % 2) -= face.n[ij/2]*face.m[l]/3;
        }
    }
    return W;
}


void Foam::viscousCoefficients::setJumpWalls
(
    const UList<scalarSquareMatrix>& jumps
)
{
    labelHashSet beside(2*jumpCells_.size());
    for (const jumpCell& cell : jumpCells_)
    {
        beside.insert(cell.celli);
    }

    // The correction at walls, face by face
    Map<scalarSquareMatrix> walls;
    for (const label f : mesh_.oneSided())
    {
        const label P = mesh_[f].own;
        if (beside.found(P))
        {
            walls.insert(P, unit());
            walls[P] = scalarSquareMatrix(wallCorrection(f)*walls[P]);
        }
    }

    // G = W (g + K G) + ..., of (1 - K)^-1 g before and its W after
    jumpWalls_.setSize(walls.size());
    label n = 0;
    forAll(jumpCells_, i)
    {
        const label celli = jumpCells_[i].celli;
        if (walls.found(celli))
        {
            const scalarSquareMatrix WK(walls[celli]*jumps[i]);
            const scalarSquareMatrix after
            (
                SVDinv(scalarSquareMatrix(unit() - WK))
            );
            jumpWalls_[n].celli = celli;
            jumpWalls_[n].after = listed(after);
            jumpWalls_[n].before = listed(after*WK);
            ++n;
        }
    }
}


void Foam::viscousCoefficients::setTurningCells()
{
    turningCells_.clear();
    Map<label> row;
    for (const label f : mesh_.oneSided())
    {
        const label P = mesh_[f].own;
        if
        (
            boundary_.velocity(mesh_.boundaryOf(f)) != flowBoundary::TRACTION
         || etaC_[P] <= es_[P]
        )
        {
            continue;
        }
        if (row.insert(P, turningCells_.size()))
        {
            turningCells_.append(turningCell{P, {}, nullptr});
        }
        turningCells_[row[P]].walls.append(f);
    }
    for (const jumpWall& wall : jumpWalls_)
    {
        if (row.found(wall.celli))
        {
            turningCells_[row[wall.celli]].after = &wall.after;
        }
    }
}


// ************************************************************************* //
