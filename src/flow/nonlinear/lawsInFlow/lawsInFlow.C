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

void Foam::lawsInFlow::place::linearise(const bool carried)
{
    if (!carried)
    {
        stress = rates;
        stress *= overRest;
    }

    placeRates at(stress);
    const scalar longest = overRest*Foam::sqrt(sqrNorm(rates));
    const scalar length = Foam::sqrt(sqrNorm(stress));
    at *= (length > longest ? longest/length : 1)/overRest;
    change = form(at, byRate, byPressure);
}


void Foam::lawsInFlow::place::predict(const placeRates& direction)
{
    first = rates;
    first *= overRest;
    slope = direction;
    slope *= overRest;
    slope.add(form(rates, byRate, byPressure)(direction), stress);
}

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
        if (system_.faces().axial().active())
        {
            const vector e(frame.e());
            gradU[i] += at.hoop*(e*e);
            gradOmega[i] += at.around*e;
        }
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
        place& at = cells_[celli];
        const viscosityLaw& law =
            materials_.law(materials_.leading(celli, at.share));
        const viscositySlopes* slopes = law.slopes();
        at.rates = places_.cell(s, celli);
        at.overRest = law.eta()[celli]/law.eta().value();
        const bool follows = slopes && slopes->byRate.size();
        at.q = follows ? slopes->q : 0;
        at.b = follows ? slopes->b : 0;
        at.byRate = follows ? slopes->byRate[celli] : 0;
        at.byPressure = follows ? slopes->byPressure[celli] : 0;
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
    own_ = false;

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
                const label f = faces[i];
                overRest[f] = ratio[i];
                own_[f] = true;
                place& at = faces_[f];
                at.rates = places_.face(s, f);
                at.overRest = ratio[i];
                at.q = slopes.q;
                at.b = slopes.b;
                at.byRate = slopes.byRate[i];
                at.byPressure = slopes.byPressure[i];
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
    own_.setSize(mesh.nFaces());
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


void Foam::lawsInFlow::linearise(const bool carried)
{
    for (place& cell : cells_)
    {
        cell.linearise(carried);
    }
    forAll(faces_, f)
    {
        if (own_[f])
        {
            faces_[f].linearise(carried);
        }
    }
}


void Foam::lawsInFlow::predict(const operatorState& step)
{
    forAll(cells_, celli)
    {
        cells_[celli].predict(places_.cell(step, celli));
    }
    forAll(faces_, f)
    {
        if (own_[f])
        {
            faces_[f].predict(places_.face(step, f));
        }
    }
}


void Foam::lawsInFlow::accept(const scalar length)
{
    for (List<place>* places : {&cells_, &faces_})
    {
        for (place& at : *places)
        {
            at.stress = at.first;
            at.stress.add(length, at.slope);
        }
    }
}


void Foam::lawsInFlow::along(const operatorState& direction) const
{
    forAll(cells_, celli)
    {
        const place& at = cells_[celli];
        change_[celli] = at.share*at.change(places_.cell(direction, celli));
    }
    system_.faces().halo().swap(change_);
}


Foam::scalar Foam::lawsInFlow::face
(
    const operatorState& direction,
    const label f
) const
{
    if (own_[f])
    {
        return faces_[f].change(places_.face(direction, f));
    }

    const planarFace& face = system_.faces()[f];
    const viscousCoefficients& K = system_.coefficients();
    const cutCells::layers sideP(K.side(f, 0));
    if (places_.oneSided(f))
    {
        return sideP.own*change_[face.own];
    }

    // By the shares of the cells in the compliance of the path, and in those
    // of the materials at their centres
    const cutCells::layers sideN(K.side(f, 1));
    const scalar P = (1 - face.w)/sideP.a, N = face.w/sideN.a;
    return
        (P*sideP.own*change_[face.own] + N*sideN.own*change_[face.nei])
       /(P + N);
}


// ************************************************************************* //
