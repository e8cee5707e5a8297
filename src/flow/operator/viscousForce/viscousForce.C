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

#include "viscousForce.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector2D Foam::viscousForce::difference
(
    const operatorState& s,
    const label f
) const
{
    const planarFace& face = mesh_[f];
    const label P = face.own, N = face.nei;
    vector2D d(s.u[N] - s.u[P]);

    if (mesh_.leans(f))
    {
        // Along the face u is that of the stiff side
        const scalar wP = K_[f].wStiff, wN = 1 - wP;
        d += (face.k()/face.dc) & (wP*s.G[P] + wN*s.G[N]);
    }

    return d;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscousForce::viscousForce
(
    const faceGeometry& mesh,
    const flowBoundary& boundary,
    const viscousCoefficients& K
)
:
    mesh_(mesh),
    boundary_(boundary),
    K_(K)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector2D Foam::viscousForce::onFace
(
    const operatorState& s,
    const label f
) const
{
    const planarFace& face = mesh_[f];
    const viscousFace& K = K_[f];
    const label P = face.own, N = face.nei;
    const vector2D& n = face.n;
    const vector2D t(face.t()), d(difference(s, f));
    const scalar wP = K.wStiff, wN = 1 - wP;

    scalar Fn = K.Kn*(d & n);
    scalar Ft =
        K.Kt*(d & t)
      + K.Kq*
        (
            K.wq*s.tangentialOfNormal(P, n)
          + (1 - K.wq)*s.tangentialOfNormal(N, n)
        );

    if (K_.cosserat())
    {
        const cosseratFace& Kr = K_.rotation(f);
        Ft += Kr.KwP*s.omega[P] + Kr.KwN*s.omega[N]
            + Kr.KsP*s.relativeRotation(P) + Kr.KsN*s.relativeRotation(N);
        if (mesh_.leans(f))
        {
            Ft += mesh_.offset(f)
              & (Kr.KwP*s.gradOmega[P] + Kr.KwN*s.gradOmega[N]);
        }
    }
    if (K_.Kb(f) > 0)
    {
        // -eta tr(D), with the compact normal gradient as in F_n
        Fn -= K_.Kb(f)*
        (
            wP*tangentialOfTangential(s, P, n)
          + wN*tangentialOfTangential(s, N, n)
        );
        if (mesh_.wedge())
        {
            Fn -= K_.Kb(f)*(wP*hoopStrain(s, P) + wN*hoopStrain(s, N));
        }
    }

    return Fn*n + Ft*t;
}


Foam::vector2D Foam::viscousForce::onWall
(
    const operatorState& s,
    const label f,
    const bool driven
) const
{
    const planarFace& face = mesh_[f];
    const viscousFace& K = K_[f];
    const label i = mesh_.boundaryOf(f);
    const label P = face.own;
    const vector2D& n = face.n;
    const vector2D t(face.t());

    if (boundary_.velocity(i) == flowBoundary::OPEN)
    {
        return Zero;
    }

    vector2D d(s.u[face.nei] - s.u[P]);
    if (mesh_.leans(f))
    {
        d += (face.k()/face.dc) & s.G[P];
    }

    scalar Fn = K.Kn*(d & n);
    if (K_.Kb(f) > 0)
    {
        Fn -= K_.Kb(f)*tangentialOfTangential(s, P, n);
        if (mesh_.wedge())
        {
            Fn -= K_.Kb(f)*hoopStrain(s, P);
        }
    }

    scalar Ft = 0;
    if (boundary_.velocity(i) == flowBoundary::TRACTION)
    {
        Ft = face.S
           *boundary_.tractionLaw(i, driven, s.normal)(s.u[face.nei] & t);
    }
    else
    {
        // The difference is the gradient halfway to the wall; the balance of
        // momentum takes the traction to the wall
        Ft = K.Kt*(d & t) + K.Kq*s.tangentialOfNormal(P, n)
           - 0.5*face.S/face.dc*(s.f[P] & t);
        if (K_.cosserat())
        {
            const cosseratFace& Kr = K_.rotation(f);
            Ft += Kr.KwP*s.omega[P] + Kr.KwN*s.omega[face.nei]
                + Kr.KsP*s.relativeRotation(P);
        }
        if (mesh_.wedge())
        {
            // Halfway there the ring is as much shorter
            Ft -= narrowing(f)
               *(Ft + 0.5*face.S/face.dc*(s.f[P] & t));
        }
    }

    return Fn*n + Ft*t;
}


Foam::scalar Foam::viscousForce::coupleOnFace
(
    const operatorState& s,
    const label f
) const
{
    const planarFace& face = mesh_[f];
    const label P = face.own, N = face.nei;
    scalar d = s.omega[N] - s.omega[P];

    if (mesh_.leans(f))
    {
        d += (face.k()/face.dc)
          & (face.w*s.gradOmega[P] + (1 - face.w)*s.gradOmega[N]);
    }
    return K_.rotation(f).Km*d;
}


Foam::scalar Foam::viscousForce::coupleOnWall
(
    const operatorState& s,
    const label f,
    const bool driven
) const
{
    const planarFace& face = mesh_[f];
    const label i = mesh_.boundaryOf(f);
    const label P = face.own;

    if (!boundary_.rotationFixed(i))
    {
        if (!(K_.M(P) > 0))
        {
            return 0;
        }

        // Reduced as M on faces, for what their correction leaves at its end
        const scalar es = K_.es(P);
        const scalar kappa = es*(4*es + K_.eta(P))/(6*(K_.eta(P) + es));

        return
            boundary_.coupleLaw(i, driven, s.normal)(s.omega[face.nei])
           *face.S/(1 + 4*kappa/(K_.M(P)*sqr(face.dc)));
    }

    // The difference is the gradient halfway to the wall; the moment balance
    // M omega,nn = 4 etaC s takes it to the wall
    scalar d = s.omega[face.nei] - s.omega[P];
    if (mesh_.leans(f))
    {
        d += (face.k()/face.dc) & s.gradOmega[P];
    }

    const scalar C =
        K_.rotation(f).Km*d
      + 2*K_.etaC(P)*s.relativeRotation(P)*face.S/face.dc;
    if (!mesh_.wedge())
    {
        return C;
    }

    // Halfway there the ring is as much shorter, and between there and the
    // wall is a couple stress around the axis
    const scalar around = 0.5*(s.omega[P] + s.omega[face.nei]);
    return
        C
      - narrowing(f)*K_.rotation(f).Km*d
      + 0.5*face.S/face.dc*K_.M(P)*around/sqr(mesh_.radius(face.nei));
}


// ************************************************************************* //
