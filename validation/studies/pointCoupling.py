"""Order in time of points and flow together: a heavy layer overturns, with
the flow of the start of the step, extrapolated, or solved at mid-step."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import cpu_seconds
from cosserat.scenes.overturn import AVERAGES, COUPLINGS, END, run
from studies.common import HERE, save

STEPS = [5, 10, 20, 40, 80]

#: Steps of the run that the others are compared with, by midpoint
REFERENCE = 320


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
