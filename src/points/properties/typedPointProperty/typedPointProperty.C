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


#include "typedPointProperty.H"
#include "checkedEntry.H"
#include "materialPointCloud.H"
#include "openfoamVersion.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
bool Foam::typedPointProperty<Type>::inRange(const Type& value)
{
    for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
    {
        if (!checkedEntry::inRange(component(value, d)))
        {
            return false;
        }
    }

    return true;
}


template<class Type>
Type Foam::typedPointProperty<Type>::get
(
    const dictionary& dict,
    const word& key,
    const Type& value
)
{
    const Type found(dict.getOrDefault<Type>(key, value));

    if (!inRange(found))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' is " << found << nl
            << "    Allowed: numbers up to " << checkedEntry::largest
            << exit(FatalIOError);
    }

    return found;
}


template<class Type>
void Foam::typedPointProperty<Type>::setValue
(
    materialPoint& p,
    const Type& value
) const
{
    for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
    {
        p.values()[first() + d] = component(value, d);
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

template<class Type>
Type Foam::typedPointProperty<Type>::startValue(const materialPoint& p) const
{
    for (label i = regions_.size() - 1; i >= 0; --i)
    {
        if (regions_[i].contains(p.position(mesh_)))
        {
            return regionValue_[i];
        }
    }

    return start_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::typedPointProperty<Type>::typedPointProperty
(
    const word& name,
    const dictionary& dict,
    const fvMesh& mesh,
    const label first,
    const dimensionSet& dims,
    const wordList& entries
)
:
    pointProperty(name, first),
    mesh_(mesh),
    start_(get(dict, "start", pTraits<Type>::zero)),
    inflow_(get(dict, "inflow", start_))
{
    wordList allowed({"type", "start", "regions", "inflow", "onMesh"});
    allowed.append(entries);
    checkedEntry::only(dict, allowed);

    PtrList<dictionary> regions;
    dict.readIfPresent("regions", regions);
    regions_.setSize(regions.size());
    regionValue_.setSize(regions.size());

    forAll(regions, i)
    {
        if (!regions[i].found("value") || regions[i].found("material"))
        {
            FatalIOErrorInFunction(dict)
                << "Region " << i << " of the property " << name
                << (regions[i].found("value") ? " has" : " lacks")
                << " the entry '"
                << (regions[i].found("value") ? "material" : "value") << '\''
                << nl << "    Allowed: the entries of a region and its value,"
                << " for all materials" << exit(FatalIOError);
        }
        regionValue_[i] = get(regions[i], "value", start_);

        // Each of the regions allows the entries that are its own
        regions[i].remove("value");
        regions_.set(i, pointRegion::New(regions[i], mesh));
    }

    if (dict.getOrDefault<bool>("onMesh", false))
    {
        if (mesh.foundObject<regIOobject>(name))
        {
            FatalIOErrorInFunction(dict)
                << "Property " << name << " is to be on the mesh, where there"
                << " is a field of this name" << nl
                << "    Allowed: any other name" << exit(FatalIOError);
        }
        field_.reset
        (
            new GeometricField<Type, fvPatchField, volMesh>
            (
                IOobject
                (
                    name,
                    mesh.time().timeName(),
                    mesh,
                    IOobject::NO_READ,
                    IOobject::AUTO_WRITE
                ),
                mesh,
                dimensioned<Type>(dims, Zero),
                zeroGradientFvPatchField<Type>::typeName
            )
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Type Foam::typedPointProperty<Type>::value(const materialPoint& p) const
{
    Type value(Zero);
    for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
    {
        setComponent(value, d) = p.values()[first() + d];
    }

    return value;
}


template<class Type>
void Foam::typedPointProperty<Type>::update
(
    materialPoint& p,
    const pointFlow& flow,
    const scalar dt
) const
{
    Type now(value(p));
    step(now, p, flow, dt);
    setValue(p, now);
}


template<class Type>
void Foam::typedPointProperty<Type>::merge
(
    materialPoint& p,
    const materialPoint& other,
    const scalar part
) const
{
    setValue(p, (1 - part)*value(p) + part*value(other));
}


template<class Type>
void Foam::typedPointProperty<Type>::transform
(
    materialPoint& p,
    const tensor& T
) const
{
    setValue(p, Foam::transform(T, value(p)));
}


template<class Type>
bool Foam::typedPointProperty<Type>::read(materialPointCloud& cloud) const
{
    IOobject io(cloudFieldIO(cloud, name(), IOobject::MUST_READ));
    const bool valid = cloud.size();

    // Processors without points have no file
    const bool found =
        valid && io.template typeHeaderOk<IOField<Type>>(false);

    if (!returnReduce(found, orOp<bool>()))
    {
        return false;
    }

    const IOField<Type> values(io, valid);
    if (values.size() != cloud.size())
    {
        FatalErrorInFunction
            << "Size of " << values.objectPath() << " is " << values.size()
            << nl << "    Allowed: one value for each of the " << cloud.size()
            << " points" << exit(FatalError);
    }

    label i = 0;
    for (materialPoint& p : cloud)
    {
        if (!inRange(values[i]))
        {
            FatalErrorInFunction
                << "Point " << i << " of "
                << values.objectPath() << " has the value " << values[i] << nl
                << "    Allowed: numbers up to " << checkedEntry::largest
                << exit(FatalError);
        }
        setValue(p, values[i++]);
    }

    return true;
}


template<class Type>
void Foam::typedPointProperty<Type>::write
(
    const materialPointCloud& cloud
) const
{
    IOField<Type> values
    (
        cloudFieldIO(cloud, name(), IOobject::NO_READ),
        cloud.size()
    );

    label i = 0;
    for (const materialPoint& p : cloud)
    {
        values[i++] = value(p);
    }
    values.write(cloud.size() > 0);
}


template<class Type>
void Foam::typedPointProperty<Type>::writeObject
(
    const materialPointCloud& cloud,
    objectRegistry& obr
) const
{
    auto& values = cloud::createIOField<Type>(name(), cloud.size(), obr);

    label i = 0;
    for (const materialPoint& p : cloud)
    {
        values[i++] = value(p);
    }
}


template<class Type>
void Foam::typedPointProperty<Type>::average(const materialPointCloud& cloud)
{
    if (!field_.valid())
    {
        return;
    }

    scalarField values(cloud.size());
    for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
    {
        label i = 0;
        for (const materialPoint& p : cloud)
        {
            values[i++] = p.values()[first() + d];
        }
        field_->primitiveFieldRef().replace(d, cloud.average(values));
    }
    field_->correctBoundaryConditions();
}


// ************************************************************************* //
