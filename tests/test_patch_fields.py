"""Types of patch fields: each of OpenFOAM's is taken, and evaluated as
OpenFOAM does, or refused by name before the first step."""

import re

import numpy as np
import pytest

from cosserat.scenes.box import Annulus
from cosserat.case import ROOT

ONE = {"a": {"eta": 1, "etaC": 1, "R": 0.1}}

STILL = ("type noSlip;", "type zeroGradient;")

#: No viscous traction, p_rgh 0
OPEN = ("type zeroGradient;", "type zeroGradient;",
        "type fixedValue; value uniform 0;")

FIELDS = ("U", "p_rgh", "omega")

#: Types that need a compiler at run time
COMPILED = {"codedFixedValue"}

#: Those of this project and of libraries that are not loaded
OWN = {"tangentialTraction", "coupleTraction", "coulombFriction",
       "rollingFriction"}


@pytest.fixture(name="listed", scope="module")
def listed_fixture(tmp_path_factory):
    """What the solver makes of each type: dict of (field, type): meaning."""
    from cosserat.scenes.box import Box
    case = Box(tmp_path_factory.mktemp("list")/"case", n=2,
               materials=ONE).write()
    text = case.run("Test-patchFields").stdout
    return {tuple(row[:2]): row[2] for row in map(str.split, text.splitlines())
            if row and row[0] in FIELDS}


def test_each_type_of_openfoam_is_in_one_of_two_sets(listed):
    """Those with a meaning are few and known; all others are refused, also
    those that fix a value by the flow, at random or for other solvers."""
    assert len(listed) > 200 and "absent" not in listed.values()
    taken = {field: {type_ for (f, type_), meaning in listed.items()
                     if f == field and meaning != "refused"}
             for field in FIELDS}
    value = {"fixedValue", "uniformFixedValue", "exprFixedValue",
             "codedFixedValue", "fixedProfile", "timeVaryingMappedFixedValue"}
    special = {"symmetry", "symmetryPlane", "cyclic", "processor",
               "processorCyclic", "empty", "wedge"}
    assert taken["omega"] == value | special | {"zeroGradient",
                                                "coupleTraction",
                                                "rollingFriction"}
    assert taken["U"] - value - special == set(VELOCITIES) - value | {
        "slip", "zeroGradient", "tangentialTraction", "coulombFriction"}
    assert taken["p_rgh"] - value - special == {
        "prghPressure", "prghTotalPressure", "totalPressure",
        "uniformTotalPressure", "zeroGradient", "fixedFluxPressure",
        "fixedFluxExtrapolatedPressure", "fixedJump", "uniformJump"}
    for name in ("mixed", "inletOutlet", "freestream", "advective",
                 "directionMixed", "mapped", "fixedGradient", "calculated",
                 "codedMixed", "waveTransmissive", "turbulentInlet", "fan"):
        for field in FIELDS:
            assert listed.get((field, name), "refused") == "refused", name


def test_page_is_the_table(box):
    """docs/patchFields.md is what the program prints."""
    page = box(n=2, materials=ONE).run("Test-patchFields", "-page").stdout
    assert page[page.index("# Patch fields"):].strip() == (
        ROOT/"docs/patchFields.md").read_text().strip()


def constant(*value):
    """The same vector everywhere."""
    return lambda t, x, y: np.tile(value, (len(x), 1))


AXIS = "origin (0 0 0); axis (1 0 0);"

#: type: (entries, side, velocity by time and place)
VELOCITIES = {
    "fixedValue": ("value uniform (1 2 0);", "left", constant(1, 2, 0)),
    "noSlip": ("", "top", constant(0, 0, 0)),
    "uniformFixedValue": (
        "uniformValue table ((0 (0 0 0)) (2 (4 2 0)));", "left",
        lambda t, x, y: np.tile((2*t, t, 0), (len(x), 1))),
    "exprFixedValue": (
        'valueExpr "vector(time()*(1 - 4*sqr(pos().y())), 0, 0)";'
        " value uniform (0 0 0);", "left",
        lambda t, x, y: np.stack([t*(1 - 4*y**2), 0*y, 0*y], 1)),
    "fixedProfile": (
        "profile table ((-0.5 (1 0 0)) (0.5 (3 0 0))); direction (0 1 0);"
        " origin 0;", "left",
        lambda t, x, y: np.stack([2 + 2*y, 0*y, 0*y], 1)),
    "timeVaryingMappedFixedValue": (
        "setAverage false; offset (0 0 0); mapMethod nearest;", "left",
        lambda t, x, y: np.stack([1 + y, t + 0*y, 0*y], 1)),
    "surfaceNormalFixedValue": ("refValue uniform -2;", "left",
                                constant(2, 0, 0)),
    "uniformNormalFixedValue": (
        "uniformValue table ((0 0) (2 -4));", "left",
        lambda t, x, y: np.tile((2*t, 0, 0), (len(x), 1))),
    "flowRateInletVelocity": (
        "volumetricFlowRate constant 0.3; value uniform (0 0 0);", "left",
        constant(3, 0, 0)),
    "cylindricalInletVelocity": (
        AXIS + " axialVelocity constant 2; radialVelocity constant 0;"
        " rpm constant 0; value uniform (0 0 0);", "left", constant(2, 0, 0)),
    "swirlFlowRateInletVelocity": (
        AXIS + " flowRate constant 0.2; rpm constant 0;"
        " value uniform (0 0 0);", "left", constant(2, 0, 0)),
    "swirlInletVelocity": (
        AXIS + " axialVelocity constant 2; radialVelocity constant 0;"
        " tangentialVelocity constant 0; value uniform (0 0 0);", "left",
        constant(2, 0, 0)),
    "rotatingWallVelocity": (
        "origin (0 -1 0); axis (0 0 1); omega 2; value uniform (0 0 0);",
        # Less its normal part, as OpenFOAM has it
        "top", lambda t, x, y: np.stack([-2*(y + 1), 0*x, 0*x], 1)),
    "translatingWallVelocity": ("U (3 0 0); value uniform (0 0 0);", "top",
                                constant(3, 0, 0)),
    "movingWallVelocity": ("value uniform (2 0 0);", "top", constant(2, 0, 0)),
}


def tables(case, side):
    """Of a velocity (1 + y, t) in space and time."""
    folder = case.path/"constant/boundaryData"/side
    centres = case.patch_centres(side)
    rows = "\n".join(f"({x!r} {y!r} {z!r})" for x, y, z in centres.tolist())
    for t in (0, 1, 2):
        (folder/str(t)).mkdir(parents=True)
        (folder/"points").write_text(f"(\n{rows}\n)\n")
        values = "\n".join(f"({1 + y!r} {t} 0)" for y in centres[:, 1].tolist())
        (folder/f"{t}/U").write_text(f"(\n{values}\n)\n")


@pytest.mark.parametrize("kind", sorted(set(VELOCITIES) - COMPILED))
def test_velocity_is_evaluated(box, kind):
    """At each time; what comes in leaves by an opening."""
    entries, side, expected = VELOCITIES[kind]
    walls = {"left": STILL, "top": STILL, "right": OPEN}
    walls[side] = (f"type {kind}; {entries}", "type zeroGradient;")
    case = box(n=4, materials=ONE, walls=walls)
    if kind.startswith("timeVarying"):
        tables(case, side)
    case.substitute("system/controlDict", {"endTime": 2})
    case.run("cosseratPicFoam")
    x, y = case.patch_centres(side)[:, :2].T
    normal = {"left": (-1, 0, 0), "top": (0, 1, 0)}[side]
    for t in (1, 2):
        U = expected(t, x, y)
        assert case.patch_field("phi", side, t)*np.ones(4) == pytest.approx(
            U @ normal/40, abs=1e-12)
        net = sum((case.patch_field("phi", each, t)*np.ones(4)).sum()
                  for each in (side, "right"))
        assert net == pytest.approx(0, abs=1e-9)
        # Which write no value
        if kind not in ("noSlip", "surfaceNormalFixedValue"):
            found = case.patch_field("U", side, t)
            assert found*np.ones((4, 1)) == pytest.approx(U, abs=1e-12)


PRESSURES = {
    "fixedValue": ("value uniform 3;", lambda t, y: 3 + 0*y),
    "uniformFixedValue": ("uniformValue table ((0 1) (2 5));",
                          lambda t, y: 1 + 2*t + 0*y),
    "exprFixedValue": ('valueExpr "2 + time()*pos().y()"; value uniform 0;',
                       lambda t, y: 2 + t*y),
    "fixedProfile": ("profile polynomial ((1 0) (2 1)); direction (0 1 0);"
                     " origin 0;", lambda t, y: 1 + 2*y),
    "prghPressure": ("p uniform 2; value uniform 0;", lambda t, y: 2 + 0*y),
}


@pytest.mark.slow
@pytest.mark.parametrize("kind", sorted(PRESSURES))
def test_pressure_is_evaluated(box, kind):
    """At each time, and the flow is linear in it: that of a pressure which is
    linear along the opening goes by its mean."""
    entries, expected = PRESSURES[kind]
    flux = {}
    for name, entry in (("case", f"type {kind}; {entries}"),
                        ("unit", "type fixedValue; value uniform 1;")):
        case = box(name, n=4, materials=ONE, g=(0, -1, 0), walls={
            "top": STILL, "bottom": STILL, "right": OPEN,
            "left": (*OPEN[:2], entry)})
        case.substitute("system/controlDict", {"endTime": 2})
        case.run("cosseratPicFoam")
        flux[name] = [case.patch_field("phi", "right", t).sum() for t in (1, 2)]
        y = case.patch_centres("left")[:, 1]
        if name == "case":
            for t in (1, 2):
                found = case.patch_field("p_rgh", "left", t)*np.ones(4)
                assert found == pytest.approx(expected(t, y), abs=1e-12)
    for i, t in enumerate((1, 2)):
        assert flux["case"][i] == pytest.approx(
            flux["unit"][i]*expected(t, y).mean(), rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("entry, expected", [
    ("type uniformFixedValue; uniformValue table ((0 0) (2 4));",
     lambda t, x: 2*t + 0*x),
    ('type exprFixedValue; valueExpr "time()*pos().x()"; value uniform 0;',
     lambda t, x: t*x),
    ("type fixedProfile; profile polynomial ((1 0) (2 1)); direction (1 0 0);"
     " origin 0;", lambda t, x: 1 + 2*x)])
def test_rotation_is_evaluated(box, entry, expected):
    """omega at each time."""
    case = box(n=4, materials=ONE, walls={"top": ("type noSlip;", entry),
                                          "left": STILL})
    case.substitute("system/controlDict", {"endTime": 2})
    case.run("cosseratPicFoam")
    x = case.patch_centres("top")[:, 0]
    for t in (1, 2):
        assert case.patch_field("omega", "top", t)*np.ones(4) == pytest.approx(
            expected(t, x), abs=1e-12)


#: field: entries of types that are refused, as they are used
REFUSED = [
    ("U", "type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0);"),
    ("U", "type freestream; freestreamValue uniform (1 0 0);"),
    ("U", "type mixed; refValue uniform (0 0 0); refGradient uniform (0 0 0);"
     " valueFraction uniform 0;"),
    ("U", "type pressureInletOutletVelocity; value uniform (0 0 0);"),
    ("U", "type pressureInletVelocity; value uniform (0 0 0);"),
    ("U", "type advective; phi phi;"),
    ("U", "type flowRateInletVelocity; volumetricFlowRate constant 1;"
     " extrapolateProfile true; value uniform (1 0 0);"),
    ("U", "type calculated; value uniform (0 0 0);"),
    ("omega", "type inletOutlet; inletValue uniform 0; value uniform 0;"),
    ("omega", "type outletInlet; outletValue uniform 0; value uniform 0;"),
    ("omega", "type freestream; freestreamValue uniform 0;"),
    ("omega", "type uniformInletOutlet; uniformInletValue constant 0;"
     " value uniform 0;"),
    ("omega", "type fixedMean; meanValue constant 1; value uniform 0;"),
    ("omega", "type slip;"),
    ("p_rgh", "type inletOutlet; inletValue uniform 0; value uniform 0;"),
    ("p_rgh", "type freestreamPressure; freestreamValue uniform 0;"),
    ("p_rgh", "type fixedMean; meanValue constant 1; value uniform 0;"),
    ("p_rgh", "type waveTransmissive; gamma 1.4; fieldInf 0; lInf 1;"
     " value uniform 0;"),
    ("p_rgh", "type uniformDensityHydrostaticPressure; rho 1; pRefValue 0;"
     " pRefPoint (0 0 0); value uniform 0;"),
    ("p_rgh", "type calculated; value uniform 0;"),
]


#: Those of value and gradient: what to take instead is said
MIXED = {"mixed", "inletOutlet", "outletInlet", "freestream",
         "uniformInletOutlet", "freestreamVelocity", "freestreamPressure",
         "pressureInletOutletVelocity"}


@pytest.mark.slow
@pytest.mark.parametrize("field, entry", REFUSED)
def test_type_is_refused_by_name(box, field, entry):
    """File, patch, type and what is allowed, before anything is solved."""
    wall = list(OPEN)
    wall[{"U": 0, "omega": 1, "p_rgh": 2}[field]] = entry
    case = box(n=4, materials=ONE, walls={"left": STILL, "right": wall})
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode == 1
    message = done.stdout[done.stdout.index("FOAM FATAL"):]
    kind = re.match(r"type (\w+)", entry)[1]
    for word in (f"Entry 'type' is {kind}", f"0/{field}.boundaryField.right",
                 "Allowed: ", "docs/patchFields.md"):
        assert word in message, message
    if kind in MIXED:
        assert "take zeroGradient or fixedValue" in " ".join(
            message.split()), message
    assert "FGMRES" not in done.stdout


def test_given_pressure_in_time(box):
    """Twice the pressure, twice the flux."""
    case = box(n=8, materials=ONE, walls={
        "top": STILL, "bottom": STILL, "right": OPEN,
        "left": (*OPEN[:2], "type uniformFixedValue;"
                 " uniformValue table ((0 1) (4 5));")})
    case.substitute("system/controlDict", {"endTime": 4})
    case.run("cosseratPicFoam")
    flux = np.array([case.patch_field("phi", "right", t).sum()
                     for t in (1, 2, 3, 4)])
    assert flux == pytest.approx(flux[0]/2*np.array([2, 3, 4, 5]), rel=1e-8)


def cyclic_entries(case, left, right):
    """Give p_rgh of the cyclic sides entries of their own."""
    path = case.path/"0/p_rgh"
    path.write_text(path.read_text().replace(
        "#includeEtc", f"left {{ {left} }}\nright {{ {right} }}\n#includeEtc"))


@pytest.mark.slow
@pytest.mark.parametrize("left", [
    "type fixedJump; patchType cyclic; jump uniform 0.8; value uniform 0;",
    "type uniformJump; patchType cyclic; jumpTable table ((0 0) (2 1.6));"
    " value uniform 0;"])
def test_jump_drives_a_periodic_channel(box, left):
    """As a weight along it does; p_rgh rises by it from the owner on."""
    scene = {"n": 8, "cyclic": True, "tolerance": 1e-12,
             "walls": {"top": STILL, "bottom": STILL},
             "materials": {"a": {"eta": 1, "etaC": 1, "R": 0.1, "rho": 1}}}
    case = box("jump", **scene)
    cyclic_entries(case, left, left.replace("jump uniform 0.8;", "").replace(
        "jumpTable table ((0 0) (2 1.6));", ""))
    case.run("cosseratPicFoam")
    weight = box("weight", g=(-0.8, 0, 0), **scene)
    weight.run("cosseratPicFoam")
    U, expected = (c.field("U", 1) for c in (case, weight))
    assert np.abs(U - expected).max() < 1e-9*np.abs(expected).max()
    assert expected[:, 0].min() < -0.05
    p = case.field("p_rgh", 1)
    x = case.centres()[:, 0]
    assert p == pytest.approx(0.8*x, abs=1e-8)


def test_values_beyond_cyclic_patches_are_of_the_solution(box):
    """p_rgh there is the mean of the two cells."""
    case = box(n=8, cyclic=True, walls={"top": STILL, "bottom": STILL},
               materials={**ONE, "b": {"eta": 9, "etaC": 1, "R": .1, "rho": 5}},
               fractions=lambda x, y: x + y > 0.2, g=(0, -1, 0))
    path = case.path/"system/controlDict"
    path.write_text(path.read_text().replace(
        "functions\n{", "functions\n{ left { type surfaceFieldValue;"
        " libs (fieldFunctionObjects); regionType patch; name left;"
        " operation average; fields (p_rgh); writeFields no; }"))
    case.run("cosseratPicFoam")
    p = case.field("p_rgh", 1).reshape(8, 8)
    assert np.ptp(p) > 0.1
    row = case.table("left", "surfaceFieldValue.dat")[-1]
    assert row[1] == pytest.approx((p[:, 0] + p[:, -1]).mean()/2, rel=1e-9)


@pytest.mark.parametrize("field, entry", [
    ("p_rgh", "type fan; patchType cyclic; jumpTable constant 1;"
     " value uniform 0;"),
    ("U", "type fixedJump; patchType cyclic; jump uniform (1 0 0);"
     " value uniform (0 0 0);"),
    ("omega", "type zeroGradient; patchType cyclic;")])
def test_types_of_cyclic_patches(box, field, entry):
    """Those of the mesh's own, and jumps of p_rgh."""
    case = box(n=4, cyclic=True, materials=ONE, walls={"top": STILL})
    path = case.path/"0"/field
    path.write_text(path.read_text().replace(
        "#includeEtc", f"left {{ {entry} }}\nright {{ {entry} }}\n#includeEtc"))
    done = case.run("cosseratPicFoam", check=False)
    message = done.stdout[done.stdout.index("FOAM FATAL"):]
    assert done.returncode == 1
    for word in (re.match(r"type (\w+)", entry)[1], f"{field}.boundaryField",
                 "Allowed: cyclic"):
        assert word in message, message


@pytest.mark.slow
def test_jump_is_not_lost_between_processors(box):
    """Where the sides of a cyclic are on two the jump would be none."""
    case = box(n=8, cyclic=True, walls={"top": STILL, "bottom": STILL},
               materials=ONE)
    entry = "type fixedJump; patchType cyclic; jump uniform 1; value uniform 0;"
    cyclic_entries(case, entry, entry)
    case.decompose(2)
    done = case.run("cosseratPicFoam", ranks=2, check=False)
    assert done.returncode and "preservePatches" in done.stdout


def test_annulus_still_turns(tmp_path):
    """Rotational cyclic patches are taken as before."""
    case = Annulus(tmp_path/"case", n=4, materials=ONE,
                   walls={"left": STILL}).write()
    case.run("cosseratPicFoam")
    assert np.abs(case.field("U", 1)).max() == 0
