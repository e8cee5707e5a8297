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

#include "directionSet.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- In four sums, which the processor adds up side by side
static Foam::scalar product
(
    const Foam::scalar* a,
    const Foam::scalar* x,
    const Foam::label n
)
{
    Foam::scalar s[4] = {0, 0, 0, 0};
    Foam::label i = 0;
    for (; i + 4 <= n; i += 4)
    {
        s[0] += a[i]*x[i];
        s[1] += a[i + 1]*x[i + 1];
        s[2] += a[i + 2]*x[i + 2];
        s[3] += a[i + 3]*x[i + 3];
    }
    for (; i < n; ++i)
    {
        s[0] += a[i]*x[i];
    }
    return (s[0] + s[1]) + (s[2] + s[3]);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::directionSet::products(const scalarField& x, scalarList& p) const
{
    const label n = p.size() - 1;
    p = Zero;

    for (label start = 0; start < x.size(); start += nChunk)
    {
        const label size = min(nChunk, x.size() - start);
        const scalar* xs = x.cdata() + start;

        for (label i = 0; i < n; ++i)
        {
            p[i] += product(v_[i].cdata() + start, xs, size);
        }
        p[n] += product(xs, xs, size);
    }
}


void Foam::directionSet::add(const scalarUList& coeffs, scalarField& x) const
{
    for (label start = 0; start < x.size(); start += nChunk)
    {
        const label size = min(nChunk, x.size() - start);
        scalar* xs = x.data() + start;

        forAll(coeffs, i)
        {
            const scalar c = coeffs[i];
            const scalar* v = v_[i].cdata() + start;
            for (label j = 0; j < size; ++j)
            {
                xs[j] += c*v[j];
            }
        }
    }
}


// ************************************************************************* //
