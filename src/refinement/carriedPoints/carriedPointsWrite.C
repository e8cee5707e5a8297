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

#include "carriedPoints.H"
#include "IOobjectList.H"
#include "materialPointCloud.H"
#include "passiveParticleCloud.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::carriedPoints::writeField(const IOobject& from) const
{
    if (from.headerClassName() != IOField<Type>::typeName)
    {
        return;
    }
    IOobject io(from);
    io.readOpt() = IOobject::MUST_READ;
    io.registerObject() = false;
    const IOField<Type> before(io);

    io.instance() = mesh_.time().timeName();
    io.readOpt() = IOobject::NO_READ;
    IOField<Type> now(io, points_.size());
    forAll(now, i)
    {
        now[i] = before[points_[i].from];
        if (from.name() == "volume")
        {
            now[i] *= points_[i].share;
        }
    }
    now.write();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::carriedPoints::write() const
{
    if (!size())
    {
        return;
    }

    const word& name = materialPointCloud::cloudName;
    const IOobjectList fields(mesh_, time_, cloud::prefix/name);
    forAllConstIters(fields, iter)
    {
        const IOobject& io = *iter();
        writeField<label>(io);
        writeField<scalar>(io);
        writeField<vector>(io);
        writeField<sphericalTensor>(io);
        writeField<symmTensor>(io);
        writeField<tensor>(io);
    }

    particle::writeLagrangianPositions = true;
    passiveParticleCloud cloud(mesh_, name, IDLList<passiveParticle>());
    for (const carried& c : points_)
    {
        passiveParticle* p = new passiveParticle(mesh_, c.place, c.cell);
        if (!c.added)
        {
            p->origProc() = origProc_[c.from];
            p->origId() = origId_[c.from];
        }
        cloud.addParticle(p);
    }
    cloud.write();
}


// ************************************************************************* //
