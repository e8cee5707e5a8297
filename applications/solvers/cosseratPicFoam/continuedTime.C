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

#include "continuedTime.H"
#include "IOdictionary.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

static const Foam::word written("written");


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::continuedTime::uniformIO
(
    const word& name,
    const IOobject::readOption read
) const
{
    return IOobject
    (
        name, timeName(), "uniform", *this, read, IOobject::NO_WRITE, false
    );
}


void Foam::continuedTime::refuse() const
{
    word before("the start");
    for (const instant& t : times())
    {
        if (t.name() != constant() && t.value() < restartTime_)
        {
            before = t.name();
        }
    }

    FatalErrorInFunction
        << "Time " << timeName() << " of " << path()
        << " is not wholly written: " << timeName() << "/uniform/" << written
        << " is not there" << nl
        << "    A run has been stopped while it wrote this time. Delete its"
        << " directory (of all processors); the last one before is "
        << before << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::continuedTime::continuedTime(const argList& args)
:
    Time(controlDictName, args),
    restartTime_(startTime_)
{
    IOobject timeIO(uniformIO("time", IOobject::MUST_READ));
    IOobject writtenIO(uniformIO(written, IOobject::MUST_READ));

    const bool begun = timeIO.typeHeaderOk<IOdictionary>(true);
    const bool whole = writtenIO.typeHeaderOk<IOdictionary>(true);

    // A start time made by hand or by a tool has neither
    if (returnReduce(begun && !whole, orOp<bool>()))
    {
        refuse();
    }
    if (!begun)
    {
        return;
    }

    const scalar now = IOdictionary(timeIO).get<scalar>("value");

    // Unless the directory has been given another name
    if (timeName(now) == timeName())
    {
        startTime_ = IOdictionary(writtenIO).get<scalar>("startTime");
        setTime(now, timeIndex());

        if (writeControl_ == wcRunTime || writeControl_ == wcAdjustableRunTime)
        {
            writeTimeIndex_ =
                label((now - startTime_ + 0.5*deltaT_)/writeInterval_);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dimensionedScalar Foam::continuedTime::startTime() const
{
    return dimensionedScalar("startTime", dimTime, restartTime_);
}


bool Foam::continuedTime::writeObject(writeObjectParameters) const
{
    if (!writeTime())
    {
        return false;
    }

    if (!returnReduce(Time::writeObject(writeObjectArguments), andOp<bool>()))
    {
        FatalErrorInFunction
            << "Time " << timeName() << " of " << path()
            << " could not be written: is the disk full?" << exit(FatalError);
    }

    IOdictionary dict(uniformIO(written, IOobject::NO_READ));
    dict.add("startTime", timeName(startTime_, maxPrecision_));

    return dict.regIOobject::writeObject(writeObjectInAscii);
}


// ************************************************************************* //
