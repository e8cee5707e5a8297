"""A ring of points in a rigid rotation."""

import numpy as np

from cosserat.scenes.box import Box, add_points

SIDES = ("left", "right", "bottom", "top")


def ring(path, scheme, turn, steps, velocity="conservativeLinear",
         **parameters):
    """Positions of points by their ids after part of a turn, and ids of those
    that start on a ring of radius 0.2 to 0.3 in the box of side 1."""
    case = Box(path, n=8, materials={"a": {"eta": 1, "etaC": 0, "R": 0}},
               walls={side: ("exact", "exact") for side in SIDES},
               U=lambda x, y: (-y, x), omega=lambda x, y: 1 + 0*x,
               **parameters).write()
    add_points(case, "{ type all; material a; }", integration=scheme,
               velocity=velocity, minPointsPerCell=0)
    end = 2*np.pi*turn
    case.substitute("system/controlDict", {
        "endTime": repr(end), "deltaT": repr(end/steps),
        "writeInterval": steps})
    case.run("cosseratPicFoam")
    ids = case.cloud("origId").astype(int)
    # By the corners of the box points leave, and others come in
    xy = np.full((ids.max() + 1, 2), np.nan)
    xy[ids] = case.cloud("positions")[:, :2]
    r = np.hypot(*xy.T)
    return xy, np.flatnonzero((r > 0.2) & (r < 0.3))
