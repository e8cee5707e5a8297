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

#include "patchLoad.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::patchLoad<Type>::patchLoad
(
    const polyPatch& pp,
    const word& key,
    const dictionary& dict,
    const bool mandatory
)
:
    function_
    (
        mandatory || dict.found(key)
      ? PatchFunction1<Type>::New(pp, key, dict)
      : autoPtr<PatchFunction1<Type>>()
    )
{}


template<class Type>
Foam::patchLoad<Type>::patchLoad
(
    const patchLoad<Type>& load,
    const polyPatch& pp
)
:
    function_()
{
    if (load.function_)
    {
        function_ = load.function_.clone(pp);
    }
}


template<class Type>
Foam::patchLoad<Type>::patchLoad
(
    const patchLoad<Type>& load,
    const polyPatch& pp,
    const fvPatchFieldMapper& mapper
)
:
    patchLoad(load, pp)
{
    autoMap(mapper);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
template<class PatchField>
Foam::tmp<Foam::Field<Type>> Foam::patchLoad<Type>::value
(
    const PatchField& pf
) const
{
    return
        function_
      ? function_->value(pf.db().time().timeOutputValue())
      : tmp<Field<Type>>(new Field<Type>(pf.size(), Zero));
}


template<class Type>
void Foam::patchLoad<Type>::autoMap(const fvPatchFieldMapper& mapper)
{
    if (function_)
    {
        function_->autoMap(mapper);
    }
}


template<class Type>
void Foam::patchLoad<Type>::rmap
(
    const patchLoad<Type>& load,
    const labelList& addr
)
{
    if (function_ && load.function_)
    {
        function_->rmap(load.function_(), addr);
    }
}


template<class Type>
void Foam::patchLoad<Type>::write(Ostream& os) const
{
    if (function_)
    {
        function_->writeData(os);
    }
}


// ************************************************************************* //
