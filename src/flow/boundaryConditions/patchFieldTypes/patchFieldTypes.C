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

#include "patchFieldTypes.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

typedef Foam::patchFieldTypes types;

// Most change with the direction of the flow. Nothing carries U or omega here:
// there is no difference between in and out to make, and one would have to be
// solved for
static const char* const mixed =
    "mixed of value and gradient: take zeroGradient or fixedValue";

static const char* const followsPressure =
    "its value follows the flow: take zeroGradient, where p_rgh is given";

// Rows as written; those of "any" are of each field
static const Foam::List<types::row> written
({
    {"any", "fixedValue", types::VALUE, "a list or a uniform value"},
    {"any", "uniformFixedValue", types::VALUE, "a function of time"},
    {
        "any", "exprFixedValue", types::VALUE,
        "an expression of place, time and fields of the last solve"
    },
    {
        "any", "codedFixedValue", types::VALUE,
        "code, at the fields of the last solve"
    },
    {"any", "fixedProfile", types::VALUE, "a function of a coordinate"},
    {
        "any", "timeVaryingMappedFixedValue", types::VALUE,
        "tables in space and time"
    },
    {"any", "symmetry", types::MIRROR, "on mesh patches of this type"},
    {"any", "symmetryPlane", types::MIRROR, "on mesh patches of this type"},
    {"any", "cyclic", types::COUPLED, "on mesh patches of this type"},
    {"any", "processor", types::COUPLED, "on mesh patches of this type"},
    {"any", "processorCyclic", types::COUPLED, "on mesh patches of this type"},
    {"any", "empty", types::EMPTY, "on mesh patches of this type"},
    {"any", "wedge", types::EMPTY, "on mesh patches of this type"},
    {"any", "fixedMean", types::REFUSED, "its value follows the flow"},
    {"any", "freestream", types::REFUSED, mixed},
    {"any", "inletOutlet", types::REFUSED, mixed},
    {"any", "mappedField", types::REFUSED, "it samples the flow elsewhere"},
    {"any", "mapped", types::REFUSED, "it samples the flow elsewhere"},
    {"any", "mixed", types::REFUSED, mixed},
    {"any", "outletInlet", types::REFUSED, mixed},
    {
        "any", "outletMappedUniformInlet", types::REFUSED,
        "it samples the flow elsewhere"
    },
    {
        "any", "scaledFixedValue", types::REFUSED,
        "what it scales is not known here"
    },
    {"any", "turbulentInlet", types::REFUSED, "its value is random"},
    {"any", "uniformInletOutlet", types::REFUSED, mixed},

    {"U", "noSlip", types::VALUE, "zero"},
    {"U", "surfaceNormalFixedValue", types::VALUE, "along the normal"},
    {
        "U", "uniformNormalFixedValue", types::VALUE,
        "along the normal, a function of time"
    },
    {
        "U", "flowRateInletVelocity", types::VALUE,
        "a flow rate; without extrapolateProfile"
    },
    {
        "U", "cylindricalInletVelocity", types::VALUE,
        "along, about and away from an axis"
    },
    {
        "U", "swirlFlowRateInletVelocity", types::VALUE,
        "a flow rate with a rotation"
    },
    {"U", "swirlInletVelocity", types::VALUE, "along an axis and about it"},
    {"U", "rotatingWallVelocity", types::VALUE, "a rotation"},
    {"U", "translatingWallVelocity", types::VALUE, "a translation"},
    {
        "U", "movingWallVelocity", types::VALUE,
        "its value, since the mesh is at rest"
    },
    {"U", "slip", types::TRACTION, "traction zero"},
    {"U", "tangentialTraction", types::TRACTION, "of this project"},
    {"U", "coulombFriction", types::FRICTION, "of this project"},
    {"U", "zeroGradient", types::OPEN, "where p_rgh is given"},
    {"U", "activeBaffleVelocity", types::REFUSED, "its value follows the flow"},
    {
        "U", "activePressureForceBaffleVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {
        "U", "flowRateOutletVelocity", types::REFUSED,
        "its value follows the flow: take flowRateInletVelocity, negative"
    },
    {
        "U", "fluxCorrectedVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {"U", "freestreamVelocity", types::REFUSED, mixed},
    {"U", "mappedFlowRate", types::REFUSED, "it samples the flow elsewhere"},
    {
        "U", "mappedVelocityFlux", types::REFUSED,
        "it samples the flow elsewhere"
    },
    {
        "U", "matchedFlowRateOutletVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {"U", "pressureDirectedInletVelocity", types::REFUSED, followsPressure},
    {"U", "pressureInletOutletParSlipVelocity", types::REFUSED, mixed},
    {"U", "pressureInletOutletVelocity", types::REFUSED, mixed},
    {"U", "pressureInletUniformVelocity", types::REFUSED, followsPressure},
    {"U", "pressureInletVelocity", types::REFUSED, followsPressure},
    {
        "U", "pressurePIDControlInletVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {"U", "swirlFanVelocity", types::REFUSED, "its value follows the flow"},
    {"U", "turbulentDFSEMInlet", types::REFUSED, "its value is random"},
    {"U", "turbulentDigitalFilterInlet", types::REFUSED, "its value is random"},

    {"p_rgh", "prghPressure", types::WEIGHT, "p given"},
    {
        "p_rgh", "prghTotalPressure", types::WEIGHT_TOTAL,
        "p given, less rho |U|^2/2 where fluid comes in"
    },
    {
        "p_rgh", "totalPressure", types::TOTAL,
        "p_rgh given, less rho |U|^2/2 where fluid comes in"
    },
    {
        "p_rgh", "uniformTotalPressure", types::TOTAL,
        "the same, a function of time"
    },
    {"p_rgh", "zeroGradient", types::RESULT, "walls and given velocities"},
    {"p_rgh", "fixedFluxPressure", types::RESULT, "the same"},
    {"p_rgh", "fixedFluxExtrapolatedPressure", types::RESULT, "the same"},
    {"p_rgh", "fixedJump", types::JUMP, "on mesh patches of type cyclic"},
    {"p_rgh", "uniformJump", types::JUMP, "the same, a function of time"},
    {"p_rgh", "fan", types::REFUSED, "its jump follows the flow"},
    {
        "p_rgh", "fanPressure", types::REFUSED,
        "its value follows the flow by a curve"
    },
    {"p_rgh", "freestreamPressure", types::REFUSED, mixed},
    {
        "p_rgh", "phaseHydrostaticPressure", types::REFUSED,
        "mixed of value and gradient: take prghPressure"
    },
    {
        "p_rgh", "prghTotalHydrostaticPressure", types::REFUSED,
        "it belongs to solvers with a field ph_rgh"
    },
    {
        "p_rgh", "uniformDensityHydrostaticPressure", types::REFUSED,
        "it gives p: take prghPressure"
    },

    {"omega", "rollingFriction", types::FRICTION, "of this project"},
    {"omega", "coupleTraction", types::COUPLE, "of this project"},
    {"omega", "zeroGradient", types::COUPLE, "couple traction zero"}
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- The rows of each field, first those that are taken
    static List<types::row> allRows()
    {
        DynamicList<types::row> rows;

        for (const char* field : {"U", "p_rgh", "omega"})
        {
            for (const bool refused : {false, true})
            {
                for (const types::row& r : written)
                {
                    const bool any = word(r.field) == "any";

                    if
                    (
                        (any || word(r.field) == field)
                     && (r.is == types::REFUSED) == refused
                    )
                    {
                        rows.append({field, r.type, r.is, r.remark});
                    }
                }
            }
        }

        return List<types::row>(rows);
    }
}


static const Foam::List<types::row> rows(Foam::allRows());


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::UList<Foam::patchFieldTypes::row>& Foam::patchFieldTypes::table()
{
    return rows;
}


const Foam::patchFieldTypes::row* Foam::patchFieldTypes::find
(
    const word& field,
    const word& type
)
{
    for (const row& r : rows)
    {
        if (field == r.field && type == r.type)
        {
            return &r;
        }
    }

    return nullptr;
}


Foam::string Foam::patchFieldTypes::allowed(const word& field)
{
    string names
    (
        find(field, "noSlip")
      ? "types that fix the value (fixedValue, noSlip, ...)"
      : "types that fix the value (fixedValue, ...)"
    );
    for (const row& r : rows)
    {
        if (field == r.field && r.is > VALUE && r.is < JUMP)
        {
            names += string(", ") + r.type;
        }
    }

    return names;
}


// ************************************************************************* //
