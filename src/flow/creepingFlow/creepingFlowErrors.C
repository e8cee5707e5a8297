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

#include "creepingFlow.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Print the range of values over all processors, or that some are none
    static void printRange
    (
        Ostream& os,
        const char* name,
        const scalarField& values
    )
    {
        label nBad = 0;
        scalar low = VGREAT, high = -VGREAT;
        for (const scalar value : values)
        {
            nBad += !std::isfinite(value);
            low = min(low, value);
            high = max(high, value);
        }
        reduce(nBad, sumOp<label>());
        reduce(low, minOp<scalar>());
        reduce(high, maxOp<scalar>());

        os  << "        " << name << ": ";
        if (nBad)
        {
            os  << "not a number in " << nBad << " cells" << nl;
        }
        else
        {
            os  << low << " to " << high << nl;
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::creepingFlow::refuseInWedge() const
{
    if
    (
        system_.faces().axial().active()
     && materials_.parts().has(sceneParts::COMPRESSIBILITY)
    )
    {
        const fileName file
        (
            mesh_.time().path()/mesh_.time().constant()/"materialProperties"
        );
        FatalIOErrorInFunction(dictionary(file))
            << "A viscosity follows the flow, on a wedge, and a bulk viscosity"
            << " is finite: the rates that it would see are deviators of the"
            << " plane" << nl
            << "    Allowed: B infinite, laws of constant viscosities"
            << " (constant, granularContact), or a planar mesh"
            << exit(FatalIOError);
    }
}


void Foam::creepingFlow::refuseNotFinite() const
{
    FatalErrorInFunction
        << "The flow at time " << mesh_.time().timeName()
        << " is not finite: residuals of U, p_rgh, omega "
        << performance_.final << nl
        << "    It is made of, smallest to largest:" << nl;

    printRange(FatalError, "volume of a cell [m3]", mesh_.V());
    printRange(FatalError, "rho [kg/m3]", materials_.rho());
    printRange(FatalError, "eta [Pa s]", materials_.eta());
    printRange(FatalError, "etaC [Pa s]", materials_.etaC());
    printRange(FatalError, "M [Pa s m2]", materials_.M());

    FatalError
        << "    One of these, a load or a value on a patch is not a number,"
        << " or so large or small that their products are not"
        << exit(FatalError);
}


void Foam::creepingFlow::checkPressureWork
(
    const powerTerms& terms
) const
{
    if (goOn_ || materials_.parts().has(sceneParts::COMPRESSIBILITY))
    {
        return;
    }

    if (!terms.atRest() && terms.pressureError() > 1)
    {
        FatalErrorInFunction
            << "The discrete pressure does " << terms.pressure
            << " W of work at time " << mesh_.time().timeName()
            << ", where gravity and walls supply "
            << terms.gravity + terms.walls << " W and it should do none: the"
            << " flow is wrong" << nl
            << "    Allowed: less than the supply. Cells nearer to squares,"
            << " smaller cells, smaller jumps of the viscosity; or"
            << " notConverged warn, to go on regardless"
            << exit(FatalError);
    }
}


bool Foam::creepingFlow::belowRounding() const
{
    scalar sqrResidual = 0;
    for (const scalar residual : performance_.final)
    {
        sqrResidual += sqr(residual);
    }

    // Sums in each cell round more often than once
    return sqrt(sqrResidual) < 100*solver_.rounding(x_);
}


void Foam::creepingFlow::refuseTolerance() const
{
    FatalIOErrorInFunction(controls_)
        << "Entry 'tolerance' is " << solver_.tolerance()
        << ", but the flow at time " << mesh_.time().timeName()
        << " has residuals of U, p_rgh, omega " << performance_.final
        << " after " << performance_.iterations
        << " iterations, and the rounding of its numbers alone makes "
        << solver_.rounding(x_) << nl
        << "    Allowed: what double precision can meet, here from about "
        << 3*solver_.rounding(x_) << " on; or notConverged warn"
        << exit(FatalIOError);
}


void Foam::creepingFlow::refuseUnconverged() const
{
    FatalErrorInFunction
        << "Flow not converged at time " << mesh_.time().timeName()
        << " after " << performance_.iterations << " iterations:"
        << " residuals of U, p_rgh, omega " << performance_.final << nl
        << "    Largest etaC/eta "
        << system_.coefficients().largestCoupling()
        << ", largest jump of eta between cells "
        << system_.coefficients().largestJump() << nl
        << "    Mesh: distances to neighbours up to "
        << system_.faces().largestAspect() << " : 1, faces up to "
        << system_.faces().largestAngle()
        << " degrees from the path through them" << nl
        << "    Cures, in system/fvSolution, creepingFlow: a larger"
        << " maxIter or nDirections, block whole in preconditioner, a"
        << " larger tolerance; or notConverged warn, to go on"
        << " regardless." << nl
        << "    In the scene: cells nearer to squares (from about 10 : 1"
        << " and 45 degrees on they cost iterations), a smaller etaC/eta or"
        << " contrast (beyond 1e3 and 1e6 the flow hardly depends on"
        << " them)" << exit(FatalError);
}


// ************************************************************************* //
