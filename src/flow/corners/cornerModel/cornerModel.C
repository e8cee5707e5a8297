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

#include "cornerModel.H"
#include "sparseEntries.H"
#include "openfoamVersion.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cornerModel::sumOverAll(scalarList& values)
{
    Pstream::listCombineGather(values, plusEqOp<scalar>());
    sendListToAll(values);
}


void Foam::cornerModel::gather
(
    const Field<vector2D>& velocity,
    const bool driven,
    scalarList& u
) const
{
    u.setSize(2*starts_.last());
    u = 0;

    forAll(corners_, i)
    {
        const List<wallCorner::cell>& cells = corners_[i].cells();
        forAll(cells, k)
        {
            if (isMine(cells[k]))
            {
                u[2*(starts_[i] + k)] = velocity[cells[k].local].x();
                u[2*(starts_[i] + k) + 1] = velocity[cells[k].local].y();
            }
        }
    }

    if (anyShared_)
    {
        sumOverAll(u);
    }

    if (driven && anyHolds_)
    {
        forAll(corners_, i)
        {
            forAll(corners_[i].cells(), k)
            {
                const vector2D wall(wallVelocity(i, k));
                u[2*(starts_[i] + k)] -= wall.x();
                u[2*(starts_[i] + k) + 1] -= wall.y();
            }
        }
    }
}


Foam::vector2D Foam::cornerModel::wallVelocity
(
    const label corneri,
    const label k
) const
{
    const wallCorner& corner = corners_[corneri];
    const wallCorner::cell& c = corner.cells()[k];
    const FixedList<scalar, 3>& motion = wallMotion_[corneri];

    return
        vector2D(motion[0], motion[1])
      + motion[2]*c.r*corner.alongTheta(c.theta);
}


Foam::scalar Foam::cornerModel::force
(
    const label corneri,
    const scalarList& u,
    const label i
) const
{
    scalar sum = 0;
    for (label j = 0; j < 2*corners_[corneri].cells().size(); ++j)
    {
        sum += K(corneri, i, j)*u[2*starts_[corneri] + j];
    }
    return sum;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cornerModel::cornerModel
(
    const fvMesh& mesh,
    const planarFrame& frame,
    const haloExchange& halo,
    const flowBoundary& boundary,
    const bool wanted
)
:
    mesh_(mesh),
    frame_(frame),
    boundary_(boundary),
    axial_(mesh),
    corners_
    (
        wanted
      ? wallCorner::find(mesh, frame, halo, boundary)
      : List<wallCorner>()
    ),
    starts_(corners_.size() + 1, Zero),
    depth_(corners_.size(), scalar(1)),
    shape_(corners_.size()),
    weight_(corners_.size()),
    wallMotion_(corners_.size(), FixedList<scalar, 3>(scalar(0))),
    anyShared_(false),
    anyHolds_(false),
    rounded_(corners_.size()),
    held_(false)
{
    forAll(corners_, i)
    {
        const wallCorner& corner = corners_[i];
        for (const wallCorner::cell& c : corner.cells())
        {
            anyShared_ = anyShared_ || c.proc != corner.cells()[0].proc;
        }
        for (const wallCorner::wall& w : corner.walls())
        {
            anyHolds_ = anyHolds_ || w.holds;
        }
        starts_[i + 1] = starts_[i] + corner.cells().size();
    }

    if (axial_.active())
    {
        forAll(depth_, i)
        {
            const point vertex(frame.inSpace(corners_[i].vertex()));
            depth_[i] = axial_.angle()*axial_.radius(vertex);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::cornerModel::description() const
{
    label nHold = 0, nSlip = 0;
    for (const wallCorner& c : corners_)
    {
        const label n = c.walls()[0].holds + c.walls()[1].holds;
        nHold += n == 2;
        nSlip += n == 0;
    }

    if (!active())
    {
        return "no";
    }

    OStringStream os;
    os  << "yes (re-entrant: " << nHold << " of no-slip walls, " << nSlip
        << " of slip walls; " << corners_.size() - nSlip - nHold
        << " where slip meets no slip)";
    return os.str();
}


void Foam::cornerModel::setWalls()
{
    if (!anyHolds_)
    {
        return;
    }

    // Velocities of the walls, of those that have one
    scalarList v(4*corners_.size(), Zero);
    forAll(corners_, i)
    {
        for (label side = 0; side < 2; ++side)
        {
            const wallCorner::wall& w = corners_[i].walls()[side];
            if (w.holds && w.proc == Pstream::myProcNo())
            {
                v[4*i + 2*side] = boundary_.u(w.face).x();
                v[4*i + 2*side + 1] = boundary_.u(w.face).y();
            }
        }
    }
    sumOverAll(v);

    forAll(corners_, i)
    {
        const FixedList<wallCorner::wall, 2>& walls = corners_[i].walls();
        const vector2D a(v[4*i], v[4*i + 1]), b(v[4*i + 2], v[4*i + 3]);
        FixedList<scalar, 3>& motion = wallMotion_[i];
        motion = scalar(0);

        if (walls[0].holds && walls[1].holds)
        {
            const vector2D d(walls[1].middle - walls[0].middle);
            const vector2D middle(0.5*(walls[1].middle + walls[0].middle));
            const vector2D change(b - a);
            if (mag(d) > SMALL*corners_[i].size())
            {
                motion[2] = (d.x()*change.y() - d.y()*change.x())/magSqr(d);
            }
            motion[0] = 0.5*(a.x() + b.x()) + motion[2]*middle.y();
            motion[1] = 0.5*(a.y() + b.y()) - motion[2]*middle.x();
        }
        else if (walls[0].holds || walls[1].holds)
        {
            motion[0] = a.x() + b.x();
            motion[1] = a.y() + b.y();
        }
    }
}


void Foam::cornerModel::addForce
(
    const Field<vector2D>& velocity,
    const bool driven,
    scalarField& r
) const
{
    const label n = mesh_.nCells();
    scalarList u;
    gather(velocity, driven, u);

    forAll(corners_, i)
    {
        const List<wallCorner::cell>& cells = corners_[i].cells();
        forAll(cells, k)
        {
            if (isMine(cells[k]))
            {
                r[cells[k].local] -= force(i, u, 2*k);
                r[n + cells[k].local] -= force(i, u, 2*k + 1);
            }
        }
    }
}


void Foam::cornerModel::addDiagonal
(
    const label cmpt,
    scalarField& diag
) const
{
    forAll(corners_, i)
    {
        const List<wallCorner::cell>& cells = corners_[i].cells();
        forAll(cells, k)
        {
            if (isMine(cells[k]))
            {
                diag[cells[k].local] += K(i, 2*k + cmpt, 2*k + cmpt);
            }
        }
    }
}


void Foam::cornerModel::addEntries
(
    const label nBlocks,
    sparseEntries& e
) const
{
    forAll(corners_, i)
    {
        const List<wallCorner::cell>& cells = corners_[i].cells();
        for (label a = 0; a < 2*cells.size(); ++a)
        {
            if (isMine(cells[a/2]))
            {
                for (label b = 0; b < 2*cells.size(); ++b)
                {
                    e.add
                    (
                        nBlocks*cells[a/2].global + a % 2,
                        nBlocks*cells[b/2].global + b % 2,
                        K(i, a, b)
                    );
                }
            }
        }
    }
}


void Foam::cornerModel::addPower
(
    const Field<vector2D>& velocity,
    scalar& walls
) const
{
    scalarList u;
    gather(velocity, true, u);

    forAll(corners_, i)
    {
        const List<wallCorner::cell>& cells = corners_[i].cells();
        forAll(cells, k)
        {
            if (isMine(cells[k]))
            {
                const vector2D F(force(i, u, 2*k), force(i, u, 2*k + 1));
                walls -= F & wallVelocity(i, k);
            }
        }
    }
}


void Foam::cornerModel::addDissipated
(
    const Field<vector2D>& velocity,
    scalarField& power
) const
{
    scalarList u;
    gather(velocity, true, u);

    forAll(corners_, i)
    {
        const List<wallCorner::cell>& cells = corners_[i].cells();
        forAll(cells, k)
        {
            if (isMine(cells[k]))
            {
                const label at = 2*(starts_[i] + k);
                power[cells[k].local] +=
                    force(i, u, 2*k)*u[at] + force(i, u, 2*k + 1)*u[at + 1];
            }
        }
    }
}


void Foam::cornerModel::setMaterials
(
    const scalarField& eta,
    const scalarField& etaC,
    const scalarField& M,
    const scalarField& invB
)
{
    // eta, etaC as it counts, 1/B of the cells of all corners
    scalarList values(3*starts_.last(), Zero);
    forAll(corners_, i)
    {
        const List<wallCorner::cell>& cells = corners_[i].cells();
        forAll(cells, k)
        {
            const label celli = cells[k].local, at = 3*(starts_[i] + k);
            if (isMine(cells[k]))
            {
                values[at] = eta[celli];
                values[at + 1] =
                    M[celli] > 0
                  ? etaC[celli]/(1 + etaC[celli]*sqr(cells[k].r)/M[celli])
                  : 0;
                values[at + 2] = invB[celli];
            }
        }
    }
    sumOverAll(values);

    waiting_.clear();
    forAll(corners_, i)
    {
        const label n = corners_[i].cells().size();
        sectorList sectors(n);
        scalarField W(n);
        bool compressible = false;

        for (label k = 0; k < n; ++k)
        {
            const label at = 3*(starts_[i] + k);
            sectors[k].end = corners_[i].cells()[k].end;
            sectors[k].eta = values[at];
            sectors[k].etaC = values[at + 1];
            W[k] = values[at] + values[at + 1];
            compressible = compressible || values[at + 2] > 0;
        }

        weight_[i] = (compressible ? 0.0 : 1.0)*sqrt(depth_[i]*W);
        if (held_)
        {
            continue;
        }
        rounded_[i] = sectors;
        const word name(round(i, rounded_[i]));
        const auto iter = known_.cfind(name);
        if (iter.found())
        {
            shape_[i] = iter();
        }
        else
        {
            waiting_.append(i);
        }
    }
}


// ************************************************************************* //
