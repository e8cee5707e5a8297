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

#include "materialPoint.H"
#include <algorithm>
#include <functional>
#include <vector>

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

namespace Foam
{
    //- Points of a block
    static const std::size_t blockSize = 1024;

    //- A place that is free, and the next one
    struct freePlace
    {
        freePlace* next;
    };

    static freePlace* firstFree = nullptr;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void* Foam::materialPoint::operator new(const std::size_t size)
{
    #ifdef __SANITIZE_ADDRESS__
    // It is to see each of them
    return ::operator new(size);
    #endif

    if (!firstFree)
    {
        char* block = static_cast<char*>(::operator new(blockSize*size));
        for (std::size_t i = blockSize; i-- > 0;)
        {
            operator delete(block + i*size);
        }
    }

    freePlace* place = firstFree;
    firstFree = place->next;

    return place;
}


void Foam::materialPoint::operator delete(void* p)
{
    #ifdef __SANITIZE_ADDRESS__
    ::operator delete(p);
    return;
    #endif

    if (p)
    {
        firstFree = new(p) freePlace{firstFree};
    }
}


void Foam::materialPoint::tidy()
{
    std::vector<void*> places;
    for (freePlace* place = firstFree; place; place = place->next)
    {
        places.push_back(place);
    }
    std::sort(places.begin(), places.end(), std::greater<void*>());

    firstFree = nullptr;
    for (void* place : places)
    {
        operator delete(place);
    }
}


// ************************************************************************* //
