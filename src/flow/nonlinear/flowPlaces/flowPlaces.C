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

#include "flowPlaces.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::flowPlaces::setHoop
(
    placeRates& at,
    const operatorState& s,
    const vector2D& u,
    const scalar r
) const
{
    at.hoop = (u & system_.faces().radial())/r;
    at.around = s.gradOmega.size() ? at.omega/r : 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowPlaces::flowPlaces(const cosseratSystem& system)
:
    system_(system),
    oneSided_(system.faces().nFaces(), false)
{
    for (const label f : system.faces().oneSided())
    {
        oneSided_[f] = true;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::placeRates Foam::flowPlaces::cell
(
    const operatorState& s,
    const label celli
) const
{
    placeRates at
    {
        s.G[celli],
        s.gradOmega.size() ? s.gradOmega[celli] : vector2D(Zero),
        system_.cosserat() && !system_.rotationUndetermined(celli)
      ? s.omega[celli] : 0.5*s.curl(celli),
        s.p[celli], 0, 0
    };
    if (system_.faces().axial().active())
    {
        setHoop(at, s, s.u[celli], system_.faces().radius(celli));
    }
    return at;
}


Foam::placeRates Foam::flowPlaces::face
(
    const operatorState& s,
    const label f
) const
{
    const planarFace& face = system_.faces()[f];
    const label P = face.own, N = face.nei;
    const vector2D& n = face.n;

    placeRates at{mean(s.G, f), Zero, 0, mean(s.p, f), 0, 0};
    vector2D slope(face.dc*(s.u[N] - s.u[P]));
    if (system_.faces().nonOrthogonal())
    {
        slope += face.k() & at.G;
    }
    at.G += n*(slope - (n & at.G));

    if (s.gradOmega.size())
    {
        at.omega =
            oneSided_[f] ? 0.5*(s.omega[P] + s.omega[N]) : mean(s.omega, f);
        at.gradOmega = mean(s.gradOmega, f);
        scalar bend = face.dc*(s.omega[N] - s.omega[P]);
        if (system_.faces().nonOrthogonal())
        {
            bend += face.k() & at.gradOmega;
        }
        at.gradOmega += (bend - (n & at.gradOmega))*n;
    }
    if (system_.faces().axial().active())
    {
        const faceGeometry& mesh = system_.faces();
        const scalar w = oneSided_[f] ? 0.5 : face.w;
        setHoop
        (
            at, s, w*s.u[P] + (1 - w)*s.u[N],
            w*mesh.radius(P) + (1 - w)*mesh.radius(N)
        );
    }
    return at;
}


Foam::placeForm Foam::flowPlaces::form
(
    const placeRates& at,
    const scalar q,
    const scalar b,
    const scalar byRate,
    const scalar byPressure
)
{
    // Of Gamma^2 = 2 D:D + 4 q s^2 + b |grad omega|^2, D without its trace
    tensor2D D(0.5*(at.G + at.G.T()));
    const scalar mean = 0.5*(D.xx() + D.yy() + at.hoop);
    D.xx() -= mean;
    D.yy() -= mean;

    placeForm form
    {
        4*byRate*D,
        2*b*byRate*at.gradOmega,
        8*q*byRate*at.relativeRotation(),
        byPressure,
        6*byRate*at.hoop,
        2*b*byRate*at.around
    };
    // By the mean that is taken away
    form.byG.xx() += 2*byRate*at.hoop;
    form.byG.yy() += 2*byRate*at.hoop;
    form.byG.xy() -= 0.5*form.byOmega;
    form.byG.yx() += 0.5*form.byOmega;

    return form;
}


// ************************************************************************* //
