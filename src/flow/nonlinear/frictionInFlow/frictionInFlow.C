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

#include "frictionInFlow.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::frictionInFlow::normal
(
    const operatorState& s
) const
{
    const faceGeometry& mesh = system_.faces();
    tmp<scalarField> tN(new scalarField(s.normal.size(), Zero));

    for (const label f : mesh.oneSided())
    {
        const planarFace& face = mesh[f];
        tN.ref()[mesh.boundaryOf(f)] =
            system_.pressure().onWall(s, face.nei, true)
          - (system_.viscous().onWall(s, f, true) & face.n)/face.S;
    }
    return tN;
}


Foam::scalar Foam::frictionInFlow::slide
(
    const operatorState& s,
    const label i
) const
{
    const faceGeometry& mesh = system_.faces();
    return s.u[i + mesh.nCells()] & mesh[mesh.nInternal() + i].t();
}


Foam::scalar Foam::frictionInFlow::see
(
    wallFriction& wall,
    const scalar motion,
    const scalar compliance,
    const scalar N
) const
{
    const scalar before = wall.present()(motion);
    const scalar free = motion - compliance*before;
    wall.see(motion, N, relaxed_);
    const scalar off = mag(wall.present()(motion) - before);

    wall.see(wall.motion(free, compliance, N, relaxed_), N, relaxed_);
    return off;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::frictionInFlow::frictionInFlow
(
    const cosseratSystem& system,
    flowBoundary& boundary
)
:
    system_(system),
    boundary_(boundary),
    relaxed_(1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::frictionInFlow::start()
{
    for (const label i : boundary_.slidingAt())
    {
        boundary_.sliding(i).rest();
    }
    for (const label i : boundary_.rollingAt())
    {
        boundary_.rolling(i).rest();
    }
}


Foam::scalar Foam::frictionInFlow::see(const operatorState& s)
{
    if (!active())
    {
        return 0;
    }

    const faceGeometry& mesh = system_.faces();
    const viscousCoefficients& K = system_.coefficients();
    const scalarField N(normal(s));
    scalar off = 0, largest = 0, offCouple = 0, largestCouple = 0;

    for (const label i : boundary_.slidingAt())
    {
        const label f = mesh.nInternal() + i;
        const label P = mesh[f].own;
        wallFriction& wall = boundary_.sliding(i);
        const scalar compliance =
            K.wallGain(f, 0)/(mesh[f].dc*K.a(P));
        off = max(off, see(wall, slide(s, i), compliance, N[i]));
        largest = max(largest, wall.limit(N[i]));
    }
    for (const label i : boundary_.rollingAt())
    {
        const label f = mesh.nInternal() + i;
        const scalar M = K.M(mesh[f].own);
        wallFriction& wall = boundary_.rolling(i);
        if (M > 0)
        {
            const scalar compliance = 1/(M*mesh[f].dc);
            offCouple =
                max(offCouple, see(wall, roll(s, i), compliance, N[i]));
            largestCouple = max(largestCouple, wall.limit(N[i]));
        }
    }

    for (scalar* value : {&off, &largest, &offCouple, &largestCouple})
    {
        reduce(*value, maxOp<scalar>());
    }
    return max
    (
        off/max(largest, VSMALL), offCouple/max(largestCouple, VSMALL)
    );
}


void Foam::frictionInFlow::linearise
(
    const operatorState& s,
    const bool derivatives
)
{
    if (!active())
    {
        return;
    }

    const scalarField N(normal(s));
    for (const label i : boundary_.slidingAt())
    {
        boundary_.sliding(i).linearise
        (
            slide(s, i), N[i], relaxed_, derivatives
        );
    }
    for (const label i : boundary_.rollingAt())
    {
        boundary_.rolling(i).linearise
        (
            roll(s, i), N[i], relaxed_, derivatives
        );
    }
}


// ************************************************************************* //
