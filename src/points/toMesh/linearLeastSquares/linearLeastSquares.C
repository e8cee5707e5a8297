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

#include "linearLeastSquares.H"
#include "materialPointCloud.H"
#include "planarCells.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace pointAverages
{
    defineTypeNameAndDebug(linearLeastSquares, 0);
    addToRunTimeSelectionTable(pointAverage, linearLeastSquares, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::pointAverages::linearLeastSquares::weights
(
    const materialPointCloud& cloud
) const
{
    const fvMesh& mesh = refCast<const fvMesh>(cloud.pMesh());
    const planarCells cells(mesh);
    const direction i0 = cells.frame().i0(), i1 = cells.frame().i1();
    const label n = mesh.nCells();

    // Positions from the centre of the cell, and their moments
    scalarField x(cloud.size()), y(cloud.size());
    scalarField total(n, Zero), mx(n, Zero), my(n, Zero);
    scalarField xx(n, Zero), xy(n, Zero), yy(n, Zero);
    label i = 0;

    for (const materialPoint& p : cloud)
    {
        const label celli = p.cell();
        const vector d(p.position(mesh) - mesh.cellCentres()[celli]);
        const scalar V = p.volume();
        x[i] = d[i0];
        y[i] = d[i1];

        total[celli] += V;
        mx[celli] += V*x[i];
        my[celli] += V*y[i];
        xx[celli] += V*sqr(x[i]);
        xy[celli] += V*x[i]*y[i];
        yy[celli] += V*sqr(y[i]);
        ++i;
    }

    // C^-1 . (c - m), zero where the points cover little of the cell; the
    // covariance of even ones in a rectangle of area A has determinant A^2/144
    scalarField dx(n, Zero), dy(n, Zero);
    for (label celli = 0; celli < n; ++celli)
    {
        const scalar V = max(total[celli], VSMALL);
        mx[celli] /= V;
        my[celli] /= V;
        const scalar Cxx = xx[celli]/V - sqr(mx[celli]);
        const scalar Cxy = xy[celli]/V - mx[celli]*my[celli];
        const scalar Cyy = yy[celli]/V - sqr(my[celli]);
        const scalar det = Cxx*Cyy - sqr(Cxy);

        const scalar A =
            mesh.cellVolumes()[celli]/cells.depth(mesh.cellCentres()[celli]);

        if (det > 1e-3*sqr(A)/144)
        {
            dx[celli] = (Cxy*my[celli] - Cyy*mx[celli])/det;
            dy[celli] = (Cxy*mx[celli] - Cxx*my[celli])/det;
        }
    }

    tmp<scalarField> tweights(new scalarField(cloud.size()));
    scalarField& w = tweights.ref();
    i = 0;

    for (const materialPoint& p : cloud)
    {
        const label celli = p.cell();
        w[i] =
            p.volume()/total[celli]
           *(
                1
              + (x[i] - mx[celli])*dx[celli]
              + (y[i] - my[celli])*dy[celli]
            );
        ++i;
    }

    return tweights;
}


// ************************************************************************* //
