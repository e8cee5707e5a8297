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
#include "planarFrame.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "tensorField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::haloExchange::rotate
(
    const label patchi,
    const char* kinds,
    scalarField& values
) const
{
    const coupledPolyPatch& pp =
        refCast<const coupledPolyPatch>(mesh_.boundaryMesh()[patchi]);

    if (pp.parallel())
    {
        return;
    }

    const tensorField& T = pp.forwardT();
    const label n = pp.size();

    for (label i = 0; i < n; ++i)
    {
        const tensor& Ti = T[T.size() == 1 ? 0 : i];
        const scalar R[2][2] =
        {
            { frame_.component(Ti, 0, 0), frame_.component(Ti, 0, 1) },
            { frame_.component(Ti, 1, 0), frame_.component(Ti, 1, 1) }
        };

        label at = i;
        for (const char* k = kinds; *k; ++k)
        {
            if (*k == 'v')
            {
                const scalar v[2] = { values[at], values[at + n] };
                for (int a = 0; a < 2; ++a)
                {
                    values[at + a*n] = R[a][0]*v[0] + R[a][1]*v[1];
                }
            }
            else if (*k == 't')
            {
                scalar G[2][2];
                for (int a = 0; a < 4; ++a)
                {
                    G[a/2][a%2] = values[at + a*n];
                }
                for (int a = 0; a < 4; ++a)
                {
                    values[at + a*n] =
                        R[a/2][0]*(G[0][0]*R[a%2][0] + G[0][1]*R[a%2][1])
                      + R[a/2][1]*(G[1][0]*R[a%2][0] + G[1][1]*R[a%2][1]);
                }
            }
            at += (*k == 's' ? 1 : *k == 'v' ? 2 : 4)*n;
        }
    }
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
    DynamicList<label> coupled;

    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];

        start_[patchi] = size_;
        size_ += patch.size();

        if (patch.coupled())
        {
            const polyPatch& pp = patch.patch();

            if (!isA<cyclicPolyPatch>(pp) && !isA<processorPolyPatch>(pp))
            {
                FatalErrorInFunction
                    << "Patch " << patch.name() << " is of type "
                    << patch.type() << nl
                    << "    Allowed of the coupled types: cyclic"
                    << exit(FatalError);
            }
            coupled.append(patchi);
        }
    }

    coupled_.transfer(coupled);
    send_.setSize(coupled_.size());
    receive_.setSize(coupled_.size());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::haloExchange::swap
(
    const char* kinds,
    std::initializer_list<scalarField*> arrays
) const
{
    if (coupled_.empty())
    {
        return;
    }

    const label nArrays = arrays.size();
    const label startOfRequests = Pstream::nRequests();

    forAll(coupled_, i)
    {
        const label patchi = coupled_[i];
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        const bool processor = isA<processorPolyPatch>(pp);

        // What this patch sends, or a cyclic one gets from its partner
        const labelUList& cells =
        (
            processor
          ? pp.faceCells()
          : refCast<const cyclicPolyPatch>(pp).neighbPatch().faceCells()
        );
        const label n = cells.size();

        scalarField& values = processor ? send_[i] : receive_[i];
        values.setSize(n*nArrays);

        label at = 0;
        for (const scalarField* a : arrays)
        {
            for (label facei = 0; facei < n; ++facei)
            {
                values[at++] = (*a)[cells[facei]];
            }
        }

        if (processor)
        {
            const processorPolyPatch& ppp =
                refCast<const processorPolyPatch>(pp);

            receive_[i].setSize(values.size());

            UIPstream::read
            (
                Pstream::commsTypes::nonBlocking,
                ppp.neighbProcNo(),
                reinterpret_cast<char*>(receive_[i].begin()),
                receive_[i].size()*sizeof(scalar),
                ppp.tag(),
                ppp.comm()
            );
            UOPstream::write
            (
                Pstream::commsTypes::nonBlocking,
                ppp.neighbProcNo(),
                reinterpret_cast<const char*>(values.begin()),
                values.size()*sizeof(scalar),
                ppp.tag(),
                ppp.comm()
            );
        }
    }

    Pstream::waitRequests(startOfRequests);

    forAll(coupled_, i)
    {
        const label patchi = coupled_[i];
        scalarField& values = receive_[i];

        rotate(patchi, kinds, values);

        label at = 0;
        for (scalarField* a : arrays)
        {
            const label n = values.size()/nArrays;
            for (label facei = 0; facei < n; ++facei)
            {
                (*a)[start_[patchi] + facei] = values[at++];
            }
        }
    }
}


// ************************************************************************* //
