"""Scenes at rest on meshes refined where it matters, beside uniform ones: the
silo, a heavy disc, a cavity with a lid. Each function returns a row: cells
(of the mesh), error (relative), iterations, cpu [s], points."""

import shutil

from cosserat.case import cpu_seconds, residuals
from cosserat.references import RELATIVES, SILO, SILO_SCENES
from cosserat.refined import refine_scene
from cosserat.scenes import jumps, relatives
from cosserat.scenes.silo import prepare, rate

#: The slot of the silo, with its four corners
SLOT = "(-0.6 -0.4 -1) (0.6 0.1 1)"


def corners(levels, rings=4, within=None):
    """Entries of a selection around corners."""
    return (f"type corners; levels {levels}; rings {rings};"
            + (f" within {within};" if within else ""))


def surface(levels, rings=4):
    """Entries of a selection at the surface of all materials."""
    return f"type surface; levels {levels}; rings {rings};"


def solve(case, selection):
    """Refine by a selection, if there is one, and solve: the row but for its
    error."""
    if selection:
        refine_scene(case, here=selection)
    case.run("cosseratPicFoam")
    log = case.log()
    row = {"cells": case.n_cells(), "iterations": residuals(log)[0][3],
           "cpu": cpu_seconds(log)}
    if (case.path/"constant/materialPointsProperties").exists():
        row["points"] = len(case.cloud("material"))
    return row


def silo(case, name, cells, selection=None, model=True):
    """Rate of discharge of a scene of references.py in a copy of the tutorial,
    by the fluxes; model: of corners."""
    scene = SILO_SCENES[name]
    prepare(case, scene, cells, corners=model)
    row = solve(case, selection)
    return row | {"error": rate(case, scene.aperture)/SILO[name].value - 1}


def disc(path, name, contrast, cells, selection=None):
    """Mean velocity of a disc of material points, by the power of its
    weight."""
    case = jumps.prepare(path, name, contrast, cells)
    row = solve(case, selection)
    found = jumps.SCENES[name].measure(case, contrast, cells)["u"]
    return row | {"error": found.error}


def follow(case, passes, share):
    """Solve, refine a share of the cells by the indicator, and so on."""
    case.measure("error", "errorIndicator", "executeControl writeTime;"
                 " writeControl writeTime;")
    for _ in range(passes):
        case.run("cosseratPicFoam", "-solveOnce")
        refine_scene(case, worst=f"type indicator; levels {passes};"
                     f" share {share};")


def lid(path, name, cells, selection=None, quantity="flux", indicator=None):
    """Flux of the vortex of a cavity, or velocity in its middle; indicator:
    passes and share of follow()."""
    shutil.rmtree(path, ignore_errors=True)
    scene = relatives.SCENES[name]
    case = relatives.RelativeCase(path, scene, cells).write()
    if indicator:
        follow(case, *indicator)
    row = solve(case, selection)
    found = relatives.measure(case, scene, cells)[quantity]
    return row | {"error": found/RELATIVES[name, quantity].value - 1}
