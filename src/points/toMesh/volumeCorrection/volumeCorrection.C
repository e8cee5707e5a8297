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

#include "volumeCorrection.H"
#include "materialPointCloud.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::volumeCorrection::mixedCells
(
    const PtrList<volScalarField>& fractions
)
{
    DynamicList<label> mixed;
    forAll(fractions[0], celli)
    {
        scalar largest = 0;
        for (const volScalarField& alpha : fractions)
        {
            largest = max(largest, alpha[celli]);
        }
        if (largest < 1)
        {
            mixed.append(celli);
        }
    }
    return labelList(mixed);
}


Foam::scalarField Foam::volumeCorrection::logFactors
(
    const PtrList<volScalarField>& fractions,
    const labelUList& mixed,
    const scalarField& wanted
)
{
    const scalarField& V = fractions[0].mesh().V();
    const label n = fractions.size();
    const scalar limit = Foam::log(2.0);
    const label maxIter = 20;
    scalarField w(n, Zero);

    for (label iter = 0; iter < maxIter; ++iter)
    {
        scalarField is(n, Zero), slope(n, Zero);

        for (const label celli : mixed)
        {
            scalar sum = 0;
            for (label m = 0; m < n; ++m)
            {
                sum += fractions[m][celli]*Foam::exp(w[m]);
            }
            for (label m = 0; m < n; ++m)
            {
                const scalar alpha =
                    fractions[m][celli]*Foam::exp(w[m])/sum;
                is[m] += V[celli]*alpha;
                slope[m] += V[celli]*alpha*(1 - alpha);
            }
        }
        reduce(is, sumOp<scalarField>());
        reduce(slope, sumOp<scalarField>());

        // Only differences of the logarithms count: half of the step for two
        scalar largest = 0;
        for (label m = 0; m < n; ++m)
        {
            if (slope[m] > VSMALL)
            {
                const scalar step = 0.5*(wanted[m] - is[m])/slope[m];
                const scalar next = min(max(w[m] + step, -limit), limit);
                largest = max(largest, mag(next - w[m]));
                w[m] = next;
            }
        }
        if (largest < 1e-10)
        {
            break;
        }
    }
    return w;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::volumeCorrection::volumeCorrection(const dictionary& dict)
:
    active_(dict.getOrDefault<Switch>("volumeCorrection", true))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::volumeCorrection::apply
(
    const materialPointCloud& cloud,
    PtrList<volScalarField>& fractions
) const
{
    const label n = fractions.size();
    if (!active_)
    {
        return;
    }

    const scalarField& V = fractions[0].mesh().V();

    scalarField wanted(cloud.census().volume());
    wanted *= gSum(V)/sum(wanted);

    const labelList mixed(mixedCells(fractions));

    // Volumes to be had in the mixed cells
    for (label m = 0; m < n; ++m)
    {
        scalar pure = gSum(V*fractions[m].primitiveField());
        scalar inMixed = 0;
        for (const label celli : mixed)
        {
            inMixed += V[celli]*fractions[m][celli];
        }
        wanted[m] -= pure - returnReduce(inMixed, sumOp<scalar>());
    }

    const scalarField w(logFactors(fractions, mixed, wanted));
    for (const label celli : mixed)
    {
        scalar sum = 0;
        for (label m = 0; m < n; ++m)
        {
            fractions[m][celli] *= Foam::exp(w[m]);
            sum += fractions[m][celli];
        }
        for (label m = 0; m < n; ++m)
        {
            fractions[m][celli] /= sum;
        }
    }
    for (volScalarField& alpha : fractions)
    {
        alpha.correctBoundaryConditions();
    }
}


// ************************************************************************* //
