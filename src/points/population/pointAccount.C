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

#include "pointAccount.H"
#include "materialPointCloud.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointAccount::pointAccount()
:
    nInside_(0),
    volumeInside_(0),
    nIn_(0),
    nAdded_(0),
    nDeleted_(0),
    share0_(1),
    share_(1),
    told_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointAccount::open(const materialPointCloud& cloud)
{
    nInside_ = cloud.census().nPoints();
    volumeInside_ = sum(cloud.census().volume());
    share0_ = volumeInside_/gSum(cloud.pMesh().cellVolumes());
    const label nPatches = cloud.pMesh().boundaryMesh().nNonProcessor();
    nOut_.setSize(nPatches, 0);
    volumeOut_.setSize(nPatches);
}


void Foam::pointAccount::close
(
    const materialPointCloud& cloud,
    const label nIn,
    const scalar volumeIn,
    const label nAdded,
    const label nDeleted,
    const labelList& nOut,
    const scalarList& volumeOut
)
{
    label n = nInside_;
    scalar volume = volumeInside_;

    const label nInAll = returnReduce(nIn, sumOp<label>());
    const scalar volumeInAll = returnReduce(volumeIn, sumOp<scalar>());

    nIn_ += nInAll;
    volumeIn_ += volumeInAll;
    nAdded_ += nAdded;
    nDeleted_ += nDeleted;
    n += nInAll + nAdded - nDeleted;
    volume += volumeInAll;

    scalar volumeGone = 0;
    forAll(nOut_, patchi)
    {
        const label gone = returnReduce(nOut[patchi], sumOp<label>());
        const scalar v = returnReduce(volumeOut[patchi], sumOp<scalar>());
        nOut_[patchi] += gone;
        volumeOut_[patchi] += v;
        n -= gone;
        volumeGone += v;
    }
    volume -= volumeGone;

    const scalar scale = volumeInside_ + volumeInAll;
    nInside_ = cloud.census().nPoints();
    volumeInside_ = sum(cloud.census().volume());

    // The volume but for the rounding of sums
    if (n != nInside_ || mag(volume - volumeInside_) > 1e-9*scale)
    {
        FatalErrorInFunction
            << "The books of the material points do not balance at time "
            << cloud.pMesh().time().timeName() << nl
            << "    Inside are " << nInside_ << " points, "
            << volumeInside_ << " m3; before + in + added - deleted - out is "
            << n << " points, " << volume << " m3"
            << exit(FatalError);
    }
}


void Foam::pointAccount::compare
(
    const materialPointCloud& cloud,
    const scalar waiting
)
{
    const polyMesh& mesh = cloud.pMesh();
    const scalar volume =
        volumeInside_ + returnReduce(waiting, sumOp<scalar>());
    share_ = volume/gSum(mesh.cellVolumes());
    const scalar change = mag(share_ - share0_);

    const volScalarField* invB = mesh.findObject<volScalarField>("invB");
    const bool compressible = invB && gMax(invB->primitiveField()) > 0;

    if (change > 0.1 && !compressible)
    {
        FatalErrorInFunction
            << "Material points fill " << 100*share_ << " % of the mesh at"
            << " time " << mesh.time().timeName() << ", " << 100*share0_
            << " % at the start" << nl
            << "    As much has to come in as goes out: look at U and the"
            << " types of its patches, at inflow in"
            << " constant/materialPointsProperties, and for steps that are too"
            << " long" << exit(FatalError);
    }
    if (change > told_ + 0.02)
    {
        told_ = change;
        WarningInFunction
            << "Material points fill " << 100*share_ << " % of the mesh at"
            << " time " << mesh.time().timeName() << ", " << 100*share0_
            << " % at the start" << endl;
    }
}


Foam::label Foam::pointAccount::nOut() const
{
    return sum(nOut_);
}


Foam::scalar Foam::pointAccount::volumeOut() const
{
    longSum all;
    for (const longSum& v : volumeOut_)
    {
        all += v.value();
    }

    return all.value();
}


void Foam::pointAccount::report(const materialPointCloud& cloud) const
{
    Info<< "Material points: " << nInside_ << " inside (" << volumeInside_
        << " m3); since the start " << nIn_ << " in (" << volumeIn_.value()
        << " m3), " << nAdded_ << " added, " << nDeleted_ << " deleted, "
        << nOut() << " out (" << volumeOut() << " m3)";

    forAll(nOut_, patchi)
    {
        if (nOut_[patchi])
        {
            Info<< ", " << nOut_[patchi] << " by "
                << cloud.pMesh().boundaryMesh()[patchi].name();
        }
    }
    Info<< "; of the mesh's volume " << 100*share_ << " %" << endl;
}


// ************************************************************************* //
