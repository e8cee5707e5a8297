"""Wall velocity against the internal length (the paper's Figure 8): no
rotation at the walls, given stress, eta = etaC."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.analytic import Material, wall_velocity_no_rotation
from cosserat.scenes.layers import run_layer
from studies.common import HERE, save

N = 96


def grading(R):
    """blockMesh grading in y by which a cell at the wall is at most a fifth
    of the boundary layer delta = R."""
    half = N//2
    ratio = 1.0
    while True:
        # Geometric cells of half the layer, smallest at the wall
        step = ratio**(1/(half - 1))
        first = 0.5/sum(step**i for i in range(half))
        if first <= R/5 or ratio > 1e5:
            return f"((0.5 0.5 {ratio!r}) (0.5 0.5 {1/ratio!r}))", first
        ratio *= 1.5


def study():
    """Rows: R (h = 1), u (at the wall), exact, error (relative), wallCell."""
    rows = []
    for i, R in enumerate(np.logspace(-3, 2, 21)):
        text, first = grading(R)
        case, _, row = run_layer(
            HERE/f"runs/internalLength/R{i}", Material(1.0, 1.0, float(R)), N,
            {"sigma": 1.0, "Omega": 0.0}, tolerance=1e-10, grading=text)
        u = float(case.patch_field("U", "top")[:, 0].mean()
                  - case.patch_field("U", "bottom")[:, 0].mean())/2
        exact = float(wall_velocity_no_rotation(Material(1, 1, R), 1, 1.0))
        rows.append({"R": float(R), "u": u, "exact": exact,
                     "error": abs(u/exact - 1), "wallCell": float(first),
                     "iterations": row["iterations"]})

    figure, axes = plt.subplots(figsize=(6, 4), dpi=130)
    line = np.logspace(-3, 2, 300)
    axes.semilogx(line, 0.5*(1 - line*np.tanh(0.5/line)), color="black", lw=1,
                  label="equation 31")
    axes.semilogx([r["R"] for r in rows], [r["u"] for r in rows], "o", ms=4,
                  color="#b5651d", label="computed")
    axes.axhline(0.5, color="grey", ls=":", lw=0.9)
    axes.axhline(0.25, color="grey", ls=":", lw=0.9)
    axes.set_xlabel("R/h")
    axes.set_ylabel(r"u(h/2) $\eta/(\sigma h)$")
    axes.grid(alpha=0.3)
    axes.legend()
    save(figure, "internalLength")
    plt.close(figure)
    return rows
