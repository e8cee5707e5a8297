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

#include "volumeExchange.H"
#include "materialPointCloud.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::volumeExchange::volumeExchange
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    active_(dict.getOrDefault<Switch>("volumeExchange", true)),
    tolerance_(dict.getOrDefault<scalar>("volumeTolerance", 5e-4))
{
    if (!(tolerance_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'volumeTolerance' is " << tolerance_ << nl
            << "    Allowed: above zero; volumeExchange no, for none"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::volumeExchange::pass
(
    const scalarList& from,
    const scalarList& to,
    scalarList& passed
)
{
    // Volumes of the materials, of all points, of the cell
    const label n = passed.size();
    const scalar c = 0.2;
    const scalar F =
        c*(from[n]/from[n + 1] - to[n]/to[n + 1])*min(from[n + 1], to[n + 1]);

    scalar sum = 0;
    for (label m = 0; m < n; ++m)
    {
        passed[m] = from[m]*to[m];
        sum += passed[m];
    }
    for (label m = 0; m < n; ++m)
    {
        passed[m] = sum > 0 ? min(F*passed[m]/sum, c*from[m]) : 0;
    }
}


void Foam::volumeExchange::sweep(List<scalarField>& volume) const
{
    const label n = volume.size() - 2;

    // Of the cells behind coupled faces
    List<scalarList> other(volume.size());
    forAll(volume, m)
    {
        syncTools::swapBoundaryCellList(mesh_, volume[m], other[m]);
    }

    List<scalarField> change(n, scalarField(mesh_.nCells(), Zero));
    scalarList here(n + 2), there(n + 2), passed(n);

    // The same numbers, whichever of the two cells is on this processor
    auto exchange = [&](const label P, const label N)
    {
        const bool gives = here[n]/here[n + 1] > there[n]/there[n + 1];

        if (gives)
        {
            pass(here, there, passed);
        }
        else
        {
            pass(there, here, passed);
        }

        for (label m = 0; m < n; ++m)
        {
            const scalar F = gives ? passed[m] : -passed[m];
            change[m][P] -= F;
            if (N >= 0)
            {
                change[m][N] += F;
            }
        }
    };

    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        const label P = mesh_.faceOwner()[facei];
        const label N = mesh_.faceNeighbour()[facei];
        forAll(volume, m)
        {
            here[m] = volume[m][P];
            there[m] = volume[m][N];
        }
        exchange(P, N);
    }
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (pp.coupled())
        {
            forAll(pp, i)
            {
                const label P = pp.faceCells()[i];
                forAll(volume, m)
                {
                    here[m] = volume[m][P];
                    there[m] =
                        other[m][pp.start() + i - mesh_.nInternalFaces()];
                }
                exchange(P, -1);
            }
        }
    }

    for (label m = 0; m < n; ++m)
    {
        volume[m] += change[m];
        volume[n] += change[m];
    }
}


bool Foam::volumeExchange::even(const List<scalarField>& volume) const
{
    const label n = volume.size() - 2;
    scalarField points(n, Zero), mesh(n, Zero);

    forAll(volume[n], celli)
    {
        const scalar all = volume[n][celli];
        for (label m = 0; m < n; ++m)
        {
            points[m] += volume[m][celli];
            mesh[m] +=
                all > 0 ? volume[n + 1][celli]*volume[m][celli]/all : 0;
        }
    }
    reduce(points, sumOp<scalarField>());
    reduce(mesh, sumOp<scalarField>());

    // A material with next to no volume cannot be had so exactly
    const scalar least = 0.01*sum(points);
    for (label m = 0; m < n; ++m)
    {
        if (mag(mesh[m] - points[m]) > tolerance_*max(points[m], least))
        {
            return false;
        }
    }
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::volumeExchange::apply(materialPointCloud& cloud) const
{
    if (!active_)
    {
        return;
    }

    const label n = cloud.materials().size();
    List<scalarField> volume(n + 2, scalarField(mesh_.nCells(), Zero));
    volume[n + 1] = mesh_.V();

    for (const materialPoint& p : cloud)
    {
        volume[p.material()][p.cell()] += p.volume();
        volume[n][p.cell()] += p.volume();
    }

    const List<scalarField> before(volume);
    const label nLeast = 5, nMost = 200;
    for (label i = 0; i < nLeast || (i < nMost && !even(volume)); ++i)
    {
        sweep(volume);
    }

    for (materialPoint& p : cloud)
    {
        const label m = p.material(), celli = p.cell();
        p.volume() *= volume[m][celli]/before[m][celli];
    }
}


// ************************************************************************* //
