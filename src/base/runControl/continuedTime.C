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
#include "uncollatedFileOperation.H"
#include <fstream>

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

static const Foam::word written("written");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Whether a file that begins as OpenFOAM's ends as those do
static bool wholeFile(const Foam::fileName& name)
{
    std::ifstream file(name, std::ios::binary);
    std::string head(1000, ' '), tail(200, ' ');

    file.read(&head[0], head.size());
    if (file.gcount() == 0)
    {
        return false;
    }
    if (head.find("FoamFile") == std::string::npos)
    {
        return true;
    }

    file.clear();
    file.seekg(0, std::ios::end);
    const std::streamoff size = file.tellg();
    file.seekg(std::max<std::streamoff>(size - tail.size(), 0));
    file.read(&tail[0], tail.size());

    return tail.find("// ****") != std::string::npos;
}


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


Foam::DynamicList<Foam::word> Foam::continuedTime::timesBefore() const
{
    DynamicList<word> before;
    for (const instant& t : times())
    {
        if (t.name() != constant() && t.value() < restartTime_)
        {
            before.append(t.name());
        }
    }

    return before;
}


void Foam::continuedTime::refuse() const
{
    const DynamicList<word> before(timesBefore());

    FatalErrorInFunction
        << "Time " << timeName() << " of " << path()
        << " is not wholly written: " << timeName() << "/uniform/" << written
        << " is not there" << nl
        << "    A run has been stopped while it wrote this time. Delete its"
        << " directory (of all processors); the last one before is "
        << (before.empty() ? word("the start") : before.last())
        << exit(FatalError);
}


bool Foam::continuedTime::left() const
{
    IOobject U("U", timeName(), *this);
    if (U.typeHeaderOk<IOdictionary>(false))
    {
        return false;
    }

    for (const word& before : timesBefore())
    {
        IOobject io(written, before, "uniform", *this);
        if (io.typeHeaderOk<IOdictionary>(false))
        {
            return true;
        }
    }

    return false;
}


Foam::fileName Foam::continuedTime::cutShort(const fileName& dir) const
{
    for (const fileName& name : readDir(dir, fileName::FILE, false))
    {
        if (!wholeFile(dir/name) && name.ext() != "gz")
        {
            return dir/name;
        }
    }

    for (const fileName& name : readDir(dir, fileName::DIRECTORY))
    {
        const fileName found(cutShort(dir/name));
        if (!found.empty())
        {
            return found;
        }
    }

    return fileName();
}


void Foam::continuedTime::checkWritten
(
    const bool good,
    const fileName& dir
) const
{
    fileName found;
    if (isA<fileOperations::uncollatedFileOperation>(fileHandler()))
    {
        found = cutShort(dir);
    }

    if (!returnReduce(good && found.empty(), andOp<bool>()))
    {
        FatalErrorInFunction
            << "Time " << timeName() << " of " << path()
            << " could not be written: is the disk full?" << nl;
        if (!found.empty())
        {
            FatalError << "    " << found << " is cut short" << nl;
        }
        FatalError
            << "    Times before are as they were; delete this one to go on"
            << exit(FatalError);
    }
}


void Foam::continuedTime::purge() const
{
    if (!purgeWrite_)
    {
        return;
    }

    if (previousWriteTimes_.empty() || previousWriteTimes_.top() != timeName())
    {
        previousWriteTimes_.push(timeName());
    }
    while (previousWriteTimes_.size() > purgeWrite_)
    {
        fileHandler().rmDir
        (
            fileHandler().filePath
            (
                objectRegistry::path(previousWriteTimes_.pop())
            )
        );
    }
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
    if (returnReduce((begun || left()) && !whole, orOp<bool>()))
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

    // Time would delete older ones before this one is whole
    label& purgeWrite = const_cast<label&>(purgeWrite_);
    const label nKept = purgeWrite;
    purgeWrite = 0;
    checkWritten(Time::writeObject(writeObjectArguments), timePath());
    purgeWrite = nKept;

    IOdictionary dict(uniformIO(written, IOobject::NO_READ));
    dict.add("startTime", timeName(startTime_, maxPrecision_));
    checkWritten
    (
        dict.regIOobject::writeObject(writeObjectInAscii),
        timePath()/"uniform"
    );
    purge();

    return true;
}


// ************************************************************************* //
