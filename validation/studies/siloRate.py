"""The silo at rest: its rate of discharge against references by finite
elements, with and without what is done about re-entrant corners."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import cpu_seconds, residuals
from cosserat.references import SILO, SILO_SCENES
from cosserat.scenes.silo import prepare, rate
from studies.common import cell_ticks, new_case, save

MESHES = [4, 8, 16, 32]


def run(name, cells, corners):
    """One solve: its row."""
    scene, reference = SILO_SCENES[name], SILO[name]
    target = f"{name.replace('/', '_').replace(', ', '-').replace(' ', '_')}"
    case = prepare(
        new_case("siloRate", f"{target}-{cells}-{corners}", "silo"),
        scene, cells, corners=corners)
    case.run("cosseratPicFoam")
    Q = rate(case, scene.aperture)
    return {
        "scene": name, "alpha": scene.alpha, "cells": cells,
        "model": "on" if corners else "off",
        "Q": Q, "reference": reference.value,
        "uncertainty": reference.uncertainty, "error": Q/reference.value - 1,
        "vMax": float(np.hypot(*case.field("U")[:, :2].T).max()),
        "iterations": residuals(case.log())[0][3],
        "cpu": cpu_seconds(case.log()),
    }


def draw(rows):
    """Errors against cells, with and without."""
    figure, axes = plt.subplots(4, 5, figsize=(13, 9.4), dpi=100, sharex=True,
                                sharey=True)
    for axis, name in zip(axes.ravel(), SILO_SCENES):
        for model, style in (("off", "C7s--"), ("on", "C0o-")):
            chosen = [row for row in rows
                      if row["scene"] == name and row["model"] == model]
            axis.plot([row["cells"] for row in chosen],
                      [100*row["error"] for row in chosen], style,
                      label=f"corners {'automatic' if model == 'on' else model}")
        axis.axhline(0, color="k", lw=0.7)
        axis.set_xscale("log")
        cell_ticks(axis, MESHES)
        axis.set_title(name, fontsize=10)
        axis.grid(alpha=0.3)
    axes[0, 0].legend(fontsize=8)
    axes[0, 0].set_ylim(-20, 60)
    for axis in axes[:, 0]:
        axis.set_ylabel("error of the rate [%]")
    for axis in axes[-1]:
        axis.set_xlabel("cells an aperture")
    for axis in axes.ravel()[len(SILO_SCENES):]:
        axis.set_visible(False)
    save(figure, "siloRate")
    plt.close(figure)


def study():
    """Rows: scene, alpha, cells (per aperture), model (corners on or off), Q
    [m2/s] by the face fluxes, reference, uncertainty (of it), error
    (relative), vMax [m/s], iterations, cpu [s]."""
    rows = [run(name, cells, corners) for name in SILO_SCENES for cells in MESHES
            for corners in (True, False)]
    for row in rows:
        print(row, flush=True)
    draw(rows)
    return rows
