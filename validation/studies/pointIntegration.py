"""Order of the schemes that move points: a ring of points in a rigid rotation
misses its start after one turn."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.scenes.ring import ring
from studies.common import HERE, save

SCHEMES = ["Euler", "RK2", "RK4"]
STEPS = [40, 80, 160, 320, 640]


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
