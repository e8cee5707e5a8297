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

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::directionSet::products(const scalarField& x, scalarList& p) const
{
    const label n = p.size() - 1, size = x.size();
    const scalar* xs = x.cdata();

    label i = 0;
    for (; i + nTogether <= n; i += nTogether)
    {
        const scalar* a = v_[i].cdata();
        const scalar* b = v_[i + 1].cdata();
        const scalar* c = v_[i + 2].cdata();
        const scalar* d = v_[i + 3].cdata();
        scalar sa = 0, sb = 0, sc = 0, sd = 0;
        for (label j = 0; j < size; ++j)
        {
            const scalar xj = xs[j];
            sa += a[j]*xj;
            sb += b[j]*xj;
            sc += c[j]*xj;
            sd += d[j]*xj;
        }
        p[i] = sa;
        p[i + 1] = sb;
        p[i + 2] = sc;
        p[i + 3] = sd;
    }
    for (; i < n; ++i)
    {
        p[i] = sumProd(v_[i], x);
    }
    p[n] = sumSqr(x);
}


void Foam::directionSet::add(const scalarUList& coeffs, scalarField& x) const
{
    const label n = coeffs.size(), size = x.size();
    scalar* xs = x.data();

    label i = 0;
    for (; i + nTogether <= n; i += nTogether)
    {
        const scalar* a = v_[i].cdata();
        const scalar* b = v_[i + 1].cdata();
        const scalar* c = v_[i + 2].cdata();
        const scalar* d = v_[i + 3].cdata();
        const scalar ka = coeffs[i], kb = coeffs[i + 1];
        const scalar kc = coeffs[i + 2], kd = coeffs[i + 3];
        for (label j = 0; j < size; ++j)
        {
            xs[j] += (ka*a[j] + kb*b[j]) + (kc*c[j] + kd*d[j]);
        }
    }
    for (; i < n; ++i)
    {
        const scalar k = coeffs[i];
        const scalar* v = v_[i].cdata();
        for (label j = 0; j < size; ++j)
        {
            xs[j] += k*v[j];
        }
    }
}


// ************************************************************************* //
