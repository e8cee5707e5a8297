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
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "emptyPolyPatch.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fvMesh> Foam::planarMesh::toMesh
(
    const fvMesh& patchesOf,
    const planarFrame& frame,
    labelListList& patchFaceSides
) const
{
    const label nPoints = points_.size();
    const vector thickness
    (
        frame.e()*patchesOf.bounds().span()[frame.normalAxis()]
    );

    pointField points(2*nPoints);
    forAll(points_, i)
    {
        points[i] = points_[i];
        points[nPoints + i] = points_[i] - thickness;
    }

    // Faces inside, by owner and then neighbour
    List<labelPairList> ofCell(nCells());
    forAll(sides_, sidei)
    {
        const side& s = sides_[sidei];
        if (s.neighbour >= 0)
        {
            ofCell[min(s.owner, s.neighbour)].append
            (
                labelPair(max(s.owner, s.neighbour), sidei)
            );
        }
    }

    DynamicList<face> faces;
    DynamicList<label> owner, neighbour;

    auto addSide = [&](const label sidei, const label celli, const bool turned)
    {
        const side& s = sides_[sidei];
        const label a = s.owner == celli ? s.a : s.b;
        const label b = s.owner == celli ? s.b : s.a;

        // The halves of a cyclic patch begin at the same place
        face f(4);
        f[0] = a + nPoints;
        f[1] = b + nPoints;
        f[2] = b;
        f[3] = a;
        if (turned)
        {
            f[0] = b + nPoints;
            f[1] = b;
            f[2] = a;
            f[3] = a + nPoints;
        }
        faces.append(f);
        owner.append(celli);
    };

    forAll(ofCell, celli)
    {
        Foam::sort(ofCell[celli]);
        for (const labelPair& next : ofCell[celli])
        {
            addSide(next.second(), celli, false);
            neighbour.append(next.first());
        }
    }

    // Patches
    const polyBoundaryMesh& patches = patchesOf.boundaryMesh();
    labelListList sidesOf(patches.size());
    {
        List<DynamicList<label>> found(patches.size());
        forAll(sides_, sidei)
        {
            const label patchi = sides_[sidei].patch;
            if (patchi >= 0)
            {
                const auto* half = isA<cyclicPolyPatch>(patches[patchi]);
                if (!half || half->owner())
                {
                    found[patchi].append(sidei);
                }
                if (half && half->owner())
                {
                    found[half->neighbPatchID()].append(sides_[sidei].partner);
                }
            }
        }
        forAll(found, patchi)
        {
            sidesOf[patchi] = std::move(found[patchi]);
        }
    }

    labelList start(patches.size(), 0), size(patches.size(), 0);
    bool frontAndBack = false;
    forAll(patches, patchi)
    {
        const polyPatch& pp = patches[patchi];
        start[patchi] = faces.size();

        if (isA<emptyPolyPatch>(pp) && !frontAndBack)
        {
            frontAndBack = true;
            forAll(loops_, celli)
            {
                face f(loops_[celli]);
                faces.append(f);
                owner.append(celli);
            }
            forAll(loops_, celli)
            {
                face f(loops_[celli]);
                for (label& pointi : f)
                {
                    pointi += nPoints;
                }
                faces.append(f.reverseFace());
                owner.append(celli);
            }
        }
        else if (counts(pp) && !isA<processorPolyPatch>(pp))
        {
            const auto* half = isA<cyclicPolyPatch>(pp);
            for (const label sidei : sidesOf[patchi])
            {
                addSide
                (
                    sidei, sides_[sidei].owner, half && !half->owner()
                );
            }
        }
        size[patchi] = faces.size() - start[patchi];
    }

    // The name of the region is that of the main mesh, so that it finds the
    // same dictionaries (which READ_IF_PRESENT stands for); it is not
    // registered
    autoPtr<fvMesh> mesh
    (
        new fvMesh
        (
            IOobject
            (
                fvMesh::defaultRegion,
                patchesOf.time().timeName(),
                patchesOf.time(),
                IOobject::READ_IF_PRESENT,
                IOobject::NO_WRITE,
                false
            ),
            std::move(points),
            faceList(std::move(faces)),
            labelList(std::move(owner)),
            labelList(std::move(neighbour)),
            false
        )
    );

    DynamicList<polyPatch*> made;
    patchFaceSides.setSize(patches.size());
    forAll(patches, patchi)
    {
        const polyPatch& pp = patches[patchi];
        if (isA<processorPolyPatch>(pp))
        {
            continue;
        }
        OStringStream os;
        os << token::BEGIN_BLOCK;
        pp.write(os);
        os << token::END_BLOCK;
        IStringStream is(os.str());
        dictionary dict(is);
        dict.set("nFaces", size[patchi]);
        dict.set("startFace", start[patchi]);
        made.append
        (
            polyPatch::New
            (
                pp.name(), dict, made.size(), mesh->boundaryMesh()
            ).ptr()
        );
        if (counts(pp))
        {
            patchFaceSides[patchi] = sidesOf[patchi];
        }
    }

    List<polyPatch*> list(std::move(made));
    mesh->addFvPatches(list);

    return mesh;
}


// ************************************************************************* //
