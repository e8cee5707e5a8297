"""Effectivity of the function object errorEstimate: estimated error over true
error, where the true one is known or by finite elements."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.scenes.estimate import (add_order, annulus, jump, layer,
                                      manufactured, without_exact)
from studies.common import HERE, save

CELLS = [12, 24, 48, 96]

RUNS = HERE/"runs/errorEstimate"

#: Scene: label of the figure
SCENES = {
    "layer0.3": "layer, R/h 0.3", "layer0.05": "layer, R/h 0.05",
    "channel": "channel", "annularCouette": "annular Couette",
    "uniform": "manufactured, uniform", "wavy": "manufactured, wavy",
    "sector": "manufactured, sector", "jump": "jump along faces, 1000:1",
    "inclusion": "inclusion", "silo": "silo",
    "rayleighTaylor": "Rayleigh-Taylor"}


def draw(rows):
    """Estimated against true error, and effectivity against cells."""
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.6), dpi=130)
    for axis, key, label in zip(axes, ("U", "Omega"), ("U", r"$\omega$")):
        every = [r[f"error{key}"] for r in rows if r[f"error{key}"]]
        span = np.array([min(every)/2, max(every)*2])
        axis.fill_between(span, span/2, 2*span, color="0.92",
                          label="effectivity 0.5 to 2")
        axis.loglog(span, span, ":", color="grey")
        for i, (scene, name) in enumerate(SCENES.items()):
            own = [r for r in rows
                   if r["scene"] == scene and r[f"error{key}"]]
            axis.loglog([r[f"error{key}"] for r in own],
                        [r[f"estimate{key}"] for r in own],
                        "o-" if i < 7 else "s--", ms=4, lw=0.9, label=name)
        axis.set_xlabel(f"true error of {label}, equation 30")
        axis.set_ylabel(f"estimated error of {label}")
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize=7)
    save(figure, "errorEstimate")
    plt.close(figure)


def study():
    """Rows: scene, n (cells across or a side; a unit of the silo), cells,
    errorU, errorOmega, estimateU, estimateOmega (equation 30),
    effectivityU, effectivityOmega, takenOrderU, takenOrderOmega,
    measuredOrderU, measuredOrderOmega (by the estimate), differenceU,
    differenceOmega (to half the cells), orderErrorU, orderErrorOmega,
    orderEstimateU, orderEstimateOmega (from the row before), worstU (place);
    None where a scene has no microrotation."""
    rows = []
    for scene in ("layer0.3", "layer0.05", "channel"):
        rows += add_order([
            layer(RUNS/scene, scene, n) for n in CELLS])
    rows += add_order([annulus(RUNS/"annularCouette", n) for n in (8, 16, 32, 64)])
    for mesh in ("uniform", "wavy", "sector"):
        rows += add_order([
            manufactured(RUNS/f"{mesh}{n}", mesh, n) for n in CELLS])
    rows += add_order([jump(RUNS/f"jump{n}", n) for n in (16, 32, 64)])
    for scene, cells in (("inclusion", (16, 32, 64)), ("silo", (2, 4, 8)),
                         ("rayleighTaylor", (16, 32, 64))):
        rows += add_order([without_exact(RUNS/f"{scene}{n}", scene, n)
                           for n in cells])
    draw(rows)
    for r in rows:
        print(r["scene"], r["n"], *(
            f"{r[key]:.3g}" if r[key] else "-" for key in (
                "errorU", "errorOmega", "effectivityU", "effectivityOmega",
                "measuredOrderU", "measuredOrderOmega", "orderErrorU",
                "orderEstimateU", "orderErrorOmega", "orderEstimateOmega")))
    return rows
