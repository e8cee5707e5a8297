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

#include "mumpsFactorisation.H"
#include "addToRunTimeSelectionTable.H"
#include "sigFpe.H"

#include <mpi.h>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(mumpsFactorisation, 0);
    addToRunTimeSelectionTable
    (
        sparseFactorisation,
        mumpsFactorisation,
        size
    );
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A serial run of OpenFOAM has not started MPI, which the library needs
static void startMPI()
{
    int started = 0;
    MPI_Initialized(&started);
    if (!started)
    {
        // argList ends it
        Foam::UPstream::initNull();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mumpsFactorisation::call(const label job)
{
    // It tries and recovers: overflow is not an error of ours
    sigFpe::ignore noTrapping;

    mumps_.job = job;
    dmumps_c(&mumps_);

    if (mumps_.infog[0] < 0)
    {
        FatalErrorInFunction
            << "MUMPS ended with error " << mumps_.infog[0] << ", "
            << mumps_.infog[1] << " (see its manual, INFOG)"
            << " in a system of " << mumps_.n << " unknowns" << nl
            << "    Cures: block multigrid in system/fvSolution, creepingFlow,"
            << " or for errors -9, -13 and -19 more memory"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mumpsFactorisation::mumpsFactorisation(const label nLocal)
:
    rows_(nLocal),
    mumps_()
{
    startMPI();

    // Of a coarse problem that the master solves alone it is the master's
    mumps_.comm_fortran =
        MPI_Comm_c2f(Pstream::parRun() ? MPI_COMM_WORLD : MPI_COMM_SELF);
    mumps_.par = 1;
    mumps_.sym = 0;
    call(-1);

    // By the numbers of its manual
    auto control = [&](const label i) -> MUMPS_INT&
    {
        return mumps_.icntl[i - 1];
    };
    control(1) = control(2) = control(3) = -1;
    control(4) = 0;
    control(7) = 3;         // ordered by Scotch
    control(14) = 60;       // per cent of room beyond the estimate
    control(18) = 3;        // spread matrix
    control(28) = 1;        // ordered on the master

    mumps_.n = rows_.size();
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::mumpsFactorisation::~mumpsFactorisation()
{
    mumps_.job = -2;
    dmumps_c(&mumps_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mumpsFactorisation::factorise(const sparseEntries& entries)
{
    const bool first = row_.empty() && !mumps_.nnz_loc;
    const label n = entries.values.size();

    if (first)
    {
        row_.setSize(n);
        column_.setSize(n);
        for (label i = 0; i < n; ++i)
        {
            row_[i] = entries.rows[i] + 1;
            column_[i] = entries.columns[i] + 1;
        }
        mumps_.nnz_loc = n;
        mumps_.irn_loc = row_.begin();
        mumps_.jcn_loc = column_.begin();
    }

    value_ = entries.values;
    mumps_.a_loc = value_.begin();

    call(first ? 4 : 2);
}


void Foam::mumpsFactorisation::solve(scalarField& b)
{
    if (Pstream::parRun())
    {
        rows_.gather(b, all_);
    }
    else
    {
        all_ = b;
    }

    mumps_.rhs = all_.begin();
    mumps_.nrhs = 1;

    call(3);

    if (Pstream::parRun())
    {
        rows_.scatter(all_, b);
    }
    else
    {
        b = all_;
    }
}


// ************************************************************************* //
