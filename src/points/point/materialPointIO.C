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

#include "materialPoint.H"
#include "IOstreams.H"
#include "IOField.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materialPoint::materialPoint
(
    const polyMesh& mesh,
    Istream& is,
    bool readFields,
    bool newFormat
)
:
    particle(mesh, is, readFields, newFormat),
    material_(0),
    dye_(0),
    volume_(0)
{
    if (readFields)
    {
        is  >> material_ >> dye_ >> volume_;
        values_ = scalarList(is);

        if (readBool(is))
        {
            step_.reset(new stepState);
            stepState& s = *step_;
            is  >> s.stage >> s.nTracks >> s.part >> s.begin
                >> s.displacement >> s.travelled >> s.sum;
        }
    }

    is.check(FUNCTION_NAME);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::materialPoint::readFields(Cloud<materialPoint>& cloud)
{
    const bool valid = cloud.size();

    particle::readFields(cloud);

    auto io = [&](const word& name)
    {
        return cloudFieldIO(cloud, name, IOobject::MUST_READ);
    };

    const IOField<label> material(io("material"), valid);
    const IOField<label> dye(io("dye"), valid);
    const IOField<scalar> volume(io("volume"), valid);

    cloud.checkFieldIOobject(cloud, material);
    cloud.checkFieldIOobject(cloud, dye);
    cloud.checkFieldIOobject(cloud, volume);

    label i = 0;
    for (materialPoint& p : cloud)
    {
        p.material_ = material[i];
        p.dye_ = dye[i];
        p.volume_ = volume[i];
        ++i;
    }
}


void Foam::materialPoint::writeFields(const Cloud<materialPoint>& cloud)
{
    particle::writeFields(cloud);

    const label n = cloud.size();

    auto io = [&](const word& name)
    {
        return cloudFieldIO(cloud, name, IOobject::NO_READ);
    };

    IOField<label> material(io("material"), n);
    IOField<label> dye(io("dye"), n);
    IOField<scalar> volume(io("volume"), n);

    label i = 0;
    for (const materialPoint& p : cloud)
    {
        material[i] = p.material_;
        dye[i] = p.dye_;
        volume[i] = p.volume_;
        ++i;
    }

    material.write(n > 0);
    dye.write(n > 0);
    volume.write(n > 0);
}


void Foam::materialPoint::writeObjects
(
    const Cloud<materialPoint>& cloud,
    objectRegistry& obr
)
{
    particle::writeObjects(cloud, obr);

    const label n = cloud.size();

    auto& material = cloud::createIOField<label>("material", n, obr);
    auto& dye = cloud::createIOField<label>("dye", n, obr);
    auto& volume = cloud::createIOField<scalar>("volume", n, obr);

    label i = 0;
    for (const materialPoint& p : cloud)
    {
        material[i] = p.material_;
        dye[i] = p.dye_;
        volume[i] = p.volume_;
        ++i;
    }
}


// * * * * * * * * * * * * * * * IOstream Operators  * * * * * * * * * * * * //

Foam::Ostream& Foam::operator<<(Ostream& os, const materialPoint& p)
{
    os  << static_cast<const particle&>(p)
        << token::SPACE << p.material_
        << token::SPACE << p.dye_
        << token::SPACE << p.volume_
        << token::SPACE << p.values_.list()
        << token::SPACE << bool(p.step_);

    if (p.step_)
    {
        const materialPoint::stepState& s = *p.step_;
        os  << token::SPACE << s.stage
            << token::SPACE << s.nTracks
            << token::SPACE << s.part
            << token::SPACE << s.begin
            << token::SPACE << s.displacement
            << token::SPACE << s.travelled
            << token::SPACE << s.sum;
    }

    os.check(FUNCTION_NAME);
    return os;
}


// ************************************************************************* //
