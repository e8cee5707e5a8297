"""The tutorials, on the meshes that they are shipped with, against numbers
that this code did not compute (cosserat.references).

A tolerance is the difference measured and a tenth of it, 0.4 % at most; tests
show that one per cent of a modulus, the way that makes it worse, breaks it, and
that another internal length changes the number as it does the reference.
"""

import re
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Callable

import numpy as np
import pytest

from cosserat.case import Case, FILES, TUTORIALS
from cosserat.finiteElements.slump import spread
from cosserat.references import DEPTH, TUTORIALS as REFERENCES
from cosserat.scenes.silo import rate
from cosserat.finiteElements import tutorials as elements

ONE_STEP = {"endTime": 1e-8, "deltaT": 1e-8, "adjustTimeStep": "no",
            "writeControl": "timeStep", "writeInterval": 1}


def start(path, tutorial, factors):
    """The first solve of a tutorial on its own mesh, with moduli multiplied
    by factors, in all materials."""
    case = Case.copy(TUTORIALS/tutorial, path)
    case.substitute("system/controlDict", ONE_STEP)
    materials = case.path/FILES["materials"]
    for key, factor in factors.items():
        text, n = re.subn(
            rf"^(\s*{key}\s+)([-\d.e+]+);",
            lambda entry, factor=factor:
            f"{entry[1]}{float(entry[2])*factor!r};",
            materials.read_text(), flags=re.M)
        assert n, key
        materials.write_text(text)
    if (case.path/"constant/cylinders.msh").exists():
        case.run("gmshToFoam", "constant/cylinders.msh")
        case.run("foamDictionary", "constant/polyMesh/boundary", "-entry",
                 "entry0/frontAndBack/type", "-set", "empty")
    else:
        case.run("blockMesh")
    case.run("cosseratPicFoam")
    return case


def powers(case):
    """Power [W] of gravity, of the walls, and all that is dissipated."""
    row = case.table("power", "powerBalance.dat")[0]
    return row[1], row[2], row[4] + row[5]


def weight(case):
    """Power of the weight [W]."""
    return powers(case)[0]


def walls(case):
    """Power of the walls [W]."""
    return powers(case)[1]


def disc_speed(case):
    """Mean speed [m/s] of a disc of radius 0.15 m that weighs 1 N/m3."""
    return weight(case)/(DEPTH*np.pi*0.15**2)


def feed_pressure(case):
    """What is dissipated over the flow rate of 0.1 m2/s [Pa]."""
    return powers(case)[2]/(DEPTH*0.1)


def vortex(case):
    """Stream function [m2/s] of the cavity's vortex: the least value of
    int_0^y u dy in the middle between the walls, from a parabola through
    three faces."""
    x, y = case.centres()[:, :2].T
    h = 1/round(np.sqrt(len(x)))
    rows = np.round(y/h - 0.5).astype(int)
    middle = np.abs(x - 0.5) < h
    u = np.bincount(rows[middle], case.field("U")[middle, 0])/2
    psi = np.concatenate([[0], np.cumsum(u)*h])
    i = psi.argmin()
    a, b, c = np.polyfit([-1, 0, 1], psi[i - 1:i + 2], 2)
    return c - b**2/(4*a)


CLASSICAL = {"etaC": 0, "R": 0}


@dataclass
class Scene:
    """How a tutorial's number is measured, its difference from the reference
    on the mesh as shipped, and factors of the moduli: one per cent that makes
    it worse, and those of the variant."""

    measure: Callable
    difference: float
    worse: dict = None
    factors: dict = field(default_factory=dict)


#: Not to be content with: the silo, whose fill ends in a corner at the start;
#: template, schemes (stiff beside soft in few cells, half of it gone on twice
#: the cells). In template and schemes the air decides, and
#: 1 % is that of the air.
SCENES = {
    "annularCouette": Scene(walls, -1.21e-3, {"R": 0.99}),
    "eccentricCylinders": Scene(walls, -4.17e-3, {"R": 0.99}),
    "eccentricCylinders, classical": Scene(walls, -4.69e-3, {"eta": 0.99},
                                           CLASSICAL),
    "cavity": Scene(vortex, -4.50e-3),
    "cavity, classical": Scene(vortex, -7.25e-3, None, CLASSICAL),
    "template": Scene(weight, 1.60e-2, {"eta": 0.99}),
    "schemes": Scene(weight, 3.67e-2, {"eta": 0.99}),
    "columnSlump": Scene(weight, -9.92e-3, {"eta_n": 1.01}),
    "columnSlump, R 0.5": Scene(weight, -9.99e-3, {"eta_n": 1.01}, {"R": 5}),
    "dune": Scene(weight, 7.07e-3, {"eta": 0.99}),
    "dune, R 0.02": Scene(weight, -3.32e-3, {"eta": 1.01}, {"R": 0.2}),
    "sinkingInclusion": Scene(disc_speed, 4.28e-3, {"eta": 0.99}),
    "sinkingInclusion, classical": Scene(disc_speed, -1.312e-2,
                                         {"eta": 1.01}, CLASSICAL),
    "hopper": Scene(feed_pressure, -1.53e-3, {"eta": 0.99}),
    "hopper, R 0.5": Scene(feed_pressure, -7.71e-3, {"eta": 0.99}, {"R": 10}),
    "silo": Scene(rate, 3.53e-2, {"eta": 0.99}),
    "silo, classical": Scene(rate, 1.65e-2, {"eta": 0.99},
                             {"alpha": 0, "etaC": 0}),
}

#: Variant: difference of its ratio to the tutorial as shipped from the
#: reference's ratio, which is off 1 by 6 % (columnSlump) to 42 % (silo)
RATIOS = {
    "eccentricCylinders, classical": -5.3e-4,
    "cavity, classical": -2.8e-3,
    "columnSlump, R 0.5": -8.2e-5,
    "dune, R 0.02": -1.03e-2,
    "sinkingInclusion, classical": -1.73e-2,
    "hopper, R 0.5": -6.2e-3,
    "silo, classical": -1.81e-2,
}


def slack(name):
    """A tenth, but never as much as half of one per cent."""
    return min(0.1*abs(SCENES[name].difference), 4e-3)


@pytest.fixture(name="difference", scope="module")
def difference_fixture(tmp_path_factory):
    """Function that gives the relative difference of a tutorial from its
    reference, with factors of moduli."""
    @lru_cache(maxsize=None)
    def difference(name, worse=False):
        scene = SCENES[name]
        factors = {**scene.factors, **(scene.worse if worse else {})}
        case = start(tmp_path_factory.mktemp("start")/"case",
                     name.split(",")[0], factors)
        return scene.measure(case)/REFERENCES[name].value - 1
    return difference


@pytest.mark.parametrize("name", SCENES)
def test_reference(difference, name):
    """Not further from the reference than measured."""
    assert abs(difference(name)) < abs(SCENES[name].difference) + slack(name)


@pytest.mark.parametrize("name", [n for n, s in SCENES.items() if s.worse])
def test_reference_can_fail(difference, name):
    """One per cent of a modulus is seen."""
    assert abs(difference(name, True)) > (abs(SCENES[name].difference)
                                          + slack(name))


@pytest.mark.parametrize("name", RATIOS)
def test_other_internal_length(difference, name):
    """Another internal length changes the number as it does the reference:
    the ratio is off by no more than measured, and by a fraction of what the
    reference changes by."""
    shipped = name.split(",")[0]
    found = (1 + difference(name))/(1 + difference(shipped)) - 1
    assert abs(found) < 1.1*abs(RATIOS[name])
    change = REFERENCES[name].value/REFERENCES[shipped].value - 1
    assert abs(found) < 0.26*abs(change)


@pytest.mark.slow
@pytest.mark.parametrize("eta, fails", [(1, False), (0.99, True)])
def test_fall_of_the_inclusion(tutorial, eta, fails):
    """The tutorial to its end: measured 0.8 % more than the elements have; one
    per cent of the matrix' viscosity shows."""
    case = tutorial("sinkingInclusion")
    path = case.path/FILES["materials"]
    text = path.read_text()
    assert re.search(r"eta +1;", text)
    path.write_text(re.sub(r"(eta +)1;", rf"\g<1>{eta};", text))
    case.run("cosseratPicFoam")
    fall = 0.65 - case.centroid(1)[1]
    error = fall/REFERENCES["sinkingInclusion, fall"].value - 1
    print(error)
    assert (abs(error) > 1.2e-2) == fails


@pytest.mark.slow
@pytest.mark.parametrize("eta_n, fails", [("3e4", False), ("3.06e4", True)])
def test_spread_of_the_column(tutorial, eta_n, fails):
    """Volume beyond the foot after 8 s on 32 x 16 cells: -1.87 % off;
    a single point is 0.16 % of it."""
    case = tutorial("columnSlump", mesh={"nx": 32, "ny": 16},
                    materials={"eta_n": eta_n})
    case.run("cosseratPicFoam")
    beyond = case.table("spread", "materialOutflow.dat")[-1, 1]
    error = beyond/REFERENCES["columnSlump, spread"].value - 1
    print(error)
    assert (abs(error) > 1.9e-2) == fails


@pytest.mark.slow
@pytest.mark.parametrize("eta, fails", [(1000, False), (1030, True)])
def test_washout_of_the_hopper(tutorial, eta, fails):
    """Old material that is left after 10 s, where the fresh one is as viscous:
    the points, their inflow and population included, are -0.07 % off. (It
    tells of 3 % in one viscosity; 1 % is as much as points are off.)"""
    case = tutorial("hopper", control={"endTime": 10})
    path = case.path/FILES["materials"]
    text, n = re.subn(r"\b3000;", f"{eta};", path.read_text())
    assert n == 2
    path.write_text(text)
    case.run("cosseratPicFoam")
    left = case.table("old", "materialOutflow.dat")[-1, 3]
    error = left/REFERENCES["hopper, washout"].value - 1
    print(error)
    assert (abs(error) > 1e-3) == fails


@pytest.mark.slow
def test_spread_by_elements():
    """The first second on a coarse mesh (finer ones have 0.03581), and what of
    the volume is lost."""
    volume, lost = spread(0.06, 0.02, 0.1, end=1.0)
    assert volume == pytest.approx(0.03581, rel=3e-3)
    assert lost < 1e-3


@pytest.mark.parametrize("name, scene", [
    ("template", elements.block), ("columnSlump", elements.column),
    ("sinkingInclusion", elements.disc), ("cavity", elements.cavity),
    ("hopper", elements.hopper), ("dune", elements.dune)])
def test_elements_give_the_references(name, scene):
    """Coarse meshes of the finite elements, within 2e-4 of what is written
    down (the powers for a depth of 1 m)."""
    reference = REFERENCES[name]
    depth = DEPTH if reference.unit == "W" else 1
    assert depth*scene(False) == pytest.approx(reference.value, rel=2e-4)
