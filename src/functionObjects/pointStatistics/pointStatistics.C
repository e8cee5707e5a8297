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

#include "pointStatistics.H"
#include "materialPointCloud.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(pointStatistics, 0);
    addToRunTimeSelectionTable(functionObject, pointStatistics, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::materialPointCloud&
Foam::functionObjects::pointStatistics::cloud() const
{
    return mesh_.lookupObject<materialPointCloud>
    (
        materialPointCloud::cloudName
    );
}


void Foam::functionObjects::pointStatistics::volumes
(
    scalar& leastFill,
    scalar& mostFill,
    scalar& share
) const
{
    const pointCensus& census = cloud().census();
    const scalarField fill(census.filled()/mesh_.V());

    leastFill = gMin(fill);
    mostFill = gMax(fill);
    share = GREAT;
    forAll(fill, celli)
    {
        if (fill[celli] > 0)
        {
            share = min
            (
                share,
                census.least()[celli]*census.count()[celli]
               /census.filled()[celli]
            );
        }
    }
    reduce(share, minOp<scalar>());
}


Foam::label Foam::functionObjects::pointStatistics::coincident() const
{
    const labelList start(cloud().census().starts());
    labelList next(start);
    List<point> places(start.last());
    for (const materialPoint& p : cloud())
    {
        places[next[p.cell()]++] = p.position(mesh_);
    }

    // A millionth of a cell apart is the same place
    label n = 0;
    forAll(mesh_.V(), celli)
    {
        const scalar near = 1e-6*Foam::cbrt(mesh_.V()[celli]);
        for (label i = start[celli]; i < start[celli + 1]; ++i)
        {
            for (label j = start[celli]; j < start[celli + 1]; ++j)
            {
                if (i != j && magSqr(places[i] - places[j]) < sqr(near))
                {
                    ++n;
                    break;
                }
            }
        }
    }

    return returnReduce(n, sumOp<label>());
}


void Foam::functionObjects::pointStatistics::writeField
(
    const word& name,
    const scalar offset
) const
{
    volScalarField field
    (
        IOobject(name, time_.timeName(), mesh_),
        mesh_,
        dimensionedScalar(name, dimless, offset)
    );
    const labelList& count = cloud().census().count();
    forAll(count, celli)
    {
        field[celli] += count[celli];
    }
    field.write();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::pointStatistics::pointStatistics
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName, dict),
    cellCost_(0)
{
    read(dict);

    if (!mesh_.foundObject<materialPointCloud>(materialPointCloud::cloudName))
    {
        FatalIOErrorInFunction(dict)
            << "The case has no material points to count" << nl
            << "    Allowed: with constant/materialPointsProperties only"
            << exit(FatalIOError);
    }

    if (Pstream::master())
    {
        writeHeader(file(), "Material points of the cells");
        writeCommented(file(), "Time [s]");
        for
        (
            const char* column :
            {
                "points", "mean", "deviation", "least", "most", "empty",
                "volume [m3]", "in", "volume in [m3]", "added", "deleted",
                "out", "volume out [m3]", "least fill", "most fill",
                "least share", "coincident"
            }
        )
        {
            writeTabbed(file(), column);
        }
        file() << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::pointStatistics::read(const dictionary& dict)
{
    cellCost_ =
        dict.found("cellCost")
      ? checkedEntry::positive("cellCost", dimless, dict).value()
      : 0;

    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


bool Foam::functionObjects::pointStatistics::execute()
{
    label cells = mesh_.nCells();
    label points = 0, empty = 0, least = labelMax, most = 0;
    scalar squares = 0;

    for (const label n : cloud().census().count())
    {
        points += n;
        squares += sqr(scalar(n));
        empty += n == 0;
        least = min(least, n);
        most = max(most, n);
    }
    reduce(cells, sumOp<label>());
    reduce(points, sumOp<label>());
    reduce(squares, sumOp<scalar>());
    reduce(empty, sumOp<label>());
    reduce(least, minOp<label>());
    reduce(most, maxOp<label>());

    const scalar mean = scalar(points)/cells;
    const scalar deviation =
        Foam::sqrt(max(squares/cells - sqr(mean), scalar(0)));

    scalar leastFill, mostFill, share;
    volumes(leastFill, mostFill, share);
    const label together = coincident();

    const pointAccount& books = cloud().account();

    if (Pstream::master())
    {
        writeCurrentTime(file());
        file()
            << token::TAB << points << token::TAB << mean
            << token::TAB << deviation << token::TAB << least
            << token::TAB << most << token::TAB << empty
            << token::TAB << books.volumeInside()
            << token::TAB << books.nIn() << token::TAB << books.volumeIn()
            << token::TAB << books.nAdded() << token::TAB << books.nDeleted()
            << token::TAB << books.nOut() << token::TAB << books.volumeOut()
            << token::TAB << leastFill << token::TAB << mostFill
            << token::TAB << share << token::TAB << together
            << endl;
    }

    Log << type() << ' ' << name() << ": " << points << " points, " << mean
        << " a cell, deviation " << deviation << ", " << least << " to "
        << most << ", " << empty << " cells empty, filled " << leastFill
        << " to " << mostFill << ", smallest share " << share << ", "
        << together << " at the place of another" << endl;

    return true;
}


bool Foam::functionObjects::pointStatistics::write()
{
    writeField("pointsPerCell", 0);
    if (cellCost_ > 0)
    {
        writeField("pointWeight", cellCost_);
    }

    return true;
}


// ************************************************************************* //
