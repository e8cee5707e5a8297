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


#include "pointPropertyList.H"
#include "IOobjectList.H"
#include "materialPointCloud.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

namespace Foam
{
    //- Files that all points have
    static const wordList ownFiles
    ({
        "positions", "coordinates", "origProcId", "origId", "material", "dye",
        "volume"
    });
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pointPropertyList::reportUnread
(
    const materialPointCloud& cloud
) const
{
    const word& time = cloud.time().timeName();
    const IOobjectList files
    (
        cloud.pMesh(),
        time,
        cloud::prefix/materialPointCloud::cloudName
    );

    wordList known(ownFiles);
    for (const pointProperty& property : properties_)
    {
        known.append(property.name());
    }

    for (const word& name : files.allNames())
    {
        if (!known.found(name))
        {
            Info<< "Point property " << name << " of time " << time
                << " is no longer asked for" << nl;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointPropertyList::pointPropertyList
(
    const fvMesh& mesh,
    const dictionary& dict,
    const flowCoupling& coupling,
    const pointFlow::gradient& gradU,
    const volScalarField& omega
)
:
    nValues_(0)
{
    const dictionary& entries = dict.subOrEmptyDict("properties");

    for (const entry& e : entries)
    {
        if (!e.isDict() || ownFiles.found(e.keyword()))
        {
            FatalIOErrorInFunction(entries)
                << "Entry '" << e.keyword() << "' of properties is "
                << (e.isDict() ? "a name that all points have a file of"
                    : "no dictionary") << nl
                << "    Allowed: one dictionary a property, by names other"
                << " than " << flatOutput(ownFiles) << exit(FatalIOError);
        }

        properties_.append
        (
            pointProperty::New(e.keyword(), e.dict(), mesh, nValues_).ptr()
        );
        nValues_ += properties_.last().nComponents();
    }

    for (const pointProperty& property : properties_)
    {
        if (property.changes() && !flow_.valid())
        {
            flow_.reset(new pointFlow(coupling, gradU, omega));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointPropertyList::report() const
{
    forAll(properties_, i)
    {
        Info<< (i ? ", " : "Point properties: ") << properties_[i].name()
            << ' ' << properties_[i].type();
    }
    if (properties_.size())
    {
        Info<< nl << endl;
    }
}


void Foam::pointPropertyList::start(materialPoint& p) const
{
    p.values().setSize(nValues_);
    for (const pointProperty& property : properties_)
    {
        property.start(p);
    }
}


void Foam::pointPropertyList::enter(materialPoint& p) const
{
    p.values().setSize(nValues_);
    for (const pointProperty& property : properties_)
    {
        property.enter(p);
    }
}


void Foam::pointPropertyList::takeFlow()
{
    if (flow_.valid())
    {
        flow_->update();
    }
}


void Foam::pointPropertyList::update(materialPoint& p, const scalar dt) const
{
    for (const pointProperty& property : properties_)
    {
        if (property.changes())
        {
            property.update(p, *flow_, dt);
        }
    }
}


void Foam::pointPropertyList::update
(
    materialPointCloud& cloud,
    const scalar dt
) const
{
    if (flow_.valid())
    {
        for (materialPoint& p : cloud)
        {
            update(p, dt);
        }
    }
}


void Foam::pointPropertyList::split(materialPoint& p) const
{
    for (const pointProperty& property : properties_)
    {
        property.split(p);
    }
}


void Foam::pointPropertyList::merge
(
    materialPoint& p,
    const materialPoint& other,
    const scalar part
) const
{
    for (const pointProperty& property : properties_)
    {
        property.merge(p, other, part);
    }
}


void Foam::pointPropertyList::transform
(
    materialPoint& p,
    const tensor& T
) const
{
    for (const pointProperty& property : properties_)
    {
        property.transform(p, T);
    }
}


void Foam::pointPropertyList::read(materialPointCloud& cloud) const
{
    if (cloud.nPoints() == 0)
    {
        return;
    }

    for (materialPoint& p : cloud)
    {
        start(p);
    }

    for (const pointProperty& property : properties_)
    {
        if (!property.read(cloud))
        {
            Info<< "Point property " << property.name() << " has no file of"
                << " time " << cloud.time().timeName()
                << ": all points have its start value" << nl;
        }
    }
    reportUnread(cloud);
}


void Foam::pointPropertyList::write(const materialPointCloud& cloud) const
{
    for (const pointProperty& property : properties_)
    {
        property.write(cloud);
    }
}


void Foam::pointPropertyList::writeObjects
(
    const materialPointCloud& cloud,
    objectRegistry& obr
) const
{
    for (const pointProperty& property : properties_)
    {
        property.writeObject(cloud, obr);
    }
}


void Foam::pointPropertyList::average(const materialPointCloud& cloud)
{
    for (pointProperty& property : properties_)
    {
        property.average(cloud);
    }
}


// ************************************************************************* //
