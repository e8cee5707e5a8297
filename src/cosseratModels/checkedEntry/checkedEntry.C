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

#include "checkedEntry.H"
#include "DynamicList.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static dimensionedScalar readFinite
    (
        const word& key,
        const dimensionSet& dims,
        const dictionary& dict,
        const string& allowed
    )
    {
        // A word, such as nan, else ends in an error without it
        const tokenList& tokens =
            dict.lookupEntry(key, keyType::LITERAL).stream();

        if (tokens.size() && tokens.last().isWord())
        {
            checkedEntry::refuse
            (
                dict, key, tokens.last().wordToken(), allowed
            );
        }

        const dimensionedScalar value(key, dims, dict);

        if (!std::isfinite(value.value()))
        {
            checkedEntry::refuse
            (
                dict, key, Foam::name(value.value()), allowed
            );
        }

        return value;
    }

    static wordList unread(const dictionary& dict, const wordList& allowed)
    {
        DynamicList<word> names;

        for (const entry& e : dict)
        {
            if (e.keyword() != "FoamFile" && !allowed.found(e.keyword()))
            {
                names.append(e.keyword());
            }
        }

        return wordList(names);
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::dimensionedScalar Foam::checkedEntry::positive
(
    const word& key,
    const dimensionSet& dims,
    const dictionary& dict
)
{
    const string allowed("a number above zero");
    const dimensionedScalar value(readFinite(key, dims, dict, allowed));

    if (value.value() <= 0)
    {
        refuse(dict, key, Foam::name(value.value()), allowed);
    }

    return value;
}


Foam::dimensionedScalar Foam::checkedEntry::nonNegative
(
    const word& key,
    const dimensionSet& dims,
    const dictionary& dict
)
{
    const string allowed("zero or a number above zero");
    const dimensionedScalar value(readFinite(key, dims, dict, allowed));

    if (value.value() < 0)
    {
        refuse(dict, key, Foam::name(value.value()), allowed);
    }

    return value;
}


void Foam::checkedEntry::refuse
(
    const dictionary& dict,
    const word& key,
    const string& found,
    const string& allowed
)
{
    FatalIOErrorInFunction(dict)
        << "Entry '" << key << "' of dictionary " << dict.dictName()
        << " is " << found.c_str() << nl
        << "    Allowed: " << allowed.c_str() << nl
        << exit(FatalIOError);
}


void Foam::checkedEntry::only
(
    const dictionary& dict,
    const wordList& allowed
)
{
    const wordList names(unread(dict, allowed));

    if (names.size())
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << names[0] << "' of dictionary " << dict.dictName()
            << " is read by nothing" << nl
            << "    Allowed: " << flatOutput(allowed) << nl
            << exit(FatalIOError);
    }
}


void Foam::checkedEntry::reportUnread
(
    const dictionary& dict,
    const wordList& allowed
)
{
    const wordList names(unread(dict, allowed));

    if (names.size())
    {
        Info<< "Entries of " << dict.name().name()
            << " that nothing reads but other entries, by $: "
            << flatOutput(names) << nl
            << "    Others allowed: " << flatOutput(allowed) << nl << endl;
    }
}


// ************************************************************************* //
