"""Significance of the wall conditions that a classical continuum does not
have (the paper's Figures 6 and 7): where rotation and velocity of the walls
fit, the flow is the classical one."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.scenes.layers import PAPER, run_layer
from studies.common import HERE, save

N = 24
DECADES = np.logspace(-3, 3, 13)


def sweep(name, values, walls):
    """Errors for each value of the dimensionless parameter of that name."""
    rows = []
    for i, value in enumerate(values):
        _, _, row = run_layer(HERE/f"runs/significance/{name}{i}", PAPER, N,
                              walls(value), tolerance=1e-12)
        rows.append({"parameter": name, "value": float(value),
                     "errU": row["errU"], "errOmega": row["errOmega"]})
    return rows


def study():
    """Rows: parameter (k or j), value, errU, errOmega.

    k = -sigma/(2 eta Omega) at sigma = 1 Pa; j = mu/(V M R^2) at V = 1 m/s,
    as the paper has it (its unit is 1/(m4 Pa))."""
    k = sorted(np.concatenate([-DECADES, DECADES]))
    rows = sweep("k", k, lambda k: {
        "sigma": 1.0, "Omega": float(-1/(2*PAPER.eta*k))})
    j = np.logspace(-4, 3, 15)
    rows += sweep("j", j, lambda j: {
        "V": 1.0, "mu": float(j*PAPER.M*PAPER.R**2)})

    figure, axes = plt.subplots(1, 3, figsize=(11, 4), dpi=130, sharey=True)
    panels = (("k", -1, "k = $-\\sigma/(2\\eta\\Omega)$, negative"),
              ("k", 1, "k = $-\\sigma/(2\\eta\\Omega)$"),
              ("j", 1, "j = $\\mu/(V M R^2)$ [1/(Pa m$^4$)]"))
    for axis, (name, sign, label) in zip(axes, panels):
        own = [r for r in rows
               if r["parameter"] == name and r["value"]*sign > 0]
        x = [abs(r["value"]) for r in own]
        axis.loglog(x, [r["errU"] for r in own], "o-", ms=4, label="u")
        axis.loglog(x, [r["errOmega"] for r in own], "s-", ms=4,
                    label=r"$\omega$")
        axis.axhline(1.2e-3 if name == "k" else 2e-3, color="grey", ls="--",
                     lw=0.9, label="worst of the paper")
        axis.set_xlabel(label)
        axis.grid(alpha=0.3)
    axes[0].invert_xaxis()
    axes[0].set_ylabel("Err, equation 30, 24 cells")
    axes[1].legend()
    save(figure, "significance")
    plt.close(figure)
    return rows
