"""What the population of points promises, at each of 1000 steps at a Courant
number of 1/2, and where a mesh is refined."""

import pytest

from cosserat.case import FILES, fresh_case
from cosserat.refined import refine_scene
from cosserat.scenes import rayleighTaylor
from cosserat.scenes.box import STILL, Box, add_points, count
from cosserat.scenes.silo import mesh_entries

STEPS = 1000


def silo(path):
    """The tutorial on a quarter of the cells along each side, until what has come down
    lies still."""
    case = fresh_case(path, "silo")
    case.substitute(FILES["mesh"], mesh_entries(2))
    case.substitute(FILES["solution"], {"tolerance": 1e-4})
    case.override("control", endTime=0.5, writeInterval=0.5)
    case.run("blockMesh")
    return case


def hopper(path):
    """The tutorial on 8 x 12 cells, of which those below are four times as
    small."""
    case = fresh_case(path, "hopper")
    case.substitute(FILES["mesh"], {
        "nx": 8, "nSpout": 2, "nCone": 6, "nBin": 4})
    case.override("control", endTime=112, writeInterval=112)
    case.run("blockMesh")
    return case


def overturn(path):
    """A heavy layer overturns, until it lies below."""
    case = rayleighTaylor.scene(path, 1, 16, 3000, 2.9)
    case.override("control", maxCo=0.5)
    return case


def cavity(path, velocity="conservativeLinear"):
    """A lid drives two materials round and round."""
    case = Box(path, n=16, tolerance=1e-6, materials={
        "a": {"eta": 1, "etaC": 0, "R": 0}, "b": {"eta": 3, "etaC": 1, "R": 0.1}
        }, fractions=lambda x, y: 0*x, walls={
            "left": STILL, "right": STILL, "bottom": STILL,
            "top": ("type fixedValue; value uniform (1 0 0);",
                    "type zeroGradient;")}).write()
    add_points(case, "{ type all; material a; }"
               " { type box; material b; min (-1 -1 -1); max (1 0.1 1); }",
               velocity=velocity)
    case.override("control", endTime=STEPS/32, deltaT=1/32, writeInterval=1e3)
    return case


SCENES = {"silo": silo, "hopper": hopper, "overturn": overturn,
          "cavity": cavity}


def statistics(case):
    """Run a case that counts its points: columns of the table by name."""
    count(case)
    case.run("cosseratPicFoam")
    table = case.table("points", "pointStatistics.dat")
    names = ("time points mean deviation least most empty volume in volumeIn"
             " added deleted out volumeOut leastFill mostFill share together")
    return dict(zip(names.split(), table.T))


@pytest.mark.slow
@pytest.mark.parametrize("scene", sorted(SCENES))
def test_bounds_of_many_steps(tmp_path, scene):
    """No point at the place of another, none below a hundredth of the mean of
    its cell, no cell below half full or above twice, four to thirty-two points
    in each."""
    rows = statistics(SCENES[scene](tmp_path/"case"))
    assert len(rows["time"]) >= STEPS
    assert rows["together"].max() == 0
    assert rows["share"].min() > 0.01
    assert rows["leastFill"].min() > 0.5 and rows["mostFill"].max() < 2
    assert rows["least"].min() >= 4 and rows["most"].max() <= 32
    # Which is work: without it the bounds would not hold
    assert rows["added"][-1] > 300


@pytest.mark.slow
def test_no_cell_is_empty(tmp_path):
    """By the other of the velocities that keep volume, in the corners of a
    cavity, at any step."""
    rows = statistics(cavity(tmp_path/"case", "faceFlux"))
    assert rows["empty"].max() == 0
    assert rows["leastFill"].min() > 0.5 and rows["mostFill"].max() < 2


@pytest.mark.slow
def test_bounds_on_a_refined_mesh(tmp_path):
    """The slot's corners refined six times, cells of which the smallest are a
    4096th of the others: no cell is empty, and points are not many more than
    at the start."""
    case = fresh_case(tmp_path/"case", "silo")
    case.substitute(FILES["mesh"], mesh_entries(4))
    case.override("control", endTime=3e-4, writeInterval=3e-4)
    case.run("blockMesh")
    refine_scene(case, slot="type corners; levels 6; rings 2;"
                            " within (-0.6 -0.4 -1) (0.6 0.1 1);")
    rows = statistics(case)
    assert rows["empty"].max() == 0
    assert rows["points"].max() < 1.5*16*case.n_cells()
    assert rows["together"].max() == 0
    assert rows["share"].min() > 0.01 and rows["added"][-1] > 1e4
    granular = case.cloud("volume")[case.cloud("material") == 1].sum()
    assert granular == pytest.approx(2.5, rel=1e-9)
    on_mesh = case.field("alpha.granular") @ case.volumes()
    assert on_mesh == pytest.approx(granular, rel=0.002)
