"""Stiff against soft (cosserat.scenes.jumps): jumps of the viscosities on cell
faces and through cells by the flow solver, by contrast, mean of the viscosities in
cut cells, and cells; against formulas, a staggered scheme and finite elements.
Rayleigh-Taylor at a ratio of 0.01 besides, whose peak is published."""

import shutil

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import RunError, cpu_seconds, residuals
from cosserat.scenes import rayleighTaylor
from cosserat.scenes.jumps import SCENES, run
from studies.common import HERE, cell_ticks, save

#: Means of the viscosity in cut cells; None leaves the choice to the solver
MEANS = [None, "arithmetic", "geometric", "harmonic"]

#: Scenes without cut cells
ON_FACES = {"discFitted", "blockOnFaces", "blockOnFaces, Cosserat",
            "blockOnWavyFaces", "blockOnTriangles", "solCx", "layers",
            "columns"}

#: Quantity that the figure shows
SHOWN = {"solCx": "v_rms", "solCxThrough": "v_rms"}

#: Ratio, and cells of its runs
OVERTURN, OVERTURN_CELLS = 0.01, (32, 64)


def solve(path, name, contrast, cells, mean):
    """Rows of one solve, a quantity each; one without where it failed."""
    head = {"scene": name, "contrast": contrast, "mean": mean or "default",
            "cells": cells}
    try:
        found, case = run(path, name, contrast, cells, mean)
    except RunError:
        print(head, "failed", flush=True)
        return [{**head, "status": "failed"}]
    return [{**head, "status": "ok", "quantity": quantity,
             "value": result.value, "reference": result.reference,
             "error": result.error, "order": None,
             "iterations": found["iterations"], "balance": found["balance"],
             "cpu": cpu_seconds(case.log())}
            for quantity, result in found["quantities"].items()]


def overturn(mean, cells):
    """Row of the peak of v_rms."""
    case, found = rayleighTaylor.run(
        HERE/f"runs/jumps/{OVERTURN}-{cells}", OVERTURN, cells, mean)
    reference = rayleighTaylor.SCENES[OVERTURN][2]
    return {"scene": "rayleighTaylor", "contrast": OVERTURN,
            "mean": mean or "default", "cells": cells, "status": "ok",
            "quantity": "vrmsMax", "value": found["vrmsMax"],
            "reference": reference,
            "error": found["vrmsMax"]/reference - 1, "order": None,
            "iterations": max(row[3] for row in residuals(case.log())),
            "balance": None, "cpu": found["cpu"]}


def add_orders(rows):
    """Add to the rows of a series the order from the row of about half the
    cells."""
    for row in rows:
        for other in rows:
            ratio = row["cells"]/other["cells"]
            if (abs(ratio - 2) < 0.1 and other["error"] and row["error"]
                    and all(row[key] == other[key] for key in (
                        "scene", "contrast", "mean", "quantity"))):
                row["order"] = float(np.log(abs(other["error"]/row["error"]))
                                     / np.log(ratio))


def draw(rows):
    """Errors against cells by scene: the default in full, other means thin."""
    figure, axes = plt.subplots(4, 4, figsize=(13, 12), dpi=130)
    for axis, (name, scene) in zip(axes.flat, SCENES.items()):
        quantity = SHOWN.get(name, "u")
        for i, contrast in enumerate(scene.contrasts):
            for mean, style in (("default", "o-"), ("arithmetic", "--"),
                                ("geometric", "-."), ("harmonic", ":")):
                chosen = sorted(
                    (row["cells"], abs(row["error"])) for row in rows
                    if (row["scene"], row["contrast"], row["mean"],
                        row.get("quantity")) == (name, contrast, mean,
                                                 quantity))
                if chosen:
                    main = mean == "default"
                    axis.loglog(*zip(*chosen), style, color=f"C{i}", ms=3,
                                lw=1.5 if main else 0.7,
                                label=f"{contrast:g}" if main else None)
        axis.set_title(f"{name}: {quantity}", fontsize=9)
        axis.set_ylim(1e-5, 2)
        cell_ticks(axis, sorted(scene.cells))
        axis.tick_params(labelsize=6)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=6)
    save(figure, "jumps")
    plt.close(figure)


def study():
    """Rows: scene, contrast, mean, cells, status (ok or failed), quantity,
    value, reference (None: value is an error), error (relative), order (from
    about half the cells), iterations, balance (of the field dissipation),
    cpu [s]."""
    path, rows = HERE/"runs/jumps/case", []
    for name, scene in SCENES.items():
        for contrast in scene.contrasts:
            for mean in MEANS[:1] if name in ON_FACES else MEANS:
                for cells in scene.cells:
                    rows += solve(path, name, contrast, cells, mean)
        print(f"{name}: {len(rows)} rows", flush=True)
    for mean in MEANS:
        rows += [overturn(mean, cells) for cells in OVERTURN_CELLS]
    add_orders([row for row in rows if row["status"] == "ok"])
    draw(rows)
    shutil.rmtree(HERE/"runs/jumps")
    return rows
