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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::viscousCoefficients::setFace
(
    const label f,
    DynamicList<jumpFace>& jumps
)
{
    const planarFace& face = mesh_[f];
    const label P = face.own, N = face.nei;
    const scalar lP = 1 - face.w, lN = 1 - lP;
    const scalar a = 1/(lP/this->a(P) + lN/this->a(N));
    const scalar eta = 1/(lP/eta_[P] + lN/eta_[N]);

    viscousFace& K = faces_[f];
    K.Kn = 2*eta*face.dc*face.S;
    K.Kt = a*face.dc*face.S;
    K.Kq = a*face.S*(lP*b(P)/this->a(P) + lN*b(N)/this->a(N));
    K.wStiff = K.wSoft = face.w;

    if (compressible_)
    {
        const bool counts = invB_[P] > 0 || invB_[N] > 0;
        Kb_[f] = counts ? eta*face.S : 0;
        K.Kn *= counts ? 0.5 : 1;
    }
    if (cosserat_)
    {
        setRotationFace(f, a, eta);
    }

    // Beyond rounding
    const scalar least = 1e-12*this->a(P);
    if (mag(this->a(P) - this->a(N)) > least || mag(b(P) - b(N)) > least)
    {
        const scalar kP = this->a(P)/lP, kN = this->a(N)/lN;
        const scalar wP = face.w, wN = 1 - wP;
        K.wStiff = wP*eta_[P]/(wP*eta_[P] + wN*eta_[N]);
        K.wSoft = wP*eta_[N]/(wP*eta_[N] + wN*eta_[P]);
        jumps.append({f, kP/(kP + kN), 1/(face.dc*(kP + kN))});
    }
}


void Foam::viscousCoefficients::setRotationFace
(
    const label f,
    const scalar a,
    const scalar eta
)
{
    const planarFace& face = mesh_[f];
    const label P = face.own, N = face.nei;
    const scalar lP = 1 - face.w, lN = 1 - lP;
    const scalar cP = a*face.S*lP/this->a(P), cN = a*face.S*lN/this->a(N);

    cosseratFace& K = rotation_[f];
    K.KwP = 2*es_[P]*cP;
    K.KwN = 2*es_[N]*cN;
    K.KsP = relativeCoefficient(P, f)*cP;
    K.KsN = relativeCoefficient(N, f)*cN;

    K.Km = 0;
    if (M_[P] > 0 && M_[N] > 0)
    {
        const scalar M = 1/(lP/M_[P] + lN/M_[N]);
        const scalar es = 1/(lP/es_[P] + lN/es_[N]);
        const scalar kappa = es*(2*es + eta)/(3*(eta + es));
        K.Km = face.dc*face.S*M/(1 + kappa/(M*sqr(face.dc)));
    }
}


void Foam::viscousCoefficients::setWall(const label f)
{
    const planarFace& face = mesh_[f];
    const label P = face.own;

    viscousFace& K = faces_[f];
    K.Kn = 2*eta_[P]*face.dc*face.S;
    K.Kt = a(P)*face.dc*face.S;
    K.Kq = b(P)*face.S;
    K.wStiff = K.wSoft = face.w;

    if (compressible_)
    {
        const bool counts = invB_[P] > 0;
        Kb_[f] = counts ? eta_[P]*face.S : 0;
        K.Kn *= counts ? 0.5 : 1;
    }
    if (cosserat_)
    {
        cosseratFace& Kr = rotation_[f];
        Kr.KwN = 2*es_[P]*face.S*wallShare(f);
        Kr.KwP = 2*es_[P]*face.S - Kr.KwN;
        Kr.KsP = relativeCoefficient(P, f)*face.S;
        Kr.KsN = 0;
        Kr.Km = M_[P]*face.dc*face.S;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscousCoefficients::viscousCoefficients
(
    const faceGeometry& mesh,
    const flowBoundary& boundary,
    const bool cosserat,
    const bool compressible
)
:
    mesh_(mesh),
    boundary_(boundary),
    cosserat_(cosserat),
    compressible_(compressible),
    eta_(mesh.nSlots(), Zero),
    etaC_(mesh.nSlots(), Zero),
    M_(mesh.nSlots(), Zero),
    es_(mesh.nSlots(), Zero),
    invB_(compressible ? mesh.nSlots() : 0, Zero),
    faces_(mesh.nFaces()),
    rotation_(cosserat ? mesh.nFaces() : 0),
    Kb_(compressible ? mesh.nFaces() : 0, Zero),
    fluxOffset_(mesh.nonOrthogonal() ? mesh.nFaces() : 0, Zero),
    anyJump_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscousCoefficients::set
(
    const scalarField& eta,
    const scalarField& etaC,
    const scalarField& M,
    const scalarField& invB
)
{
    const label n = mesh_.nCells();
    SubList<scalar>(eta_, n) = eta;
    SubList<scalar>(etaC_, n) = etaC;
    SubList<scalar>(M_, n) = M;
    mesh_.halo().swap(eta_, etaC_, M_);
    if (compressible_)
    {
        SubList<scalar>(invB_, n) = invB;
        mesh_.halo().swap(invB_);
    }

    // Slots of walls are not read; they must not divide by zero either
    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        eta_[face.nei] = eta_[face.own];
        etaC_[face.nei] = etaC_[face.own];
        M_[face.nei] = M_[face.own];
    }
    es_ = min(etaC_, eta_);

    DynamicList<jumpFace> jumps;
    mesh_.forTwoSided([&](const label f) { setFace(f, jumps); });
    for (const label f : mesh_.oneSided())
    {
        setWall(f);
    }

    forAll(fluxOffset_, f)
    {
        const planarFace& face = mesh_[f];
        fluxOffset_[f] =
            mesh_.offset(f) + (face.w - faces_[f].wStiff)/face.dc*face.k();
    }
    jumps_.transfer(jumps);
    anyJump_ = returnReduce(jumps_.size() > 0, orOp<bool>());

    setJumpCells();
}


Foam::scalar Foam::viscousCoefficients::resolution
(
    const label celli,
    const label f
) const
{
    const scalar m = M_[celli]*sqr(mesh_[f].dc);
    return m > 0 ? etaC_[celli]*m/sqr(m + etaC_[celli]) : 0;
}


Foam::scalar Foam::viscousCoefficients::relativeCoefficient
(
    const label celli,
    const label f
) const
{
    return 2*(etaC_[celli] - es_[celli])
      - (2.0/3.0)*etaC_[celli]*resolution(celli, f);
}


Foam::scalar Foam::viscousCoefficients::wallShare(const label f) const
{
    const label P = mesh_[f].own;
    return
        M_[P] > 0
      ? 0.5*M_[P]/(M_[P] + etaC_[P]/sqr(mesh_[f].dc))
      : 0;
}


Foam::scalar Foam::viscousCoefficients::wallGain(const label f) const
{
    const label P = mesh_[f].own;
    return 1/
    (
        1 - boundary_.curvature(mesh_.boundaryOf(f))/mesh_[f].dc
       *(eta_[P] - etaC_[P])/(eta_[P] + etaC_[P])
    );
}


Foam::scalar Foam::viscousCoefficients::largestCoupling() const
{
    scalar largest = 0;
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        largest = max(largest, etaC_[celli]/eta_[celli]);
    }
    return returnReduce(largest, maxOp<scalar>());
}


Foam::scalar Foam::viscousCoefficients::largestJump() const
{
    scalar largest = 1;
    for (const jumpFace& jump : jumps_)
    {
        const planarFace& face = mesh_[jump.f];
        const scalar ratio = eta_[face.own]/eta_[face.nei];
        largest = max(largest, max(ratio, 1/ratio));
    }
    return returnReduce(largest, maxOp<scalar>());
}


// ************************************************************************* //
