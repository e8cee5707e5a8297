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
#include "syncTools.H"
#include <functional>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::viscousCoefficients::setSides(const cutCells& cuts)
{
    const planarFrame& frame = mesh_.frame();
    sides_.setSize(mesh_.nFaces());

    auto side = [&](const label f, const label k, const scalar part)
    {
        const planarFace& face = mesh_[f];
        const label celli = k ? face.nei : face.own;
        return
            celli < mesh_.nCells() && cuts.cut(celli)
          ? cuts.along
            (
                celli,
                frame.inSpace(vector2D(part/face.dc*face.m)),
                frame.inSpace(face.n)
            )
          : at(celli);
    };

    mesh_.forTwoSided
    (
        [&](const label f)
        {
            sides_[f][0] = side(f, 0, 1 - mesh_[f].w);
            sides_[f][1] = side(f, 1, -mesh_[f].w);
        }
    );
    for (const label f : mesh_.oneSided())
    {
        sides_[f] = side(f, 0, 1);
    }
    swapSides();
}


void Foam::viscousCoefficients::swapSides()
{
    typedef cutCells::layers layers;
    const fvMesh& mesh = mesh_.mesh();
    scalarList behind(mesh.nFaces() - mesh_.nInternal());

    auto onCoupled = [&](const std::function<void(label, label)>& act)
    {
        for (const label patchi : mesh_.halo().coupledPatches())
        {
            const polyPatch& patch = mesh.boundaryMesh()[patchi];
            const label start = mesh_.faceOf(mesh_.halo().start(patchi));
            forAll(patch, i)
            {
                act(start + i, patch.start() - mesh_.nInternal() + i);
            }
        }
    };

    for
    (
        scalar layers::* const part :
        {&layers::eta, &layers::a, &layers::b, &layers::es, &layers::etaC,
         &layers::M, &layers::facing, &layers::own}
    )
    {
        behind = 0;
        onCoupled
        (
            [&](const label f, const label i)
            {
                behind[i] = sides_[f][0].*part;
            }
        );
        syncTools::swapBoundaryFaceList(mesh, behind);
        onCoupled
        (
            [&](const label f, const label i)
            {
                sides_[f][1].*part = behind[i];
            }
        );
    }
}


void Foam::viscousCoefficients::scaleFace(const label f)
{
    const scalar share = faceShare(f);

    viscousFace& K = faces_[f];
    K.Kn *= share;
    K.Kt *= share;
    K.Kq *= share;
    if (compressible_)
    {
        Kb_[f] *= share;
    }
    if (cosserat_)
    {
        cosseratFace& Kr = rotation_[f];
        for (scalar* k : {&Kr.KwP, &Kr.KwN, &Kr.KsP, &Kr.KsN, &Kr.Km})
        {
            *k *= share;
        }
    }
}


void Foam::viscousCoefficients::setFace
(
    const label f,
    DynamicList<jumpFace>& jumps
)
{
    const planarFace& face = mesh_[f];
    const scalar lP = 1 - face.w, lN = 1 - lP;
    const cutCells::layers P(side(f, 0)), N(side(f, 1));
    const scalar a = 1/(lP/P.a + lN/N.a);
    const scalar eta = 1/(lP/P.eta + lN/N.eta);

    viscousFace& K = faces_[f];
    K.Kn = 2*eta*face.dc*face.S;
    K.Kt = a*face.dc*face.S;
    K.Kq = a*face.S*(lP*P.b/P.a + lN*N.b/N.a);
    K.wStiff = K.wSoft = K.wq = face.w;

    if (compressible_)
    {
        const bool counts = invB_[face.own] > 0 || invB_[face.nei] > 0;
        Kb_[f] = counts ? eta*face.S : 0;
        K.Kn *= counts ? 0.5 : 1;
    }
    if (cosserat_)
    {
        setRotationFace(f, a, eta);
    }
    if (!held_ && this->jumps(f))
    {
        jumps.append(setJump(f));
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
    const scalar lP = 1 - face.w, lN = 1 - lP;
    const cutCells::layers P(side(f, 0)), N(side(f, 1));
    const scalar cP = a*face.S*lP/P.a, cN = a*face.S*lN/N.a;

    cosseratFace& K = rotation_[f];
    K.KwP = 2*P.es*cP;
    K.KwN = 2*N.es*cN;
    // The adjoint of the curl of the cells: as deep as they are, and where they
    // are cut with the stiffness that their gradients have
    auto ofCell = [&](const label celli, const scalar l, const scalar a1)
    {
        return
            relativeCoefficient(at(celli), f)*mesh_.depthRatio(celli, f)
           *a*face.S*l/max(a1, this->a(celli));
    };
    K.KsP = ofCell(face.own, lP, P.a);
    K.KsN = ofCell(face.nei, lN, N.a);

    K.Km = 0;
    if (P.M > 0 && N.M > 0)
    {
        const scalar M = 1/(lP/P.M + lN/N.M);
        const scalar es = 1/(lP/P.es + lN/N.es);
        const scalar kappa = es*(2*es + eta)/(3*(eta + es));
        K.Km = face.dc*face.S*M/(1 + kappa/(M*sqr(face.dc)));
    }
}


void Foam::viscousCoefficients::setWall(const label f)
{
    const planarFace& face = mesh_[f];
    const cutCells::layers P(side(f, 0));

    viscousFace& K = faces_[f];
    K.Kn = 2*P.eta*face.dc*face.S;
    K.Kt = P.a*face.dc*face.S;
    K.Kq = P.b*face.S;
    K.wStiff = K.wSoft = K.wq = face.w;

    if (compressible_)
    {
        const bool counts = invB_[face.own] > 0;
        Kb_[f] = counts ? P.eta*face.S : 0;
        K.Kn *= counts ? 0.5 : 1;
    }
    if (cosserat_)
    {
        cosseratFace& Kr = rotation_[f];
        Kr.KwN = 2*P.es*face.S*wallShare(f);
        Kr.KwP = 2*P.es*face.S - Kr.KwN;
        Kr.KsP = relativeCoefficient(P, f)*face.S;
        Kr.KsN = 0;
        Kr.Km = M_[face.own]*face.dc*face.S;
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
    anyJump_(false),
    held_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscousCoefficients::set
(
    const scalarField& eta,
    const scalarField& etaC,
    const scalarField& M,
    const scalarField& invB,
    const cutCells* cuts
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
    // A law sees the relative rotation of faces: so has their stress
    es_ = overRest_.size() ? etaC_ : scalarField(min(etaC_, eta_));

    sides_.clear();
    if (cuts)
    {
        setSides(*cuts);
    }

    DynamicList<jumpFace> jumps;
    mesh_.forTwoSided([&](const label f) { setFace(f, jumps); });
    for (const label f : mesh_.oneSided())
    {
        setWall(f);
    }
    if (held_)
    {
        takeKept();
    }

    forAll(fluxOffset_, f)
    {
        const planarFace& face = mesh_[f];
        if (mesh_.leans(f))
        {
            fluxOffset_[f] =
                mesh_.offset(f)
              + (face.w - faces_[f].wStiff)/face.dc*face.k();
        }
    }
    forAll(faceOverRest_, f)
    {
        if (faceOverRest_[f] >= 0)
        {
            scaleFace(f);
        }
    }
    if (!held_)
    {
        jumps_.transfer(jumps);
        setJumpCells();
    }
    anyJump_ = returnReduce(jumps_.size() > 0, orOp<bool>());
    setTurningCells();
}


void Foam::viscousCoefficients::setOverRest(const scalarField& ratio)
{
    overRest_.setSize(mesh_.nSlots());
    SubList<scalar>(overRest_, mesh_.nCells()) = ratio;
    mesh_.halo().swap(overRest_);
    for (const label f : mesh_.oneSided())
    {
        overRest_[mesh_[f].nei] = overRest_[mesh_[f].own];
    }
}


Foam::scalar Foam::viscousCoefficients::faceShare(const label f) const
{
    const planarFace& face = mesh_[f];
    return faceOverRest_[f]
       *((1 - face.w)/overRest_[face.own] + face.w/overRest_[face.nei]);
}


Foam::scalar Foam::viscousCoefficients::resolution
(
    const scalar etaC,
    const scalar M,
    const label f
) const
{
    const scalar m = M*sqr(mesh_[f].dc);
    return m > 0 ? etaC*m/sqr(m + etaC) : 0;
}


Foam::scalar Foam::viscousCoefficients::relativeCoefficient
(
    const cutCells::layers& side,
    const label f
) const
{
    return 2*(side.etaC - side.es)
      - (2.0/3.0)*side.etaC*resolution(side.etaC, side.M, f);
}


Foam::scalar Foam::viscousCoefficients::wallShare(const label f) const
{
    const label P = mesh_[f].own;
    return
        M_[P] > 0
      ? 0.5*M_[P]/(M_[P] + etaC_[P]/sqr(mesh_[f].dc))
      : 0;
}


Foam::scalar Foam::viscousCoefficients::wallGain
(
    const label f,
    const scalar resistance
) const
{
    const label P = mesh_[f].own;
    return 1/
    (
        1 - boundary_.curvature(mesh_.boundaryOf(f))/mesh_[f].dc
       *b(P)/a(P)
      + resistance/(mesh_[f].dc*a(P))
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
