"""The shear layer over a thousand steps and a shear of fifty (the paper's
Figure 3): errors, dye bands, points per cell."""

import matplotlib.pyplot as plt

from cosserat.case import Case
from cosserat.picture import draw_points, draw_walls
from cosserat.scenes.longShear import STEPS, V, run
from studies.common import HERE, save


def study():
    """Rows: step, time, shear (total), errU, errOmega, bands, asymmetry,
    bandError, minPoints and maxPoints (a cell, seeded with 36), points (in
    all), added."""
    path = HERE/"runs/longShear/case"
    rows = run(path, [1, 10, 50, 200, 500, STEPS])
    case = Case(path)

    figure, axes = plt.subplots(1, 4, figsize=(12, 3.4), dpi=130, sharey=True)
    times = case.times()
    for axis, time in zip(axes, [times[0], times[1], times[3], times[5]]):
        draw_points(axis, case, time, [0], size=3)
        draw_walls(axis, case)
        axis.set_aspect("equal")
        axis.set_title(f"t = {float(time):.3g} s, shear {2*V*float(time):.3g}",
                       fontsize=9)
        axis.set_xlabel("x [m]")
    axes[0].set_ylabel("y [m]")
    save(figure, "longShear")
    plt.close(figure)
    return rows
