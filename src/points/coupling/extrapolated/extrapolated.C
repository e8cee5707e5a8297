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

#include "extrapolated.H"
#include "symmetryPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace flowCouplings
{
    defineTypeNameAndDebug(extrapolated, 0);
    addToRunTimeSelectionTable(flowCoupling, extrapolated, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowCouplings::extrapolated::extrapolated
(
    const dictionary& dict,
    const volVectorField& U,
    const surfaceScalarField& phi
)
:
    flowCoupling(U, phi),
    UBefore_
    (
        IOobject
        (
            "UBefore",
            U.time().timeName(),
            U.mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        U.mesh(),
        dimensionedVector(U.dimensions(), Zero),
        calculatedFvPatchVectorField::typeName
    ),
    phiBefore_
    (
        IOobject
        (
            "phiBefore",
            U.time().timeName(),
            U.mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        U.mesh(),
        dimensionedScalar(phi.dimensions(), Zero)
    ),
    dtBefore_
    (
        IOobject
        (
            "dtBefore",
            U.time().timeName(),
            "uniform",
            U.time(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        dimensionedScalar(dimTime, Zero)
    ),
    ahead_(0),
    UMid_(IOobject("UMid", U.time().timeName(), U.mesh()), UBefore_),
    phiMid_(IOobject("phiMid", U.time().timeName(), U.mesh()), phiBefore_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::flowCouplings::extrapolated::update(const scalar dt)
{
    ahead_ = 0;
    if (dtBefore_.value() > 0)
    {
        ahead_ = 0.5*dt/dtBefore_.value();
        UMid_ == (1 + ahead_)*U_ - ahead_*UBefore_;
        phiMid_ == (1 + ahead_)*phi_ - ahead_*phiBefore_;
    }
    else
    {
        Info<< "Material points: no flow of a step before to extrapolate from,"
            << " frozen in this step" << endl;
        UMid_ == U_;
        phiMid_ == phi_;
    }

    UBefore_ == U_;
    phiBefore_ == phi_;

    // Symmetry planes are not written but evaluated, so a restart lacks the
    // value of the step before there: by what the flow's differs from an
    // evaluated one is that of now
    forAll(UMid_.boundaryField(), patchi)
    {
        const polyPatch& pp = U_.mesh().boundaryMesh()[patchi];
        if (isA<symmetryPolyPatch>(pp) || isA<symmetryPlanePolyPatch>(pp))
        {
            fvPatchVectorField& before = UBefore_.boundaryFieldRef()[patchi];
            fvPatchVectorField& mid = UMid_.boundaryFieldRef()[patchi];
            before.evaluate();
            mid.evaluate();
            mid == mid + (U_.boundaryField()[patchi] - before);
        }
    }

    dtBefore_.value() = dt;
}


// ************************************************************************* //
