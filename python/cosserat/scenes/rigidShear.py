"""A benchmark with a smooth density (Gassmoeller et al. 2019), averaged from
points: its density, and the flow that it drives."""

import numpy as np

from cosserat.analytic import RigidShear
from cosserat.scenes.box import Box, add_points

FLUID = {"eta": 1, "etaC": 0, "R": 0}


def run(path, average, points, n, steps=0):
    """Row of a run: relative L2 errors of u, p and the density, at random
    places of the points; after a time of 1, which is half a turn in the
    middle, where there are steps."""
    case = Box(path, n=n, materials={"heavy": FLUID, "light": FLUID},
               fractions=lambda x, y: 0*x, force=RigidShear.force,
               tolerance=1e-8).write()
    add_points(case, "{ type all; material heavy; }", pointsPerCell=points,
               average=average, minPointsPerCell=0,
               properties="{ density { type carried; onMesh yes; } }")
    case.substitute("system/controlDict", {
        "endTime": 1 if steps else 0, "deltaT": 1/max(steps, 1),
        "writeInterval": max(steps, 1)})
    case.run("Test-rigidShear", "-scatter")

    time = case.times()[-1] if steps else 0
    x, y = case.centres()[:, :2].T
    p = case.field("p", time)

    def err(numeric, exact):
        return float(np.sqrt(((numeric - exact)**2).sum()/(exact**2).sum()))

    return {"average": average, "pointsPerCell": points, "n": n,
            "time": float(time),
            "errU": err(case.field("U", time)[:, :2].T, RigidShear.u(x, y)),
            "errP": err(p - p.mean(), RigidShear.p(x, y)),
            "errRho": err(case.field("density", time),
                          RigidShear.density(x, y))}
