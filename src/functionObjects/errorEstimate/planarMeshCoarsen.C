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

#include "planarMesh.H"
#include "bitSet.H"
#include "DynamicList.H"

#include <deque>
#include <vector>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::planarMesh::across
(
    const label celli,
    const label sidei,
    label& other,
    label& otherSide
) const
{
    const side& s = sides_[sidei];

    if (s.partner >= 0)
    {
        otherSide = s.partner;
        other = sides_[otherSide].owner;
    }
    else
    {
        otherSide = sidei;
        other = s.owner == celli ? s.neighbour : s.owner;
    }
}


Foam::boolList Foam::planarMesh::keptSides() const
{
    enum : char { UNKNOWN, KEPT, GONE };
    std::vector<char> fate(sides_.size(), UNKNOWN);

    // Points where more than four sides meet: nothing continues there
    labelList nSidesAt(points_.size(), 0);
    for (const side& s : sides_)
    {
        ++nSidesAt[s.a];
        ++nSidesAt[s.b];
    }

    std::deque<label> front;
    auto decide = [&](const label sidei, const char what)
    {
        if (fate[sidei] == UNKNOWN)
        {
            fate[sidei] = what;
            front.push_back(sidei);
        }
    };

    // From side to side of a cell, and on across the sides between
    auto spreadIn = [&](const label celli, const label sidei)
    {
        const labelList& mine = cellSides_[celli];
        const label n = mine.size();
        const label at = mine.find(sidei);
        if (n != 4)
        {
            return;
        }
        decide(mine[(at + 2) % 4], fate[sidei] == KEPT ? GONE : KEPT);

        for (const label step : {1, 3})
        {
            // Over the side next to this one into the other cell; the loops
            // of both run against each other
            const label between = mine[(at + step) % 4];
            const label shared = loops_[celli][step == 1 ? (at + 1) % 4 : at];
            label other, otherSide;
            across(celli, between, other, otherSide);

            if
            (
                other >= 0
             && cellSides_[other].size() == 4
             && (nSidesAt[shared] <= 4 || otherSide != between)
            )
            {
                const label there = cellSides_[other].find(otherSide);
                decide
                (
                    cellSides_[other][(there + (step == 1 ? 1 : 3)) % 4],
                    fate[sidei]
                );
            }
        }
    };

    for (label first = 0; ; )
    {
        if (first == 0)
        {
            forAll(sides_, sidei)
            {
                if (sides_[sidei].neighbour < 0)
                {
                    decide(sidei, KEPT);
                }
            }
        }

        while (!front.empty())
        {
            const label sidei = front.front();
            front.pop_front();
            spreadIn(sides_[sidei].owner, sidei);
            if (sides_[sidei].neighbour >= 0)
            {
                spreadIn(sides_[sidei].neighbour, sidei);
            }
        }

        // A ring has sides that no patch decides on: begin with the one of
        // the lowest middle, which does not depend on the numbers of cells
        label lowest = -1;
        auto rank = [&](const label sidei)
        {
            const point m(middle(sidei));
            return m.x() + 1e-3*m.y() + 1e-6*m.z();
        };
        forAll(sides_, sidei)
        {
            if
            (
                fate[sidei] == UNKNOWN
             && (lowest < 0 || rank(sidei) < rank(lowest))
            )
            {
                lowest = sidei;
            }
        }
        if (lowest < 0)
        {
            break;
        }
        decide(lowest, KEPT);
        first = 1;
    }

    boolList kept(sides_.size());
    forAll(kept, sidei)
    {
        kept[sidei] = fate[sidei] == KEPT;
    }
    return kept;
}


Foam::labelList Foam::planarMesh::blocks
(
    const boolUList& kept,
    label& nBlocks
) const
{
    labelList block(nCells(), -1);
    nBlocks = 0;

    forAll(block, start)
    {
        if (block[start] >= 0)
        {
            continue;
        }
        DynamicList<label> todo;
        todo.append(start);
        block[start] = nBlocks;

        while (todo.size())
        {
            const label celli = todo.remove();
            for (const label sidei : cellSides_[celli])
            {
                const side& s = sides_[sidei];
                const label other =
                    s.owner == celli ? s.neighbour : s.owner;
                if (!kept[sidei] && other >= 0 && block[other] < 0)
                {
                    block[other] = nBlocks;
                    todo.append(other);
                }
            }
        }
        ++nBlocks;
    }
    return block;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::planarMesh Foam::planarMesh::coarsened
(
    const vector& e,
    labelList& cellToBlock,
    labelList& sideToSide
) const
{
    boolList kept(keptSides());
    label nBlocks;
    cellToBlock = blocks(kept, nBlocks);

    // Sides within a block go as well
    forAll(sides_, sidei)
    {
        const side& s = sides_[sidei];
        if
        (
            s.neighbour >= 0
         && cellToBlock[s.owner] == cellToBlock[s.neighbour]
        )
        {
            kept[sidei] = false;
        }
    }

    // Points in the middle of a side of a block: two kept sides, no cell that
    // has both
    labelList nKept(points_.size(), 0);
    forAll(sides_, sidei)
    {
        if (kept[sidei])
        {
            ++nKept[sides_[sidei].a];
            ++nKept[sides_[sidei].b];
        }
    }
    bitSet stays(points_.size());
    forAll(nKept, pointi)
    {
        stays[pointi] = nKept[pointi] > 2;
    }
    forAll(loops_, celli)
    {
        const labelList& loop = loops_[celli];
        const labelList& mine = cellSides_[celli];
        forAll(loop, i)
        {
            if (kept[mine[i]] && kept[mine[mine.rcIndex(i)]])
            {
                stays[loop[i]] = true;
            }
        }
    }

    // Loops of the blocks: kept sides one after the other
    planarMesh coarse;
    coarse.loops_.setSize(nBlocks);
    List<DynamicList<label>> sidesOf(nBlocks);
    forAll(cellSides_, celli)
    {
        for (const label sidei : cellSides_[celli])
        {
            if (kept[sidei])
            {
                sidesOf[cellToBlock[celli]].append(sidei);
            }
        }
    }

    // Directed as in the block
    auto from = [&](const label block, const label sidei)
    {
        const side& s = sides_[sidei];
        return cellToBlock[s.owner] == block ? s.a : s.b;
    };
    auto to = [&](const label block, const label sidei)
    {
        const side& s = sides_[sidei];
        return cellToBlock[s.owner] == block ? s.b : s.a;
    };

    labelList newPoint(points_.size(), -1);
    DynamicList<point> points;
    List<labelListList> chains(nBlocks);

    forAll(sidesOf, block)
    {
        DynamicList<label>& mine = sidesOf[block];

        // Put in order, from a point that stays
        label first = -1;
        forAll(mine, i)
        {
            if (stays[from(block, mine[i])])
            {
                first = i;
                break;
            }
        }
        bool whole = first >= 0;
        if (whole)
        {
            Swap(mine[0], mine[first]);
            for (label i = 1; i < mine.size() && whole; ++i)
            {
                label next = -1;
                for (label j = i; j < mine.size(); ++j)
                {
                    if (from(block, mine[j]) == to(block, mine[i - 1]))
                    {
                        next = j;
                        break;
                    }
                }
                whole = next >= 0;
                if (whole)
                {
                    Swap(mine[i], mine[next]);
                }
            }
        }
        if (!whole)
        {
            FatalErrorInFunction
                << "The mesh cannot be coarsened by two each way: the block"
                << " at " << centres_[cellToBlock.find(block)]
                << " has a hole" << exit(FatalError);
        }

        DynamicList<label> loop;
        DynamicList<labelList> chainsOf;
        DynamicList<label> chain;
        for (const label sidei : mine)
        {
            const label start = from(block, sidei);
            if (stays[start])
            {
                if (newPoint[start] < 0)
                {
                    newPoint[start] = points.size();
                    points.append(points_[start]);
                }
                loop.append(newPoint[start]);
                if (chain.size())
                {
                    chainsOf.append(labelList(std::move(chain)));
                    chain.clear();
                }
            }
            chain.append(sidei);
        }
        chainsOf.append(labelList(std::move(chain)));
        coarse.loops_[block] = std::move(loop);
        chains[block] = std::move(chainsOf);
    }

    coarse.points_ = std::move(points);
    EdgeMap<label> where(4*nBlocks);
    coarse.setSides(where);
    coarse.setGeometry(e);

    sideToSide.setSize(sides_.size());
    sideToSide = -1;
    forAll(chains, block)
    {
        forAll(chains[block], i)
        {
            for (const label sidei : chains[block][i])
            {
                sideToSide[sidei] = coarse.cellSides_[block][i];
            }
        }
    }
    forAll(sides_, sidei)
    {
        const label coarsei = sideToSide[sidei];
        if (coarsei >= 0)
        {
            side& s = coarse.sides_[coarsei];
            s.patch = sides_[sidei].patch;
            const label partner = sides_[sidei].partner;
            s.partner = partner < 0 ? -1 : sideToSide[partner];
        }
    }

    return coarse;
}


// ************************************************************************* //
