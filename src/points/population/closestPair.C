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

#include "closestPair.H"
#include "cellSurroundings.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::closestPair::lost(const label i, const label j) const
{
    const materialPoint& a = *points_[i];
    const materialPoint& b = *points_[j];

    return
        a.volume() + b.volume() <= largest_ && sameKind(a, b)
      ? spread(a, b, magSqr(places_[i] - places_[j]))
      : GREAT;
}


void Foam::closestPair::findPartner(const label i)
{
    partner_[i] = -1;
    lost_[i] = GREAT;
    for (label j = 0; j < i; ++j)
    {
        const scalar s = lost(i, j);
        if (cellSurroundings::more*s < lost_[i])
        {
            lost_[i] = s;
            partner_[i] = j;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::closestPair::closestPair
(
    const polyMesh& mesh,
    const DynamicList<materialPoint*>& points,
    const scalar largest
)
:
    mesh_(mesh),
    points_(points),
    largest_(largest),
    places_(points.size()),
    partner_(points.size()),
    lost_(points.size())
{
    forAll(points_, i)
    {
        places_.append(points_[i]->position(mesh_));
        partner_.append(-1);
        lost_.append(GREAT);
        findPartner(i);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::closestPair::later() const
{
    label best = -1;
    scalar least = GREAT;
    forAll(lost_, i)
    {
        if (cellSurroundings::more*lost_[i] < least)
        {
            least = lost_[i];
            best = i;
        }
    }

    return best;
}


void Foam::closestPair::update(const label stays, const label goes)
{
    const label moved = stays > goes ? stays - 1 : stays;
    places_[stays] = points_[moved]->position(mesh_);

    // The list has closed up behind the one that left
    label n = 0;
    forAll(partner_, i)
    {
        if (i != goes)
        {
            const label p = partner_[i];
            places_[n] = places_[i];
            lost_[n] = lost_[i];
            partner_[n] = p == goes ? n : (p > goes ? p - 1 : p);
            ++n;
        }
    }
    places_.setSize(n);
    lost_.setSize(n);
    partner_.setSize(n);

    // New partners of the one that moved, of those that had one of the two, and
    // of those that it came near to
    for (label i = 0; i < n; ++i)
    {
        const scalar s = i > moved ? lost(i, moved) : GREAT;
        if
        (
            i == moved || partner_[i] == i || partner_[i] == moved
         || (s < GREAT && s < cellSurroundings::more*lost_[i])
        )
        {
            findPartner(i);
        }
    }
}


// ************************************************************************* //
