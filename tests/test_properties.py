"""What points carry beside material, dye and volume."""

import re

import numpy as np
import pytest

from cosserat.analytic import shear_strain
from cosserat.scenes.box import Annulus, add_points

FLUID = {"a": {"eta": 1, "etaC": 0, "R": 0}}
STRAIN = "strain { type accumulatedStrain; onMesh yes; }"
EXACT = {side: ("exact", "exact") for side in
         ("left", "right", "bottom", "top")}
STILL = ("type noSlip;", "type zeroGradient;")
CAVITY = {"left": STILL, "right": STILL, "bottom": STILL,
          "top": ("type fixedValue; value uniform (1 0 0);",
                  "type zeroGradient;")}


def moved(case, properties, steps, dt, ranks=1, **entries):
    """Run a case with points of these properties."""
    add_points(case, "{ type all; material a; }",
               properties=f"{{ {properties} }}", **entries)
    case.substitute("system/controlDict", {
        "endTime": steps*dt, "deltaT": dt, "writeInterval": steps})
    if ranks > 1:
        (case.path/"system/decomposeParDict").write_text(
            "FoamFile { version 2.0; format ascii; class dictionary;"
            f" object x; }}\nnumberOfSubdomains {ranks}; method simple;\n"
            "simpleCoeffs { n (2 1 1); }\n")
        case.run("decomposePar")
    case.run("cosseratPicFoam", ranks=ranks)
    if ranks > 1:
        case.run("reconstructPar", "-latestTime")
    return case


@pytest.mark.slow
@pytest.mark.parametrize("steps, integration, ranks", [
    (3, "RK2", 1), (10, "Euler", 1), (10, "RK4", 2)])
def test_strain_of_simple_shear(box, steps, integration, ranks):
    """The rate times the age of each point, whatever the steps, also of those
    that flow in by the sides, and across processors."""
    case = box(n=8, materials=FLUID, walls=EXACT,
               U=lambda x, y: (2*y, 0*x), omega=lambda x, y: -1 + 0*x)
    moved(case, STRAIN, steps, 0.6/steps, ranks, minPointsPerCell=0,
          integration=integration)
    x, y = case.cloud("positions")[:, :2].T
    strain, exact = case.cloud("strain"), shear_strain(x, y, 2, 0.6)
    assert np.abs(strain - exact).max() < 1e-5
    old = exact == exact.max()
    assert 0.2 < old.mean() < 0.95
    assert np.abs(strain[old] - 1.2).max() < 1e-8


def test_residence_time(box):
    """The age of points in a shear, also of those that flow in; and with
    regions the time above the middle, where they stay, alone."""
    case = box(n=8, materials=FLUID, walls=EXACT,
               U=lambda x, y: (2*y, 0*x), omega=lambda x, y: -1 + 0*x)
    moved(case, "age { type residenceTime; onMesh yes; } above"
          " { type residenceTime; start 2; inflow 2; within ( { type box;"
          " min (-1 0 -1); max (1 1 1); } ); }", 3, 0.2, minPointsPerCell=0)
    x, y = case.cloud("positions")[:, :2].T
    age = case.cloud("age")
    assert np.abs(age - shear_strain(x, y, 2, 0.6)/2).max() < 1e-5
    assert np.abs(case.cloud("above") - 2 - (y > 0)*age).max() < 1e-12
    assert 0.05 < case.field("age").min() < 0.1
    assert case.field("age").max() == pytest.approx(0.6)


def test_strain_of_a_rotation_is_none(box):
    """Nor of points that flow in at the corners."""
    case = box(n=8, materials=FLUID, walls=EXACT, U=lambda x, y: (-y, x),
               omega=lambda x, y: 1 + 0*x)
    moved(case, STRAIN, 10, 0.1, minPointsPerCell=0)
    assert np.abs(case.cloud("strain")).max() < 1e-8


def test_strain_across_a_rotation_of_the_mesh(tmp_path):
    """Between cylinders, of which one turns, on a quarter that is periodic:
    uniform along circles, and the shear rate there times time."""
    case = Annulus(tmp_path/"case", n=12, materials=FLUID, walls={
        "left": ("exact", "exact"), "right": ("exact", "exact")},
        U=lambda x, y: (-y/(x*x + y*y), x/(x*x + y*y)),
        omega=lambda x, y: 0*x).write()
    moved(case, STRAIN, 20, 0.1, minPointsPerCell=0)
    r = np.hypot(*case.cloud("positions")[:, :2].T)
    # A vortex: the shear rate is 2/r^2. Measured: 0.101, as it changes within
    # a cell, and 0.039 in the mean of cells, those at walls
    strain = case.cloud("strain")*r**2/4
    x, y, _ = case.centres().T
    mean = case.field("strain")*(x*x + y*y)/4
    assert np.abs(strain - 1).max() < 0.11
    assert np.abs(mean - 1).max() < 0.042


def test_tracers_see_the_same_strain(box):
    """In a steady flow, where their rule is the same, but that they take D for
    D'. Measured: 3.2e-4, of the divergence of the cells' gradients."""
    case = box(n=8, materials=FLUID, walls=CAVITY)
    path = case.path/"system/controlDict"
    path.write_text(path.read_text().replace("functions\n{", """functions
{
    followed { type pointTracers; libs (cosseratFunctionObjects);
        places ((0.1 0.4 0)); }"""))
    moved(case, STRAIN, 20, 0.1, minPointsPerCell=0)
    last = case.table("followed", "tracer0.dat")[-1]
    places = case.cloud("positions")[:, :2]
    at = np.hypot(*(places - last[1:3]).T).argmin()
    assert last[9] > 1
    assert case.cloud("strain")[at] == pytest.approx(last[9], rel=1e-3)


@pytest.mark.slow
def test_splitting_and_merging_keep_the_sum(box):
    """A carried number in a cavity where points are added and deleted: its sum
    by volume stays, the mean of cells is that of their points, none leaves the
    range of the start; and a strain that is the same everywhere stays so."""
    ore = ("ore { type carried; onMesh yes; regions ( { type disc;"
           " centre (0 0.2 0); radius 0.3; value 3; } ); }")
    case = moved(box(n=8, materials=FLUID, walls=CAVITY), ore, 30, 0.1,
                 pointsPerCell=9, minPointsPerCell=8, maxPointsPerCell=12,
                 velocity="cellPoint")
    added, deleted = re.findall(r"(\d+) added, (\d+) deleted", case.log())[-1]
    assert int(added) > 20 and int(deleted) > 20
    value, volume = case.cloud("ore"), case.cloud("volume")
    x, y = np.meshgrid((np.arange(24) + 0.5)/24 - 0.5,
                       (np.arange(24) + 0.5)/24 - 0.5)
    start = 3*(np.hypot(x, y - 0.2) < 0.3).mean()*volume.sum()
    assert (value*volume).sum() == pytest.approx(start, rel=1e-12)
    assert value.min() == 0 and value.max() <= 3
    assert np.any((value > 0) & (value < 3))
    i, j = np.floor((case.cloud("positions")[:, :2] + 0.5)*8).astype(int).T
    mean = (np.bincount(8*j + i, value*volume, minlength=64)
            / np.bincount(8*j + i, volume, minlength=64))
    assert np.allclose(case.field("ore"), mean, atol=1e-12)

    case = moved(box("shear", n=8, cyclic=True, materials=FLUID, walls=EXACT,
                     U=lambda x, y: (y, 0*x), omega=lambda x, y: -0.5 + 0*x),
                 STRAIN, 10, 0.25, pointsPerCell=9, minPointsPerCell=9,
                 maxPointsPerCell=9)
    added, deleted = re.findall(r"(\d+) added, (\d+) deleted", case.log())[-1]
    assert int(added) > 20 and int(deleted) > 20
    assert np.abs(case.cloud("strain") - 2.5).max() < 1e-8


@pytest.mark.slow
def test_empty_cells_filled_across_processors(box):
    """One point a cell, in steps of more than a cell: what comes of a point on
    the other side has its value."""
    case = box(n=8, cyclic=True, materials=FLUID, walls=EXACT,
               U=lambda x, y: (1 + 0*x, 0*y), omega=lambda x, y: 0*x)
    moved(case, "ore { type carried; start 7; }", 20, 0.09, 2,
          pointsPerCell=1, minPointsPerCell=1, velocity="cell")
    assert (case.cloud("ore") == 7).all()


def test_points_that_flow_in_have_their_value(box):
    """By the left side, in half of the length."""
    case = box(n=8, materials=FLUID, U=lambda x, y: (1 + 0*x, 0*y),
               omega=lambda x, y: 0*x, walls=EXACT)
    moved(case, "ore { type carried; start 1; inflow 5; }", 5, 0.1,
          minPointsPerCell=0)
    x = case.cloud("positions")[:, 0]
    clear = np.abs(x) > 0.05
    assert np.array_equal(case.cloud("ore")[clear], np.where(x < 0, 5, 1)[clear])


def test_restart_finds_properties_by_name(box):
    """In any order; one that is new starts, one that is gone is named."""
    case = box(n=4, materials=FLUID, walls=CAVITY)
    moved(case, "ore { type carried; start 2; } " + STRAIN, 2, 0.1)
    assert "Point properties: ore carried, strain accumulatedStrain" in (
        case.log())
    before = case.cloud("strain")
    case.substitute("system/controlDict", {
        "startFrom": "latestTime", "endTime": 0.4})
    path = case.path/"constant/materialPointsProperties"
    path.write_text(path.read_text().replace(
        "ore { type carried; start 2; } " + STRAIN,
        STRAIN + " salt { type carried; start 4; }"))
    case.run("cosseratPicFoam")
    log = case.log()
    assert "Point property salt has no file of time 0.2: all points" in log
    assert "Point property ore of time 0.2 is no longer asked for" in log
    assert "Point property strain" not in log
    assert (case.cloud("salt") == 4).all()
    assert case.cloud("strain").mean() == pytest.approx(
        2*before.mean(), rel=0.02)
    assert not (case.path/"0.4/lagrangian/materialPoints/ore").exists()
