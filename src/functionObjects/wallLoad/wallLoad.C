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

#include "wallLoad.H"
#include "checkedEntry.H"
#include "creepingFlow.H"
#include "oneLayer.H"
#include "openfoamVersion.H"
#include "wordRes.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(wallLoad, 0);
    addToRunTimeSelectionTable(functionObject, wallLoad, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

//- Numbers of a patch: force, its normal and tangential part, moment, couple;
//- and of a bin: area, normal and tangential force, couple
static const Foam::label nOfPatch = 11;
static const Foam::label nOfBin = 4;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Add a vector to three numbers
    static void add(scalar* sum, const vector& v)
    {
        for (direction d = 0; d < 3; ++d)
        {
            sum[d] += v[d];
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::functionObjects::wallLoad::physical() const
{
    DynamicList<label> patches;
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (!patch.coupled() && !oneLayer::isPlane(patch.patch()))
        {
            patches.append(patch.index());
        }
    }
    return labelList(std::move(patches));
}


void Foam::functionObjects::wallLoad::readPatches(const dictionary& dict)
{
    patches_ = physical();

    wordRes wanted;
    if (!dict.readIfPresent("patches", wanted))
    {
        return;
    }

    wordList names;
    DynamicList<label> chosen;
    for (const label patchi : patches_)
    {
        names.append(mesh_.boundary()[patchi].name());
        if (wanted.match(names.last()))
        {
            chosen.append(patchi);
        }
    }

    for (const wordRe& one : wanted)
    {
        bool found = false;
        for (const word& name : names)
        {
            found = found || one.match(name);
        }
        if (!found)
        {
            OStringStream allowed;
            allowed << "patches that are neither empty nor coupled:";
            for (const word& name : names)
            {
                allowed << ' ' << name;
            }
            checkedEntry::refuse(dict, "patches", one, allowed.str());
        }
    }

    patches_.transfer(chosen);
}


void Foam::functionObjects::wallLoad::readBins(const dictionary& dict)
{
    nBin_ = 0;
    if (!dict.found("bins"))
    {
        return;
    }

    const dictionary& bins = dict.subDict("bins");
    checkedEntry::only(bins, {"direction", "nBin"});
    direction_ = checkedEntry::direction("direction", bins);
    nBin_ = bins.get<label>("nBin");
    if (nBin_ < 1)
    {
        checkedEntry::refuse(bins, "nBin", Foam::name(nBin_), "1 or more");
    }

    scalar end = -GREAT;
    start_ = GREAT;
    for (const label patchi : patches_)
    {
        for (const point& p : mesh_.boundaryMesh()[patchi].localPoints())
        {
            start_ = min(start_, p & direction_);
            end = max(end, p & direction_);
        }
    }
    reduce(start_, minOp<scalar>());
    reduce(end, maxOp<scalar>());
    length_ = (end - start_)/nBin_;

    if (!(length_ > 0))
    {
        checkedEntry::refuse
        (
            bins, "direction", "one along which the patches have no length",
            "another direction"
        );
    }
}


void Foam::functionObjects::wallLoad::open
(
    const word& name,
    const string& head,
    std::initializer_list<const char*> columns
)
{
    if (!Pstream::master())
    {
        return;
    }

    files_.append(newOutputFile(name).ptr());
    OFstream& os = files_.last();
    writeHeader(os, head);
    writeCommented(os, "Time [s]");
    for (const char* column : columns)
    {
        writeTabbed(os, column);
    }
    os  << endl;
}


void Foam::functionObjects::wallLoad::begin()
{
    const std::initializer_list<const char*> columns
    {
        "force x [N]", "y", "z", "normal x [N]", "y", "z",
        "tangential x [N]", "y", "z", "moment [N m]", "couple [N m]"
    };

    open("wallLoad", "Load on all patches together", columns);
    for (const label patchi : patches_)
    {
        const word& name = mesh_.boundary()[patchi].name();
        open("wallLoad_" + name, "Load on patch " + name, columns);
    }
    if (corners_)
    {
        open("wallLoad_corners", "Load on re-entrant corners", columns);
    }
    if (nBin_)
    {
        open
        (
            "wallLoad_bins", "Load by area, in bins",
            {
                "middle [m]", "area [m2]", "normal [Pa]", "tangential [Pa]",
                "couple [Pa m]"
            }
        );
    }
}


template<class FieldType>
FieldType& Foam::functionObjects::wallLoad::field
(
    const word& name,
    const dimensionSet& dims
) const
{
    if (!mesh_.foundObject<FieldType>(name))
    {
        regIOobject::store
        (
            new FieldType
            (
                IOobject(name, mesh_.time().timeName(), mesh_),
                mesh_,
                dimensioned<typename FieldType::value_type>(dims, Zero),
                "calculated"
            )
        );
    }
    return mesh_.lookupObjectRef<FieldType>(name);
}


Foam::label Foam::functionObjects::wallLoad::binOf(const point& place) const
{
    const label i = label(((place & direction_) - start_)/length_);

    // The ends are those of points, and faces between them
    return min(max(i, 0), nBin_ - 1);
}


void Foam::functionObjects::wallLoad::addPatch
(
    const fvPatch& patch,
    const vectorField& force,
    const scalarField& couple,
    scalarField& sums
) const
{
    const vectorField n(patch.nf());
    scalar* sum = &sums[nOfPatch*patches_.find(patch.index())];

    forAll(force, i)
    {
        const scalar normal = force[i] & n[i];
        const vector tangential(force[i] - normal*n[i]);

        add(sum, force[i]);
        add(sum + 3, normal*n[i]);
        add(sum + 6, tangential);
        sum[9] += e_ & ((patch.Cf()[i] - CofR_) ^ force[i]);
        sum[10] += couple[i];

        if (nBin_)
        {
            scalar* bin =
                &sums[nOfPatch*nRows() + nOfBin*binOf(patch.Cf()[i])];
            bin[0] += patch.magSf()[i];
            bin[1] += normal;
            bin[2] += tangential & (n[i] ^ e_);
            bin[3] += couple[i];
        }
    }
}


void Foam::functionObjects::wallLoad::addCorners
(
    const vectorField& force,
    scalarField& sums
) const
{
    scalar* sum = &sums[nOfPatch*patches_.size()];

    forAll(force, celli)
    {
        add(sum, force[celli]);
        sum[9] += e_ & ((mesh_.C()[celli] - CofR_) ^ force[celli]);
    }
}


void Foam::functionObjects::wallLoad::toCircle(scalarField& sums) const
{
    sums *= axial_.toCircle();

    for (label i = 0; i < nRows(); ++i)
    {
        scalar* sum = &sums[nOfPatch*i];
        for (label j = 0; j < 9; ++j)
        {
            sum[j] = j % 3 == axial_.axis() ? sum[j] : 0;
        }
        sum[9] = 0;
    }
}


void Foam::functionObjects::wallLoad::writeRows(const scalarField& sums)
{
    if (!Pstream::master())
    {
        return;
    }

    scalarField all(nOfPatch, Zero);
    for (label i = 0; i < nRows(); ++i)
    {
        all += SubField<scalar>(sums, nOfPatch, nOfPatch*i);
    }

    for (label i = 0; i <= nRows(); ++i)
    {
        OFstream& os = files_[i];
        writeCurrentTime(os);
        for (label j = 0; j < nOfPatch; ++j)
        {
            os << token::TAB << (i ? sums[nOfPatch*(i - 1) + j] : all[j]);
        }
        os  << endl;
    }

    for (label i = 0; i < nBin_; ++i)
    {
        OFstream& os = files_.last();
        const label start = nOfPatch*nRows() + nOfBin*i;
        const scalar area = sums[start];

        writeCurrentTime(os);
        os  << token::TAB << start_ + (i + 0.5)*length_ << token::TAB << area;
        for (label j = 1; j < nOfBin; ++j)
        {
            os  << token::TAB << (area > 0 ? sums[start + j]/area : 0);
        }
        os  << endl;
    }

    Log << type() << ' ' << name() << ": force "
        << vector(all[0], all[1], all[2]) << " N, moment "
        << all[9] << " and couple " << all[10] << " N m" << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::wallLoad::wallLoad
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name),
    e_(planarFrame(oneLayer::check(mesh_)).e()),
    axial_(mesh_),
    corners_(false),
    nBin_(0),
    start_(0),
    length_(0),
    traction_("wallTraction"),
    couple_("wallCouple")
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::wallLoad::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    CofR_ = dict.getOrDefault<point>("CofR", Zero);
    readPatches(dict);
    readBins(dict);
    files_.clear();

    return true;
}


bool Foam::functionObjects::wallLoad::execute()
{
    const creepingFlow& flow = creepingFlow::find(mesh_);
    corners_ = flow.corners() && patches_.size() == physical().size();

    if (files_.empty())
    {
        begin();
    }

    volVectorField& traction = field<volVectorField>(traction_, dimPressure);
    volScalarField& couples =
        field<volScalarField>(couple_, dimPressure*dimLength);
    scalarField sums(nOfPatch*nRows() + nOfBin*nBin_, Zero);

    for (const label patchi : physical())
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        vectorField force, viscous;
        scalarField couple;
        flow.wallLoads(patchi, force, viscous, couple);
        force += viscous;

        traction.boundaryFieldRef()[patchi] == force/patch.magSf();
        couples.boundaryFieldRef()[patchi] == couple/patch.magSf();

        if (patches_.found(patchi))
        {
            addPatch(patch, force, couple, sums);
        }
    }
    if (corners_)
    {
        addCorners(flow.cornerLoads(), sums);
    }

    reduce(sums, sumOp<scalarField>());
    if (axial_.active())
    {
        toCircle(sums);
    }
    writeRows(sums);

    return true;
}


bool Foam::functionObjects::wallLoad::write()
{
    // Rows are there of each step, times of those that are written
    if (time_.writeTime() || postProcess)
    {
        writeObject(traction_);
        writeObject(couple_);
    }

    return true;
}


// ************************************************************************* //
