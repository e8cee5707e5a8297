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

#include "bodyRotations.H"
#include "openfoamVersion.H"
#include "regionSplit.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Viscosity of a body over that of the softest cell, at least: with less its
//- rotation saves no iteration (measured, docs/discretisation.md, section 12)
static const Foam::scalar leastContrast = 30;

//- The next limit over the one before: bodies in bodies, or beside air
static const Foam::scalar nextLimit = 1000;

//- Share of the resistance by its own viscosity up to which a body turns freely
static const Foam::scalar mostShare = 0.5;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    template<class Type>
    static void sumOverRanks(List<Type>& sums)
    {
        Pstream::listCombineGather(sums, plusEqOp<Type>());
        sendListToAll(sums);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::bodyRotations::find
(
    const scalar limit,
    List<part>& found
) const
{
    const fvMesh& mesh = system_.faces().mesh();
    const scalarField& eta = system_.materials().eta().primitiveField();

    boolList stiff;
    stiff.setSize(mesh.nCells(), false);
    label nStiff = 0;
    forAll(stiff, celli)
    {
        stiff[celli] = eta[celli] > limit;
    }
    for (const part& taken : parts_)
    {
        stiff[taken.celli] = false;
    }
    for (const bool yes : stiff)
    {
        nStiff += yes;
    }
    if (returnReduce(nStiff, sumOp<label>()) == 0)
    {
        return 0;
    }

    boolList stiffBehind;
    syncTools::swapBoundaryCellList(mesh, stiff, stiffBehind);
    boolList blocked(mesh.nFaces());
    forAll(blocked, facei)
    {
        const bool other =
            mesh.isInternalFace(facei)
          ? stiff[mesh.faceNeighbour()[facei]]
          : stiffBehind[facei - mesh.nInternalFaces()];
        blocked[facei] = stiff[mesh.faceOwner()[facei]] != other;
    }
    const regionSplit regions(mesh, blocked);

    DynamicList<part> cells(nStiff);
    forAll(stiff, celli)
    {
        if (stiff[celli])
        {
            cells.append({celli, regions[celli], {0, 0, 0}});
        }
    }
    found.transfer(cells);
    return regions.nRegions();
}


void Foam::bodyRotations::setMotions
(
    const label nBodies,
    List<part>& found
) const
{
    const vectorField& C = system_.faces().mesh().C();
    const planarFrame& frame = system_.faces().frame();
    const scalarField& V = system_.faces().V();

    scalarField volume(nBodies, Zero);
    vectorField centre(nBodies, Zero);
    for (const part& cell : found)
    {
        volume[cell.body] += V[cell.celli];
        centre[cell.body] += V[cell.celli]*C[cell.celli];
    }
    sumOverRanks(volume);
    sumOverRanks(centre);
    centre /= max(volume, VSMALL);

    for (part& cell : found)
    {
        const vector d(C[cell.celli] - centre[cell.body]);
        cell.motion[0] = -d[frame.i1()];
        cell.motion[1] = d[frame.i0()];
        cell.motion[2] =
            system_.cosserat() && !system_.rotationUndetermined(cell.celli);
    }
}


Foam::scalarField Foam::bodyRotations::work
(
    const UList<part>& cells,
    const label nBodies,
    const scalarField& r
) const
{
    const label n = system_.nCells();
    scalarField sums(nBodies, Zero);
    for (const part& cell : cells)
    {
        scalar& sum = sums[cell.body];
        sum +=
            cell.motion[0]*r[cell.celli] + cell.motion[1]*r[n + cell.celli];
        if (system_.cosserat())
        {
            sum += cell.motion[2]*r[3*n + cell.celli];
        }
    }
    sumOverRanks(sums);
    return sums;
}


void Foam::bodyRotations::add
(
    const UList<part>& cells,
    const scalarField& angles,
    scalarField& x
) const
{
    const label n = system_.nCells();
    for (const part& cell : cells)
    {
        const scalar angle = angles[cell.body];
        x[cell.celli] += angle*cell.motion[0];
        x[n + cell.celli] += angle*cell.motion[1];
        if (system_.cosserat())
        {
            x[3*n + cell.celli] += angle*cell.motion[2];
        }
    }
}


Foam::scalarField Foam::bodyRotations::freeCompliance
(
    const label nBodies,
    const UList<part>& found
) const
{
    const scalarField& V = system_.faces().V();
    const scalarField& eta = system_.materials().eta().primitiveField();

    scalarField x(system_.size(), Zero), r;
    add(found, scalarField(nBodies, 1), x);
    operatorState s(system_.newState());
    system_.residual(x, false, s, r);
    const scalarField resistance(-work(found, nBodies, r));

    // By its own viscosity, to a velocity gradient of 1 in each component
    scalarField own(nBodies, Zero);
    labelList nCells(nBodies, Zero);
    for (const part& cell : found)
    {
        own[cell.body] += 2*V[cell.celli]*eta[cell.celli];
        ++nCells[cell.body];
    }
    sumOverRanks(own);
    sumOverRanks(nCells);

    // A body of one cell has no velocity in its rotation
    scalarField compliance(nBodies, Zero);
    forAll(compliance, bodyi)
    {
        if
        (
            nCells[bodyi] > 1 && resistance[bodyi] > 0
         && resistance[bodyi] < mostShare*own[bodyi]
        )
        {
            compliance[bodyi] = 1/resistance[bodyi];
        }
    }
    return compliance;
}


void Foam::bodyRotations::take
(
    const scalarField& compliance,
    const UList<part>& found
)
{
    labelList number(compliance.size(), -1);
    forAll(compliance, bodyi)
    {
        if (compliance[bodyi] > 0)
        {
            number[bodyi] = compliance_.size();
            compliance_.append(compliance[bodyi]);
        }
    }
    for (part cell : found)
    {
        cell.body = number[cell.body];
        if (cell.body >= 0)
        {
            parts_.append(cell);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::bodyRotations::update()
{
    const scalarField& eta = system_.materials().eta().primitiveField();

    parts_.clear();
    compliance_.clear();
    if
    (
        system_.faces().axial().active()
     || system_.materials().followsFlow()
    )
    {
        return;
    }

    const scalar stiffest = gMax(eta);
    const scalar softest = max(gMin(eta), SMALL*stiffest);
    for
    (
        scalar limit = leastContrast*softest;
        limit < stiffest;
        limit *= nextLimit
    )
    {
        List<part> found;
        const label nBodies = find(limit, found);
        if (nBodies == 0)
        {
            break;
        }
        setMotions(nBodies, found);
        take(freeCompliance(nBodies, found), found);
    }
}


Foam::scalarField Foam::bodyRotations::angles(const scalarField& r) const
{
    if (compliance_.empty())
    {
        return scalarField();
    }
    return scalarField(compliance_)*work(parts_, compliance_.size(), r);
}


// ************************************************************************* //
