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

#include "haloExchange.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "oneLayer.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::tensor2D> Foam::haloExchange::rotationOf
(
    const label patchi
) const
{
    const coupledPolyPatch& pp =
        refCast<const coupledPolyPatch>(mesh_.boundaryMesh()[patchi]);

    if (pp.parallel())
    {
        return List<tensor2D>();
    }

    const tensorField& T = pp.forwardT();
    List<tensor2D> R(T.size());
    forAll(R, i)
    {
        R[i] = frame_.inPlane(T[i]);
    }
    return R;
}


void Foam::haloExchange::exchange() const
{
    const label startOfRequests = Pstream::nRequests();

    forAll(coupled_, i)
    {
        if (processor_[i] < 0)
        {
            continue;
        }

        const processorPolyPatch& pp = refCast<const processorPolyPatch>
        (
            mesh_.boundaryMesh()[coupled_[i]]
        );
        receive_[i].setSize(send_[i].size());

        UIPstream::read
        (
            Pstream::commsTypes::nonBlocking,
            processor_[i],
            reinterpret_cast<char*>(receive_[i].begin()),
            receive_[i].size()*sizeof(scalar),
            pp.tag(),
            pp.comm()
        );
        UOPstream::write
        (
            Pstream::commsTypes::nonBlocking,
            processor_[i],
            reinterpret_cast<const char*>(send_[i].begin()),
            send_[i].size()*sizeof(scalar),
            pp.tag(),
            pp.comm()
        );
    }

    Pstream::waitRequests(startOfRequests);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::haloExchange::haloExchange
(
    const fvMesh& mesh,
    const planarFrame& frame
)
:
    mesh_(mesh),
    frame_(frame),
    start_(mesh.boundary().size()),
    size_(mesh.nCells())
{
    DynamicList<label> patches, coupled, processor;
    DynamicList<labelList> cells;
    DynamicList<List<tensor2D>> rotation;

    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];

        start_[patchi] = size_;
        if (!oneLayer::isPlane(patch.patch()))
        {
            patches.append(patchi);
            size_ += patch.size();
        }

        if (patch.coupled())
        {
            const polyPatch& pp = patch.patch();
            const bool cyclic = isA<cyclicPolyPatch>(pp);

            if (!cyclic && !isA<processorPolyPatch>(pp))
            {
                FatalErrorInFunction
                    << "Patch " << patch.name() << " is of type "
                    << patch.type() << nl
                    << "    Allowed of the coupled types: cyclic"
                    << exit(FatalError);
            }

            coupled.append(patchi);
            rotation.append(rotationOf(patchi));
            processor.append
            (
                cyclic
              ? -1 : refCast<const processorPolyPatch>(pp).neighbProcNo()
            );
            cells.append
            (
                cyclic
              ? refCast<const cyclicPolyPatch>(pp).neighbPatch().faceCells()
              : pp.faceCells()
            );
        }
    }

    patches_.transfer(patches);
    coupled_.transfer(coupled);
    processor_.transfer(processor);
    cells_.transfer(cells);
    rotation_.transfer(rotation);
    send_.setSize(coupled_.size());
    receive_.setSize(coupled_.size());
}


// ************************************************************************* //
