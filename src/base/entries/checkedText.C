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

#include "checkedText.H"
#include "Pstream.H"
#include "StringStream.H"
#include "token.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::checkedText::next()
{
    token_.clear();
    if (written_)
    {
        return;
    }
    if (!rest_.empty())
    {
        token_.swap(rest_);
        splitUnits();
        return;
    }

    token t;
    is_.read(t);

    if (expression_ && t == token::BEGIN_BLOCK)
    {
        // Text up to the bracket, whatever brackets are in it
        is_.getLine(token_, token::END_BLOCK);
        token_ = "#eval{" + token_ + '}';
        expression_ = false;
    }
    else if (t.good())
    {
        OStringStream os;
        os  << t;
        token_ = os.str();
        expression_ = token_ == "#eval";

        splitUnits();
    }
    else if (!is_.eof())
    {
        FatalIOErrorInFunction(is_)
            << "Entry '" << key_.c_str() << "' has a value that cannot be read"
            << nl << "    Allowed: numbers up to 1e308, words, strings, lists"
            << exit(FatalIOError);
    }

    if (token_ == "nonuniform" || (token_ == "binary" && key_ == "format"))
    {
        written_ = true;
        token_.clear();
    }
}


void Foam::checkedText::splitUnits()
{
    // To the stream ']' is a letter like others: [m s^-1] ends in a word
    const auto at = token_.find(']');

    if (inUnits_ && at != string::npos && token_.size() > 1)
    {
        const auto length = std::max<string::size_type>(at, 1);
        rest_ = token_.substr(length);
        token_.resize(length);
    }
}


void Foam::checkedText::skipDirective()
{
    const string directive(token_);

    // Entries may be given again where others choose among them or take them
    // away
    branches_ =
        branches_ || directive.compare(0, 3, "#if") == 0
     || directive == "#remove" || directive == "#inputMode";

    if (directive == "#else" || directive == "#endif")
    {
        next();
    }
    else if (directive == "#ifeq")
    {
        next();
        next();
        next();
    }
    else if
    (
        directive.compare(0, 8, "#include") == 0
     || directive.compare(0, 9, "#sinclude") == 0
     || directive == "#inputMode" || directive == "#remove"
    )
    {
        // What follows may be on the same line, the end of a dictionary too
        next();
        label depth = 0;
        do
        {
            if (token_[0] != '"')
            {
                depth += std::count(token_.begin(), token_.end(), '(');
                depth -= std::count(token_.begin(), token_.end(), ')');
            }
            next();
        } while (depth > 0 && !token_.empty());
    }
    else
    {
        skipLine();
    }
}


void Foam::checkedText::skipLine()
{
    const label line = is_.lineNumber();
    do
    {
        next();
    } while (!token_.empty() && is_.lineNumber() == line);
}


void Foam::checkedText::refuse(const char open, const label line) const
{
    if (written_)
    {
        return;
    }

    FatalIOErrorInFunction(is_)
        << "'" << open << "' of line " << line << " is not closed before "
        << (token_.empty() ? "the end of the file" : token_.c_str()) << nl
        << "    Allowed: each bracket closed, and each entry ended by ';'"
        << exit(FatalIOError);
}


void Foam::checkedText::refuseClosing() const
{
    FatalIOErrorInFunction(is_)
        << "'" << token_.c_str() << "' closes nothing, after entry '"
        << key_.c_str() << "'; OpenFOAM would read no further" << nl
        << "    Allowed: as many brackets closed as opened"
        << exit(FatalIOError);
}


void Foam::checkedText::readEntries(const bool file, const label line)
{
    HashSet<string> keys;

    while (!token_.empty() && token_ != "}")
    {
        if (token_ == ";")
        {
            next();
            continue;
        }
        if (token_[0] == '#')
        {
            skipDirective();
            continue;
        }
        if (string("()[]{").find(token_) != string::npos)
        {
            FatalIOErrorInFunction(is_)
                << "'" << token_.c_str() << "' stands where an entry has to"
                << " begin, after entry '" << key_.c_str() << "'" << nl
                << "    Allowed: as many brackets closed as opened, and each"
                << " entry ended by ';'" << exit(FatalIOError);
        }

        key_ = token_;
        const bool again = key_[0] != '$' && !keys.insert(key_) && !branches_;
        if (again && file)
        {
            // Often appended, to override the first one
            Info<< "Entry '" << key_.c_str() << "' of " << is_.name().name()
                << " is given twice: the last one counts" << nl;
        }
        else if (again)
        {
            FatalIOErrorInFunction(is_)
                << "Entry '" << key_.c_str() << "' is given twice" << nl
                << "    Allowed: once; OpenFOAM would take the last one, and"
                << " merge dictionaries" << exit(FatalIOError);
        }

        next();
        if (token_ == "{")
        {
            const label begin = is_.lineNumber();
            next();
            readEntries(false, begin);
            next();
        }
        else
        {
            readValue();
        }
    }

    if (token_.empty() && !file)
    {
        refuse('{', line);
    }
    if (!token_.empty() && file)
    {
        refuseClosing();
    }
}


void Foam::checkedText::readValue()
{
    const string key(key_);

    // Of the last entry of a dictionary OpenFOAM does not ask for ';'
    while (token_ != ";" && token_ != "}")
    {
        if (token_.empty())
        {
            if (written_)
            {
                return;
            }
            FatalIOErrorInFunction(is_)
                << "Entry '" << key.c_str() << "' is not ended" << nl
                << "    Allowed: each entry ended by ';'" << exit(FatalIOError);
        }
        if (token_ == "[")
        {
            readUnits();
        }
        else if (token_ == "(" || token_ == "{")
        {
            const char open = token_[0];
            const label line = is_.lineNumber();
            next();
            readList(open, line);
        }
        else if (token_ == ")" || token_ == "]")
        {
            refuseClosing();
        }
        next();
    }
    if (token_ == ";")
    {
        next();
    }
}


void Foam::checkedText::readUnits()
{
    const label line = is_.lineNumber();

    // Numbers or names, with brackets of their own: [kg/(m s)]
    inUnits_ = true;
    do
    {
        next();
        if
        (
            (token_.empty() && !written_)
         || token_ == ";" || token_ == "{" || token_ == "}"
        )
        {
            refuse('[', line);
        }
    } while (token_ != "]" && !written_);
    inUnits_ = false;
}


void Foam::checkedText::readList(const char open, const label line)
{
    const string end(1, open == '(' ? ')' : '}');

    while (token_ != end && !written_)
    {
        if (token_ == "{" && open == '(')
        {
            const label begin = is_.lineNumber();
            next();
            readEntries(false, begin);
        }
        else if (token_ == "[")
        {
            readUnits();
        }
        else if (token_ == "(" || token_ == "{")
        {
            const char inner = token_[0];
            const label begin = is_.lineNumber();
            next();
            readList(inner, begin);
        }
        else if
        (
            token_.empty() || token_ == ")" || token_ == "]" || token_ == "}"
         || (token_ == ";" && open != '{')
        )
        {
            refuse(open, line);
        }
        next();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::checkedText::checkedText(const fileName& file)
:
    is_(file),
    inUnits_(false),
    expression_(false),
    written_(false),
    branches_(false)
{
    if (Pstream::master() && is_.good())
    {
        next();
        readEntries(true, 0);
    }
}


// ************************************************************************* //
