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

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Steps in which viscosities are rounded, in each power of e
static const Foam::scalar stepsInE = 10;

//- etaC over eta that is none
static const Foam::scalar noCoupling = 1e-3;

//- Radii, over the mean distance of the cells around a corner, in which
//- residuals count (those cells and the next ring on squares) and solutions
//- are sampled; the distance from which corners do not disturb each other
static const Foam::scalar countedRadius = 3.2, sampledRadius = 8,
    freeRadius = 14;

//- Part of a second solution, in the cells around, that must be its own
static const Foam::scalar smallestShare = 0.02;

//- Internal lengths over the size of a corner that keep all from rotating
static const Foam::scalar manyLengths = 1e4;

//- Shapes that are kept
static const Foam::label nKept = 5000;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::cornerModel::round
(
    const label corneri,
    sectorList& sectors
) const
{
    scalar largest = 0;
    for (const cornerFlow::sector& s : sectors)
    {
        largest = max(largest, s.eta);
    }

    OStringStream name;
    name << corneri;
    for (cornerFlow::sector& s : sectors)
    {
        const label eta = std::lround(stepsInE*Foam::log(s.eta/largest));
        name << '_' << eta;
        const scalar ratio = s.etaC/s.eta;
        s.eta = Foam::exp(eta/stepsInE);
        s.etaC = 0;
        if (ratio > noCoupling)
        {
            const label coupling = std::lround(stepsInE*Foam::log(ratio));
            name << 'c' << coupling;
            s.etaC = s.eta*Foam::exp(coupling/stepsInE);
        }
    }
    return word(name.str(), false);
}


void Foam::cornerModel::sample
(
    const job& j,
    const label modei,
    const scalar r,
    const scalar theta,
    vector2D& u,
    scalar& p
) const
{
    const wallCorner& corner = corners_[j.corner];
    u = vector2D(0, 0);
    p = 0;

    for (label k = 0; k < j.flow->size(); ++k)
    {
        scalar ur, ut, pk;
        j.flow->evaluate(k, r/corner.size(), theta, ur, ut, pk);
        const scalar share = j.shares[modei][k];
        u += share*(ur*corner.alongR(theta) + ut*corner.alongTheta(theta));
        p += share*pk/corner.size();
    }
}


void Foam::cornerModel::prepare(job& j) const
{
    const wallCorner& corner = corners_[j.corner];
    const List<wallCorner::cell>& cells = corner.cells();

    j.flow.reset
    (
        new cornerFlow
        (
            j.sectors, corner.walls()[0].holds, corner.walls()[1].holds
        )
    );

    // Orthonormal in the cells around, by Gram and Schmidt
    label nModes = 0;
    scalarRectangularMatrix& values = j.defect.s;
    values.setSize(2*cells.size(), j.flow->size());
    j.shares.setSize(j.flow->size());

    auto product = [&](const label a, const label b)
    {
        scalar sum = 0;
        for (label i = 0; i < 2*cells.size(); ++i)
        {
            const cornerFlow::sector& s = j.sectors[i/2];
            sum += (s.eta + s.etaC)*values(i, a)*values(i, b);
        }
        return sum;
    };
    auto sampleCells = [&](const label modei)
    {
        forAll(cells, k)
        {
            vector2D u;
            scalar p;
            sample(j, modei, cells[k].r, cells[k].theta, u, p);
            values(2*k, modei) = u.x();
            values(2*k + 1, modei) = u.y();
        }
        return product(modei, modei);
    };

    for (label modei = 0; modei < j.flow->size(); ++modei)
    {
        FixedList<scalar, cornerFlow::maxModes>& share = j.shares[nModes];
        share = scalar(0);
        share[modei] = 1;
        const scalar whole = sampleCells(nModes);
        for (label other = 0; other < nModes; ++other)
        {
            const scalar part = product(nModes, other);
            for (label k = 0; k < j.flow->size(); ++k)
            {
                share[k] -= part*j.shares[other][k];
            }
        }
        const scalar own = sampleCells(nModes);
        if (own > smallestShare*whole)
        {
            for (scalar& s : share)
            {
                s /= Foam::sqrt(own);
            }
            sampleCells(nModes);
            ++nModes;
        }
    }
    j.shares.setSize(nModes);

    j.defect.reset(j.sectors, nModes);

    findCells(j);
}


void Foam::cornerModel::findCells(job& j) const
{
    const wallCorner& corner = corners_[j.corner];
    const pointField& C = mesh_.cellCentres();
    DynamicList<label> cells;
    DynamicList<scalar> r, theta;
    DynamicList<bool> counts;

    forAll(C, celli)
    {
        const vector2D way
        (
            corner.from
            (
                vector2D(C[celli][frame_.i0()], C[celli][frame_.i1()])
            )
        );
        const scalar distance = mag(way);
        if (distance < sampledRadius*corner.size())
        {
            const scalar t = corner.theta(way);
            cells.append(celli);
            r.append(distance);
            theta.append(t);
            counts.append
            (
                distance < countedRadius*corner.size()
             && t > 0 && t < corner.angle()
             && !hasOtherWall(celli, j.corner)
            );
        }
    }

    j.cells = cells;
    j.r = r;
    j.theta = theta;
    j.counts = counts;
}


bool Foam::cornerModel::hasOtherWall
(
    const label celli,
    const label corneri
) const
{
    const wallCorner& corner = corners_[corneri];

    // The axis is one
    if (axial_.active())
    {
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            if (axial_.radius(mesh_.points()[pointi]) < 1e-6*corner.size())
            {
                return true;
            }
        }
    }

    for (const label facei : mesh_.cells()[celli])
    {
        if (!mesh_.isInternalFace(facei))
        {
            const polyPatch& pp =
                mesh_.boundaryMesh()
                [
                    mesh_.boundaryMesh().whichPatch(facei)
                ];
            const vector& n = mesh_.faceAreas()[facei];
            const vector& c = mesh_.faceCentres()[facei];
            const vector2D way
            (
                corner.from(vector2D(c[frame_.i0()], c[frame_.i1()]))
            );
            const scalar t = corner.theta(way);
            if
            (
                !pp.coupled()
             && mag(n & frame_.e()) < 0.5*mag(n)
             && mag(t) > 1e-3
             && mag(t - corner.angle()) > 1e-3
            )
            {
                return true;
            }
        }
    }
    return false;
}


void Foam::cornerModel::setMode
(
    const job& j,
    const label modei,
    scalarField& x
) const
{
    const label n = mesh_.nCells();
    forAll(j.cells, i)
    {
        vector2D u;
        scalar p;
        sample(j, modei, j.r[i], j.theta[i], u, p);
        x[j.cells[i]] = u.x();
        x[n + j.cells[i]] = u.y();
        x[2*n + j.cells[i]] = p;
    }
}


void Foam::cornerModel::setUnit
(
    const job& j,
    const label unknown,
    scalarField& x
) const
{
    const wallCorner& corner = corners_[j.corner];
    const wallCorner::cell& c = corner.cells()[unknown/3];
    if (isMine(c))
    {
        const label cmpt = unknown % 3;
        x[cmpt*mesh_.nCells() + c.local] = cmpt < 2 ? 1 : 1/corner.size();
    }
}


void Foam::cornerModel::add
(
    const job& j,
    const scalarField& r,
    const label column,
    scalarRectangularMatrix& sums,
    scalarRectangularMatrix& rows
) const
{
    const wallCorner& corner = corners_[j.corner];
    const label n = mesh_.nCells();

    forAll(j.cells, i)
    {
        if (j.counts[i])
        {
            const label celli = j.cells[i];
            for (label a = 0; a < sums.m(); ++a)
            {
                vector2D u;
                scalar p;
                sample(j, a, j.r[i], j.theta[i], u, p);
                sums(a, column) +=
                    u.x()*r[celli] + u.y()*r[n + celli] - p*r[2*n + celli];
            }
        }
    }
    forAll(corner.cells(), k)
    {
        const wallCorner::cell& c = corner.cells()[k];
        if (isMine(c))
        {
            rows(3*k, column) = r[c.local];
            rows(3*k + 1, column) = r[n + c.local];
            rows(3*k + 2, column) = -r[2*n + c.local]/corner.size();
        }
    }
}


void Foam::cornerModel::measure(const discreteOperator& residual)
{
    label nUnknowns = 0, nModes = 0;
    for (const job& j : jobs_)
    {
        nUnknowns = max(nUnknowns, j.defect.nUnknowns());
        nModes = max(nModes, j.defect.nModes());
    }

    scalarField x(4*mesh_.nCells()), r;

    for (label modei = 0; modei < nModes; ++modei)
    {
        x = 0;
        for (const job& j : jobs_)
        {
            if (modei < j.defect.nModes())
            {
                setMode(j, modei, x);
            }
        }
        residual(x, r);
        for (job& j : jobs_)
        {
            if (modei < j.defect.nModes())
            {
                add(j, r, modei, j.defect.sAs, j.defect.As);
            }
        }
    }

    for (label unknown = 0; unknown < nUnknowns; ++unknown)
    {
        x = 0;
        for (const job& j : jobs_)
        {
            if (unknown < j.defect.nUnknowns())
            {
                setUnit(j, unknown, x);
            }
        }
        residual(x, r);
        for (job& j : jobs_)
        {
            if (unknown < j.defect.nUnknowns())
            {
                add(j, r, unknown, j.defect.sA, j.defect.A);
            }
        }
    }

    for (job& j : jobs_)
    {
        for (scalarRectangularMatrix* M : j.defect.sums())
        {
            scalarList values(M->size());
            std::copy(M->begin(), M->end(), values.begin());
            sumOverAll(values);
            std::copy(values.begin(), values.end(), M->begin());
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::cornerModel::takeJobs
(
    scalarField& eta,
    scalarField& etaC,
    scalarField& M
)
{
    jobs_.clear();
    DynamicList<label> others;

    for (const label i : waiting_)
    {
        bool free = true;
        for (const job& j : jobs_)
        {
            const wallCorner& other = corners_[j.corner];
            free =
                free
             && mag(corners_[i].from(other.vertex()))
              > freeRadius*max(corners_[i].size(), other.size());
        }
        if (free)
        {
            jobs_.append(new job());
            job& j = jobs_.last();
            j.corner = i;
            j.sectors = rounded_[i];
            prepare(j);

            forAll(j.cells, c)
            {
                label k = 0;
                while
                (
                    k < j.sectors.size() - 1 && j.theta[c] > j.sectors[k].end
                )
                {
                    ++k;
                }
                eta[j.cells[c]] = j.sectors[k].eta;
                etaC[j.cells[c]] = j.sectors[k].etaC;
                M[j.cells[c]] =
                    j.sectors[k].etaC*sqr(manyLengths*corners_[i].size());
            }
        }
        else
        {
            others.append(i);
        }
    }

    waiting_ = others;
    return jobs_.size();
}


void Foam::cornerModel::doJobs(const discreteOperator& residual)
{
    measure(residual);

    if (known_.size() > nKept)
    {
        known_.clear();
    }
    for (const job& j : jobs_)
    {
        shape_[j.corner] = j.defect.shape();
        sectorList sectors(j.sectors);
        known_.insert(round(j.corner, sectors), shape_[j.corner]);
    }
    jobs_.clear();
}


// ************************************************************************* //
