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

#include "pointAverage.H"
#include "materialPointCloud.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(pointAverage, 0);
    defineRunTimeSelectionTable(pointAverage, dictionary);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pointAverage::checkFilled
(
    const materialPointCloud& cloud,
    const UList<scalar>& total
) const
{
    forAll(total, celli)
    {
        if (total[celli] == 0)
        {
            FatalErrorInFunction
                << "Cell " << celli << " at "
                << cloud.pMesh().cellCentres()[celli]
                << " has no material point, time "
                << cloud.pMesh().time().timeName() << nl
                << "    Cures: more pointsPerCell or minPointsPerCell, a"
                << " smaller maxCo" << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::pointAverage::sum
(
    const materialPointCloud& cloud,
    PtrList<volScalarField>& sums
) const
{
    const tmp<scalarField> tweights(weights(cloud));
    const scalarField& w = tweights();
    label i = 0;

    for (const materialPoint& p : cloud)
    {
        sums[p.material()][p.cell()] += w[i++];
    }

    // Some weights may be negative
    for (volScalarField& s : sums)
    {
        s.primitiveFieldRef() =
            max(min(s.primitiveField(), scalar(1)), scalar(0));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointAverage::fractions
(
    const materialPointCloud& cloud,
    PtrList<volScalarField>& alphas
) const
{
    for (volScalarField& alpha : alphas)
    {
        alpha.primitiveFieldRef() = 0;
    }
    sum(cloud, alphas);

    scalarField total(cloud.pMesh().nCells(), Zero);
    for (const volScalarField& alpha : alphas)
    {
        total += alpha.primitiveField();
    }
    checkFilled(cloud, total);

    for (volScalarField& alpha : alphas)
    {
        alpha.primitiveFieldRef() /= total;
        alpha.correctBoundaryConditions();
    }
}


Foam::tmp<Foam::scalarField> Foam::pointAverage::average
(
    const materialPointCloud& cloud,
    const UList<scalar>& values
) const
{
    const label n = cloud.pMesh().nCells();
    const tmp<scalarField> tweights(weights(cloud));
    const scalarField& w = tweights();

    tmp<scalarField> taverage(new scalarField(n, Zero));
    scalarField& average = taverage.ref();
    scalarField total(n, Zero), lower(n, GREAT), upper(n, -GREAT);
    label i = 0;

    for (const materialPoint& p : cloud)
    {
        const label celli = p.cell();
        average[celli] += w[i]*values[i];
        total[celli] += w[i];
        lower[celli] = min(lower[celli], values[i]);
        upper[celli] = max(upper[celli], values[i]);
        ++i;
    }
    checkFilled(cloud, total);
    average = max(min(average, upper), lower);

    return taverage;
}


// ************************************************************************* //
