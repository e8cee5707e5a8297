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
#include "oneLayer.H"
#include "meshTools.H"
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

void Foam::pointVelocities::faceFlux::setCorners
(
    const label celli,
    const pointField& corners
)
{
    const label n = corners.size();
    const label start = start_[celli];

    scalar area = 0;
    for (label i = 2; i < n; ++i)
    {
        area += frame_.cross
        (
            corners[i - 1] - corners[0], corners[i] - corners[0]
        );
    }
    const bool clockwise = area < 0;

    auto corner = [&](const label i)
    {
        return corners[clockwise ? n - 1 - i % n : i % n];
    };
    label first = 0;
    for (label i = 0; i < n; ++i)
    {
        if (onAxis(corner(i)) && onAxis(corner(i + 1)))
        {
            first = i + 1;
        }
    }

    for (label i = 0; i < n; ++i)
    {
        corners_[start + i] = corner(first + i);
    }
}


void Foam::pointVelocities::faceFlux::setFaces(const label celli)
{
    const polyMesh& mesh = phi_.mesh();
    const label start = start_[celli];
    const label n = start_[celli + 1] - start;

    for (label i = 0; i < n; ++i)
    {
        const point& from = corners_[start + i];
        const point middle(from + 0.5*edge(celli, i));
        faces_[start + i] = -1;
        sign_[start + i] = 0;
        if (onAxis(from) && onAxis(middle))
        {
            continue;
        }

        scalar nearest = GREAT;

        for (const label facei : mesh.cells()[celli])
        {
            const label patchi =
                mesh.isInternalFace(facei)
              ? -1
              : mesh.boundaryMesh().whichPatch(facei);

            if
            (
                patchi >= 0
             && oneLayer::isPlane(mesh.boundaryMesh()[patchi])
            )
            {
                continue;
            }

            const vector d(mesh.faceCentres()[facei] - middle);
            const scalar distance = magSqr(frame_.inPlane(d));
            if (distance < nearest)
            {
                nearest = distance;
                faces_[start + i] = facei;
                sign_[start + i] =
                    mesh.faceOwner()[facei] == celli ? 1 : -1;
            }
        }
    }
}


void Foam::pointVelocities::faceFlux::makeFan(const label celli)
{
    const label start = start_[celli];
    const label n = start_[celli + 1] - start;
    const SubList<point> corners(corners_, n, start);

    if (n == 3 || (n == 4 && planarCells::turns(corners).size() == 4))
    {
        return;
    }
    if (faces_[start + n - 1] < 0)
    {
        FatalErrorInFunction
            << "Cell " << celli << " has an edge on the axis and the corners "
            << corners << nl
            << "    Allowed: triangles and convex quadrilaterals along the"
            << " axis, or here velocity cellPoint, cell, cellPointFace, ... in"
            << " materialPointsProperties" << exit(FatalError);
    }

    point centre(phi_.mesh().cellCentres()[celli]);
    meshTools::constrainToMeshCentre(phi_.mesh(), centre);

    fan_[celli] = fans_.size();
    fanCells_.append(celli);
    fans_.append(new fluxFan(frame_, centre, corners));

    // Below this its numbers would be rounding
    if (fans_[fan_[celli]].flatness() < 1e-6)
    {
        FatalErrorInFunction
            << "Cell " << celli << " at " << centre << " has the corners "
            << corners << ", and its centre does not see all edges" << nl
            << "    Allowed: convex cells, also with hanging nodes, or here"
            << " velocity cellPoint, cell, cellPointFace, ... in"
            << " materialPointsProperties" << exit(FatalError);
    }
}


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
        const vector d(p - corners_[s + (i + 1) % 3]);
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
    const point& o = corners_[s];
    const direction i0 = frame_.i0(), i1 = frame_.i1();
    const scalar a0 = corners_[s + 1][i0] - o[i0];
    const scalar a1 = corners_[s + 1][i1] - o[i1];
    const scalar b0 = corners_[s + 3][i0] - o[i0];
    const scalar b1 = corners_[s + 3][i1] - o[i1];
    const scalar c0 = corners_[s + 2][i0] - corners_[s + 1][i0] - b0;
    const scalar c1 = corners_[s + 2][i1] - corners_[s + 1][i1] - b1;
    const scalar d0 = p[i0] - o[i0];
    const scalar d1 = p[i1] - o[i1];
    const bool affine =
        mag(c0) + mag(c1) < 1e-14*(mag(a0) + mag(a1) + mag(b0) + mag(b1));

    // Newton's method for xi, eta; one step for a parallelogram
    scalar xi = 0.5, eta = 0.5, J = 1;
    scalar xXi0 = a0, xXi1 = a1, xEta0 = b0, xEta1 = b1;
    for (label i = 0; i < 10; ++i)
    {
        xXi0 = a0 + eta*c0;
        xXi1 = a1 + eta*c1;
        xEta0 = b0 + xi*c0;
        xEta1 = b1 + xi*c1;
        J = xXi0*xEta1 - xXi1*xEta0;

        const scalar r0 = d0 - xi*a0 - eta*b0 - xi*eta*c0;
        const scalar r1 = d1 - xi*a1 - eta*b1 - xi*eta*c1;
        const scalar dXi = (r0*xEta1 - r1*xEta0)/J;
        const scalar dEta = (xXi0*r1 - xXi1*r0)/J;
        xi += dXi;
        eta += dEta;

        if (affine || mag(dXi) + mag(dEta) < 1e-12)
        {
            break;
        }
    }

    const Pair<scalar> f(through(s, xi, eta));

    return frame_.inSpace
    (
        (f.first()*xXi0 + f.second()*xEta0)/J,
        (f.first()*xXi1 + f.second()*xEta1)/J
    );
}


Foam::Pair<Foam::scalar> Foam::pointVelocities::faceFlux::through
(
    const label s,
    const scalar xi,
    const scalar eta
) const
{
    const scalar x = xi - 0.5, y = eta - 0.5;

    // Towards the axis r U along it goes with r and r U across it with r^2
    if (faces_[s + 3] < 0)
    {
        return Pair<scalar>
        (
            (flux_[s + 1] + slope_[s + 1]*y)*sqr(xi),
            2*xi
           *(
                flux_[s + 2]*eta
              - flux_[s]*(1 - eta)
              + 0.5*slope_[s + 1]*eta*(1 - eta)
            )
        );
    }

    // Fluxes change along the edges; what that adds to the divergence is
    // taken out by terms that vanish on the edges
    return Pair<scalar>
    (
        (flux_[s + 1] + slope_[s + 1]*y)*xi
      - (flux_[s + 3] - slope_[s + 3]*y)*(1 - xi)
      + 0.5*(slope_[s] - slope_[s + 2])*xi*(1 - xi),
        (flux_[s + 2] - slope_[s + 2]*x)*eta
      - (flux_[s] + slope_[s]*x)*(1 - eta)
      + 0.5*(slope_[s + 1] - slope_[s + 3])*eta*(1 - eta)
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

    forAll(flux_, i)
    {
        flux_[i] = faces_[i] < 0 ? 0 : sign_[i]*all[faces_[i]]/depth_;
    }
}


void Foam::pointVelocities::faceFlux::setSlopes(const tensorField& gradU)
{
    for (label celli = 0; celli + 1 < start_.size(); ++celli)
    {
        for (label i = start_[celli]; i < start_[celli + 1]; ++i)
        {
            // Along the edge, and outward with the same length
            const vector t(edge(celli, i - start_[celli]));
            const vector outward
            (
                frame_.inSpace(planarFrame::tangent(frame_.inPlane(t)))
            );

            slope_[i] =
                faces_[i] < 0 || gradU.empty()
              ? 0 : (t & gradU[faces_[i]]) & outward;

            if (axial_.active() && faces_[i] >= 0)
            {
                const scalar r = axial_.radius(corners_[i] + 0.5*t);
                const bool ends =
                    onAxis(corners_[i]) || onAxis(corners_[i] + t);

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
    List<pointField> corners(mesh.nCells());
    forAll(corners, celli)
    {
        corners[celli] = cells.corners(celli);
        start_[celli + 1] = start_[celli] + corners[celli].size();
    }

    const label n = start_.last();
    corners_.setSize(n);
    faces_.setSize(n);
    sign_.setSize(n);
    flux_.setSize(n, Zero);
    slope_.setSize(n, Zero);

    forAll(corners, celli)
    {
        setCorners(celli, corners[celli]);
        setFaces(celli);
        makeFan(celli);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointVelocities::faceFlux::update()
{
    takeFluxes();
    if (axial_.active())
    {
        setSlopes(tensorField());
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


// ************************************************************************* //
