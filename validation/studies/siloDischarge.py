"""Discharge of the silo (the paper's Figures 9 and 11): internal lengths alpha
of 0, 1/3, 2/3, 5/3, 10/3 apertures on three meshes, and the average of the
viscosity in cut cells."""

import shutil

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import FILES, cpu_seconds, residuals
from cosserat.picture import outflow, snapshots
from cosserat.scenes.silo import (ALPHAS, REST, VOLUME, mesh_entries, rate,
                                  refine)
from studies.common import RESULTS, new_case, save

#: Cells a unit length, and a mesh with smallest cells of 1/32 in the corners,
#: with 9 points a cell and steps at a Courant number of 1
MESHES = [4, 8, 16]
REFINED = 32

TIMES = [REST, 4.75e-4, 1.425e-3, 2.85e-3, 3.8e-3]


def initial_rate(case):
    """Volume that leaves through the aperture in a time, at rest [m2/s]."""
    case.substitute("system/controlDict", {
        "endTime": REST, "deltaT": REST, "adjustTimeStep": "no",
        "writeControl": "timeStep", "writeInterval": 1})
    case.run("cosseratPicFoam")
    return rate(case)


def run(name, alpha, cells, average):
    """One discharge: its case and row."""
    def scene(target):
        case = new_case("siloDischarge", target, "silo")
        if cells == REFINED:
            refine(case)
            case.substitute(FILES["control"], {"maxCo": 1})
            case.substitute(FILES["points"], {"pointsPerCell": 9})
        else:
            case.substitute(FILES["mesh"], mesh_entries(cells))
        case.substitute("constant/materialProperties", {
            "alpha": repr(alpha), "viscosityAverage": average})
        case.run("blockMesh")
        return case

    target = f"{name.replace('/', '_')}-{cells}-{average}"
    rest = scene(f"{target}-rest")
    initial = initial_rate(rest)
    case = scene(target)
    case.run("cosseratPicFoam")
    # The picture at rest
    shutil.copytree(rest.path/rest.times()[0], case.path/rest.times()[0])

    log, rows = case.log(), outflow(case)
    half = np.flatnonzero(rows[:, 1] >= VOLUME/2)
    return case, {
        "alpha": alpha, "cells": cells, "cell": 1/cells,
        "viscosityAverage": average,
        "initialRate": initial,
        "outflow": float(rows[-1, 1]),
        "timeToHalf": float(np.interp(VOLUME/2, *rows[half[0] - 1:half[0] + 1,
                                                      [1, 0]].T))
        if half.size else None,
        "volumeDrift": float(np.abs(rows[:, 4]/VOLUME - 1).max()),
        "steps": len(rows) - 1,
        "maxIterations": max(row[3] for row in residuals(log)),
        "cpu": cpu_seconds(log),
    }


def draw(cases, names):
    """Volume against time by alpha, all meshes; and by average."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.2), dpi=130, sharey=True)
    for (name, cells, average), case in cases.items():
        rows = outflow(case)
        style = {"lw": 1.4*cells/MESHES[-1] + 0.3}
        if average == "arithmetic":
            axes[0].plot(
                rows[:, 0]*1e3, rows[:, 1], color=f"C{names.index(name)}",
                label=rf"$\alpha$ = {name}" if cells == MESHES[-1] else None,
                **style)
        if name == "2/3":
            i = ["arithmetic", "geometric", "harmonic"].index(average)
            axes[1].plot(
                rows[:, 0]*1e3, rows[:, 1], color=f"C{i}",
                label=f"{average} mean" if cells == MESHES[0] else None,
                **style)
    for axis, title in zip(axes, (
            "internal length, arithmetic mean", r"mean, $\alpha$ = 2/3")):
        axis.axhline(VOLUME, color="grey", lw=0.8, ls=":")
        axis.set_title(title, fontsize=10)
        axis.set_xlabel("time [ms]")
        axis.set_xlim(0, 3.8)
        axis.set_ylim(0, 26)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    axes[0].set_ylabel("volume that has left the fill [m$^2$]")
    save(figure, "siloDischarge")
    plt.close(figure)


def study():
    """Rows: alpha, cells (a unit; 32: refined into the corners), cell (width),
    viscosityAverage, initialRate [m2/s], outflow [m2] at the end, timeToHalf
    [s], volumeDrift (largest, relative, of the volume on the mesh), steps,
    maxIterations, cpu."""
    wanted = [(name, cells, "arithmetic") for cells in MESHES
              for name in ALPHAS]
    wanted += [("2/3", 4, average) for average in ("geometric", "harmonic")]
    cases, rows = {}, []
    wanted += [(name, REFINED, "arithmetic") for name in ALPHAS]
    for name, cells, average in wanted:
        case, row = run(name, ALPHAS[name], cells, average)
        if cells != REFINED:
            cases[name, cells, average] = case
        rows.append(row)
        print(row, flush=True)

    draw(cases, list(ALPHAS))
    for name in ("0", "2/3"):
        case = cases[name, 8, "arithmetic"]
        times = [t for t in case.times()
                 if min(abs(float(t)/shown - 1) for shown in TIMES) < 1e-3]
        snapshots(case, times, [1],
                  RESULTS/f"siloDischarge-{name.replace('/', '_')}.png")
    return rows
