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

#include "pointFiles.H"
#include "materialPointCloud.H"
#include "openfoamVersion.H"
#include "passiveParticleCloud.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Places of the points, as OpenFOAM's class IOPosition has those of a cloud
class pointPositions
:
    public regIOobject
{
    const materialPointCloud& cloud_;

    const cloud::geometryType geometry_;

public:

    pointPositions
    (
        const materialPointCloud& points,
        const cloud::geometryType geometry
    )
    :
        regIOobject
        (
            cloudFieldIO
            (
                points,
                cloud::geometryTypeNames[geometry],
                IOobject::NO_READ
            )
        ),
        cloud_(points),
        geometry_(geometry)
    {}

    virtual const word& type() const
    {
        return Cloud<trackedPoint>::typeName;
    }

    virtual bool writeData(Ostream& os) const
    {
        os  << cloud_.size() << nl << token::BEGIN_LIST << nl;
        for (const materialPoint& p : cloud_)
        {
            const particle at(p.asParticle(cloud_.pMesh()));
            if (geometry_ == cloud::geometryType::COORDINATES)
            {
                at.writeCoordinates(os);
            }
            else
            {
                at.writePosition(os);
            }
            os  << nl;
        }
        os  << token::END_LIST << endl;

        return os.good();
    }
};


//- Set a list from what a function gives of each point
template<class Type, class Function>
static void take
(
    const materialPointCloud& cloud,
    const Function& value,
    Field<Type>& values
)
{
    label i = 0;
    for (const materialPoint& p : cloud)
    {
        values[i++] = value(p);
    }
}


//- Write what a function gives of each point
template<class Type, class Function>
static void writeField
(
    const materialPointCloud& cloud,
    const word& name,
    const Function& value
)
{
    IOField<Type> values
    (
        cloudFieldIO(cloud, name, IOobject::NO_READ),
        cloud.size()
    );
    take(cloud, value, values);
    values.write(cloud.size() > 0);
}


//- Put what a function gives of each point into a registry
template<class Type, class Function>
static void writeObject
(
    const materialPointCloud& cloud,
    const word& name,
    const Function& value,
    objectRegistry& obr
)
{
    take
    (
        cloud,
        value,
        cloud::createIOField<Type>(name, cloud.size(), obr)
    );
}


// What is of each point

static label origProc(const materialPoint& p)
{
    return p.origProc();
}

static label origId(const materialPoint& p)
{
    return p.origId();
}

static label material(const materialPoint& p)
{
    return p.material();
}

static label dye(const materialPoint& p)
{
    return p.dye();
}

static scalar volume(const materialPoint& p)
{
    return p.volume();
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::pointFiles::read(materialPointCloud& cloud)
{
    passiveParticleCloud places(cloud.pMesh(), cloud.name());
    const bool valid = places.size();

    auto io = [&](const word& name)
    {
        return cloudFieldIO(places, name, IOobject::MUST_READ);
    };

    const IOField<label> material(io("material"), valid);
    const IOField<label> dye(io("dye"), valid);
    const IOField<scalar> volume(io("volume"), valid);

    places.checkFieldIOobject(places, material);
    places.checkFieldIOobject(places, dye);
    places.checkFieldIOobject(places, volume);

    label i = 0;
    for (passiveParticle& p : places)
    {
        cloud.add(materialPoint(p, material[i], dye[i], volume[i]));
        places.deleteParticle(p);
        ++i;
    }
}


void Foam::pointFiles::write(const materialPointCloud& cloud)
{
    for
    (
        const auto geometry :
        {cloud::geometryType::COORDINATES, cloud::geometryType::POSITIONS}
    )
    {
        pointPositions(cloud, geometry).write(cloud.size() > 0);
    }

    writeField<label>(cloud, "origProcId", origProc);
    writeField<label>(cloud, "origId", origId);
    writeField<label>(cloud, "material", material);
    writeField<label>(cloud, "dye", dye);
    writeField<scalar>(cloud, "volume", volume);
}


void Foam::pointFiles::writeObjects
(
    const materialPointCloud& cloud,
    objectRegistry& obr
)
{
    writeObject<label>(cloud, "origProc", origProc, obr);
    writeObject<label>(cloud, "origId", origId, obr);
    writeObject<point>
    (
        cloud,
        "position",
        [&](const materialPoint& p) { return p.position(cloud.pMesh()); },
        obr
    );
    writeObject<label>(cloud, "material", material, obr);
    writeObject<label>(cloud, "dye", dye, obr);
    writeObject<scalar>(cloud, "volume", volume, obr);
}


// ************************************************************************* //
