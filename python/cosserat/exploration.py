"""Accuracy against cost of a user's own case: the case on several meshes and
with several numbers of points a cell, compared with the limit that Richardson
extrapolation gives."""

import argparse
import json
import os
import shutil
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import FILES, Case, cpu_seconds
from cosserat.tradeoff import (distance, extrapolate, front, override, refine,
                               restrict)


def copy(source, target):
    """A clean copy of the case."""
    shutil.rmtree(target, ignore_errors=True)
    if (source/"0.orig").is_dir():
        return Case.copy(source, target)
    shutil.copytree(source, target, ignore=shutil.ignore_patterns(
        "[1-9]*", "0.[0-9]*", "processor*", "log.*", "postProcessing",
        "polyMesh", "results"))
    return Case(target)


def run(source, folder, factor, points):
    """The case with its cells along each side multiplied by a factor, and
    points a cell (None: as it is). Returns a row, and centres, volumes and
    velocity of its cells at the end."""
    case = copy(source, folder/f"{factor:g}-{points or 'own'}")
    case.timeout = None
    with (case.path/"system/controlDict").open("a") as text:
        text.write("\nwriteFormat ascii; writeCompression off;"
                   " writeControl adjustableRunTime; writeInterval $endTime;\n")
    if factor != 1:
        refine(case, factor)
    if points:
        override(case, FILES, pointsPerCell=points)
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    row = {"factor": factor, "nCells": case.n_cells(),
           "pointsPerCell": points, "cpu": max(cpu_seconds(case.log()), 0.01),
           "steps": case.log().count("\nStep ")}
    print(row, flush=True)
    return row, (case.centres(), case.volumes(), case.field("U")[:, :2])


def explore(source, folder, coarsest, points):
    """Rows of the case: error of the velocity at the end on meshes whose cells
    are multiplied by coarsest, 2 coarsest and 4 coarsest a side, and of each
    number of points on the middle one."""
    levels = [coarsest*2**i for i in range(3)]
    runs = [run(source, folder, factor, None) for factor in levels]
    cells = runs[0][1][0]
    limit, order, uncertainty = extrapolate(*(
        restrict(*fields, cells) for _, fields in runs))
    # Points a cell of the case itself are among the meshes
    runs += [run(source, folder, levels[1], n) for n in points]
    rows = [{**row, "error": distance(restrict(*fields, cells), limit),
             "errorUncertainty": uncertainty, "order": order}
            for row, fields in runs]
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
    parser.add_argument("-points", type=int, nargs="*", default=[4, 9, 36],
                        help="points a cell to compare (default 4 9 36)")
    given = parser.parse_args(arguments)
    source = Path(os.environ.get("COSSERATPIC_CALLER", "."))/given.case
    if not (source/"system/blockMeshDict").is_file():
        raise SystemExit(f"no system/blockMeshDict in {given.case}: the mesh"
                         " is refined through it")
    has_points = (source/"constant/materialPointsProperties").is_file()
    rows = explore(source.resolve(), folder/"runs/tradeOff", given.coarsest,
                   given.points if has_points else [])
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
    print(f"Velocity of the case at its end: error {own['error']:.2%}, known"
          f" to {own['errorUncertainty']:.2%} (order {own['order']:.1f})")
    print(f"{path}\n{path.with_suffix('.png')}")
