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

#include "cellGradient.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellGradient::setWallRotation
(
    operatorState& s,
    const label f,
    const bool driven
) const
{
    const label i = mesh_.boundaryOf(f);
    const label P = mesh_[f].own;
    scalar& omega = s.omega[mesh_[f].nei];

    if (boundary_.rotationFixed(i))
    {
        omega = driven ? boundary_.rotation(i) : 0;
        return;
    }

    omega = s.omega[P];
    if (K_.M(P) > 0)
    {
        const wallLaw couple(boundary_.coupleLaw(i, driven, s.normal));
        omega += couple.given/(K_.M(P)*mesh_[f].dc);
        omega *= K_.rotationGain(f, couple.resistance);
    }
}


Foam::scalar Foam::cellGradient::wallSpeed
(
    const operatorState& s,
    const label f,
    const bool driven
) const
{
    // Tangential gradient such that the wall bears the traction, with
    // u_n,t = -curvature u_t. The mean of omega on the way makes it the mean
    // gradient, so the speed is of second order. turnWalls() adds what the
    // compact form leaves out
    const planarFace& face = mesh_[f];
    const label P = face.own;
    const wallLaw traction
    (
        boundary_.tractionLaw(mesh_.boundaryOf(f), driven, s.normal)
    );
    const scalar mean =
        s.omega[P] + K_.wallShare(f)*(s.omega[face.nei] - s.omega[P]);
    const scalar slope =
        (traction.given - 2*K_.es(P)*mean)/K_.a(P);

    return
        K_.wallGain(f, traction.resistance)
       *((s.u[P] & face.t()) + slope/face.dc);
}


void Foam::cellGradient::addWallSpeed
(
    operatorState& s,
    const label f,
    const scalar straight,
    const bool driven
) const
{
    const planarFace& face = mesh_[f];
    const wallLaw traction
    (
        boundary_.tractionLaw(mesh_.boundaryOf(f), driven, s.normal)
    );
    const vector2D change
    (
        K_.wallGain(f, traction.resistance)*straight*face.t()
    );

    s.u[face.nei] += change;
    s.G[face.own] += mesh_.edge(f)/mesh_.area(face.own)*(face.n*change);
}


void Foam::cellGradient::correctRotation
(
    operatorState& s,
    const label f,
    const bool driven
) const
{
    const planarFace& face = mesh_[f];
    const label i = mesh_.boundaryOf(f);
    const label P = face.own;
    const scalar d = 1/face.dc;

    // d^2 omega,nn by the moment balance
    const scalar curvature = 4*s.relativeRotation(P)*K_.resolution(P, f);

    scalar change = 0;
    if (!boundary_.rotationFixed(i))
    {
        change = -0.5*curvature;
        if (mesh_.leans(f))
        {
            change -= d*(face.k() & s.gradOmega[P]);
        }
        change *= K_.rotationGain
        (
            f, boundary_.coupleLaw(i, driven, s.normal).resistance
        );
        s.omega[face.nei] += change;
    }
    if (boundary_.velocity(i) == flowBoundary::TRACTION)
    {
        addWallSpeed
        (
            s,
            f,
            d*K_.es(P)*(curvature/6 - change)/K_.a(P),
            driven
        );
    }
}


void Foam::cellGradient::correctWalls
(
    operatorState& s,
    const bool driven
) const
{
    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        const label P = face.own;
        const scalar d = 1/face.dc;

        if (K_.cosserat() && !K_.rotationUndetermined(P))
        {
            correctRotation(s, f, driven);
        }

        // From the foot of the normal through the centre to the face centre
        if
        (
            mesh_.nonOrthogonal()
         && boundary_.velocity(mesh_.boundaryOf(f)) == flowBoundary::TRACTION
        )
        {
            addWallSpeed
            (
                s, f, -d*(face.k() & (s.G[P] & face.t())), driven
            );
        }

        // The Gauss gradient has the slopes of quarter and inner face by
        // halves; two thirds and one third are right at the centre
        const vector2D c
        (
            (s.u[face.nei] - s.u[P])/d - (face.m & s.G[P])
        );
        s.G[P] += (face.n*c)/3;
    }
}


void Foam::cellGradient::weightWalls
(
    operatorState& s,
    const UList<tensor2D>& before
) const
{
    const List<jumpWall>& walls = K_.jumpWalls();
    forAll(walls, i)
    {
        tensor2D& G = s.G[walls[i].celli];
        G = product(walls[i].after, G) - product(walls[i].before, before[i]);
    }
}


void Foam::cellGradient::turnWalls(operatorState& s, const bool driven) const
{
    for (const turningCell& cell : K_.turningCells())
    {
        // Speeds of the walls, and change of the gradient, for s = 1
        const label P = cell.celli;
        const label n = cell.walls.size();
        scalarList speed(n);
        tensor2D dG(Zero);
        for (label i = 0; i < n; ++i)
        {
            const planarFace& face = mesh_[cell.walls[i]];
            const scalar resistance =
                boundary_.tractionLaw
                (
                    mesh_.boundaryOf(cell.walls[i]), driven, s.normal
                ).resistance;
            speed[i] =
               -2*(K_.etaC(P) - K_.es(P))/(K_.a(P)*face.dc)
               *K_.wallGain(cell.walls[i], resistance);
            dG += mesh_.edge(cell.walls[i])/mesh_.area(P)
               *(face.n*(speed[i]*face.t()));
        }
        for (label i = 0; i < n; ++i)
        {
            const planarFace& face = mesh_[cell.walls[i]];
            const vector2D c(speed[i]*face.dc*face.t() - (face.m & dG));
            dG += (face.n*c)/3;
        }
        if (cell.after)
        {
            dG = product(*cell.after, dG);
        }

        // s = s_before - s curl(dG)/2
        const scalar relative =
            s.relativeRotation(P)/(1 + 0.5*(dG.xy() - dG.yx()));
        s.G[P] += relative*dG;
        for (label i = 0; i < n; ++i)
        {
            const planarFace& face = mesh_[cell.walls[i]];
            s.u[face.nei] += relative*speed[i]*face.t();
        }
    }
}


// ************************************************************************* //
