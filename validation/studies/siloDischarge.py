"""Discharge of the silo (the paper's Figures 9 and 11): internal lengths alpha
of 0, 1/3, 2/3, 5/3, 10/3 apertures on three meshes, and the average of the
viscosity in cut cells."""

import shutil

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import FILES, cpu_seconds, residuals
from cosserat.picture import outflow, snapshots
from cosserat.scenes.silo import (ALPHAS, REST, VOLUME, halve, mesh_entries,
                                  rate, refine)
from studies.common import RESULTS, new_case, save

#: Cells a unit length, and a mesh with smallest cells of 1/32 in the corners,
#: with 9 points a cell and steps at a Courant number of 1
MESHES = [4, 8, 16]
REFINED = 32

TIMES = [REST, 4.75e-4, 1.425e-3, 2.85e-3, 3.8e-3]

#: When the jet of the whole silo has folded for the first time, and gravity
#: across the silo [m/s2] by which it folds alike on all meshes
FOLDED = 8e-4
TILT = 0.1

#: Half of the silo behind a mirror, all of it, all of it tilted until FOLDED
SHAPES = ["half", "whole", "tilted"]

#: Of the discharges by mesh: 4 cells would leave two from corner to mirror,
#: fewer than what is done about corners reaches over
MESH_SHAPES = {cells: "half" if cells > 4 else "whole"
               for cells in [*MESHES, REFINED]}


def initial_rate(case):
    """Volume that leaves through the aperture in a time, at rest [m2/s]."""
    case.substitute("system/controlDict", {
        "endTime": REST, "deltaT": REST, "adjustTimeStep": "no",
        "writeControl": "timeStep", "writeInterval": 1})
    case.run("cosseratPicFoam")
    return rate(case)


def scene(target, alpha, cells, average, shape):
    """A case of one discharge, meshed."""
    case = new_case("siloDischarge", target, "silo")
    if cells != REFINED:
        case.substitute(FILES["mesh"], mesh_entries(cells))
    if shape == "half":
        halve(case)
    if cells == REFINED:
        refine(case, shape == "half")
        case.substitute(FILES["control"], {"maxCo": 1})
        case.substitute(FILES["points"], {"pointsPerCell": 9})
    if shape == "tilted":
        case.substitute("constant/g", {"value": f"({TILT} -10 0)"})
        case.substitute(FILES["control"], {"endTime": FOLDED})
    case.substitute("constant/materialProperties", {
        "alpha": repr(alpha), "viscosityAverage": average})
    case.run("blockMesh")
    return case


def discharged(case, shape):
    """Rows of the outflow; of a half as of the whole."""
    rows = outflow(case)
    if shape == "half":
        rows[:, 1:] *= 2
    return rows


def run(name, cells, average, shape):
    """One discharge: its case and row."""
    target = f"{name.replace('/', '_')}-{cells}-{average}-{shape}"
    asked = ALPHAS[name], cells, average
    rest = scene(f"{target}-rest", *asked,
                 "whole" if shape == "half" else shape)
    initial = initial_rate(rest)
    case = scene(target, *asked, shape)
    case.run("cosseratPicFoam")
    if shape != "half":
        # The picture at rest
        shutil.copytree(rest.path/rest.times()[0], case.path/rest.times()[0])

    log, rows = case.log(), discharged(case, shape)
    half = np.flatnonzero(rows[:, 1] >= VOLUME/2)
    load = case.table("load", "wallLoad.dat")
    return case, {
        "alpha": ALPHAS[name], "cells": cells, "cell": 1/cells,
        "viscosityAverage": average, "shape": shape,
        "initialRate": initial,
        "folded": float(np.interp(FOLDED, rows[:, 0], rows[:, 1])),
        "outflow": float(rows[-1, 1]),
        "timeToHalf": float(np.interp(VOLUME/2, *rows[half[0] - 1:half[0] + 1,
                                                      [1, 0]].T))
        if half.size else None,
        # Forces of the weight about the middle
        "sideways": float(np.abs(load[:, 10]/load[:, 2]).max())
        if shape == "whole" else None,
        "volumeDrift": float(np.abs(rows[:, 4]/VOLUME - 1).max()),
        "steps": len(rows) - 1,
        "maxIterations": max(row[3] for row in residuals(log)),
        "cpu": cpu_seconds(log),
    }


def draw(cases, names):
    """Volume against time by alpha, all meshes; and by average."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.2), dpi=130, sharey=True)
    for (name, cells, average), case in cases.items():
        rows = discharged(case, MESH_SHAPES[cells])
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
    viscosityAverage, shape (of SHAPES), initialRate [m2/s], folded and outflow
    (volume [m2] out at the time FOLDED and at the end), timeToHalf [s],
    sideways (of shape whole: largest distance of the centre of the fill from
    the middle [m]), volumeDrift (largest, relative, of the volume on the
    mesh), steps, maxIterations, cpu. Volumes and rates are of the whole
    silo."""
    wanted = [(name, cells, "arithmetic", shape)
              for cells, shape in MESH_SHAPES.items() for name in ALPHAS]
    wanted += [("2/3", 4, average, MESH_SHAPES[4])
               for average in ("geometric", "harmonic")]
    wanted += [(name, cells, "arithmetic", "whole")
               for cells in (8, REFINED) for name in ("0", "2/3")]
    wanted += [("0", 16, "arithmetic", "whole")]
    wanted += [("0", cells, "arithmetic", "tilted")
               for cells in (8, 16, REFINED)]
    drawn, wholes, rows = {}, {}, []
    for name, cells, average, shape in wanted:
        case, row = run(name, cells, average, shape)
        if cells != REFINED and shape == MESH_SHAPES[cells]:
            drawn[name, cells, average] = case
        if cells == 8 and shape == "whole":
            wholes[name] = case
        rows.append(row)
        print(row, flush=True)

    draw(drawn, list(ALPHAS))
    for name, case in wholes.items():
        times = [t for t in case.times()
                 if min(abs(float(t)/shown - 1) for shown in TIMES) < 1e-3]
        snapshots(case, times, [1],
                  RESULTS/f"siloDischarge-{name.replace('/', '_')}.png")
    return rows
