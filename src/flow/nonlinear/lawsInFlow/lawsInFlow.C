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

#include "lawsInFlow.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::lawsInFlow::hydrostatic() const
{
    scalarField rhoGh(system_.faces().nSlots(), Zero);
    SubList<scalar>(rhoGh, system_.nCells()) = system_.loads().rhoGh();
    system_.faces().halo().swap(rhoGh);

    return rhoGh;
}


void Foam::lawsInFlow::toFaces
(
    const labelList& faces,
    scalarField& values
) const
{
    const faceGeometry& mesh = system_.faces();
    scalarField all(mesh.nSlots(), Zero);
    SubList<scalar>(all, system_.nCells()) = values;
    mesh.halo().swap(all);

    values.setSize(faces.size());
    forAll(faces, i)
    {
        const planarFace& face = mesh[faces[i]];
        const scalar w = places_.oneSided(faces[i]) ? 1 : face.w;
        values[i] = w*all[face.own] + (1 - w)*all[face.nei];
    }
}


template<class Rates, class Use>
void Foam::lawsInFlow::see
(
    const label n,
    const Rates& rates,
    const Use& use
) const
{
    const planarFrame& frame = system_.faces().frame();
    tensorField gradU(n);
    vectorField gradOmega(n);
    scalarField omega(n), p(n);

    for (label i = 0; i < n; ++i)
    {
        const placeRates at(rates(i));
        gradU[i] = frame.inSpace(at.G);
        gradOmega[i] = frame.inSpace(at.gradOmega);
        omega[i] = at.omega;
        p[i] = at.p;
    }
    use
    (
        flowState
        {
            materials_.mesh(), frame.e(), gradU, p, omega, gradOmega, nullptr
        }
    );
}


void Foam::lawsInFlow::seeCells
(
    const operatorState& s,
    const scalarField& rhoGh
)
{
    see
    (
        system_.nCells(),
        [&](const label i)
        {
            placeRates at(places_.cell(s, i));
            at.p += rhoGh[i];
            return at;
        },
        [&](const flowState& flow)
        {
            materials_.correct(flow);
        }
    );

    forAll(cells_, celli)
    {
        const viscositySlopes* slopes =
            materials_.law(materials_.most(celli)).slopes();
        cells_[celli] =
            slopes && slopes->byRate.size()
          ? flowPlaces::form
            (
                places_.cell(s, celli), slopes->q, slopes->b,
                slopes->byRate[celli], slopes->byPressure[celli]
            )
          : placeForm{tensor2D(Zero), Zero, 0, 0};
    }
}


void Foam::lawsInFlow::seeFaces
(
    const operatorState& s,
    const scalarField& rhoGh
)
{
    const faceGeometry& mesh = system_.faces();
    scalarField overRest(mesh.nFaces(), -1.0);
    ownForm_ = false;

    forAll(within_, m)
    {
        const labelList& faces = within_[m];
        auto rates = [&](const label i)
        {
            placeRates at(places_.face(s, faces[i]));
            const scalar w = places_.oneSided(faces[i]) ? 1 : mesh[faces[i]].w;
            at.p += w*rhoGh[mesh[faces[i]].own]
              + (1 - w)*rhoGh[mesh[faces[i]].nei];
            return at;
        };
        auto take = [&](flowState flow)
        {
            flow.toPlaces = [&](scalarField& q) { toFaces(faces, q); };
            scalarField ratio;
            viscositySlopes slopes;
            if (!materials_.law(m).at(flow, ratio, slopes))
            {
                return;
            }
            forAll(faces, i)
            {
                overRest[faces[i]] = ratio[i];
                ownForm_[faces[i]] = true;
                faces_[faces[i]] = flowPlaces::form
                (
                    places_.face(s, faces[i]), slopes.q, slopes.b,
                    slopes.byRate[i], slopes.byPressure[i]
                );
            }
        };
        see(faces.size(), rates, take);
    }
    system_.setFaceViscosities(overRest);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::lawsInFlow::lawsInFlow
(
    materialFields& materials,
    cosseratSystem& system
)
:
    materials_(materials),
    system_(system),
    places_(system)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::lawsInFlow::start()
{
    const faceGeometry& mesh = system_.faces();
    cells_.setSize(mesh.nCells());
    faces_.setSize(mesh.nFaces());
    ownForm_.setSize(mesh.nFaces());
    change_.setSize(mesh.nSlots());

    // Where there are several, -1
    scalarField kind(mesh.nSlots(), -1.0);
    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        if (materials_.pure(celli))
        {
            kind[celli] = materials_.most(celli);
        }
    }
    mesh.halo().swap(kind);

    List<DynamicList<label>> within(materials_.size());
    for (label f = 0; f < mesh.nFaces(); ++f)
    {
        const label m = label(kind[mesh[f].own]);
        if (m >= 0 && (places_.oneSided(f) || label(kind[mesh[f].nei]) == m))
        {
            within[m].append(f);
        }
    }
    within_.setSize(within.size());
    forAll(within, m)
    {
        within_[m].transfer(within[m]);
    }

    materials_.rest();
    system_.setFaceViscosities(scalarField());
}


void Foam::lawsInFlow::see(const operatorState& s)
{
    const scalarField rhoGh(hydrostatic());
    seeCells(s, rhoGh);
    seeFaces(s, rhoGh);
}


void Foam::lawsInFlow::along(const operatorState& direction) const
{
    forAll(cells_, celli)
    {
        change_[celli] = cells_[celli](places_.cell(direction, celli));
    }
    system_.faces().halo().swap(change_);
}


Foam::scalar Foam::lawsInFlow::face
(
    const operatorState& direction,
    const label f
) const
{
    if (ownForm_[f])
    {
        return faces_[f](places_.face(direction, f));
    }

    const planarFace& face = system_.faces()[f];
    if (places_.oneSided(f))
    {
        return change_[face.own];
    }

    // By the shares of the cells in the compliance of the path
    const viscousCoefficients& K = system_.coefficients();
    const scalar P = (1 - face.w)/K.side(f, 0).a, N = face.w/K.side(f, 1).a;
    return (P*change_[face.own] + N*change_[face.nei])/(P + N);
}


// ************************************************************************* //
