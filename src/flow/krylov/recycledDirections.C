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

#include "recycledDirections.H"
#include "ListOps.H"
#include "SVD.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Singular value below which a direction is slow. The image of each takes a
//- quarter of an iteration of the next solve
static const Foam::scalar slow = 0.2;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::recycledDirections::readMost(const dictionary& controls)
{
    const label most = controls.getOrDefault<label>("nRecycled", 6);
    if (most < 0)
    {
        FatalIOErrorInFunction(controls)
            << "Entry 'nRecycled' is " << most << nl
            << "    Allowed: 0 and above" << exit(FatalIOError);
    }
    return most;
}


void Foam::recycledDirections::combine
(
    const RectangularMatrix<scalar>& columns,
    const labelUList& which,
    const directionSet& z
)
{
    const label nBefore = size(), n = columns.m() - nBefore;
    scalarList before(nBefore), now(n);
    directionSet next(which.size());

    forAll(which, i)
    {
        forAll(before, j)
        {
            before[j] = columns(j, which[i])*s_[j];
        }
        forAll(now, j)
        {
            now[j] = columns(nBefore + j, which[i]);
        }
        next[i] = scalarField(z[0].size(), Zero);
        u_.add(before, next[i]);
        z.add(now, next[i]);
    }
    forAll(which, i)
    {
        u_[i].transfer(next[i]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::recycledDirections::recycledDirections(const dictionary& controls)
:
    most_(readMost(controls)),
    u_(most_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::recycledDirections::forget()
{
    s_.clear();
    G_.clear();
}


void Foam::recycledDirections::renew(const directionSet& z)
{
    if (!G_.m())
    {
        return;
    }

    const SVD svd(G_);
    labelList order;
    sortedOrder(svd.S(), order);
    label nSlow = 0;
    while
    (
        nSlow < min(most_, order.size()) && svd.S()[order[nSlow]] < slow
    )
    {
        ++nSlow;
    }
    combine(svd.V(), SubList<label>(order, nSlow), z);
    G_.clear();

    s_.setSize(nSlow);
    forAll(s_, i)
    {
        s_[i] = svd.S()[order[i]];
    }
}


void Foam::recycledDirections::normalise
(
    const label j,
    const label n,
    const scalarUList& h,
    const scalar length
)
{
    scalarField& u = u_[j];
    u_.add(-scalarField(SubList<scalar>(h, n)), u);
    u /= length;
    if (n < j)
    {
        u_[n].transfer(u);
    }
    s_[n] = length;
}


void Foam::recycledDirections::start(const label n, const label nColumns)
{
    s_.setSize(n);
    B_ = RectangularMatrix<scalar>(n, nColumns, Zero);
}


void Foam::recycledDirections::setColumn(const label i, const scalarUList& h)
{
    forAll(s_, j)
    {
        B_(j, i) = h[j];
    }
}


void Foam::recycledDirections::add(const scalarUList& h, scalarField& x) const
{
    u_.add(SubList<scalar>(h, size()), x);
}


void Foam::recycledDirections::add
(
    const scalarUList& y,
    const directionSet& z,
    scalarField& x
) const
{
    scalarList h(size(), Zero);
    forAll(h, i)
    {
        forAll(y, j)
        {
            h[i] -= B_(i, j)*y[j];
        }
    }
    z.add(y, x);
    u_.add(h, x);
}


void Foam::recycledDirections::keep(const hessenberg& problem)
{
    if (!most_)
    {
        return;
    }

    const label nBefore = size(), n = problem.size();
    G_ = RectangularMatrix<scalar>(nBefore + n, nBefore + n, Zero);

    forAll(s_, i)
    {
        G_(i, i) = s_[i];
        for (label j = 0; j < n; ++j)
        {
            G_(i, nBefore + j) = B_(i, j);
        }
    }
    for (label i = 0; i < n; ++i)
    {
        for (label j = i; j < n; ++j)
        {
            G_(nBefore + i, nBefore + j) = problem.R(i, j);
        }
    }
}


// ************************************************************************* //
