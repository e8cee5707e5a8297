"""Points pass the boundary where fluid does, whatever the types of patches."""

import re

import numpy as np
import pytest

from cosserat.box import add_points
from test_population import ONE, THROUGH, TWO, account, opened

STILL = ("type noSlip;", "type zeroGradient;")


def retyped(case, kind, sides=("left", "right", "bottom", "top")):
    """Give sides of a box another type of mesh patch."""
    path = case.path/"constant/polyMesh/boundary"
    text = path.read_text()
    for side in sides:
        text = re.sub(rf"(\b{side}\s*{{\s*type\s+)\w+;", rf"\1{kind};", text)
        text = re.sub(rf"(\b{side}\s*{{[^}}]*?)inGroups\s+[^;]*;", r"\1", text)
    path.write_text(text)
    return case


@pytest.mark.parametrize("velocity", ["conservativeLinear", "cellPoint"])
@pytest.mark.parametrize("sides", [
    ("left", "right", "bottom", "top"), ("top",), ("left", "bottom")])
def test_walls_of_type_patch_hold_points(box, velocity, sides):
    """A driven cavity: the points are those of the same with walls."""
    places = []
    for name in ("wall", "patch"):
        case = box(name, n=8, materials=ONE, tolerance=1e-7, walls={
            "left": STILL, "right": STILL, "bottom": STILL,
            "top": ("type fixedValue; value uniform (1 0 0);",
                    "type zeroGradient;")})
        add_points(case, "{ type all; material a; }", velocity=velocity)
        if name == "patch":
            retyped(case, "patch", sides)
        case.substitute("system/controlDict", {
            "endTime": 5, "deltaT": 0.1, "writeInterval": 50})
        case.run("cosseratPicFoam")
        assert account(case)[6] == 0
        places.append(case.cloud("positions"))
    assert np.array_equal(*places)


@pytest.mark.parametrize("kinds", ["wall", "patch"])
def test_through_walls_or_patches(box, kinds):
    """Velocities in and out: the account is that of the fluxes."""
    case = box("case", n=8, materials=TWO, walls=THROUGH,
               fractions=lambda x, y: 0*x)
    retyped(case, kinds, ("left", "right"))
    add_points(case, "{ type all; material a; }",
               inflow="{ left { material b; } }")
    text = (case.path/"constant/materialPointsProperties")
    text.write_text(text.read_text().replace("} };", "} }"))
    case.substitute("system/controlDict", {
        "deltaT": 0.0375, "endTime": 0.75, "writeInterval": 20})
    case.run("cosseratPicFoam")
    assert account(case)[:4] == pytest.approx([1024, 0.1, 768, 0.075], rel=1e-6)
    assert account(case)[6] == 768
    assert (case.field("alpha.b").reshape(8, 8)
            == [1, 1, 1, 1, 1, 1, 0, 0]).all()


@pytest.mark.parametrize("make_patch", [True, False])
@pytest.mark.parametrize("entry", [
    "type fixedValue; value uniform (1 0 0);",
    "type surfaceNormalFixedValue; refValue uniform -1;",
    "type flowRateInletVelocity; volumetricFlowRate constant 0.1;"
    " value uniform (0 0 0);"])
def test_inflow_without_an_entry_is_named_at_once(box, entry, make_patch):
    """By a wall as by a patch, before the first step."""
    case = box(n=4, materials=TWO, fractions=lambda x, y: 0*x, walls={
        **THROUGH, "left": (entry, "type zeroGradient;")})
    if make_patch:
        opened(case)
    add_points(case, "{ type all; material a; }")
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode == 1 and "Time = " not in done.stdout
    assert "through patch left at time 0" in done.stdout
    assert "'inflow/left' is not there" in done.stdout


def test_one_material_needs_no_entry(box):
    """What comes in is what there is."""
    case = box(n=8, materials=ONE, walls=THROUGH)
    add_points(case, "{ type all; material a; }")
    case.substitute("system/controlDict", {
        "deltaT": 0.0375, "endTime": 0.75, "writeInterval": 20})
    case.run("cosseratPicFoam")
    assert account(case)[:4] == pytest.approx([1024, 0.1, 768, 0.075], rel=1e-6)


def test_part_of_a_patch_is_open(box):
    """Fluid comes in by the upper half of one side and leaves by that of the
    other: so do the points, and none by the halves at rest."""
    half = ("type fixedValue; value nonuniform List<vector> 8"
            " ((0 0 0) (0 0 0) (0 0 0) (0 0 0)"
            " (1 0 0) (1 0 0) (1 0 0) (1 0 0));", "type zeroGradient;")
    case = box(n=8, materials=TWO, fractions=lambda x, y: 0*x, walls={
        "left": half, "right": half, "top": ("type slip;",) + STILL[1:],
        "bottom": STILL})
    opened(case)
    add_points(case, "{ type all; material a; }",
               inflow="{ left { material b; } }")
    text = (case.path/"constant/materialPointsProperties")
    text.write_text(text.read_text().replace("} };", "} }"))
    case.substitute("system/controlDict", {
        "deltaT": 0.03, "endTime": 1.5, "writeInterval": 50})
    case.run("cosseratPicFoam")
    _, volume, n_in, volume_in, _, _, n_out, _ = account(case)
    assert volume_in == pytest.approx(0.05*1.5, rel=1e-2)
    assert n_in > 700 and n_out > 700
    assert volume == pytest.approx(0.1, rel=2e-2)
    share = float(re.findall(r"of the mesh's volume (\S+) %", case.log())[-1])
    assert share == pytest.approx(100, abs=2)
    # The lower half is not emptied
    xy = case.cloud("positions")
    assert ((xy[:, 1] < 0).sum()
            == pytest.approx(512, rel=0.1))


def test_moving_walls_pass_nothing(box):
    """Walls that move along themselves, of any type, and a mirror."""
    slide = ("type fixedValue; value uniform (1 0 0);", "type zeroGradient;")
    case = box(n=8, cyclic=True, materials=ONE, symmetry=("bottom",),
               walls={"top": slide})
    retyped(case, "patch", ("top",))
    add_points(case, "{ type all; material a; }")
    case.substitute("system/controlDict", {
        "endTime": 3, "deltaT": 0.1, "writeInterval": 30})
    case.run("cosseratPicFoam")
    assert account(case)[0] == 1024 and account(case)[2] == account(case)[6] == 0


@pytest.mark.parametrize("side, entry, word", [
    ("top", "type slip;", "slip"), ("top", "type noSlip;", "noSlip"),
    ("top", "type tangentialTraction; traction uniform (1 0 0);",
     "tangentialTraction")])
def test_entries_where_nothing_comes_in(box, side, entry, word):
    """inflow of a patch that no fluid can pass."""
    case = box(n=4, materials=TWO, fractions=lambda x, y: 0*x,
               walls={**THROUGH, side: (entry, "type zeroGradient;")})
    retyped(case, "patch")
    add_points(case, "{ type all; material a; }",
               inflow="{ left { material b; } top { material a; } }")
    text = (case.path/"constant/materialPointsProperties")
    text.write_text(text.read_text().replace("} };", "} }"))
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode == 1
    assert "Entry 'top' of inflow" in done.stdout and word in done.stdout


def test_growing_difference_is_told_and_then_an_error(box):
    """Material that comes into a body which can be compressed fills more than
    the mesh: told. Where none can be, steps of many cells do so: an error."""
    case = box("told", n=8, walls={"left": THROUGH["left"]}, materials={
        "a": {"eta": 1, "etaC": 0, "R": 0, "B": 10}})
    add_points(case, "{ type all; material a; }")
    case.substitute("system/controlDict", {
        "endTime": 0.2, "deltaT": 0.02, "writeInterval": 10})
    log = case.run("cosseratPicFoam").stdout
    told = [float(a) for a in re.findall(r"points fill (\S+) % of the mesh", log)]
    assert len(told) > 4 and told == sorted(told)
    assert told[-1] == pytest.approx(120, abs=3)

    # A turn in steps of cells by a scheme that throws points outward
    turn = {side: ("exact", "exact")
            for side in ("left", "right", "bottom", "top")}
    case = box("error", n=8, materials=ONE, walls=turn,
               U=lambda x, y: (-y, x), omega=lambda x, y: 1 + 0*x)
    add_points(case, "{ type all; material a; }", integration="Euler",
               minPointsPerCell=0)
    case.substitute("system/controlDict", {"endTime": 6, "deltaT": 0.5})
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode == 1
    fills = [float(a) for a in re.findall(r"points fill (\S+) %", done.stdout)]
    assert 90 < fills[0] < 98 and fills[-1] < 90 and len(fills) >= 2
