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
#include "ITstream.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static string between(const string& lower)
    {
        return lower + " and at most " + Foam::name(checkedEntry::largest);
    }

    // Read here and not by dimensionedScalar, which stops without the entry
    static dimensionedScalar readFinite
    (
        const word& key,
        const dimensionSet& dims,
        const dictionary& dict,
        const string& allowed
    )
    {
        ITstream& is = dict.lookup(key, keyType::LITERAL);

        if (is.nRemainingTokens() == 0)
        {
            checkedEntry::refuse(dict, key, "empty", allowed);
        }

        // An optional name, and optional dimensions
        token first(is);
        if (!first.isWord() || is.nRemainingTokens() == 0)
        {
            is.putBack(first);
        }

        scalar scale = 1;
        token next(is);
        is.putBack(next);
        if (next == token::BEGIN_SQR)
        {
            dimensionSet found(dims);
            found.read(is, scale);

            if (found != dims)
            {
                OStringStream os;
                os  << "of dimensions " << found << " instead of " << dims;
                checkedEntry::refuse(dict, key, os.str(), allowed);
            }
            if (is.nRemainingTokens() == 0)
            {
                checkedEntry::refuse(dict, key, "without a number", allowed);
            }
        }

        token number(is);
        if (!number.isNumber())
        {
            OStringStream os;
            os  << number;
            checkedEntry::refuse
            (
                dict, key, number.good() ? os.str() : "empty", allowed
            );
        }
        if (is.nRemainingTokens())
        {
            checkedEntry::refuse
            (
                dict, key, "more than a number: is a ';' missing?", allowed
            );
        }

        const scalar value = scale*number.number();

        const bool lost = value != 0 && mag(value)*checkedEntry::largest < 1;

        if (!checkedEntry::inRange(value) || lost)
        {
            checkedEntry::refuse(dict, key, Foam::name(value), allowed);
        }

        return dimensionedScalar(key, dims, value);
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

bool Foam::checkedEntry::inRange(const scalar value)
{
    // Not so where it is not a number
    return mag(value) <= largest;
}


Foam::dimensionedScalar Foam::checkedEntry::positive
(
    const word& key,
    const dimensionSet& dims,
    const dictionary& dict
)
{
    const string allowed(between("a number above zero"));
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
    const string allowed(between("zero or a number above zero"));
    const dimensionedScalar value(readFinite(key, dims, dict, allowed));

    if (value.value() < 0)
    {
        refuse(dict, key, Foam::name(value.value()), allowed);
    }

    return value;
}


Foam::scalar Foam::checkedEntry::place
(
    const word& key,
    const dictionary& dict
)
{
    return readFinite
    (
        key, dimLength, dict, "a number of at most " + Foam::name(largest)
    ).value();
}


Foam::vector Foam::checkedEntry::direction
(
    const word& key,
    const dictionary& dict
)
{
    const vector value(dict.get<vector>(key));

    if (!(mag(value) > 0) || !inRange(mag(value)))
    {
        OStringStream os;
        os  << value;
        refuse(dict, key, os.str(), "a direction: any vector but zero");
    }

    return value/mag(value);
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
