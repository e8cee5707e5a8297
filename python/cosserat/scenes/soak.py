"""Scenes of many steps, and the books of their points.

A hopper with inflow and outflow, whose grains are replaced again and again,
and a driven cavity of two materials; in both the population is kept in narrow
limits, so that points are added and deleted."""

import shutil

import numpy as np

from cosserat.case import fresh_case
from cosserat.scenes.box import STILL, Box, add_points, count

#: Points of a cell at the start
SEEDED = 16

LIMITS = {"minPointsPerCell": 8, "maxPointsPerCell": 20}


def hopper(path, steps):
    """The tutorial's hopper on 8 x 12 cells, at a Courant number of 1/2."""
    case = fresh_case(path, "hopper")
    case.substitute("system/blockMeshDict", {
        "nx": 8, "nSpout": 2, "nCone": 6, "nBin": 4})
    case.override("points", **LIMITS)
    count(case)
    control(case, steps, 0.1)
    case.run("blockMesh")
    return case


def cavity(path, steps):
    """A driven cavity on 10 x 10 cells, a second material below, with
    velocities that gather points."""
    shutil.rmtree(path, ignore_errors=True)
    case = Box(path, n=10, tolerance=1e-6, materials={
        "a": {"eta": 1, "etaC": 0, "R": 0}, "b": {"eta": 3, "etaC": 1, "R": 0.1},
        }, fractions=lambda x, y: 0*x, walls={
            "left": STILL, "right": STILL, "bottom": STILL,
            "top": ("type fixedValue; value uniform (1 0 0);",
                    "type zeroGradient;")}).write()
    add_points(case, "{ type all; material a; }"
               " { type box; material b; min (-1 -1 -1); max (1 0.1 1); }",
               velocity="cellPoint", **LIMITS)
    control(case, steps, 0.05)
    return case


SCENES = {"hopper": hopper, "cavity": cavity}


def control(case, steps, deltaT):
    """Steps of one length; all digits in the table."""
    case.override("control", adjustTimeStep="no", writeControl="timeStep",
                  writeInterval=steps, writePrecision=17, deltaT=deltaT,
                  endTime=repr(steps*deltaT))


def accounts(case):
    """The books of every step against those of the seeding: the last ones,
    largest error of the number of points, and of the volume over that of the
    mesh, which is full."""
    table = case.table("points", "pointStatistics.dat")
    inside = table[:, 1]
    volume, n_in, v_in, added, deleted, n_out, v_out = table[:, 7:14].T
    start = SEEDED*case.n_cells()
    full = case.volumes().sum()
    return {
        "steps": len(inside), "points": int(inside[-1]), "in": int(n_in[-1]),
        "added": int(added[-1]), "deleted": int(deleted[-1]),
        "out": int(n_out[-1]),
        "errPoints": int(np.abs(
            start + n_in + added - deleted - n_out - inside).max()),
        "errVolume": float(np.abs(full + v_in - v_out - volume).max()/full),
    }
