"""The tutorials, on the meshes that they are shipped with, against numbers
that this code did not compute (cosserat.tutorialReferences).

A tolerance is the difference measured, rounded up by a tenth; each test shows
that one per cent of a modulus, the way that makes it worse, breaks it.
"""

from dataclasses import dataclass, field
from typing import Callable

import numpy as np
import pytest

from cosserat.case import Case, TUTORIALS
from cosserat.tutorialReferences import DEPTH, REFERENCES

ONE_STEP = {"endTime": 1e-8, "deltaT": 1e-8, "adjustTimeStep": "no",
            "writeControl": "timeStep", "writeInterval": 1}


def start(path, tutorial, materials, points=True):
    """The first solve of a tutorial on its own mesh."""
    case = Case.copy(TUTORIALS/tutorial, path)
    case.substitute("system/controlDict", ONE_STEP)
    case.substitute("constant/materialProperties", materials)
    if not points:
        (case.path/"constant/materialPointsProperties").unlink()
    if (case.path/"constant/cylinders.msh").exists():
        case.run("gmshToFoam", "constant/cylinders.msh")
        case.run("foamDictionary", "constant/polyMesh/boundary", "-entry",
                 "entry0/frontAndBack/type", "-set", "empty")
    else:
        case.run("blockMesh")
    case.run("cosseratPicFoam")
    return case


def power_of_the_walls(path, tutorial, materials):
    """Power [W] that the walls supply."""
    case = start(path, tutorial, materials, points=False)
    return case.table("power", "powerBalance.dat")[0, 2]


def vortex(path, tutorial, materials):
    """Stream function [m2/s] of the cavity's vortex: the least value of
    -int_y^1 u dy in the middle between the walls, from a parabola through
    three faces."""
    case = start(path, tutorial, materials, points=False)
    x, y = case.centres()[:, :2].T
    h = 1/round(np.sqrt(len(x)))
    rows = np.round(y/h - 0.5).astype(int)
    middle = np.abs(x - 0.5) < h
    u = np.bincount(rows[middle], case.field("U")[middle, 0])/2
    psi = np.concatenate([[0], np.cumsum(u)*h])
    i = psi.argmin()
    a, b, c = np.polyfit([-1, 0, 1], psi[i - 1:i + 2], 2)
    return c - b**2/(4*a)


@dataclass
class Scene:
    """How a tutorial's number is measured, its relative difference from the
    reference, and what makes it worse."""

    measure: Callable
    difference: float
    worse: dict
    materials: dict = field(default_factory=dict)


SCENES = {
    "annularCouette": Scene(power_of_the_walls, -1.21e-3, {"R": 0.198}),
    "eccentricCylinders": Scene(power_of_the_walls, -4.2e-3, {"R": 0.198}),
    "eccentricCylinders, classical": Scene(
        power_of_the_walls, -4.7e-3, {"eta": 990}, {"etaC": 0, "R": 0}),
}


def difference(path, name, **materials):
    """Of the tutorial from its reference, relative."""
    found = SCENES[name].measure(path, name.split(",")[0],
                                 {**SCENES[name].materials, **materials})
    return found/REFERENCES[name].value - 1


@pytest.mark.parametrize("name", SCENES)
def test_reference(tmp_path, name):
    """Not further from the reference than measured."""
    assert abs(difference(tmp_path/"case", name)) < 1.1*abs(
        SCENES[name].difference)


@pytest.mark.parametrize("name", SCENES)
def test_reference_can_fail(tmp_path, name):
    """One per cent of a modulus is seen."""
    assert abs(difference(tmp_path/"case", name, **SCENES[name].worse)
               ) > 1.1*abs(SCENES[name].difference)
