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

// * * * * * * * * * * * * * * * Local Constants * * * * * * * * * * * * * * //

typedef Foam::patchFieldTypes types;

static const Foam::List<types::row> rows
({
    {"U", "fixedValue", types::VALUE, "a list or a uniform value"},
    {"U", "uniformFixedValue", types::VALUE, "a function of time"},
    {
        "U", "exprFixedValue", types::VALUE,
        "an expression of place, time and fields of the last solve"
    },
    {
        "U", "codedFixedValue", types::VALUE,
        "code, at the fields of the last solve"
    },
    {"U", "fixedProfile", types::VALUE, "a function of a coordinate"},
    {
        "U", "timeVaryingMappedFixedValue", types::VALUE,
        "tables in space and time"
    },
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
    {"U", "zeroGradient", types::OPEN, "where p_rgh is given"},
    {"U", "symmetry", types::MIRROR, "on mesh patches of this type"},
    {"U", "symmetryPlane", types::MIRROR, "on mesh patches of this type"},
    {"U", "cyclic", types::COUPLED, "on mesh patches of this type"},
    {"U", "processor", types::COUPLED, "on mesh patches of this type"},
    {"U", "processorCyclic", types::COUPLED, "on mesh patches of this type"},
    {"U", "empty", types::EMPTY, "on mesh patches of this type"},
    {"U", "activeBaffleVelocity", types::REFUSED, "its value follows the flow"},
    {
        "U", "activePressureForceBaffleVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {"U", "fixedMean", types::REFUSED, "its value follows the flow"},
    {
        "U", "flowRateOutletVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {
        "U", "fluxCorrectedVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {
        "U", "freestream", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {
        "U", "inletOutlet", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {"U", "mappedField", types::REFUSED, "it samples the flow elsewhere"},
    {"U", "mapped", types::REFUSED, "it samples the flow elsewhere"},
    {"U", "mappedFlowRate", types::REFUSED, "it samples the flow elsewhere"},
    {
        "U", "mappedVelocityFlux", types::REFUSED,
        "it samples the flow elsewhere"
    },
    {
        "U", "matchedFlowRateOutletVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {
        "U", "outletInlet", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {
        "U", "outletMappedUniformInlet", types::REFUSED,
        "it samples the flow elsewhere"
    },
    {
        "U", "pressureDirectedInletVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {
        "U", "pressureInletOutletParSlipVelocity", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {
        "U", "pressureInletOutletVelocity", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {
        "U", "pressureInletUniformVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {
        "U", "pressureInletVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {
        "U", "pressurePIDControlInletVelocity", types::REFUSED,
        "its value follows the flow"
    },
    {
        "U", "scaledFixedValue", types::REFUSED,
        "what it scales is not known here"
    },
    {"U", "swirlFanVelocity", types::REFUSED, "its value follows the flow"},
    {"U", "turbulentDFSEMInlet", types::REFUSED, "its value is random"},
    {"U", "turbulentDigitalFilterInlet", types::REFUSED, "its value is random"},
    {"U", "turbulentInlet", types::REFUSED, "its value is random"},

    {"p_rgh", "fixedValue", types::VALUE, "a list or a uniform value"},
    {"p_rgh", "uniformFixedValue", types::VALUE, "a function of time"},
    {
        "p_rgh", "exprFixedValue", types::VALUE,
        "an expression of place, time and fields of the last solve"
    },
    {
        "p_rgh", "codedFixedValue", types::VALUE,
        "code, at the fields of the last solve"
    },
    {"p_rgh", "fixedProfile", types::VALUE, "a function of a coordinate"},
    {
        "p_rgh", "timeVaryingMappedFixedValue", types::VALUE,
        "tables in space and time"
    },
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
    {"p_rgh", "symmetry", types::MIRROR, "on mesh patches of this type"},
    {"p_rgh", "symmetryPlane", types::MIRROR, "on mesh patches of this type"},
    {"p_rgh", "cyclic", types::COUPLED, "on mesh patches of this type"},
    {"p_rgh", "processor", types::COUPLED, "on mesh patches of this type"},
    {
        "p_rgh", "processorCyclic", types::COUPLED,
        "on mesh patches of this type"
    },
    {"p_rgh", "empty", types::EMPTY, "on mesh patches of this type"},
    {"p_rgh", "fan", types::REFUSED, "its jump follows the flow"},
    {
        "p_rgh", "fanPressure", types::REFUSED,
        "its value follows the flow by a curve"
    },
    {"p_rgh", "fixedMean", types::REFUSED, "its value follows the flow"},
    {
        "p_rgh", "freestream", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {
        "p_rgh", "inletOutlet", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {"p_rgh", "mappedField", types::REFUSED, "it samples the flow elsewhere"},
    {
        "p_rgh", "mapped", types::REFUSED,
        "it samples the flow elsewhere"
    },
    {
        "p_rgh", "outletInlet", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {
        "p_rgh", "outletMappedUniformInlet", types::REFUSED,
        "it samples the flow elsewhere"
    },
    {
        "p_rgh", "phaseHydrostaticPressure", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {
        "p_rgh", "prghTotalHydrostaticPressure", types::REFUSED,
        "it belongs to solvers with a field ph_rgh"
    },
    {
        "p_rgh", "scaledFixedValue", types::REFUSED,
        "what it scales is not known here"
    },
    {"p_rgh", "turbulentInlet", types::REFUSED, "its value is random"},
    {
        "p_rgh", "uniformDensityHydrostaticPressure", types::REFUSED,
        "it gives p: prghPressure does so here"
    },

    {"omega", "fixedValue", types::VALUE, "a list or a uniform value"},
    {"omega", "uniformFixedValue", types::VALUE, "a function of time"},
    {
        "omega", "exprFixedValue", types::VALUE,
        "an expression of place, time and fields of the last solve"
    },
    {
        "omega", "codedFixedValue", types::VALUE,
        "code, at the fields of the last solve"
    },
    {"omega", "fixedProfile", types::VALUE, "a function of a coordinate"},
    {
        "omega", "timeVaryingMappedFixedValue", types::VALUE,
        "tables in space and time"
    },
    {"omega", "zeroGradient", types::COUPLE, "couple traction zero"},
    {"omega", "coupleTraction", types::COUPLE, "of this project"},
    {"omega", "symmetry", types::MIRROR, "on mesh patches of this type"},
    {"omega", "symmetryPlane", types::MIRROR, "on mesh patches of this type"},
    {"omega", "cyclic", types::COUPLED, "on mesh patches of this type"},
    {"omega", "processor", types::COUPLED, "on mesh patches of this type"},
    {
        "omega", "processorCyclic", types::COUPLED,
        "on mesh patches of this type"
    },
    {"omega", "empty", types::EMPTY, "on mesh patches of this type"},
    {"omega", "fixedMean", types::REFUSED, "its value follows the flow"},
    {
        "omega", "freestream", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {
        "omega", "inletOutlet", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {"omega", "mappedField", types::REFUSED, "it samples the flow elsewhere"},
    {
        "omega", "mapped", types::REFUSED,
        "it samples the flow elsewhere"
    },
    {
        "omega", "outletInlet", types::REFUSED,
        "mixed: value or gradient by the direction of the flow"
    },
    {
        "omega", "outletMappedUniformInlet", types::REFUSED,
        "it samples the flow elsewhere"
    },
    {
        "omega", "scaledFixedValue", types::REFUSED,
        "what it scales is not known here"
    },
    {"omega", "turbulentInlet", types::REFUSED, "its value is random"}
});


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
