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

#include "surfaceStabilisation.H"
#include "gaussGrad.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::surfaceStabilisation::readTheta(const fvMesh& mesh)
{
    const dictionary& dict =
        mesh.solutionDict().subOrEmptyDict("creepingFlow");
    const scalar theta =
        dict.getOrDefault<scalar>("freeSurfaceStabilisation", 0);

    if (!(theta >= 0 && theta <= 1))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'freeSurfaceStabilisation' is " << theta << nl
            << "    Allowed: 0 to 1" << exit(FatalIOError);
    }

    return theta;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceStabilisation::surfaceStabilisation
(
    const fvMesh& mesh,
    const planarFrame& frame,
    const haloExchange& halo
)
:
    mesh_(mesh),
    frame_(frame),
    halo_(halo),
    theta_(readTheta(mesh)),
    g_(Zero)
{
    if (active())
    {
        Info<< "Free surfaces stabilised with theta " << theta_ << nl << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::surfaceStabilisation::update
(
    const volScalarField& rho,
    const vector& g
)
{
    if (!active())
    {
        return;
    }

    const tmp<volVectorField> tgrad
    (
        fv::gaussGrad<scalar>::gradf(linearInterpolate(rho)(), "gradRho")
    );
    const vectorField& grad = tgrad().primitiveField();

    gradRho_.setSize(halo_.size(), Zero);
    forAll(grad, celli)
    {
        gradRho_[celli] = frame_.inPlane(grad[celli]);
    }
    halo_.swap(gradRho_);

    g_ = frame_.inPlane(g);
}


// ************************************************************************* //
