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

#include "cornerFlow.H"
#include "scalarList.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Range in which exponents are looked for
static const Foam::scalar lowestLambda = 0.004, highestLambda = 0.85;

//- Points of that: half of them in geometric steps, from slow slides on
static const Foam::label nPoints = 240;

//- Half the distance of two exponents that stand for a double one
static const Foam::scalar halfWidth = 0.02;

//- Imaginary parts: of what is a double zero, and the largest looked for
static const Foam::scalar smallestImaginary = 1e-3, largestImaginary = 0.6;

//- Zeros nearer than this are a double one
static const Foam::scalar smallestDistance = 1e-4;

//- Conditions at a double zero over those beside it, where any state fulfils
//- them
static const Foam::scalar smallConditions = 1e-4;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cornerFlow::solve(rows& A, state& b)
{
    for (label k = 0; k < 4; ++k)
    {
        label pivot = k;
        for (label i = k + 1; i < 4; ++i)
        {
            if (std::abs(A[i][k]) > std::abs(A[pivot][k]))
            {
                pivot = i;
            }
        }
        std::swap(A[k], A[pivot]);
        std::swap(b[k], b[pivot]);

        for (label i = k + 1; i < 4; ++i)
        {
            const number factor = A[i][k]/A[k][k];
            for (label j = k; j < 4; ++j)
            {
                A[i][j] -= factor*A[k][j];
            }
            b[i] -= factor*b[k];
        }
    }
    for (label k = 3; k >= 0; --k)
    {
        for (label j = k + 1; j < 4; ++j)
        {
            b[k] -= A[k][j]*b[j];
        }
        b[k] /= A[k][k];
    }
}


Foam::cornerFlow::rows Foam::cornerFlow::stateRows
(
    const number lambda,
    const label k,
    const scalar theta
) const
{
    const scalar eta = sectors_[k].eta/scale_;
    const scalar etaC = sectors_[k].etaC/scale_;
    const scalar mu = eta + etaC;
    const number m[] = {lambda + 1.0, lambda - 1.0};
    rows R;

    for (label i = 0; i < 4; ++i)
    {
        // cos, sin of (lambda + 1) theta, then of (lambda - 1) theta
        const number a = m[i/2];
        const number c = std::cos(a*theta), s = std::sin(a*theta);
        const bool sine = i % 2;
        const number F = sine ? s : c;
        const number F1 = sine ? a*c : -a*s;
        const number F2 = -a*a*F, F3 = -a*a*F1;
        const number p = mu*(m[0]*m[0]*F1 + F3)/m[1];

        R[0][i] = F1;
        R[1][i] = -m[0]*F;
        R[2][i] = -p - 2*eta*lambda*F1;
        R[3][i] = mu*(F2 + m[0]*F) - (eta - etaC)*m[0]*lambda*F;
    }

    return R;
}


Foam::FixedList<Foam::List<Foam::cornerFlow::state>, 2>
Foam::cornerFlow::carried(const number lambda) const
{
    FixedList<List<state>, 2> coeffs;

    for (label free = 0; free < 2; ++free)
    {
        // Free are sigma_tt, and sigma_tr or u_r
        state y(number(0));
        y[free == 0 ? 2 : holds_[0] ? 3 : 0] = 1;
        coeffs[free].setSize(sectors_.size());

        forAll(sectors_, k)
        {
            rows R(stateRows(lambda, k, 0));
            state& c = coeffs[free][k];
            c = y;
            solve(R, c);

            const rows E(stateRows(lambda, k, sectors_[k].end - start(k)));
            for (label i = 0; i < 4; ++i)
            {
                y[i] = 0;
                for (label j = 0; j < 4; ++j)
                {
                    y[i] += E[i][j]*c[j];
                }
            }
        }
    }

    return coeffs;
}


Foam::cornerFlow::state
Foam::cornerFlow::conditions(const number lambda) const
{
    const FixedList<List<state>, 2> coeffs(carried(lambda));
    const label last = sectors_.size() - 1;
    const rows E
    (
        stateRows(lambda, last, sectors_[last].end - start(last))
    );
    const label which[] = {1, holds_[1] ? 0 : 3};

    state B(number(0));
    for (label i = 0; i < 2; ++i)
    {
        for (label free = 0; free < 2; ++free)
        {
            for (label j = 0; j < 4; ++j)
            {
                B[2*i + free] += E[which[i]][j]*coeffs[free][last][j];
            }
        }
    }

    return B;
}


Foam::cornerFlow::number
Foam::cornerFlow::determinant(const number lambda) const
{
    const state B(conditions(lambda));
    return B[0]*B[3] - B[1]*B[2];
}


Foam::scalar Foam::cornerFlow::determinant(const scalar lambda) const
{
    return determinant(number(lambda)).real();
}


Foam::scalar Foam::cornerFlow::bisected(scalar a, scalar b) const
{
    const bool positive = determinant(a) > 0;
    while (b - a > 1e-13)
    {
        const scalar middle = 0.5*(a + b);
        ((determinant(middle) > 0) == positive ? a : b) = middle;
    }
    return 0.5*(a + b);
}


Foam::scalar Foam::cornerFlow::lowest(scalar a, scalar b) const
{
    const scalar golden = 0.5*(Foam::sqrt(5.0) - 1);
    scalar c = b - golden*(b - a), d = a + golden*(b - a);
    scalar fc = mag(determinant(c)), fd = mag(determinant(d));

    while (b - a > 1e-9)
    {
        if (fc < fd)
        {
            b = d;
            d = c;
            fd = fc;
            c = b - golden*(b - a);
            fc = mag(determinant(c));
        }
        else
        {
            a = c;
            c = d;
            fc = fd;
            d = a + golden*(b - a);
            fd = mag(determinant(d));
        }
    }
    return 0.5*(a + b);
}


Foam::cornerFlow::number
Foam::cornerFlow::complexZero(const number guess) const
{
    // Secants
    number a = guess, b = guess + number(1e-3, 1e-3);
    number fa = determinant(a), fb = determinant(b);
    for (label i = 0; i < 40 && std::abs(b - a) > 1e-12 && fb != fa; ++i)
    {
        const number c = b - fb*(b - a)/(fb - fa);
        a = b;
        fa = fb;
        b = c;
        fb = determinant(b);
    }
    return b;
}


void Foam::cornerFlow::addMode
(
    const number lambda,
    const FixedList<number, 2>& shares,
    const bool imaginary
)
{
    const FixedList<List<state>, 2> coeffs(carried(lambda));
    mode m;
    m.lambda = lambda;
    m.imaginary = imaginary;
    m.coeffs.setSize(sectors_.size());
    forAll(sectors_, k)
    {
        for (label j = 0; j < 4; ++j)
        {
            m.coeffs[k][j] =
                shares[0]*coeffs[0][k][j] + shares[1]*coeffs[1][k][j];
        }
    }
    modes_.append(m);
}


void Foam::cornerFlow::addMode(const scalar lambda)
{
    // What B leaves least of: eigenvector of B'B
    const state B(conditions(lambda));
    const scalar B0 = B[0].real(), B1 = B[1].real();
    const scalar B2 = B[2].real(), B3 = B[3].real();
    const scalar a = sqr(B0) + sqr(B2), b = B0*B1 + B2*B3;
    const scalar c = sqr(B1) + sqr(B3);
    const scalar angle = 0.5*Foam::atan2(-2*b, c - a);

    FixedList<number, 2> shares;
    shares[0] = Foam::cos(angle);
    shares[1] = Foam::sin(angle);
    addMode(lambda, shares, false);
}


void Foam::cornerFlow::addComplexModes(const number lambda)
{
    const state B(conditions(lambda));
    const label row =
        std::abs(B[0]) + std::abs(B[1]) > std::abs(B[2]) + std::abs(B[3])
      ? 0 : 2;
    FixedList<number, 2> shares;
    shares[0] = -B[row + 1];
    shares[1] = B[row];
    addMode(lambda, shares, false);
    addMode(lambda, shares, true);
}


void Foam::cornerFlow::addPair(const scalar lambda)
{
    const state here(conditions(lambda));
    const state beside(conditions(lambda + halfWidth));
    scalar size = 0, sizeBeside = 0;
    for (label i = 0; i < 4; ++i)
    {
        size += std::norm(here[i]);
        sizeBeside += std::norm(beside[i]);
    }

    if (size < sqr(smallConditions)*sizeBeside)
    {
        for (label free = 0; free < 2; ++free)
        {
            FixedList<number, 2> shares(number(0));
            shares[free] = 1;
            addMode(lambda, shares, false);
        }
    }
    else
    {
        addMode(lambda - halfWidth);
        addMode(lambda + halfWidth);
    }
}


void Foam::cornerFlow::search()
{
    scalarList lambda(nPoints + 1), det(nPoints + 1);
    forAll(lambda, i)
    {
        const scalar x = 2*scalar(i)/nPoints;
        const scalar turn = 0.1;
        lambda[i] =
            x < 1
          ? lowestLambda*Foam::pow(turn/lowestLambda, x)
          : turn + (x - 1)*(highestLambda - turn);
        det[i] = determinant(lambda[i]);
    }

    for (label i = 1; i <= nPoints && modes_.size() < maxModes; ++i)
    {
        if ((det[i] > 0) != (det[i - 1] > 0))
        {
            addMode(bisected(lambda[i - 1], lambda[i]));
        }
        else if
        (
            i < nPoints
         && (det[i + 1] > 0) == (det[i] > 0)
         && mag(det[i]) <= mag(det[i - 1])
         && mag(det[i]) <= mag(det[i + 1])
        )
        {
            const scalar l = lowest(lambda[i - 1], lambda[i + 1]);
            const scalar d = determinant(l);
            const bool crosses = (d > 0) != (det[i] > 0);
            const scalar first = crosses ? bisected(lambda[i - 1], l) : l;
            const scalar second = crosses ? bisected(l, lambda[i + 1]) : l;

            if (second - first > smallestDistance)
            {
                addMode(first);
                addMode(second);
            }
            else
            {
                // Squares of the distance, from the real axis, of zeros of
                // a parabola through three points
                const scalar h0 = lambda[i - 1] - l, h1 = lambda[i + 1] - l;
                const scalar curvature =
                    ((det[i - 1] - d)/h0 - (det[i + 1] - d)/h1)/(h0 - h1);
                const scalar square = d/curvature;
                if (square < sqr(smallestImaginary))
                {
                    addPair(l);
                }
                else if (square < sqr(largestImaginary))
                {
                    const number zero
                    (
                        complexZero(number(l, Foam::sqrt(square)))
                    );
                    if
                    (
                        zero.real() > lowestLambda
                     && zero.real() < highestLambda
                    )
                    {
                        addComplexModes(zero);
                    }
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cornerFlow::cornerFlow
(
    const List<sector>& sectors,
    const bool firstHolds,
    const bool secondHolds
)
:
    sectors_(sectors),
    scale_(0)
{
    holds_[0] = firstHolds;
    holds_[1] = secondHolds;
    for (const sector& s : sectors_)
    {
        scale_ = max(scale_, s.eta + s.etaC);
    }
    search();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cornerFlow::evaluate
(
    const label modei,
    const scalar r,
    const scalar theta,
    scalar& ur,
    scalar& ut,
    scalar& p
) const
{
    label k = 0;
    while (k < sectors_.size() - 1 && theta > sectors_[k].end)
    {
        ++k;
    }

    const mode& m = modes_[modei];
    const scalar mu = sectors_[k].eta + sectors_[k].etaC;
    const scalar angle = theta - start(k);
    const number plus = m.lambda + 1.0, minus = m.lambda - 1.0;
    number F = 0, F1 = 0, F3 = 0;

    for (label i = 0; i < 4; ++i)
    {
        const number a = i < 2 ? plus : minus;
        const number c = std::cos(a*angle), s = std::sin(a*angle);
        const number f1 = i % 2 ? a*c : -a*s;
        F += m.coeffs[k][i]*(i % 2 ? s : c);
        F1 += m.coeffs[k][i]*f1;
        F3 -= m.coeffs[k][i]*a*a*f1;
    }

    const number power = std::exp(m.lambda*Foam::log(r));
    auto part = [&](const number& z)
    {
        return m.imaginary ? z.imag() : z.real();
    };
    ur = part(power*F1);
    ut = part(-plus*power*F);
    p = part(power/r*mu*(plus*plus*F1 + F3)/minus);
}


// ************************************************************************* //
