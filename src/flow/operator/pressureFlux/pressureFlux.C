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

#include "pressureFlux.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pressureFlux::setMobility(const partialOperators& parts)
{
    scalarField diag[2], face;
    parts.velocityBlock(0, diag[0], face);
    parts.velocityBlock(1, diag[1], face);

    scalarField rAU(mesh_.nSlots());
    SubList<scalar>(rAU, mesh_.nCells()) =
        mesh_.V()/(0.5*diag[0] + 0.5*diag[1]);
    mesh_.halo().swap(rAU);

    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh_[f];
            mobility_[f] = mobilityAtJump
            (
                f, face.w*rAU[face.own] + (1 - face.w)*rAU[face.nei]
            );
        }
    );
    for (const label f : mesh_.oneSided())
    {
        mobility_[f] = rAU[mesh_[f].own];
    }
}


Foam::scalar Foam::pressureFlux::mobilityAtJump
(
    const label f,
    const scalar mobility
) const
{
    const planarFace& face = mesh_[f];
    const scalar same = K_.sameness(f);

    // Of cut cells and compressible ones there is no such formula
    if
    (
        followed_
     || K_.side(f, 0).facing >= 0 || K_.compressible(face.own)
     || K_.side(f, 1).facing >= 0 || K_.compressible(face.nei)
    )
    {
        return same*mobility;
    }
    return
        sqr(same)*mobility
      + (1 - same)
       /(4*sqr(face.dc)*(K_.eta(face.own) + K_.eta(face.nei)));
}


void Foam::pressureFlux::setSmooth()
{
    bitSet beside(mesh_.nSlots());
    for (const jumpFace& jump : K_.jumps())
    {
        beside.set(mesh_[jump.f].own);
        beside.set(mesh_[jump.f].nei);
    }

    Field<tensor2D> sum(mesh_.nCells(), Zero);
    DynamicList<smoothFace> faces;
    auto add = [&](const label f, const scalar own, const scalar nei)
    {
        const planarFace& face = mesh_[f];
        faces.append({f, own, nei});
        const tensor2D T((face.S/face.dc*face.n)*face.m);
        sum[face.own] += own*T;
        if (face.nei < mesh_.nCells())
        {
            sum[face.nei] += nei*T;
        }
    };
    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh_[f];
            const bool own = beside[face.own], nei = beside[face.nei];
            if (own || nei)
            {
                const scalar same = sqr(K_.sameness(f));
                add
                (
                    f, own ? same*(1 - face.w) : 0, nei ? same*face.w : 0
                );
            }
        }
    );
    for (const label f : mesh_.oneSided())
    {
        if
        (
            beside[mesh_[f].own]
         && boundary_.pressureFixed(mesh_.boundaryOf(f))
        )
        {
            add(f, 1, 0);
        }
    }
    smoothFaces_ = faces;

    DynamicList<label> cells;
    DynamicList<tensor2D> inverses;
    forAll(sum, celli)
    {
        if (beside[celli])
        {
            cells.append(celli);
            inverses.append(planarFrame::generalInverse(sum[celli]));
        }
    }
    smoothCells_ = cells;
    reconstruction_ = inverses;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pressureFlux::pressureFlux
(
    const faceGeometry& mesh,
    const flowBoundary& boundary,
    const viscousCoefficients& K
)
:
    mesh_(mesh),
    boundary_(boundary),
    K_(K),
    followed_(false),
    mobility_(mesh.nFaces(), Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pressureFlux::update
(
    const partialOperators& parts,
    const bool followed
)
{
    followed_ = followed;
    setMobility(parts);
    if (!followed)
    {
        setSmooth();
    }
}


void Foam::pressureFlux::calc(operatorState& s) const
{
    if (followed_ || !K_.anyJump())
    {
        s.fSmooth.clear();
        return;
    }

    s.fSmooth = s.f;
    for (const label celli : smoothCells_)
    {
        s.fSmooth[celli] = Zero;
    }
    for (const smoothFace& part : smoothFaces_)
    {
        const planarFace& face = mesh_[part.f];
        const vector2D F(face.S*s.faceForce[part.f]/face.dc*face.n);
        s.fSmooth[face.own] += part.own*F;
        s.fSmooth[face.nei] += part.nei*F;
    }
    forAll(smoothCells_, i)
    {
        vector2D& f = s.fSmooth[smoothCells_[i]];
        f = reconstruction_[i] & f;
    }
}


Foam::scalar Foam::pressureFlux::speed
(
    const operatorState& s,
    const label f
) const
{
    const planarFace& face = mesh_[f];
    const scalar w = followed_ ? K_[f].wSoft : face.w;
    const vector2D mean
    (
        w*smooth(s, face.own) + (1 - w)*smooth(s, face.nei)
    );
    return mobility_[f]*(s.faceForce[f] - (mean & face.m));
}


Foam::scalar Foam::pressureFlux::openSpeed
(
    const operatorState& s,
    const label f
) const
{
    const planarFace& face = mesh_[f];
    return
        mobility_[f]*(s.faceForce[f] - (smooth(s, face.own) & face.m));
}


// ************************************************************************* //
