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

#include "flowLoads.H"
#include "coupledPolyPatch.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam
{
    //- Where p_rgh is given: densities, lowest height and last patch; and
    //- whether p is given anywhere instead
    struct openings
    {
        scalar least, most, lowest;
        label patch;
        bool byWeight;

        openings
        (
            const fvMesh& mesh,
            const flowBoundary& boundary,
            const scalarField& rho,
            const vector& g
        )
        :
            least(GREAT),
            most(-GREAT),
            lowest(GREAT),
            patch(-1),
            byWeight(false)
        {
            const vector up(mag(g) > 0 ? -g/mag(g) : vector(Zero));

            for (const label patchi : boundary.patches())
            {
                const auto is = boundary.pressureMeaning(patchi);
                byWeight = byWeight || patchFieldTypes::byWeight(is);
                if
                (
                    !patchFieldTypes::givesValue(is)
                 || patchFieldTypes::byWeight(is)
                )
                {
                    continue;
                }

                patch = patchi;
                for (const label celli : mesh.boundary()[patchi].faceCells())
                {
                    least = min(least, rho[celli]);
                    most = max(most, rho[celli]);
                }
                const polyPatch& pp = mesh.boundaryMesh()[patchi];
                for (const point& p : pp.localPoints())
                {
                    lowest = min(lowest, p & up);
                }
            }
            reduce(least, minOp<scalar>());
            reduce(most, maxOp<scalar>());
            reduce(lowest, minOp<scalar>());

            if (patch < 0)
            {
                least = 0;
            }
        }
    };
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::flowLoads::checkPeriodic(const coupledPolyPatch& pp) const
{
    const vector g(gravity());
    const vector turned(transform(pp.forwardT()[0], g));

    if (mag(turned - g) > 1e-6*mag(g))
    {
        FatalErrorInFunction
            << "Gravity " << g << " is " << turned << " where patch "
            << pp.name() << " is turned onto its partner: the body is"
            << " periodic, its weight is not" << nl
            << "    Allowed: gravity along the axis of cyclic patches with a"
            << " rotation; or walls in their place" << exit(FatalError);
    }
}


Foam::vector Foam::flowLoads::periodicGravity() const
{
    const vector g(gravity());

    vector periodic(Zero);
    for (const polyPatch& pp : mesh_.mesh().boundaryMesh())
    {
        if (isA<coupledPolyPatch>(pp) && pp.size())
        {
            const coupledPolyPatch& cpp = refCast<const coupledPolyPatch>(pp);
            if (!cpp.parallel())
            {
                checkPeriodic(cpp);
            }
            else if (cpp.separated())
            {
                const vector along(normalised(cpp.separation()[0]));
                periodic = periodic - (periodic & along)*along
                  + (g & along)*along;
            }
        }
    }
    reduce(periodic, maxMagSqrOp<vector>());

    return periodic;
}


void Foam::flowLoads::setHeights(const vector& periodic)
{
    const scalarField& rho = rho_;
    const scalar gh = height_.gh(gravity(), periodic);

    // Of the constant that a pressure may have as much as leaves small numbers
    // where p_rgh is given far away
    const openings given(mesh_.mesh(), boundary_, rho, gravity());
    const bool far = mag(gh) > 1e3*mag(gravity())*mesh_.mesh().bounds().mag();
    const scalar level = far && !given.byWeight ? given.least*gh : 0;

    fromPRgh_ = rho*gh - level;
    const vectorField& C = mesh_.mesh().C();
    rhoGh_ = rho*(gradientGravity_ & (C - height_.middle())) + level;

    givenFromPRgh_ = scalarField(mesh_.nSlots() - mesh_.nCells(), Zero);
    for (const label patchi : boundary_.patches())
    {
        const fvPatch& patch = mesh_.mesh().boundary()[patchi];
        const label start = boundary_.at(mesh_.halo().start(patchi));
        const bool byWeight =
            patchFieldTypes::byWeight(boundary_.pressureMeaning(patchi));

        forAll(patch, i)
        {
            const label celli = patch.faceCells()[i];
            givenFromPRgh_[start + i] = fromPRgh_[celli];
            if (byWeight)
            {
                // That type knows nothing of what is periodic
                givenFromPRgh_[start + i] +=
                    rho[celli]*(periodic & patch.Cf()[i]);
            }
        }
    }

    if (!height_.given())
    {
        checkHeights();
    }
}


void Foam::flowLoads::checkHeights() const
{
    const openings given(mesh_.mesh(), boundary_, rho_, gravity());

    if
    (
        given.patch >= 0 && given.most - given.least > 1e-9*given.most
     && mag(given.lowest) > 1e-6*mesh_.mesh().bounds().mag()
    )
    {
        const dictionary where
        (
            fileName
            (
                mesh_.mesh().time().timeName()/"p_rgh.boundaryField."
              + mesh_.mesh().boundary()[given.patch].name()
            )
        );

        FatalIOErrorInFunction(where)
            << "Entry 'type' gives p_rgh = p - rho gh, and densities are "
            << given.least << " to " << given.most << " kg/m3 where it is"
            << " given, so that the flow depends on what heights are counted"
            << " from; the lowest place where it is given is at height "
            << given.lowest << nl
            << "    Allowed: a file constant/hRef, of the height where p_rgh"
            << " is p (0 to count from the origin); or type prghPressure,"
            << " which gives p" << exit(FatalIOError);
    }
}


// ************************************************************************* //
