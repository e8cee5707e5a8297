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

#include "sceneParts.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::sceneParts::part>
Foam::sceneParts::partNames
({
    { part::MICROROTATION, "microrotation" },
    { part::COMPRESSIBILITY, "compressibility" },
    { part::GRAVITY, "gravity" },
    { part::AVERAGES, "averages" },
    { part::MATRICES, "matrices" }
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::sceneParts::require(const part p, const string& reason)
{
    reasons_[p] += (reasons_[p].empty() ? "" : ", ") + reason;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sceneParts::sceneParts
(
    const PtrList<material>& materials,
    const dictionary& controls
)
{
    for (const material& m : materials)
    {
        const viscosityLaw& law = m.law();

        if (law.microrotation())
        {
            require(MICROROTATION, m.name());
        }
        if (law.invB().value() > 0)
        {
            require(COMPRESSIBILITY, m.name());
        }
        if (m.rho().value() > 0)
        {
            require(GRAVITY, m.name());
        }
    }

    if (materials.size() > 1)
    {
        require(AVERAGES, Foam::name(materials.size()) + " materials");
    }

    for (const word& p : controls.getOrDefault<wordList>("forced", wordList()))
    {
        if (!partNames.found(p))
        {
            checkedEntry::refuse
            (
                controls, "forced", p,
                "microrotation, compressibility, gravity, averages, matrices"
            );
        }
        require(partNames[p], "forced");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sceneParts::print(Ostream& os, const string& corners) const
{
    auto row = [&os](const word& name, const string& what)
    {
        os  << "    " << name.c_str();
        for (label k = name.size(); k < 18; ++k)
        {
            os  << ' ';
        }
        os  << what.c_str() << nl;
    };

    os  << "Parts of the scene" << nl;
    forAll(reasons_, i)
    {
        row
        (
            partNames[part(i)],
            has(part(i)) ? "yes (" + reasons_[i] + ')'
          : i == MATRICES ? string("when a property changes") : string("no")
        );
    }
    row("corners", corners);
    os  << endl;
}


// ************************************************************************* //
