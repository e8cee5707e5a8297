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

#include "cornerDefect.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Steps towards F, share of each, and the last one over F
static const Foam::label nSteps = 200;
static const Foam::scalar shareOfStep = 0.7, lastStep = 1e-9;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarRectangularMatrix Foam::cornerDefect::weighted() const
{
    scalarRectangularMatrix Ws(nUnknowns(), nModes(), Zero);
    forAll(W_, i)
    {
        for (label a = 0; a < nModes(); ++a)
        {
            Ws(3*(i/2) + i % 2, a) = W_[i]*s(i, a);
        }
    }
    return Ws;
}


Foam::scalarSquareMatrix Foam::cornerDefect::inner
(
    const scalarRectangularMatrix& Ws,
    const scalarRectangularMatrix& sK
) const
{
    scalarSquareMatrix AK(nUnknowns(), Zero);
    for (label i = 0; i < nUnknowns(); ++i)
    {
        for (label k = 0; k < nUnknowns(); ++k)
        {
            AK(i, k) = A(i, k);
            for (label a = 0; a < nModes(); ++a)
            {
                AK(i, k) -= Ws(i, a)*sK(a, k);
            }
        }
    }
    return AK;
}


Foam::scalarSquareMatrix Foam::cornerDefect::left
(
    const scalarRectangularMatrix& Ws,
    const scalarSquareMatrix& F
) const
{
    // K s = W s F since s' W s = 1
    scalarRectangularMatrix sK(nModes(), nUnknowns(), Zero);
    for (label i = 0; i < nUnknowns(); ++i)
    {
        for (label a = 0; a < nModes(); ++a)
        {
            for (label b = 0; b < nModes(); ++b)
            {
                sK(a, i) += F(a, b)*Ws(i, b);
            }
        }
    }
    const scalarSquareMatrix AK(inner(Ws, sK));

    scalarSquareMatrix d(nModes(), Zero);
    for (label b = 0; b < nModes(); ++b)
    {
        // What the cells around change of s
        scalarSquareMatrix M(AK);
        scalarList y(nUnknowns());
        forAll(y, i)
        {
            y[i] = sK(b, i) - As(i, b);
        }
        LUsolve(M, y);

        for (label a = 0; a < nModes(); ++a)
        {
            d(a, b) = sAs(a, b) - F(a, b);
            forAll(y, i)
            {
                d(a, b) += (sA(a, i) - sK(a, i))*y[i];
            }
        }
    }
    return d;
}


Foam::scalar Foam::cornerDefect::add
(
    const scalarSquareMatrix& d,
    scalarSquareMatrix& F
)
{
    scalar change = 0, size = 0;
    for (label a = 0; a < F.m(); ++a)
    {
        for (label b = 0; b <= a; ++b)
        {
            const scalar dF = 0.5*shareOfStep*(d(a, b) + d(b, a));
            F(a, b) += dF;
            F(b, a) = F(a, b);
            change = max(change, mag(dF));
            size = max(size, mag(F(a, b)));
        }
    }
    return change/max(size, VSMALL);
}


void Foam::cornerDefect::keepPositive(scalarSquareMatrix& F)
{
    if (F.m() == 1)
    {
        F(0, 0) = max(F(0, 0), scalar(0));
    }
    else if (F.m() == 2)
    {
        const scalar mean = 0.5*(F(0, 0) + F(1, 1));
        const scalar half = 0.5*(F(0, 0) - F(1, 1));
        const scalar radius = Foam::hypot(half, F(0, 1));
        const scalar low = mean - radius, high = mean + radius;

        if (high <= 0)
        {
            F = Zero;
        }
        else if (low < 0)
        {
            // high times the projection on its direction
            const scalar f = high/(2*radius);
            F(0, 0) = f*(radius + half);
            F(1, 1) = f*(radius - half);
            F(0, 1) *= f;
            F(1, 0) *= f;
        }
    }
}


Foam::scalarSquareMatrix Foam::cornerDefect::balanced() const
{
    const scalarRectangularMatrix Ws(weighted());
    scalarSquareMatrix F(nModes(), Zero);
    for (label a = 0; a < nModes(); ++a)
    {
        for (label b = 0; b < nModes(); ++b)
        {
            F(a, b) = 0.5*(sAs(a, b) + sAs(b, a));
        }
    }
    const scalarSquareMatrix first(F);

    for (label step = 0; step < nSteps; ++step)
    {
        if (add(left(Ws, F), F) <= lastStep)
        {
            return F;
        }
    }

    return first;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cornerDefect::reset
(
    const UList<cornerFlow::sector>& sectors,
    const label nModes
)
{
    W_.setSize(2*sectors.size());
    forAll(W_, i)
    {
        W_[i] = sectors[i/2].eta + sectors[i/2].etaC;
    }

    const label nUnknowns = 3*sectors.size();
    sAs = scalarRectangularMatrix(nModes, nModes, Zero);
    As = scalarRectangularMatrix(nUnknowns, nModes, Zero);
    A = scalarRectangularMatrix(nUnknowns, nUnknowns, Zero);
    sA = scalarRectangularMatrix(nModes, nUnknowns, Zero);
}


Foam::scalarSquareMatrix Foam::cornerDefect::shape() const
{
    scalarSquareMatrix F(balanced());
    keepPositive(F);

    const label n = W_.size();
    scalarSquareMatrix K(n, Zero);
    for (label i = 0; i < n; ++i)
    {
        for (label k = 0; k < n; ++k)
        {
            const scalar W = Foam::sqrt(W_[i]*W_[k]);
            for (label a = 0; a < F.m(); ++a)
            {
                for (label b = 0; b < F.m(); ++b)
                {
                    K(i, k) += W*s(i, a)*F(a, b)*s(k, b);
                }
            }
        }
    }
    return K;
}


// ************************************************************************* //
