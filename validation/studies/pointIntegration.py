"""Order of the schemes that move points: a ring of points in a rigid rotation
misses its start after one turn."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.box import Box, add_points
from studies.common import HERE, save

SCHEMES = ["Euler", "RK2", "RK4"]
STEPS = [40, 80, 160, 320, 640]
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


def study():
    """Rows: scheme, dt [s], steps a turn, error (largest distance from the
    start, over the radius of 0.25), order (from the row before; None in the
    first)."""
    runs = HERE/"runs/pointIntegration"
    # Where points start, to 1e-12 of a turn
    start, chosen = ring(runs/"start", "RK4", 1e-12, 1)

    rows = []
    for scheme in SCHEMES:
        for steps in STEPS:
            xy, _ = ring(runs/f"{scheme}-{steps}", scheme, 1, steps)
            error = np.hypot(*(xy[chosen] - start[chosen]).T).max()/0.25
            before = rows[-1] if steps != STEPS[0] else None
            rows.append({
                "scheme": scheme, "dt": 2*np.pi/steps, "steps": steps,
                "error": float(error),
                "order": float(np.log2(before["error"]/error))
                if before else None})

    figure, axis = plt.subplots(figsize=(5, 4), dpi=130)
    for scheme, order in zip(SCHEMES, (1, 2, 4)):
        own = [row for row in rows if row["scheme"] == scheme]
        dt = np.array([row["dt"] for row in own])
        axis.loglog(dt, [row["error"] for row in own], "o-", ms=4,
                    label=scheme)
        axis.loglog(dt, own[0]["error"]*(dt/dt[0])**order, ":", color="grey")
    axis.set_xlabel("dt [s], a turn takes 6.28 s")
    axis.set_ylabel("miss after a turn, over the radius")
    axis.legend(title="dotted: order 1, 2, 4", fontsize=8)
    axis.grid(alpha=0.3)
    save(figure, "pointIntegration")
    plt.close(figure)
    return rows
