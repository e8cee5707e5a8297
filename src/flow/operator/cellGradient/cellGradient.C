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

#include "cellGradient.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellGradient::calcRotation
(
    operatorState& s,
    const bool everywhere
) const
{
    s.gradOmega = Zero;

    auto add = [&](const label celli, const vector2D& S, const scalar omega)
    {
        // Differences, so that the faces left out do not matter
        s.gradOmega[celli] += (omega - s.omega[celli])*S;
    };

    auto addFace = [&](const label f)
    {
        // No couple passes where M is zero on one side, nor has omega a meaning
        // there
        if (K_.rotation(f).Km > 0)
        {
            const planarFace& face = mesh_[f];
            const vector2D S(mesh_.edge(f)*face.n);
            const scalar omega =
                face.w*s.omega[face.own] + (1 - face.w)*s.omega[face.nei];
            add(face.own, S, omega);
            add(face.nei, -S, omega);
        }
    };
    auto setCell = [&](const label celli)
    {
        s.gradOmega[celli] = mesh_.gradient(celli, s.gradOmega[celli]);
    };

    if (everywhere)
    {
        mesh_.forTwoSided(addFace);
    }
    else
    {
        for (const label f : mesh_.leaning().faces)
        {
            addFace(f);
        }
    }
    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        add(face.own, mesh_.edge(f)*face.n, s.omega[face.nei]);
    }
    for (const axisEdge& axis : mesh_.axisEdges())
    {
        add(axis.celli, axis.S, 0);
    }

    if (everywhere)
    {
        for (label celli = 0; celli < mesh_.nCells(); ++celli)
        {
            setCell(celli);
        }
    }
    else
    {
        for (const label celli : mesh_.leaning().cells)
        {
            setCell(celli);
        }
    }
    mesh_.halo().swap(s.gradOmega);
}


void Foam::cellGradient::weight(operatorState& s) const
{
    // Faces first, without what the gradient of the cell itself adds
    for (const jumpFace& jump : K_.jumps())
    {
        const planarFace& face = mesh_[jump.f];
        const label P = face.own, N = face.nei;
        const vector2D d(s.u[N] - s.u[P]), t(face.t());

        for (const label celli : {P, N})
        {
            if (celli >= mesh_.nCells())
            {
                continue;
            }
            const jumpSide& side = jump.sides[celli == P ? 0 : 1];
            const scalar vn = (face.w - side.wn)*(d & face.n);
            scalar vt = (face.w - side.wt)*(d & t);
            if (K_.cosserat())
            {
                vt += side.omegaP*s.omega[P] + side.omegaN*s.omega[N];
            }
            s.G[celli] +=
                mesh_.gradientVector(celli, jump.f)*(vn*face.n + vt*t);
        }
    }

    // Then that
    for (const jumpCell& cell : K_.jumpCells())
    {
        s.G[cell.celli] = product(cell.inverse, s.G[cell.celli]);
    }
}


void Foam::cellGradient::addFaceAdjoint
(
    const Field<tensor2D>& B,
    const unknowns& all,
    scalarField& r
) const
{
    for (const label f : mesh_.aroundAdjoint().faces)
    {
        const planarFace& face = mesh_[f];
        const vector2D b
        (
            mesh_.edge(f)*(face.n & (B[face.own] - B[face.nei]))
        );
        all.addForce(r, face.own, face.w*b);
        all.addForce(r, face.nei, (1 - face.w)*b);
    }

    for (const axisEdge& axis : mesh_.axisEdges())
    {
        all.addForce(r, axis.celli, onAxis(axis.S & B[axis.celli]));
    }

    // Weights of jumps instead of linear ones
    for (const jumpFace& jump : K_.jumps())
    {
        const planarFace& face = mesh_[jump.f];
        const vector2D t(face.t());
        vector2D c(Zero);
        for (const label k : {0, 1})
        {
            const jumpSide& side = jump.sides[k];
            const vector2D b
            (
                (k ? -mesh_.edge(jump.f) : mesh_.edge(jump.f))
               *(face.n & B[k ? face.nei : face.own])
            );
            c += (face.w - side.wn)*(b & face.n)*face.n
               + (face.w - side.wt)*(b & t)*t;
        }
        all.addForce(r, face.own, -c);
        all.addForce(r, face.nei, c);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellGradient::cellGradient
(
    const faceGeometry& mesh,
    const flowBoundary& boundary,
    const viscousCoefficients& K
)
:
    mesh_(mesh),
    boundary_(boundary),
    K_(K)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cellGradient::setBoundary
(
    operatorState& s,
    const bool driven
) const
{
    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        const label i = mesh_.boundaryOf(f);
        vector2D& u = s.u[face.nei];

        if (K_.cosserat())
        {
            setWallRotation(s, f, driven);
        }

        switch (boundary_.velocity(i))
        {
            case flowBoundary::VELOCITY:
            {
                u = driven ? boundary_.u(i) : vector2D(Zero);
                break;
            }
            case flowBoundary::TRACTION:
            {
                u = wallSpeed(s, f, driven)*face.t();
                if (driven && boundary_.frictional())
                {
                    u += boundary_.normalSpeed(i)*face.n;
                }
                break;
            }
            case flowBoundary::OPEN:
            {
                u = s.u[face.own];
                break;
            }
        }
    }
}


void Foam::cellGradient::gauss(operatorState& s) const
{
    s.G = Zero;

    // Differences, so that the digits of a large common velocity do not matter
    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh_[f];
            const tensor2D flux
            (
                mesh_.edge(f)*(face.n*(s.u[face.nei] - s.u[face.own]))
            );

            // What a slot gets here is overwritten by swap()
            s.G[face.own] += (1 - face.w)*flux;
            s.G[face.nei] += face.w*flux;
        }
    );
    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        s.G[face.own] +=
            mesh_.edge(f)*(face.n*(s.u[face.nei] - s.u[face.own]));
    }
    for (const axisEdge& axis : mesh_.axisEdges())
    {
        const vector2D& u = s.u[axis.celli];
        s.G[axis.celli] += axis.S*(onAxis(u) - u);
    }

    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        s.G[celli] = mesh_.gradient(celli, s.G[celli]);
    }
}


void Foam::cellGradient::calc(operatorState& s, const bool driven) const
{
    gauss(s);
    if (s.gradOmega.size())
    {
        calcRotation(s, driven || s.followed);
    }
    weight(s);

    const List<jumpWall>& walls = K_.jumpWalls();
    List<tensor2D> before(walls.size());
    forAll(walls, i)
    {
        before[i] = s.G[walls[i].celli];
    }
    correctWalls(s, driven);
    weightWalls(s, before);
    turnWalls(s, driven);
}


void Foam::cellGradient::addAdjoint
(
    Field<tensor2D>& B,
    const unknowns& all,
    scalarField& r
) const
{
    for (const jumpCell& cell : K_.jumpCells())
    {
        B[cell.celli] = transposedProduct(cell.inverse, B[cell.celli]);
    }
    for (const label celli : mesh_.aroundAdjoint().cells)
    {
        B[celli] = mesh_.gradientAdjoint(celli, B[celli]);
    }
    mesh_.halo().swap(B);

    addFaceAdjoint(B, all, r);
}


// ************************************************************************* //
