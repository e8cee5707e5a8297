"""Points pass the boundary where fluid does, whatever the types of patches."""

import re

import numpy as np
import pytest

from cosserat.scenes.box import (FORWARD, ONE, STILL, TWO, account, add_points,
                                 retype)


@pytest.mark.slow
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
            retype(case, "patch", *sides)
        case.substitute("system/controlDict", {
            "endTime": 5, "deltaT": 0.1, "writeInterval": 50})
        case.run("cosseratPicFoam")
        assert account(case)[6] == 0
        places.append(case.cloud("positions"))
    assert np.array_equal(*places)


@pytest.mark.parametrize("kinds", ["wall", "patch"])
def test_through_walls_or_patches(box, kinds):
    """Velocities in and out: the account is that of the fluxes."""
    case = box("case", n=8, materials=TWO, walls=FORWARD,
               fractions=lambda x, y: 0*x)
    retype(case, kinds, "left", "right")
    add_points(case, "{ type all; material a; }",
               inflow="{ left { material b; } }")
    case.substitute("system/controlDict", {
        "deltaT": 0.0375, "endTime": 0.75, "writeInterval": 20})
    case.run("cosseratPicFoam")
    assert account(case)[:4] == pytest.approx([1024, 0.1, 768, 0.075], rel=1e-6)
    assert account(case)[6] == 768
    assert (case.field("alpha.b").reshape(8, 8)
            == [1, 1, 1, 1, 1, 1, 0, 0]).all()


@pytest.mark.slow
@pytest.mark.parametrize("make_patch", [True, False])
@pytest.mark.parametrize("entry", [
    "type fixedValue; value uniform (1 0 0);",
    "type surfaceNormalFixedValue; refValue uniform -1;",
    "type flowRateInletVelocity; volumetricFlowRate constant 0.1;"
    " value uniform (0 0 0);"])
def test_inflow_without_an_entry_is_named_at_once(box, entry, make_patch):
    """By a wall as by a patch, before the first step."""
    case = box(n=4, materials=TWO, fractions=lambda x, y: 0*x, walls={
        **FORWARD, "left": (entry, "type zeroGradient;")})
    if make_patch:
        retype(case, "patch", "left", "right")
    add_points(case, "{ type all; material a; }")
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode == 1 and "Time = " not in done.stdout
    assert "through patch left at time 0" in done.stdout
    assert "'inflow/left' is not there" in done.stdout


def test_one_material_needs_no_entry(box):
    """What comes in is what there is."""
    case = box(n=8, materials=ONE, walls=FORWARD)
    add_points(case, "{ type all; material a; }")
    case.substitute("system/controlDict", {
        "deltaT": 0.0375, "endTime": 0.75, "writeInterval": 20})
    case.run("cosseratPicFoam")
    assert account(case)[:4] == pytest.approx([1024, 0.1, 768, 0.075], rel=1e-6)


@pytest.mark.slow
def test_part_of_a_patch_is_open(box):
    """Fluid comes in by the upper half of one side and leaves by that of the
    other: so do the points, and none by the halves at rest."""
    half = ("type fixedValue; value nonuniform List<vector> 8"
            " ((0 0 0) (0 0 0) (0 0 0) (0 0 0)"
            " (1 0 0) (1 0 0) (1 0 0) (1 0 0));", "type zeroGradient;")
    case = box(n=8, materials=TWO, fractions=lambda x, y: 0*x, walls={
        "left": half, "right": half, "top": ("type slip;",) + STILL[1:],
        "bottom": STILL})
    retype(case, "patch", "left", "right")
    add_points(case, "{ type all; material a; }",
               inflow="{ left { material b; } }")
    case.substitute("system/controlDict", {
        "deltaT": 0.03, "endTime": 1.5, "writeInterval": 50})
    case.run("cosseratPicFoam")
    _, volume, n_in, volume_in, _, _, n_out, _ = account(case)
    assert volume_in == pytest.approx(0.05*1.5, rel=1e-2)
    assert n_in > 700 and n_out > 700
    assert volume == pytest.approx(0.1, rel=2e-2)
    share = case.cloud("volume").sum()/case.volumes().sum()
    assert share == pytest.approx(1, abs=0.02)
    # The lower half is not emptied
    xy = case.cloud("positions")
    assert ((xy[:, 1] < 0).sum()
            == pytest.approx(512, rel=0.1))


def test_moving_walls_pass_nothing(box):
    """Walls that move along themselves, of any type, and a mirror."""
    slide = ("type fixedValue; value uniform (1 0 0);", "type zeroGradient;")
    case = box(n=8, cyclic=True, materials=ONE, symmetry=("bottom",),
               walls={"top": slide})
    retype(case, "patch", "top")
    add_points(case, "{ type all; material a; }")
    case.substitute("system/controlDict", {
        "endTime": 3, "deltaT": 0.1, "writeInterval": 30})
    case.run("cosseratPicFoam")
    assert account(case)[0] == 1024 and account(case)[2] == account(case)[6] == 0


@pytest.mark.slow
@pytest.mark.parametrize("side, entry, word", [
    ("top", "type slip;", "slip"), ("top", "type noSlip;", "noSlip"),
    ("top", "type tangentialTraction; traction uniform (1 0 0);",
     "tangentialTraction")])
def test_entries_where_nothing_comes_in(box, side, entry, word):
    """inflow of a patch that no fluid can pass."""
    case = box(n=4, materials=TWO, fractions=lambda x, y: 0*x,
               walls={**FORWARD, side: (entry, "type zeroGradient;")})
    retype(case, "patch", "left", "right", "bottom", "top")
    add_points(case, "{ type all; material a; }",
               inflow="{ left { material b; } top { material a; } }")
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode == 1
    assert "Entry 'top' of inflow" in done.stdout and word in done.stdout


@pytest.mark.slow
def test_growing_difference_is_told_and_then_an_error(box):
    """Material that comes into a body which can be compressed fills more than
    the mesh: told. Where none can be, steps of many cells do so: an error."""
    case = box("told", n=8, walls={"left": FORWARD["left"]}, materials={
        "a": {"eta": 1, "etaC": 0, "R": 0, "B": 10}})
    add_points(case, "{ type all; material a; }")
    case.substitute("system/controlDict", {
        "endTime": 0.2, "deltaT": 0.02, "writeInterval": 10})
    log = case.run("cosseratPicFoam").stdout
    assert log.count("Material points fill") > 4
    fill = case.table("points", "pointStatistics.dat")[:, 7]/0.1
    assert (np.diff(fill) >= 0).all()
    assert fill[-1] == pytest.approx(1.2, abs=0.03)

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
    assert done.stdout.count("Material points fill") >= 2
    fill = case.table("points", "pointStatistics.dat")[:, 7]/0.1
    # The step that ends the run has no row
    assert 0.9 < fill.min() < 0.98
    assert re.search(r"FATAL ERROR(.*\n)+?Material points fill 8", done.stdout)
