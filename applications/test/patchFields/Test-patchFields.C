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

Application
    Test-patchFields

Description
    Lists all types of patch fields that can be selected for U, p_rgh and
    omega, with those of the libraries in libs of the case's controlDict, and
    what they mean for the flow, one a line:

        <field> <type> <meaning> [remark]

    meaning is that of patchFieldTypes. Types of the table that OpenFOAM does
    not have here are 'absent'.

    With -page it prints docs/patchFields.md instead.

Usage
    In a case: Test-patchFields [-page]

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "patchFieldTypes.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

typedef patchFieldTypes types;

//- By meaning
static const char* const names[] =
{
    "value", "weight", "total", "weightTotal", "traction", "friction",
    "open", "couple", "result", "mirror", "jump", "coupled", "empty", "refused"
};


template<class Type>
static void list(const word& field)
{
    wordHashSet selectable
    (
        fvPatchField<Type>::patchConstructorTablePtr_->toc()
    );
    selectable +=
        wordHashSet(fvPatchField<Type>::dictionaryConstructorTablePtr_->toc());

    for (const word& type : selectable.sortedToc())
    {
        const types::row* r = types::find(field, type);
        Info<< field << ' ' << type << ' '
            << names[types::of(field, type)] << ' '
            << (r ? r->remark : "") << nl;
    }

    for (const types::row& r : types::table())
    {
        if (field == r.field && !selectable.found(r.type))
        {
            Info<< field << ' ' << r.type << " absent" << nl;
        }
    }
}


static void printPage()
{
    Info<< "# Patch fields" << nl << nl
        << "What types of `U`, `p_rgh` and `omega` are taken, and what is made"
        << " of them." << nl
        << "All others stop the run before its first step, by name: those"
        << " refused below and those" << nl << "not listed." << nl << nl
        << "    $ Test-patchFields -page    # prints this page" << nl << nl
        << "| field | type | meaning | |" << nl
        << "|---|---|---|---|" << nl;

    for (const types::row& r : types::table())
    {
        Info<< "| " << r.field << " | " << r.type << " | "
            << (r.is == types::REFUSED ? "**refused**" : names[r.is])
            << " | " << r.remark << " |" << nl;
    }
}


int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::noParallel();
    argList::addBoolOption("page", "Print the page of the manual");
    #include "setRootCase.H"
    if (args.found("page"))
    {
        printPage();
        return 0;
    }

    #include "createTime.H"

    list<vector>("U");
    list<scalar>("p_rgh");
    list<scalar>("omega");

    return 0;
}


// ************************************************************************* //
