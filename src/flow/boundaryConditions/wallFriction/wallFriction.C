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

#include "wallFriction.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::wallFriction::set
(
    const scalar adhesion,
    const scalar mu,
    const scalar rate,
    const scalar wall
)
{
    adhesion_ = adhesion;
    mu_ = mu;
    rate_ = rate;
    wall_ = wall;
}


Foam::scalar Foam::wallFriction::motion
(
    const scalar free,
    const scalar compliance,
    const scalar N,
    const scalar relaxed
) const
{
    // slip + most slip/sqrt(slip^2 + rate^2) = way. Newton's method from the
    // left of the root, where the left side is concave: it stays there
    const scalar rate = relaxed*rate_;
    const scalar most = compliance*limit(N);
    const scalar way = mag(free - wall_);
    scalar slip = max(way - most, scalar(0));

    for (label i = 0; i < 100; ++i)
    {
        const scalar length = Foam::sqrt(sqr(slip) + sqr(rate));
        const scalar left = way - slip - most*slip/length;
        const scalar change = left/(1 + most*sqr(rate)/pow3(length));
        slip += change;
        if (mag(change) <= SMALL*slip)
        {
            break;
        }
    }

    return wall_ + sign(free - wall_)*slip;
}


void Foam::wallFriction::see
(
    const scalar motion,
    const scalar N,
    const scalar relaxed
)
{
    const scalar length = Foam::sqrt(sqr(motion - wall_) + sqr(relaxed*rate_));
    present_.resistance = limit(N)/length;
    present_.given = present_.resistance*wall_;
}


void Foam::wallFriction::linearise
(
    const scalar motion,
    const scalar N,
    const scalar relaxed,
    const bool derivatives
)
{
    change_.resistance = present_.resistance;
    byNormal_ = 0;

    if (derivatives)
    {
        const scalar slip = motion - wall_;
        const scalar sqrLength = sqr(slip) + sqr(relaxed*rate_);
        change_.resistance *= sqr(relaxed*rate_)/sqrLength;
        byNormal_ = N > 0 ? -mu_*slip/Foam::sqrt(sqrLength) : 0;
    }
}


void Foam::wallFriction::rest()
{
    present_ = change_ = {0, 0};
    byNormal_ = 0;
}


// ************************************************************************* //
