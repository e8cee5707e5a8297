"""Accuracy against cost of a user's own case: the case on several meshes and
with several numbers of points a cell, compared with the limit that Richardson
extrapolation gives."""

import argparse
import json
import os
import shutil
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import FILES, Case
from cosserat.tradeoff import (at_points, distance, extrapolate, front,
                               observed_order, override, refine, verdict)


#: Quantity: its name, and how the keys of its errors end; columns of results
QUANTITIES = {"velocity U": ("", slice(0, 2)),
              "microrotation omega": ("Omega", slice(2, 3)),
              "pressure p_rgh": ("P", slice(3, 4))}


def copy(source, target):
    """A clean copy of the case."""
    shutil.rmtree(target, ignore_errors=True)
    if (source/"0.orig").is_dir():
        return Case.copy(source, target)
    shutil.copytree(source, target, ignore=shutil.ignore_patterns(
        "[1-9]*", "0.[0-9]*", "processor*", "log.*", "postProcessing",
        "polyMesh", "results"))
    return Case(target)


def set_end(case, time):
    """Let a case write one time, its end; None: its own."""
    entries = ("writeFormat ascii; writeCompression off;"
               " writeControl adjustableRunTime; writeInterval $endTime;")
    if time:
        step = min(time, float(case.run(
            "foamDictionary", "system/controlDict", "-entry", "deltaT",
            "-value", log=False).stdout.split()[-1]))
        entries = f"stopAt endTime; endTime {time!r}; deltaT {step!r}; {entries}"
    with (case.path/"system/controlDict").open("a") as text:
        text.write(f"\n{entries}\n")


def children_seconds():
    """Processor time of the programs that have ended [s]; a run with
    -solveOnce prints none."""
    used = getrusage(RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(source, folder, factor, points, time=None):
    """The case with its cells along each side multiplied by a factor, and
    points per cell (None: as it is), up to a time (None: its own end; 0: the
    flow of the start). Returns a row, and centres and results (U, omega,
    p_rgh) of its cells at the end."""
    case = copy(source, folder/f"{factor:g}-{points or 'own'}")
    case.timeout = None
    set_end(case, time)
    if factor != 1:
        refine(case, factor)
    if points:
        override(case, FILES, pointsPerCell=points)
    case.run("blockMesh")
    before = children_seconds()
    case.run("cosseratPicFoam", *(["-solveOnce"] if time == 0 else []))
    cpu = children_seconds() - before
    row = {"factor": factor, "nCells": case.n_cells(),
           "pointsPerCell": points, "cpu": max(cpu, 0.01),
           "steps": case.log().count("\nStep ")}
    print(row, flush=True)
    U, omega, p = (case.field(name, "0" if time == 0 else None)
                   for name in ("U", "omega", "p_rgh"))
    return row, (case.centres(), np.column_stack([U[:, :2], omega, p]))


def explore(source, folder, coarsest, points, time=None):
    """Rows of the case: errors of velocity, microrotation and pressure at a
    time (None: the end) on meshes whose cells are multiplied by coarsest,
    2 coarsest and 4 coarsest a side, and of each number of points on the
    middle one."""
    levels = [coarsest*2**i for i in range(3)]
    runs = [run(source, folder, factor, None, time) for factor in levels]
    # Points a cell of the case itself are among the meshes
    runs += [run(source, folder, levels[1], n, time) for n in points]
    rows = [row for row, _ in runs]
    cells = runs[0][1][0]
    results = [at_points(*fields, cells) for _, fields in runs]
    for end, columns in QUANTITIES.values():
        meshes = [result[:, columns] for result in results[:3]]
        limit, order, uncertainty = extrapolate(*meshes)
        for row, result in zip(rows, results):
            row.update({f"error{end}": distance(result[:, columns], limit),
                        f"errorUncertainty{end}": uncertainty,
                        f"order{end}": order,
                        f"observedOrder{end}": observed_order(*meshes)})
    for row, on in zip(rows, front([row["cpu"] for row in rows],
                                   [row["error"] for row in rows])):
        row["onFront"] = on
    return rows


def draw(rows, name, path):
    """Error against processor time, with the front."""
    figure, axis = plt.subplots(figsize=(6, 4.2), dpi=130)
    for own, mark, label in (
            ([r for r in rows if not r["pointsPerCell"]], "s-", "cells"),
            ([r for r in rows if r["pointsPerCell"]], "o", "points a cell")):
        axis.loglog([r["cpu"] for r in own], [r["error"] for r in own], mark,
                    ms=5, lw=0.8, label=label)
        for r in own:
            axis.annotate(
                r["pointsPerCell"] or f"{r['nCells']} cells",
                (r["cpu"], r["error"]), xytext=(5, 4), fontsize=7,
                textcoords="offset points")
    best = sorted((r for r in rows if r["onFront"]), key=lambda r: r["cpu"])
    axis.step([r["cpu"] for r in best], [r["error"] for r in best], "k:",
              where="post", label="front")
    axis.axhspan(0, rows[0]["errorUncertainty"], color="0.93",
                 label="uncertainty of the limit")
    axis.margins(x=0.2)
    axis.set_title(name, fontsize=10)
    axis.set_xlabel("processor time [s]")
    axis.set_ylabel("error of the velocity")
    axis.grid(alpha=0.3)
    axis.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path)
    plt.close(figure)


def main(arguments, prog, folder):
    """The command line of a program; its cases are run in runs/tradeOff of a
    folder, and results/tradeOff.json and .png are written there."""
    parser = argparse.ArgumentParser(
        prog=prog, description=__doc__)
    parser.add_argument("-case", required=True, type=Path, metavar="DIR",
                        help="a case with system/blockMeshDict, ready to run")
    parser.add_argument(
        "-coarsest", type=float, default=0.5, metavar="FACTOR",
        help="cells a side of the coarsest of three meshes over the case's,"
        " each of the others twice as fine (default 0.5: the case itself is"
        " the middle one; with 0.25 it is the finest)")
    parser.add_argument("-time", type=float, metavar="T",
                        help="compare at this time, 0: the flow of the start"
                        " (default: the end)")
    parser.add_argument("-points", type=int, nargs="*", default=[4, 9, 36],
                        help="points a cell to compare (default 4 9 36)")
    given = parser.parse_args(arguments)
    source = Path(os.environ.get("COSSERATPIC_CALLER", "."))/given.case
    if not (source/"system/blockMeshDict").is_file():
        raise SystemExit(f"no system/blockMeshDict in {given.case}: the mesh"
                         " is refined through it")
    has_points = (source/"constant/materialPointsProperties").is_file()
    rows = explore(source.resolve(), folder/"runs/tradeOff", given.coarsest,
                   given.points if has_points else [], given.time)
    path = folder/"results/tradeOff.json"
    path.parent.mkdir(exist_ok=True)
    path.write_text(json.dumps({"rows": rows}, indent=1))
    draw(rows, source.resolve().name, path.with_suffix(".png"))

    print(f"\n{'cells':>8} {'points':>7} {'time [s]':>9} {'error':>8}  front")
    for row in rows:
        print(f"{row['nCells']:8} {row['pointsPerCell'] or 'own':>7}"
              f" {row['cpu']:9.2f} {row['error']:8.2%}"
              f"  {'*' if row['onFront'] else ''}")
    own = min(rows, key=lambda row: (abs(np.log(row["factor"])),
                                     row["pointsPerCell"] or 0))
    print("Errors of the case "
          + ("at its end" if given.time is None else f"at {given.time:g} s")
          + f", {own['nCells']} cells, by Richardson extrapolation:")
    for name, (end, _) in QUANTITIES.items():
        print(f"{name:>20}: {own[f'error{end}']:.2%}, known to"
              f" {own[f'errorUncertainty{end}']:.2%}, observed order"
              f" {own[f'observedOrder{end}']:.2f}."
              f" {verdict(own[f'observedOrder{end}'])}")
    print(f"{path}\n{path.with_suffix('.png')}")
