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


#include "pointFlow.H"
#include "flowCoupling.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::pointFlow::before
(
    const word& name,
    const IOobject::readOption read
) const
{
    const fvMesh& mesh = lastOmega_.mesh();

    return IOobject
    (
        name + "Before",
        mesh.time().timeName(),
        mesh,
        read,
        IOobject::AUTO_WRITE
    );
}


template<class FieldType>
void Foam::pointFlow::readBefore
(
    const word& name,
    autoPtr<FieldType>& field
) const
{
    IOobject io(before(name, IOobject::MUST_READ));

    if
    (
        coupling_.extrapolates()
     && io.template typeHeaderOk<FieldType>(true)
    )
    {
        field.reset(new FieldType(io, lastOmega_.mesh(), dimless/dimTime));
    }
}


template<class Type>
void Foam::pointFlow::take
(
    const word& name,
    const Field<Type>& last,
    autoPtr<DimensionedField<Type, volMesh>>& old,
    Field<Type>& now
) const
{
    now = last;

    if (!coupling_.extrapolates())
    {
        return;
    }
    if (old.valid())
    {
        const scalar f = coupling_.ahead();
        now += f*(last - old().field());
        old->field() = last;
    }
    else
    {
        old.reset
        (
            new DimensionedField<Type, volMesh>
            (
                before(name, IOobject::NO_READ),
                lastOmega_.mesh(),
                dimless/dimTime,
                last
            )
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointFlow::pointFlow
(
    const flowCoupling& coupling,
    const gradient& gradU,
    const volScalarField& omega
)
:
    coupling_(coupling),
    lastGradU_(gradU),
    lastOmega_(omega)
{
    readBefore("gradU", gradUBefore_);
    readBefore("omega", omegaBefore_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointFlow::update()
{
    take("gradU", lastGradU_()().primitiveField(), gradUBefore_, gradU_);
    take("omega", lastOmega_.primitiveField(), omegaBefore_, omega_);
}


// ************************************************************************* //
