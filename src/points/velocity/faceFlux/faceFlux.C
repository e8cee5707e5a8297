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

#include "faceFlux.H"
#include "planarCells.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace pointVelocities
{
    defineTypeNameAndDebug(faceFlux, 0);
    addToRunTimeSelectionTable(pointVelocity, faceFlux, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::pointVelocities::faceFlux::inTriangle
(
    const label celli,
    const point& p
) const
{
    const label s = start_[celli];
    auto edge = [&](const label i)
    {
        return faceFlux::edge(celli, i % 3);
    };
    const scalar twoA = frame_.cross(edge(0), edge(1));

    // The fluxes of the two edges at a corner give the velocity there, which
    // is linear between the corners
    vector U(Zero);
    for (label i = 0; i < 3; ++i)
    {
        const label k = (i + 2) % 3;
        const vector corner
        (
            (flux_[s + i] - 0.5*slope_[s + i])*edge(k)
          - (flux_[s + k] + 0.5*slope_[s + k])*edge(i)
        );
        const vector d(p - faceFlux::corner(s + (i + 1) % 3));
        U += frame_.cross(edge(i + 1), d)/sqr(twoA)*corner;
    }
    return U;
}


Foam::vector Foam::pointVelocities::faceFlux::inQuadrilateral
(
    const label celli,
    const point& p
) const
{
    // In the plane, from the first corner: the sides to its neighbours and
    // what the fourth is off a parallelogram
    const label s = start_[celli];
    auto corner = [&](const label i)
    {
        return frame_.inPlane(points_[corners_[s + i]]);
    };
    const vector2D o(corner(0));
    const vector2D a(corner(1) - o);
    const vector2D b(corner(3) - o);
    const vector2D c((corner(2) - corner(1)) - b);
    const vector2D d(frame_.inPlane(p) - o);
    const bool affine = fluxBox::is(a, b, c);

    // Newton's method for xi, eta; one step for a parallelogram
    scalar xi = 0.5, eta = 0.5, J = 1;
    vector2D xXi(a), xEta(b);
    for (label i = 0; i < 10; ++i)
    {
        xXi = a + eta*c;
        xEta = b + xi*c;
        J = xXi.x()*xEta.y() - xXi.y()*xEta.x();

        const vector2D r(d - xi*a - eta*b - xi*eta*c);
        const scalar dXi = (r.x()*xEta.y() - r.y()*xEta.x())/J;
        const scalar dEta = (xXi.x()*r.y() - xXi.y()*r.x())/J;
        xi += dXi;
        eta += dEta;

        if (affine || mag(dXi) + mag(dEta) < 1e-12)
        {
            break;
        }
    }

    const vector2D f(through(s, xi, eta));

    return frame_.inSpace((f.x()*xXi + f.y()*xEta)/J);
}


Foam::vector2D Foam::pointVelocities::faceFlux::through
(
    const label s,
    const scalar xi,
    const scalar eta
) const
{
    if (faces_[s + 3] >= 0)
    {
        return fluxBox::through(&flux_[s], &slope_[s], xi, eta);
    }

    // Towards the axis r U along it goes with r and r U across it with r^2
    return vector2D
    (
        (flux_[s + 1] + slope_[s + 1]*(eta - 0.5))*sqr(xi),
        2*xi
       *(
            flux_[s + 2]*eta
          - flux_[s]*(1 - eta)
          + 0.5*slope_[s + 1]*eta*(1 - eta)
        )
    );
}


Foam::vector Foam::pointVelocities::faceFlux::inCell
(
    const label celli,
    const point& p
) const
{
    if (fan_[celli] >= 0)
    {
        return fans_[fan_[celli]].value(p);
    }

    return
        start_[celli + 1] - start_[celli] == 3
      ? inTriangle(celli, p)
      : inQuadrilateral(celli, p);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::pointVelocities::faceFlux::takeFluxes()
{
    const fvMesh& mesh = phi_.mesh();
    scalarField all(mesh.nFaces(), Zero);

    SubList<scalar>(all, mesh.nInternalFaces()) = phi_.primitiveField();
    forAll(phi_.boundaryField(), patchi)
    {
        const scalarField& phip = phi_.boundaryField()[patchi];
        const label start = mesh.boundaryMesh()[patchi].start();
        forAll(phip, i)
        {
            all[start + i] = phip[i];
        }
    }

    for (label celli = 0; celli + 1 < start_.size(); ++celli)
    {
        for (label i = start_[celli]; i < start_[celli + 1]; ++i)
        {
            const label facei = faces_[i];
            if (facei >= 0)
            {
                const bool out = mesh.faceOwner()[facei] == celli;
                flux_[i] = (out ? all[facei] : -all[facei])/depth_;
            }
        }
    }
}


void Foam::pointVelocities::faceFlux::setSlopes(const scalarField& slopes)
{
    forAll(slope_, i)
    {
        slope_[i] = faces_[i] < 0 || slopes.empty() ? 0 : slopes[faces_[i]];
    }
    if (!axial_.active())
    {
        return;
    }

    for (label celli = 0; celli + 1 < start_.size(); ++celli)
    {
        for (label i = start_[celli]; i < start_[celli + 1]; ++i)
        {
            if (faces_[i] >= 0)
            {
                const vector t(edge(celli, i - start_[celli]));
                const scalar r = axial_.radius(corner(i) + 0.5*t);
                const bool ends = onAxis(corner(i)) || onAxis(corner(i) + t);

                slope_[i] =
                    (ends ? 0 : r*slope_[i]) + flux_[i]*t[axial_.radial()]/r;
            }
        }
    }
}


void Foam::pointVelocities::faceFlux::setFan
(
    const label i,
    scalar vorticity
)
{
    const label celli = fanCells_[i];
    const label start = start_[celli];
    const label n = start_[celli + 1] - start;

    if (axial_.active())
    {
        // That of r U
        const bool first = axial_.radial() == frame_.i0();
        vorticity =
            axial_.radius(phi_.mesh().cellCentres()[celli])*vorticity
          + (first ? U_[celli][frame_.i1()] : -U_[celli][frame_.i0()]);
    }

    fans_[i].set
    (
        SubList<scalar>(flux_, n, start),
        SubList<scalar>(slope_, n, start),
        vorticity
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointVelocities::faceFlux::faceFlux
(
    const dictionary& dict,
    const volVectorField& U,
    const surfaceScalarField& phi
)
:
    U_(U),
    phi_(phi),
    frame_(U.mesh()),
    axial_(U.mesh()),
    points_(U.mesh().points()),
    start_(U.size() + 1, Zero)
{
    const fvMesh& mesh = U.mesh();
    depth_ =
        axial_.active()
      ? axial_.angle()
      : mesh.bounds().span()[frame_.normalAxis()];
    least_ = 1e-9*mesh.bounds().mag();
    fan_.setSize(mesh.nCells(), -1);

    const planarCells cells(mesh);
    forAll(fan_, celli)
    {
        start_[celli + 1] = start_[celli] + cells.outline(celli).size();
    }

    const label n = start_.last();
    corners_.setSize(n);
    faces_.setSize(n);
    flux_.setSize(n, Zero);
    slope_.setSize(n, Zero);

    if (!axial_.active())
    {
        boxes_.setSize(mesh.nCells());
        box_.setSize(mesh.nCells(), false);
    }
    forAll(fan_, celli)
    {
        setCorners(celli, cells.outline(celli));
        setFaces(celli);
        makeFan(celli);
        makeBox(celli);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointVelocities::faceFlux::update()
{
    takeFluxes();
    if (axial_.active())
    {
        setSlopes(scalarField());
    }

    forAll(fans_, i)
    {
        setFan(i, 0);
    }
}


Foam::vector Foam::pointVelocities::faceFlux::value(const particle& p) const
{
    return value(p.position(), p.cell());
}


Foam::vector Foam::pointVelocities::faceFlux::value
(
    const point& p,
    const label celli
) const
{
    if (!axial_.active())
    {
        return inCell(celli, p);
    }

    const scalar r = max(axial_.radius(p), least_);
    point q(p);
    q[axial_.radial()] += r - axial_.radius(p);

    return inCell(celli, q)/r;
}


void Foam::pointVelocities::faceFlux::inPlane
(
    const planarWalk& walk,
    const UList<vector2D>& places,
    const labelUList& cells,
    UList<vector2D>& U
) const
{
    forAll(places, i)
    {
        const label celli = cells[i];
        if (box_.size() && box_[celli])
        {
            const label s = start_[celli];
            U[i] = boxes_[celli].value(places[i], &flux_[s], &slope_[s]);
        }
        else
        {
            U[i] = frame_.inPlane(value(frame_.inSpace(places[i]), celli));
        }
    }
}


// ************************************************************************* //
