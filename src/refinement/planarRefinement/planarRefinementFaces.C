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

#include "planarRefinement.H"
#include "polyTopoChange.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::planarRefinement::assignParts(plan& p, const label celli) const
{
    const planarLoops::loop cell(p.loops.outline(celli));
    const labelList& parts = p.parts[celli];
    const label n = cell.points.size();

    auto assign = [&](const label facei, const label half, const label part)
    {
        const bool owns = mesh_.faceOwner()[facei] == celli;
        (owns ? p.owner : p.neighbour)[half][facei] = part;
    };

    forAll(cell.corners, corneri)
    {
        const planarLoops::middle mid(p.loops.middleOf(cell, corneri));
        const label last = cell.corners[cell.next(corneri)];
        label part = parts[corneri];

        label i = cell.corners[corneri];
        do
        {
            const label facei = cell.faces[i];
            const label half =
                p.loops.ends(facei).first() == cell.points[i] ? 0 : 1;
            assign(facei, half, part);
            if (facei == mid.face)
            {
                part = parts[cell.next(corneri)];
            }
            assign(facei, 1 - half, part);

            i = (i + 1) % n;
            if (i == mid.at)
            {
                part = parts[cell.next(corneri)];
            }
        } while (i != last);
    }
}


Foam::labelList Foam::planarRefinement::newOutline
(
    const plan& p,
    const planarLoops::loop& cell,
    labelList& middles
) const
{
    List<planarLoops::middle> mids(cell.corners.size());
    forAll(mids, corneri)
    {
        mids[corneri] = p.loops.middleOf(cell, corneri);
    }
    middles.setSize(mids.size(), -1);

    DynamicList<label> points(2*cell.points.size());
    forAll(cell.points, i)
    {
        const label facei = cell.faces[i];
        forAll(mids, corneri)
        {
            if (mids[corneri].at == i)
            {
                middles[corneri] = points.size();
            }
            else if (mids[corneri].face == facei)
            {
                middles[corneri] = points.size() + 1;
            }
        }
        points.append(cell.points[i]);
        if (p.split[facei])
        {
            points.append(p.middle[facei]);
        }
    }

    return labelList(std::move(points));
}


void Foam::planarRefinement::setFace
(
    polyTopoChange& change,
    const label facei,
    const bool add,
    face f,
    label owner,
    label neighbour
) const
{
    const label patchi = mesh_.boundaryMesh().whichPatch(facei);
    const label zonei = mesh_.faceZones().whichZone(facei);
    bool flipped = false;
    if (zonei >= 0)
    {
        const faceZone& zone = mesh_.faceZones()[zonei];
        flipped = zone.flipMap()[zone.whichFace(facei)];
    }

    const bool turn = neighbour >= 0 && neighbour < owner;
    if (turn)
    {
        f = f.reverseFace();
        std::swap(owner, neighbour);
        flipped = !flipped;
    }

    if (add)
    {
        change.addFace
        (
            f, owner, neighbour, -1, -1, facei, turn, patchi, zonei, flipped
        );
    }
    else
    {
        change.modifyFace
        (
            f, facei, owner, neighbour, turn, patchi, zonei, flipped
        );
    }
}


void Foam::planarRefinement::changeUprightFaces
(
    plan& p,
    polyTopoChange& change
) const
{
    forAll(p.split, facei)
    {
        if (!p.loops.upright(facei))
        {
            continue;
        }
        const labelPair& ends = p.loops.ends(facei);

        for (label half = 0; half < (p.split[facei] ? 2 : 1); ++half)
        {
            face f(mesh_.faces()[facei]);
            if (p.split[facei])
            {
                const label gone = half ? ends.first() : ends.second();
                const label mid = p.middle[facei];
                f[f.find(gone)] = mid;
                f[f.find(p.front[gone])] = p.front[mid];
            }
            setFace
            (
                change, facei, half == 1, f,
                p.owner[half][facei], p.neighbour[half][facei]
            );
        }
    }
}


void Foam::planarRefinement::addInnerFace
(
    plan& p,
    polyTopoChange& change,
    const label back,
    const label centre,
    const vector& across,
    const label first,
    const label second
) const
{
    face f(4);
    f[0] = back;
    f[1] = centre;
    f[2] = p.front[centre];
    f[3] = p.front[back];

    // Normals are from the lower cell to the higher
    const vector n(f.areaNormal(change.points()));
    if (((n & across) > 0) != (first < second))
    {
        f = f.reverseFace();
    }

    change.addFace
    (
        f, min(first, second), max(first, second),
        -1, -1, -1, false, -1, -1, false
    );
}


void Foam::planarRefinement::changeCell
(
    plan& p,
    polyTopoChange& change,
    const label celli
) const
{
    const planarLoops::loop cell(p.loops.outline(celli));
    labelList middles;
    const labelList outline(newOutline(p, cell, middles));

    auto setSides = [&](const UList<label>& loop, const label part)
    {
        face back(loop), front(loop);
        forAll(loop, i)
        {
            front[i] = p.front[loop[i]];
        }
        const bool add = part != celli;
        setFace(change, p.loops.backFace(celli), add, back, part, -1);
        setFace
        (
            change, p.loops.frontFace(celli), add, front.reverseFace(), part,
            -1
        );
    };

    if (!p.refined[celli])
    {
        if (outline.size() > cell.points.size())
        {
            setSides(outline, celli);
        }
        return;
    }

    const label n = middles.size();
    for (label corneri = 0; corneri < n; ++corneri)
    {
        DynamicList<label> loop;
        const label end = middles[corneri];
        label i = middles[(corneri + n - 1) % n];
        loop.append(outline[i]);
        do
        {
            i = (i + 1) % outline.size();
            loop.append(outline[i]);
        } while (i != end);
        loop.append(p.centre[celli]);
        setSides(loop, p.parts[celli][corneri]);

        const label next = cell.next(corneri);
        const vector across
        (
            mesh_.points()[cell.points[cell.corners[next]]]
          - mesh_.points()[cell.points[cell.corners[corneri]]]
        );
        addInnerFace
        (
            p, change, outline[end], p.centre[celli], across,
            p.parts[celli][corneri], p.parts[celli][next]
        );
    }
}


// ************************************************************************* //
