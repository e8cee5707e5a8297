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
#include "carriedDensity.H"
#include "surfaceFields.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::flowLoads::setGravity(const vector& periodic)
{
    const planarFrame& frame = mesh_.frame();
    const fvMesh& mesh = mesh_.mesh();
    const vector2D along(frame.inPlane(periodic));

    scalarField rho(mesh_.nSlots());
    SubList<scalar>(rho, mesh_.nCells()) = rho_;
    mesh_.halo().swap(rho);

    auto setFace = [&](const label f, const vector& Cf)
    {
        const planarFace& face = mesh_[f];
        const label P = face.own, N = face.nei;
        faceForce_[f] =
            (face.w*rho[P] + (1 - face.w)*rho[N])*(along & face.m)
          - (gradientGravity_ & (Cf - height_.middle()))
           *face.dc*(rho[N] - rho[P]);
    };

    for (label f = 0; f < mesh_.nInternal(); ++f)
    {
        setFace(f, mesh.Cf()[f]);
    }
    for (const label patchi : mesh_.halo().coupledPatches())
    {
        const vectorField& Cf = mesh.Cf().boundaryField()[patchi];
        const label start = mesh_.faceOf(mesh_.halo().start(patchi));
        forAll(Cf, i)
        {
            setFace(start + i, Cf[i]);
        }
    }
}


void Foam::flowLoads::checkAxial() const
{
    const vector g(gravity());
    vector across(g);
    across[mesh_.axial().axis()] = 0;

    if (mag(across) > 0)
    {
        const fileName file
        (
            mesh_.mesh().time().lookupObject<uniformDimensionedVectorField>
            (
                "g"
            ).objectPath()
        );
        FatalIOErrorInFunction(dictionary(file))
            << "Entry 'value' is " << g << ", on a wedge with its axis along "
            << "xyz"[mesh_.axial().axis()] << nl
            << "    Allowed: gravity along the axis; no other is the same at"
            << " every angle" << exit(FatalIOError);
    }
}


void Foam::flowLoads::addBodyForce()
{
    Field<vector2D> b(mesh_.nSlots(), Zero);
    const vectorField& force = load_.force()->primitiveField();
    forAll(force, celli)
    {
        b[celli] = mesh_.frame().inPlane(force[celli]);
    }
    mesh_.halo().swap(b);

    mesh_.forTwoSided
    (
        [&](const label f)
        {
            const planarFace& face = mesh_[f];
            faceForce_[f] +=
                face.m
              & (face.w*b[face.own] + (1 - face.w)*b[face.nei]);
        }
    );
    for (const label f : mesh_.oneSided())
    {
        faceForce_[f] += mesh_[f].m & b[mesh_[f].own];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowLoads::flowLoads
(
    const faceGeometry& mesh,
    const flowBoundary& boundary,
    const materialFields& materials
)
:
    mesh_(mesh),
    boundary_(boundary),
    materials_(materials),
    load_(mesh.mesh()),
    height_(mesh.mesh()),
    faceForce_(mesh.nFaces(), Zero),
    gradientGravity_(Zero),
    rhoGh_(mesh.nCells(), Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::flowLoads::update(const scalarField& M)
{
    const fvMesh& mesh = mesh_.mesh();

    rho_ =
        materials_.layered() && gravity() != vector(Zero)
      ? carriedDensity(materials_, gravity()).density()
      : tmp<scalarField>(new scalarField(materials_.rho().primitiveField()));

    if (mesh_.axial().active())
    {
        checkAxial();
    }
    const vector periodic(periodicGravity());
    gradientGravity_ = gravity() - periodic;
    setHeights(periodic);

    faceForce_ = 0;
    if (materials_.parts().has(sceneParts::GRAVITY))
    {
        setGravity(periodic);
    }
    if (load_.force())
    {
        addBodyForce();
    }

    auto refuse = [&]
    (
        const word& name,
        const scalar couple,
        const char* unit,
        const label celli
    )
    {
        FatalErrorInFunction
            << "A " << name << " of " << couple << unit << celli
            << " at " << mesh.C()[celli]
            << ", whose bending viscosity M is 0" << nl
            << "    Allowed: " << name << " 0 (or zeroGradient on a wall), or"
            << " a material with etaC and R above zero there"
            << exit(FatalError);
    };

    for (const label f : mesh_.oneSided())
    {
        const scalar couple = boundary_.couple(mesh_.boundaryOf(f));
        if (couple != 0 && M[mesh_[f].own] <= 0)
        {
            refuse
            (
                "coupleTraction", couple, " Pa m acts on the wall of cell ",
                mesh_[f].own
            );
        }
    }
    if (load_.couple())
    {
        const scalarField& couple = load_.couple()->primitiveField();
        forAll(couple, celli)
        {
            if (couple[celli] != 0 && M[celli] <= 0)
            {
                refuse
                (
                    "bodyCouple", couple[celli], " Pa acts on cell ", celli
                );
            }
        }
    }
}


Foam::vector Foam::flowLoads::gravity() const
{
    return
        materials_.parts().has(sceneParts::GRAVITY)
      ? mesh_.mesh().time()
       .lookupObject<uniformDimensionedVectorField>("g").value()
      : vector(Zero);
}


Foam::tmp<Foam::vectorField> Foam::flowLoads::bodyForce() const
{
    tmp<vectorField> tforce(rho_*gravity());
    if (load_.force())
    {
        tforce.ref() += load_.force()->primitiveField();
    }
    return tforce;
}


Foam::scalar Foam::flowLoads::boundaryRhoGh(const label slot) const
{
    const planarFace& face = mesh_[mesh_.faceOf(slot)];

    return
        rhoGh_[face.own]
      + rho_[face.own]
       *(mesh_.frame().inPlane(gradientGravity_) & (face.m/face.dc));
}


void Foam::flowLoads::netForce
(
    const vector& direction,
    scalar& net,
    scalar& magnitude
) const
{
    const vector2D along(mesh_.frame().inPlane(direction));
    net = magnitude = 0;

    auto add = [&](const scalar force)
    {
        net += force;
        magnitude += mag(force);
    };

    for (const label f : mesh_.oneSided())
    {
        const planarFace& face = mesh_[f];
        const label i = mesh_.boundaryOf(f);
        add(boundary_.traction(i)*face.S*(face.t() & along));
        if (boundary_.pressureFixed(i))
        {
            const scalar p = givenPressure(i) + boundaryRhoGh(face.nei);
            add(-p*face.S*(face.n & along));
        }
    }
    forAll(boundary_.jump(), i)
    {
        // A cyclic face is seen from both sides
        const planarFace& face = mesh_[mesh_.nInternal() + i];
        add(0.5*boundary_.jump()[i]*face.S*(face.n & along));
    }

    const vectorField b(bodyForce());
    forAll(b, celli)
    {
        add(mesh_.V()[celli]*(b[celli] & direction));
    }

    reduce(net, sumOp<scalar>());
    reduce(magnitude, sumOp<scalar>());
}


// ************************************************************************* //
