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

//- Steps towards F, share of each, and the last one over F
static const Foam::label nSteps = 200;
static const Foam::scalar shareOfStep = 0.7, lastStep = 1e-9;

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
    j.s.setSize(2*cells.size(), j.flow->size());
    j.shares.setSize(j.flow->size());

    auto product = [&](const label a, const label b)
    {
        scalar sum = 0;
        for (label i = 0; i < 2*cells.size(); ++i)
        {
            const cornerFlow::sector& s = j.sectors[i/2];
            sum += (s.eta + s.etaC)*j.s(i, a)*j.s(i, b);
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
            j.s(2*k, modei) = u.x();
            j.s(2*k + 1, modei) = u.y();
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

    const label nUnknowns = 3*cells.size();
    j.sAs = scalarRectangularMatrix(nModes, nModes, Zero);
    j.As = scalarRectangularMatrix(nUnknowns, nModes, Zero);
    j.A = scalarRectangularMatrix(nUnknowns, nUnknowns, Zero);
    j.sA = scalarRectangularMatrix(nModes, nUnknowns, Zero);

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


void Foam::cornerModel::measure(const discreteOperator& residual)
{
    const label n = mesh_.nCells();
    label nUnknowns = 0, nModes = 0;
    for (const job& j : jobs_)
    {
        nUnknowns = max(nUnknowns, j.A.m());
        nModes = max(nModes, j.sAs.m());
    }

    scalarField x(4*n), r;

    // Add s_a.r to row a of a matrix, and, given one, the residual itself
    auto add = [&]
    (
        job& j, const label column,
        scalarRectangularMatrix& sums, scalarRectangularMatrix& rows
    )
    {
        const wallCorner& corner = corners_[j.corner];
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
                        u.x()*r[celli] + u.y()*r[n + celli]
                      - p*r[2*n + celli];
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
    };

    for (label modei = 0; modei < nModes; ++modei)
    {
        x = 0;
        for (const job& j : jobs_)
        {
            if (modei < j.sAs.m())
            {
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
        }
        residual(x, r);
        for (job& j : jobs_)
        {
            if (modei < j.sAs.m())
            {
                add(j, modei, j.sAs, j.As);
            }
        }
    }

    for (label unknown = 0; unknown < nUnknowns; ++unknown)
    {
        x = 0;
        for (const job& j : jobs_)
        {
            const wallCorner& corner = corners_[j.corner];
            if (unknown < j.A.m() && isMine(corner.cells()[unknown/3]))
            {
                const label cmpt = unknown % 3;
                x[cmpt*n + corner.cells()[unknown/3].local] =
                    cmpt < 2 ? 1 : 1/corner.size();
            }
        }
        residual(x, r);
        for (job& j : jobs_)
        {
            if (unknown < j.A.m())
            {
                add(j, unknown, j.sA, j.A);
            }
        }
    }

    for (job& j : jobs_)
    {
        for (scalarRectangularMatrix* M : {&j.sAs, &j.As, &j.A, &j.sA})
        {
            scalarList values(M->size());
            std::copy(M->begin(), M->end(), values.begin());
            sumOverAll(values);
            std::copy(values.begin(), values.end(), M->begin());
        }
    }
}


Foam::scalarSquareMatrix Foam::cornerModel::solve(const job& j)
{
    const label nModes = j.sAs.m(), nUnknowns = j.A.m();

    // W s, by unknown
    scalarRectangularMatrix Ws(nUnknowns, nModes, Zero);
    for (label i = 0; i < j.s.m(); ++i)
    {
        const cornerFlow::sector& s = j.sectors[i/2];
        for (label a = 0; a < nModes; ++a)
        {
            Ws(3*(i/2) + i % 2, a) = (s.eta + s.etaC)*j.s(i, a);
        }
    }

    scalarSquareMatrix F(nModes, Zero);
    for (label a = 0; a < nModes; ++a)
    {
        for (label b = 0; b < nModes; ++b)
        {
            F(a, b) = 0.5*(j.sAs(a, b) + j.sAs(b, a));
        }
    }

    // Without end it would be the defect of s itself, where it begins
    const scalarSquareMatrix first(F);

    for (label step = 0; step < nSteps; ++step)
    {
        // Rows of K by solution; K s = W s F since s' W s = 1
        scalarRectangularMatrix sK(nModes, nUnknowns, Zero);
        scalarSquareMatrix AK(nUnknowns, Zero);
        for (label i = 0; i < nUnknowns; ++i)
        {
            for (label a = 0; a < nModes; ++a)
            {
                for (label b = 0; b < nModes; ++b)
                {
                    sK(a, i) += F(a, b)*Ws(i, b);
                }
            }
        }
        for (label i = 0; i < nUnknowns; ++i)
        {
            for (label k = 0; k < nUnknowns; ++k)
            {
                AK(i, k) = j.A(i, k);
                for (label a = 0; a < nModes; ++a)
                {
                    AK(i, k) -= Ws(i, a)*sK(a, k);
                }
            }
        }

        scalar change = 0, size = 0;
        scalarSquareMatrix left(nModes, Zero);
        for (label b = 0; b < nModes; ++b)
        {
            // What the cells around change of s
            scalarSquareMatrix M(AK);
            scalarList y(nUnknowns);
            for (label i = 0; i < nUnknowns; ++i)
            {
                y[i] = sK(b, i) - j.As(i, b);
            }
            LUsolve(M, y);

            for (label a = 0; a < nModes; ++a)
            {
                left(a, b) = j.sAs(a, b) - F(a, b);
                for (label i = 0; i < nUnknowns; ++i)
                {
                    left(a, b) += (j.sA(a, i) - sK(a, i))*y[i];
                }
            }
        }
        for (label a = 0; a < nModes; ++a)
        {
            for (label b = 0; b <= a; ++b)
            {
                const scalar d = 0.5*shareOfStep*(left(a, b) + left(b, a));
                F(a, b) += d;
                F(b, a) = F(a, b);
                change = max(change, mag(d));
                size = max(size, mag(F(a, b)));
            }
        }
        if (change <= lastStep*size)
        {
            return F;
        }
    }

    return first;
}


void Foam::cornerModel::keepPositive(scalarSquareMatrix& F)
{
    if (F.m() == 1)
    {
        F(0, 0) = max(F(0, 0), scalar(0));
    }
    else if (F.m() == 2)
    {
        const scalar mean = 0.5*(F(0, 0) + F(1, 1));
        const scalar half = 0.5*(F(0, 0) - F(1, 1));
        const scalar radius = Foam::hypot(half, F(0, 1));
        const scalar low = mean - radius, high = mean + radius;

        if (high <= 0)
        {
            F = Zero;
        }
        else if (low < 0)
        {
            // high times the projection on its direction
            const scalar f = high/(2*radius);
            F(0, 0) = f*(radius + half);
            F(1, 1) = f*(radius - half);
            F(0, 1) *= f;
            F(1, 0) *= f;
        }
    }
}


Foam::scalarSquareMatrix Foam::cornerModel::shape
(
    const job& j,
    const scalarSquareMatrix& F
) const
{
    const label n = j.s.m();
    scalarSquareMatrix K(n, Zero);

    for (label i = 0; i < n; ++i)
    {
        const cornerFlow::sector& si = j.sectors[i/2];
        for (label k = 0; k < n; ++k)
        {
            const cornerFlow::sector& sk = j.sectors[k/2];
            const scalar W = Foam::sqrt((si.eta + si.etaC)*(sk.eta + sk.etaC));
            for (label a = 0; a < F.m(); ++a)
            {
                for (label b = 0; b < F.m(); ++b)
                {
                    K(i, k) += W*j.s(i, a)*F(a, b)*j.s(k, b);
                }
            }
        }
    }
    return K;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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

        weight_[i] = (compressible ? 0.0 : 1.0)*sqrt(W);
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
        scalarSquareMatrix F(solve(j));
        keepPositive(F);
        shape_[j.corner] = shape(j, F);
        sectorList sectors(j.sectors);
        known_.insert(round(j.corner, sectors), shape_[j.corner]);
    }
    jobs_.clear();
}


// ************************************************************************* //
