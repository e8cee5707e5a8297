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

#include "hessenberg.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::hessenberg::solveTriangular(scalarList& y) const
{
    for (label i = n_ - 1; i >= 0; --i)
    {
        for (label j = i + 1; j < n_; ++j)
        {
            y[i] -= R_(i, j)*y[j];
        }
        y[i] /= R_(i, i);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::hessenberg::hessenberg(const label most, const scalar beta)
:
    R_(most, most),
    cosine_(most, Zero),
    sine_(most, Zero),
    g_(most + 1, Zero),
    n_(0)
{
    g_[0] = beta;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::hessenberg::add(scalarList& h, const scalar rest)
{
    const label k = n_;

    for (label i = 0; i < k; ++i)
    {
        const scalar hi = h[i];
        h[i] = cosine_[i]*hi + sine_[i]*h[i + 1];
        h[i + 1] = -sine_[i]*hi + cosine_[i]*h[i + 1];
    }
    const scalar length = Foam::sqrt(sqr(h[k]) + sqr(rest));
    if (!(length > 0))
    {
        return false;
    }
    cosine_[k] = h[k]/length;
    sine_[k] = rest/length;
    h[k] = length;
    g_[k + 1] = -sine_[k]*g_[k];
    g_[k] *= cosine_[k];

    for (label i = 0; i <= k; ++i)
    {
        R_(i, k) = h[i];
    }
    ++n_;
    return true;
}


Foam::scalarList Foam::hessenberg::solution() const
{
    scalarList y(SubList<scalar>(g_, n_));
    solveTriangular(y);
    return y;
}


Foam::scalar Foam::hessenberg::smallest()
{
    scalarList& y = least_;
    y.setSize(n_, 1);
    scalar length = Foam::sqrt(sumSqr(y));

    for (label step = 0; step < 2; ++step)
    {
        for (scalar& yi : y)
        {
            yi /= length;
        }

        // R^T R times the next is this one
        for (label i = 0; i < n_; ++i)
        {
            for (label j = 0; j < i; ++j)
            {
                y[i] -= R_(j, i)*y[j];
            }
            y[i] /= R_(i, i);
        }
        solveTriangular(y);
        length = Foam::sqrt(sumSqr(y));
    }
    return 1/Foam::sqrt(length);
}


// ************************************************************************* //
