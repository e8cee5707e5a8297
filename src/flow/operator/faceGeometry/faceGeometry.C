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

#include "faceGeometry.H"
#include "surfaceFields.H"
#include "unitConversion.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Skewness, offset of the face centre from the path over its length, of faces
//- whose cells need the adjoint force (triangles have up to a third), and of
//- cells around that take it with them
static const Foam::scalar verySkewed = 0.1, slightlySkewed = 0.01;

//- Skewness or tangent of the angle of a face that are rounding
static const Foam::scalar rounding = 1e-9;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::faceGeometry::setFace
(
    const label f,
    const vector& S,
    const scalar dc,
    const scalar w,
    const vector& d,
    const vector& toCentre
)
{
    planarFace& face = faces_[f];
    face.S = mag(S);
    face.n = frame_.inPlane(S)/face.S;
    face.m = dc*frame_.inPlane(d);
    face.dc = dc;
    face.w = w;
    offset_[f] = frame_.inPlane(vector(toCentre - (1 - w)*d));
}


void Foam::faceGeometry::setInternal()
{
    const surfaceVectorField delta(mesh_.delta());

    for (label f = 0; f < nInternal_; ++f)
    {
        const label P = faces_[f].own = mesh_.owner()[f];
        faces_[f].nei = mesh_.neighbour()[f];
        setFace
        (
            f,
            mesh_.Sf()[f],
            mesh_.nonOrthDeltaCoeffs()[f],
            mesh_.weights()[f],
            delta[f],
            mesh_.Cf()[f] - mesh_.C()[P]
        );
    }
    twoSided_.append(labelPair(0, nInternal_));
}


void Foam::faceGeometry::setBoundary()
{
    DynamicList<label> oneSided;

    for (const label patchi : halo_.patches())
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const label start = faceOf(halo_.start(patchi));
        const vectorField& Sf = mesh_.Sf().boundaryField()[patchi];
        const scalarField& dc =
            mesh_.nonOrthDeltaCoeffs().boundaryField()[patchi];
        const scalarField& w = mesh_.weights().boundaryField()[patchi];
        const vectorField delta(patch.delta());

        forAll(patch, i)
        {
            const label f = start + i;
            const label P = faces_[f].own = patch.faceCells()[i];
            faces_[f].nei = halo_.start(patchi) + i;
            const vector out(patch.Cf()[i] - mesh_.C()[P]);

            if (patch.coupled())
            {
                setFace(f, Sf[i], dc[i], w[i], delta[i], out);
            }
            else
            {
                setFace(f, Sf[i], mag(Sf[i])/(Sf[i] & out), 1, out, Zero);
                oneSided.append(f);
            }
        }

        if (patch.coupled() && patch.size())
        {
            twoSided_.append(labelPair(start, start + patch.size()));
        }
    }
    oneSided_.transfer(oneSided);
}


void Foam::faceGeometry::setRadii()
{
    radius_.setSize(nSlots());
    area_.setSize(nCells_);
    edge_.setSize(faces_.size());
    radial_ = vector2D
    (
        axial_.radial() == frame_.i0(), axial_.radial() == frame_.i1()
    );

    const vectorField& C = mesh_.C().primitiveField();
    forAll(area_, celli)
    {
        radius_[celli] = axial_.radius(C[celli]);
        area_[celli] = axial_.area(V_[celli], C[celli]);
    }
    halo_.swap(radius_);

    auto setEdge = [&](const label f, const point& Cf)
    {
        edge_[f] = faces_[f].S/(axial_.angle()*axial_.radius(Cf));
    };
    for (label f = 0; f < nInternal_; ++f)
    {
        setEdge(f, mesh_.Cf()[f]);
    }
    for (const label patchi : halo_.patches())
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const label start = halo_.start(patchi);
        forAll(patch, i)
        {
            setEdge(faceOf(start + i), patch.Cf()[i]);
            if (!patch.coupled())
            {
                radius_[start + i] = axial_.radius(patch.Cf()[i]);
            }
        }
    }
    setAxisEdges();
}


void Foam::faceGeometry::setAxisEdges()
{
    // What is missing to close the polygons
    Field<vector2D> missing(nCells_, Zero);
    scalarField around(nCells_, Zero);
    forAll(faces_, f)
    {
        const label P = faces_[f].own, N = faces_[f].nei;
        missing[P] -= edge_[f]*faces_[f].n;
        around[P] += edge_[f];
        if (N < nCells_)
        {
            missing[N] += edge_[f]*faces_[f].n;
            around[N] += edge_[f];
        }
    }

    DynamicList<axisEdge> edges;
    forAll(missing, celli)
    {
        if (mag(missing[celli]) > 1e-6*around[celli])
        {
            edges.append({celli, missing[celli], radius_[celli]});
        }
    }
    axisEdges_.transfer(edges);
}


void Foam::faceGeometry::classify()
{
    scalar angle = 0, largest = 0;
    scalarField skewness(nSlots(), Zero);
    boolList lean(nSlots(), false);
    forAll(faces_, f)
    {
        const planarFace& face = faces_[f];
        const scalar off = mag(offset_[f])*face.dc;
        angle = max(angle, mag(face.k()));
        largest = max(largest, off);
        skewness[face.own] = max(skewness[face.own], off);
        skewness[face.nei] = max(skewness[face.nei], off);

        leans_[f] = max(mag(face.k()), off) > rounding;
        lean[face.own] = lean[face.own] || leans_[f];
        lean[face.nei] = lean[face.nei] || leans_[f];
    }

    // Beyond rounding
    skewed_ = returnReduce(largest, maxOp<scalar>()) > 1e-5;
    nonOrthogonal_ = skewed_ || returnReduce(angle, maxOp<scalar>()) > 1e-5;
    anyAdjoint_ = returnReduce(largest, maxOp<scalar>()) > verySkewed;

    if (nonOrthogonal_)
    {
        leaning_ = part(lean);
    }
    if (anyAdjoint_)
    {
        setAdjoint(skewness);
        setAroundAdjoint();
    }
}


void Foam::faceGeometry::setAdjoint(const scalarField& skewness)
{
    // From very skewed cells through all that are skewed, and one layer more
    scalarField taken(nSlots(), Zero);
    forAll(adjoint_, celli)
    {
        taken[celli] = skewness[celli] > verySkewed;
    }

    for (bool last = false, grows = true; grows || !last;)
    {
        last = !grows;
        grows = false;
        halo_.swap(taken);
        const scalarField before(taken);
        forTwoSided
        (
            [&](const label f)
            {
                const label P = faces_[f].own, N = faces_[f].nei;
                for (const labelPair& way : {labelPair(P, N), labelPair(N, P)})
                {
                    const label celli = way.first();
                    if
                    (
                        celli < nCells_ && taken[celli] < before[way.second()]
                     && (last || skewness[celli] > slightlySkewed)
                    )
                    {
                        taken[celli] = 1;
                        grows = true;
                    }
                }
            }
        );
        reduce(grows, orOp<bool>());
        grows = grows && !last;
    }

    forAll(adjoint_, celli)
    {
        adjoint_[celli] = taken[celli] > 0;
    }
}


Foam::partOfMesh Foam::faceGeometry::part(const boolList& taken) const
{
    DynamicList<label> cells, faces;
    for (label celli = 0; celli < nCells_; ++celli)
    {
        if (taken[celli])
        {
            cells.append(celli);
        }
    }
    forTwoSided
    (
        [&](const label f)
        {
            const label P = faces_[f].own, N = faces_[f].nei;
            if (taken[P] || (N < nCells_ && taken[N]))
            {
                faces.append(f);
            }
        }
    );

    partOfMesh found;
    found.cells.transfer(cells);
    found.faces.transfer(faces);
    return found;
}


void Foam::faceGeometry::setAroundAdjoint()
{
    scalarField own(nSlots(), Zero);
    forAll(adjoint_, celli)
    {
        own[celli] = adjoint_[celli];
    }
    halo_.swap(own);

    boolList taken(nSlots(), false);
    forAll(adjoint_, celli)
    {
        taken[celli] = adjoint_[celli];
    }
    forTwoSided
    (
        [&](const label f)
        {
            const label P = faces_[f].own, N = faces_[f].nei;
            taken[P] = taken[P] || own[N] > 0;
            taken[N] = taken[N] || own[P] > 0;
        }
    );
    aroundAdjoint_ = part(taken);
}


void Foam::faceGeometry::setExactness()
{
    // The sums of a gradient for the coordinates themselves
    exact_.setSize(nCells_);
    exact_ = Zero;

    auto add = [&](const label celli, const label f, const scalar way)
    {
        const planarFace& face = faces_[f];
        exact_[celli] += (way*edge(f)/face.dc*face.n)*face.m;
    };
    forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = faces_[f];
            add(face.own, f, 1 - face.w);
            if (face.nei < nCells_)
            {
                add(face.nei, f, face.w);
            }
        }
    );
    for (const label f : oneSided_)
    {
        add(faces_[f].own, f, 1);
    }
    for (const axisEdge& axis : axisEdges_)
    {
        // Along it values are those of the cell
        exact_[axis.celli] += axis.S*(-axis.way*radial_);
    }

    forAll(exact_, celli)
    {
        exact_[celli] = area(celli)*planarFrame::inverse(exact_[celli]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::faceGeometry::faceGeometry
(
    const fvMesh& mesh,
    const planarFrame& frame,
    const haloExchange& halo
)
:
    mesh_(mesh),
    frame_(frame),
    halo_(halo),
    axial_(mesh),
    nCells_(mesh.nCells()),
    nInternal_(mesh.nInternalFaces()),
    V_(mesh.V()),
    faces_(nInternal_ + halo.size() - nCells_),
    offset_(faces_.size(), Zero),
    nonOrthogonal_(false),
    skewed_(false),
    leans_(faces_.size(), false),
    adjoint_(nCells_, false),
    anyAdjoint_(false),
    radial_(Zero),
    flat_(false)
{
    setInternal();
    setBoundary();
    if (axial_.active())
    {
        setRadii();
    }
    classify();

    if (skewed_)
    {
        setExactness();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::faceGeometry::flatten(const bool flat)
{
    if (axial_.active() && flat != flat_)
    {
        flat_ = flat;
        forAll(faces_, f)
        {
            Swap(faces_[f].S, edge_[f]);
        }
    }
}


Foam::scalar Foam::faceGeometry::largestAspect() const
{
    scalarField smallest(nCells_, GREAT), most(nCells_, Zero);
    forTwoSided
    (
        [&](const label f)
        {
            for (const label celli : {faces_[f].own, faces_[f].nei})
            {
                if (celli < nCells_)
                {
                    smallest[celli] = min(smallest[celli], faces_[f].dc);
                    most[celli] = max(most[celli], faces_[f].dc);
                }
            }
        }
    );
    return gMax(scalarField(most/smallest));
}


Foam::scalar Foam::faceGeometry::largestAngle() const
{
    scalar tangent = 0;
    forTwoSided
    (
        [&](const label f) { tangent = max(tangent, mag(faces_[f].k())); }
    );
    return radToDeg(atan(returnReduce(tangent, maxOp<scalar>())));
}


// ************************************************************************* //
