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
#include "polyMesh.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materialPoint::materialPoint
(
    const polyMesh& mesh,
    const point& position,
    const label celli,
    const label material,
    const label dye,
    const scalar volume
)
:
    materialPoint(particle(mesh, position, celli), material, dye, volume)
{}


Foam::materialPoint::materialPoint
(
    const polyMesh& mesh,
    const point& position,
    const label celli,
    const UList<scalar>& numbers
)
:
    materialPoint
    (
        mesh,
        position,
        celli,
        label(numbers[0]),
        label(numbers[1]),
        numbers[2]
    )
{
    values_ =
        SubList<scalar>(numbers, numbers.size() - nOwnNumbers, nOwnNumbers);
}


Foam::materialPoint::materialPoint
(
    const particle& p,
    const label material,
    const label dye,
    const scalar volume
)
:
    coordinates_(p.coordinates()),
    volume_(volume),
    cell_(p.cell()),
    tetFace_(p.tetFace()),
    origProc_(p.origProc()),
    origId_(p.origId()),
    dye_(dye),
    tetPt_(few(p.tetPt())),
    material_(few(material))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarList Foam::materialPoint::handsOn() const
{
    scalarList numbers(nOwnNumbers + values_.size());
    numbers[0] = material_;
    numbers[1] = dye_;
    numbers[2] = volume_;
    forAll(values_, i)
    {
        numbers[nOwnNumbers + i] = values_[i];
    }

    return numbers;
}


Foam::point Foam::materialPoint::position(const polyMesh& mesh) const
{
    return asParticle(mesh).position();
}


Foam::particle Foam::materialPoint::asParticle(const polyMesh& mesh) const
{
    particle p(mesh, coordinates_, cell_, tetFace_, tetPt_);

    // It is none that is new
    --particle::particleCount_;
    p.origProc() = origProc_;
    p.origId() = origId_;

    return p;
}


Foam::scalar Foam::materialPoint::track
(
    const polyMesh& mesh,
    const vector& way
)
{
    particle p(asParticle(mesh));
    const scalar rest = p.track(way, 0);
    setPlace(p);

    return rest;
}


void Foam::materialPoint::trackToFace
(
    const polyMesh& mesh,
    const vector& way
)
{
    particle p(asParticle(mesh));
    p.trackToFace(way, 0);
    setPlace(p);
}


// ************************************************************************* //
