"""Averages of the points on a benchmark with a smooth density (Gassmoeller et
al. 2019): its density, and the flow that it drives."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.results import add_orders
from cosserat.scenes.rigidShear import run
from studies.common import HERE, cell_ticks, save

CELLS = [8, 16, 32, 64]
POINTS = [4, 16, 36, 100]
AVERAGES = ["cellMean", "linearLeastSquares"]


def draw(rows):
    """Density and velocity against the cells, at the start."""
    figure, axes = plt.subplots(1, 2, figsize=(9, 4), dpi=130)
    colours = dict(zip(POINTS, plt.cm.viridis(np.linspace(0, 0.85, 4))))
    for axis, key, label in ((axes[0], "errRho", "density"),
                             (axes[1], "errU", "u")):
        for average, line in zip(AVERAGES, ("o--", "s-")):
            for points in POINTS:
                own = [row for row in rows if row["time"] == 0
                       and row["average"] == average
                       and row["pointsPerCell"] == points]
                axis.loglog(CELLS, [row[key] for row in own], line, ms=4,
                            color=colours[points],
                            label=f"{average}, {points} a cell")
        top = max(row[key] for row in rows)
        for order in (1, 2):
            axis.loglog(CELLS, [1.6*top*(CELLS[0]/n)**order for n in CELLS],
                        ":", color="grey", lw=order, label=f"order {order}")
        cell_ticks(axis, CELLS)
        axis.set_xlabel("cells along a side")
        axis.set_ylabel(f"error of {label}, relative L2")
        axis.grid(alpha=0.3)
    axes[1].legend(fontsize=7, loc="lower left")
    save(figure, "rigidShear")
    plt.close(figure)


def study():
    """Rows: average, pointsPerCell, n (cells along a side), time, errU, errP,
    errRho (relative L2), orderU, orderP, orderRho. At time 0 and, with 16
    points a cell and a Courant number of 1/2, at time 1."""
    rows = []
    for average in AVERAGES:
        for points in POINTS:
            own = [run(HERE/"runs/rigidShear"/f"{average}{points}-{n}",
                       average, points, n) for n in CELLS]
            add_orders(own, "U", "P", "Rho")
            rows += own
        own = [run(HERE/"runs/rigidShear"/f"{average}-moved-{n}", average, 16,
                   n, steps=2*n) for n in CELLS]
        add_orders(own, "U", "P", "Rho")
        rows += own
    draw(rows)
    return rows
