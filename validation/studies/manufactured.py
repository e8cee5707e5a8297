"""Order of convergence by a manufactured solution with viscosities that vary
smoothly, on meshes of every kind."""

import matplotlib.pyplot as plt

from cosserat.results import add_orders
from cosserat.scenes.manufactured import MESHES, run
from studies.common import HERE, cell_ticks, save

CELLS = [12, 24, 48, 96]


def study():
    """Rows: mesh, n (cells along a side), cells, errU, errOmega, errP
    (relative L2), orderU, orderOmega, orderP, iterations."""
    rows = []
    for mesh in MESHES:
        own = [run(HERE/"runs/manufactured"/f"{mesh}{n}", mesh, n)
               for n in CELLS]
        add_orders(own, "U", "Omega", "P")
        rows += own

    figure, axes = plt.subplots(1, 3, figsize=(11, 4), dpi=130)
    for axis, key, label in zip(axes, ("errU", "errOmega", "errP"),
                                ("u", r"$\omega$", "p")):
        for mesh in MESHES:
            own = [row for row in rows if row["mesh"] == mesh]
            axis.loglog(CELLS, [row[key] for row in own], "o-", ms=4,
                        label=mesh)
        top = max(row[key] for row in rows)
        axis.loglog(CELLS, [top*(CELLS[0]/n)**2 for n in CELLS], ":",
                    color="grey", label="order 2")
        cell_ticks(axis, CELLS)
        axis.set_xlabel("cells along a side")
        axis.set_ylabel(f"error of {label}, relative L2")
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize=8)
    save(figure, "manufactured")
    plt.close(figure)
    return rows
