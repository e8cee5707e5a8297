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

#include "errorPower.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::errorPower::mostSmallest = 0.1;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::errorPower::see
(
    hessenberg& problem,
    const scalar slowest,
    const scalarField& v,
    const scalarField& z
)
{
    scalar smallest = min(mostSmallest, slowest);
    if (problem.size() == 0)
    {
        r_ = problem.residual()*v;
        z_ = problem.residual()*z;
    }
    else
    {
        const scalar share = problem.share(), c = problem.coefficient();
        forAll(r_, i)
        {
            r_[i] = share*r_[i] + c*v[i];
            z_[i] = share*z_[i] + c*z[i];
        }
        smallest = min(smallest, problem.smallest());
    }
    power_ = mag(gSumProd(r_, z_))/max(smallest, SMALL);
}


// ************************************************************************* //
