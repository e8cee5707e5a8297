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

#include "probedMatrix.H"
#include "openfoamVersion.H"
#include "HashSet.H"
#include "ListListOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static labelList starts(const cosseratSystem& system, const bool pressure)
    {
        DynamicList<label> blocks(4);
        blocks.append(0);
        blocks.append(1);
        if (pressure)
        {
            blocks.append(2);
        }
        if (system.cosserat())
        {
            blocks.append(3);
        }
        return labelList(blocks);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelHashSet Foam::probedMatrix::within
(
    const labelListList& graph,
    const label celli,
    const label steps
)
{
    labelHashSet found;
    found.insert(celli);
    labelList front(1, celli);

    for (label step = 0; step < steps; ++step)
    {
        DynamicList<label> next;
        for (const label i : front)
        {
            for (const label j : graph[i])
            {
                if (found.insert(j))
                {
                    next.append(j);
                }
            }
        }
        front.transfer(next);
    }

    return found;
}


void Foam::probedMatrix::colour()
{
    const faceGeometry& mesh = system_.faces();
    const label n = mesh.nCells();

    // Global numbers of cells and of those behind coupled faces
    scalarField number(mesh.nSlots(), -1);
    for (label celli = 0; celli < n; ++celli)
    {
        number[celli] = global_.toGlobal(celli);
    }
    mesh.halo().swap(number);

    List<DynamicList<label>> around(n);
    mesh.forTwoSided
    (
        [&](const label f)
        {
            const label P = mesh[f].own, N = mesh[f].nei;
            around[P].append(label(number[N] + 0.5));
            if (N < n)
            {
                around[N].append(label(number[P] + 0.5));
            }
        }
    );

    List<labelListList> graphs(Pstream::nProcs());
    labelListList& mine = graphs[Pstream::myProcNo()];
    mine.setSize(n);
    forAll(mine, celli)
    {
        mine[celli].transfer(around[celli]);
    }
    Pstream::gatherList(graphs);

    labelList colour;
    nColours_ = 0;
    if (Pstream::master())
    {
        const labelListList graph
        (
            ListListOps::combine<labelListList>
            (
                graphs, accessOp<labelListList>()
            )
        );
        colour = labelList(graph.size(), -1);
        forAll(graph, celli)
        {
            labelHashSet taken;
            for (const label other : within(graph, celli, 4))
            {
                taken.insert(colour[other]);
            }
            label free = 0;
            while (taken.found(free))
            {
                ++free;
            }
            colour[celli] = free;
            nColours_ = max(nColours_, free + 1);
        }
    }
    sendToAll(colour);
    sendToAll(nColours_);
    colours_ = SubList<label>(colour, n, global_.toGlobal(0));
}


Foam::labelList Foam::probedMatrix::columns(const label colour) const
{
    const faceGeometry& mesh = system_.faces();
    const label n = mesh.nCells();

    scalarField known(mesh.nSlots(), -1);
    for (label celli = 0; celli < n; ++celli)
    {
        if (colours_[celli] == colour)
        {
            known[celli] = global_.toGlobal(celli);
        }
    }

    // There is one at most within two steps
    for (label step = 0; step < 2; ++step)
    {
        mesh.halo().swap(known);
        const scalarField before(known);
        mesh.forTwoSided
        (
            [&](const label f)
            {
                const label P = mesh[f].own, N = mesh[f].nei;
                known[P] = max(known[P], before[N]);
                known[N] = max(known[N], before[P]);
            }
        );
    }

    labelList columns(n);
    forAll(columns, celli)
    {
        columns[celli] = known[celli] < 0 ? -1 : label(known[celli] + 0.5);
    }
    return columns;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::probedMatrix::probedMatrix
(
    const cosseratSystem& system,
    const bool pressure
)
:
    system_(system),
    starts_(starts(system, pressure)),
    global_(system.nCells()),
    nColours_(0)
{
    colour();

    columns_.setSize(nColours_);
    forAll(columns_, colour)
    {
        columns_[colour] = columns(colour);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::probedMatrix::getEntries(sparseEntries& entries) const
{
    const label n = system_.nCells();
    const label nb = nBlocks();

    operatorState s(system_.newState());
    scalarField x(system_.size()), r;

    for (label colour = 0; colour < nColours_; ++colour)
    {
        const labelList& columns = columns_[colour];
        for (label j = 0; j < nb; ++j)
        {
            x = 0;
            forAll(colours_, celli)
            {
                if (colours_[celli] == colour)
                {
                    x[starts_[j]*n + celli] = 1;
                }
            }
            system_.plainResidual(x, false, true, s, r);

            forAll(columns, celli)
            {
                if (columns[celli] >= 0)
                {
                    for (label i = 0; i < nb; ++i)
                    {
                        entries.add
                        (
                            number(celli, i),
                            nb*columns[celli] + j,
                            -r[starts_[i]*n + celli]
                        );
                    }
                }
            }
        }
    }

    system_.corners().addEntries(nb, entries);
}


Foam::tmp<Foam::scalarField> Foam::probedMatrix::ordered
(
    const scalarField& x
) const
{
    const label n = system_.nCells();
    const label nb = nBlocks();
    tmp<scalarField> tb(new scalarField(nb*n));
    scalarField& b = tb.ref();

    for (label k = 0; k < nb; ++k)
    {
        for (label celli = 0; celli < n; ++celli)
        {
            b[nb*celli + k] = x[starts_[k]*n + celli];
        }
    }
    return tb;
}


void Foam::probedMatrix::spread(const scalarField& b, scalarField& x) const
{
    const label n = system_.nCells();
    const label nb = nBlocks();

    for (label k = 0; k < nb; ++k)
    {
        for (label celli = 0; celli < n; ++celli)
        {
            x[starts_[k]*n + celli] = b[nb*celli + k];
        }
    }
}


// ************************************************************************* //
