"""Order in time of points and flow together: a heavy layer overturns, with
the flow of the start of the step, extrapolated, or solved at mid-step."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.box import Box, add_points
from studies.common import HERE, cpu_seconds, save

COUPLINGS = ["frozen", "extrapolated", "midpoint"]

AVERAGES = ["linearLeastSquares", "cellMean"]

STEPS = [5, 10, 20, 40, 80]

#: Steps of the run that the others are compared with, by midpoint
REFERENCE = 320

#: Cells a side and end [s], by which points have moved by up to a fifth
N, END = 32, 30.0


def run(path, coupling, steps, n=N, average=AVERAGES[0]):
    """Positions by id, and the log."""
    fluid = {"eta": 1, "etaC": 0, "R": 0}
    case = Box(path, n=n, g=(0, -1, 0), tolerance=1e-9,
               materials={"heavy": {**fluid, "rho": 1}, "light": fluid},
               fractions=lambda x, y: 0*x).write()
    add_points(case, "{ type all; material heavy; }"
               " { type belowInterface; material light; along (1 0 0);"
               " up (0 1 0); height polynomial ((0.1 0) (0.3 1)); }",
               coupling=coupling, average=average, minPointsPerCell=0)
    case.substitute("system/controlDict", {
        "endTime": END, "deltaT": END/steps, "writeInterval": steps})
    case.run("cosseratPicFoam")
    xy = case.cloud("positions")[np.argsort(case.cloud("origId")), :2]
    return xy, case.log()


def study():
    """Rows: average, coupling, steps, dt [s], error (rms distance of all
    points from where the reference of the same average has them [m], box of
    1 m), order (from the row before; None in the first), cpu [s]."""
    runs = HERE/"runs/pointCoupling"
    rows = []
    for average in AVERAGES:
        reference, _ = run(runs/f"{average}-reference", "midpoint", REFERENCE,
                           average=average)
        for coupling in COUPLINGS:
            for steps in STEPS:
                xy, log = run(runs/f"{average}-{coupling}-{steps}", coupling,
                              steps, average=average)
                error = np.sqrt(((xy - reference)**2).sum(axis=1).mean())
                before = rows[-1] if steps != STEPS[0] else None
                rows.append({
                    "average": average, "coupling": coupling, "steps": steps,
                    "dt": END/steps, "error": float(error),
                    "order": float(np.log2(before["error"]/error))
                    if before else None, "cpu": cpu_seconds(log)})

    figure, axes = plt.subplots(1, 2, figsize=(9, 4), dpi=130)
    for average, line in zip(AVERAGES, ("o-", "x--")):
        for coupling, colour in zip(COUPLINGS, ("C0", "C1", "C2")):
            own = [row for row in rows if row["coupling"] == coupling
                   and row["average"] == average]
            for axis, key in zip(axes, ("dt", "cpu")):
                axis.loglog([row[key] for row in own],
                            [row["error"] for row in own], line, ms=4,
                            color=colour, lw=1, label=f"{coupling}, {average}")
    dt = np.array([row["dt"] for row in own])
    for order, first in ((1, rows[0]), (2, rows[len(STEPS)])):
        axes[0].loglog(dt, first["error"]*(dt/dt[0])**order, ":",
                       color="grey", label=f"order {order}")
    axes[0].set_xlabel("dt [s]")
    axes[1].set_xlabel("processor time [s]")
    axes[0].set_ylabel("rms distance of the points [m]")
    axes[0].legend(fontsize=6)
    for axis in axes:
        axis.grid(alpha=0.3)
    save(figure, "pointCoupling")
    plt.close(figure)
    return rows
