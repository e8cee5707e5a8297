"""Convergence with the mesh (the paper's Figures 4 and 5), beside ELLIPSIS3D,
the descendant of its code, measured on the same problem."""

import matplotlib.pyplot as plt

from cosserat.results import add_orders
from cosserat.scenes.layers import PAPER, WALLS, run_layer
from studies.common import HERE, LABELS, cell_ticks, save

CELLS = [6, 12, 24, 48, 96]

#: Err of equation 30 of ELLIPSIS3D: case: (u on CELLS, omega on CELLS)
ELLIPSIS = {
    "OmegaV": ([2.27e-3, 6.81e-4, 1.85e-4, 4.82e-5, 1.23e-5],
               [2.71e-2, 6.79e-3, 1.70e-3, 4.25e-4, 1.06e-4]),
    "OmegaSigma": ([2.16e-3, 4.26e-4, 1.02e-4, 2.48e-5, 6.12e-6],
                   [2.48e-2, 6.20e-3, 1.55e-3, 3.88e-4, 9.69e-5]),
    "muV": ([2.51e-4, 7.63e-5, 2.08e-5, 5.43e-6, 1.38e-6],
            [2.50e-3, 6.50e-4, 1.66e-4, 4.19e-5, 1.05e-5]),
    "muSigma": ([5.55e-4, 1.68e-4, 4.58e-5, 1.19e-5, 3.06e-6],
                [6.04e-3, 1.56e-3, 3.96e-4, 9.97e-5, 2.50e-5]),
}


def draw(rows):
    """Errors of u and omega against the number of cells."""
    figure, axes = plt.subplots(1, 2, figsize=(9, 4.4), dpi=130)
    for axis, key, column, label in zip(
            axes, ("errU", "errOmega"), (0, 1), ("u", r"$\omega$")):
        for i, case in enumerate([*WALLS, "gravity"]):
            own = [row for row in rows if row["case"] == case]
            axis.loglog([row["n"] for row in own], [row[key] for row in own],
                        "o-", ms=4, color=f"C{i}", label=LABELS[case])
            if case in ELLIPSIS:
                axis.loglog(CELLS, ELLIPSIS[case][column], "--", lw=0.9,
                            color=f"C{i}")
        axis.plot([], [], "--", color="grey", label="ELLIPSIS3D")
        cell_ticks(axis, CELLS)
        axis.set_xlabel("cells across the layer")
        axis.set_ylabel(f"Err({label}), equation 30")
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize=8)
    save(figure, "convergence")
    plt.close(figure)


def study():
    """Rows: case, n, errU, errOmega, orderU, orderOmega, iterations, cpu;
    for the shear layer also ellipsisU and ellipsisOmega."""
    rows = []
    for case in [*WALLS, "gravity"]:
        own = []
        for i, n in enumerate(CELLS):
            _, _, row = run_layer(HERE/f"runs/convergence/{case}{n}", PAPER, n,
                                  WALLS.get(case), None if case in WALLS
                                  else 1, tolerance=1e-11)
            own.append({"case": case, "n": n, **row})
            if case in ELLIPSIS:
                own[-1]["ellipsisU"] = ELLIPSIS[case][0][i]
                own[-1]["ellipsisOmega"] = ELLIPSIS[case][1][i]
        add_orders(own, "U", "Omega")
        rows += own
    draw(rows)
    return rows
