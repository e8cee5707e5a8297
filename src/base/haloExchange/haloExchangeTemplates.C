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

#include "haloExchange.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::haloExchange::pack
(
    const Field<Type>& field,
    const labelList& cells,
    scalar*& at
)
{
    for (const label celli : cells)
    {
        for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
        {
            *at++ = component(field[celli], d);
        }
    }
}


template<class Type>
void Foam::haloExchange::unpack
(
    Field<Type>& field,
    const label i,
    const scalar*& at
) const
{
    const label start = start_[coupled_[i]];
    const List<tensor2D>& R = rotation_[i];

    forAll(cells_[i], facei)
    {
        Type& value = field[start + facei];
        for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
        {
            setComponent(value, d) = *at++;
        }
        if (R.size())
        {
            rotate(R[R.size() == 1 ? 0 : facei], value);
        }
    }
}


template<class... Types>
Foam::label Foam::haloExchange::width()
{
    label sum = 0;
    for (const label n : {label(pTraits<Types>::nComponents)...})
    {
        sum += n;
    }
    return sum;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class... Types>
void Foam::haloExchange::swap(Field<Types>&... fields) const
{
    if (coupled_.empty())
    {
        return;
    }

    // The lists call a function for one field after the other
    forAll(coupled_, i)
    {
        message(i).setSize(width<Types...>()*cells_[i].size());
        scalar* at = message(i).begin();
        (void)std::initializer_list<int>{(pack(fields, cells_[i], at), 0)...};
    }

    exchange();

    forAll(coupled_, i)
    {
        const scalar* at = receive_[i].cbegin();
        (void)std::initializer_list<int>{(unpack(fields, i, at), 0)...};
    }
}


// ************************************************************************* //
