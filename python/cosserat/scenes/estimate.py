"""Scenes whose error is known or found by finite elements, with the function
object errorEstimate."""

import shutil
from functools import lru_cache

import numpy as np

from cosserat.analytic import (AnnularCouette, Manufactured, Material, SolCx,
                               err)
from cosserat.case import fresh_case
from cosserat.finiteElements import tutorials
from cosserat.finiteElements.silo import silo_flow
from cosserat.references import SILO_SCENES
from cosserat.scenes.box import Box
from cosserat.scenes.layers import PAPER, WALLS, run_layer
from cosserat.scenes.manufactured import MATERIALS, MESHES
from cosserat.scenes.silo import mesh_entries

THIN = Material(1.0, 1.0, 0.05)

FUNCTION = """
functions
{
    error
    {
        type            errorEstimate;
        libs            (cosseratFunctionObjects);
        writeControl    writeTime;
    }
}
"""


def switch_on(case):
    """Add the function object to a case; its controlDict merges dictionaries
    of the same name."""
    with (case.path/"system/controlDict").open("a") as text:
        text.write(FUNCTION)


def row(scene, n, case, errors):
    """Row of a run: errors of U and of omega beside the estimates."""
    table = case.table("error", "errorEstimate.dat")[-1]
    return {
        "scene": scene, "n": n, "cells": case.n_cells(),
        "errorU": errors[0], "errorOmega": errors[1],
        "estimateU": float(table[1]), "estimateOmega": float(table[2]),
        "effectivityU": float(table[1]/errors[0]),
        "effectivityOmega": float(table[2]/errors[1]) if errors[1] else None,
        "takenOrderU": float(table[3]), "takenOrderOmega": float(table[4]),
        "measuredOrderU": float(table[5]),
        "measuredOrderOmega": float(table[6]),
        "differenceU": float(table[7]), "differenceOmega": float(table[8]),
        "worstU": table[10:12].tolist()}


def distance(exact, numeric):
    """Equation 30 of vectors."""
    return float(np.linalg.norm(exact - numeric, axis=-1).sum()
                 / np.linalg.norm(numeric, axis=-1).sum())


def layer(path, scene, n):
    """A layer or channel."""
    material = THIN if scene == "layer0.05" else PAPER
    walls = None if scene == "channel" else WALLS["OmegaV"]
    case, _, errors = run_layer(path, material, n, walls, G=1,
                                prepare=switch_on)
    return row(scene, n, case, (errors["errU"], errors["errOmega"]))


def annulus(path, n):
    """The tutorial annularCouette at rest, n cells across."""
    case = fresh_case(path, "annularCouette")
    case.substitute("system/blockMeshDict", {"nAcross": n, "nQuarter": 3*n//2})
    case.substitute("system/fvSolution", {"tolerance": 1e-8})
    case.substitute("system/controlDict", {
        "endTime": 1e-6, "deltaT": 1e-6, "writeInterval": 1e-6})
    switch_on(case)
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    x, y = case.centres()[:, :2].T
    r = np.hypot(x, y)
    exact = AnnularCouette(Material(1000, 1000, 0.2), (1, 2), (1, 0), (1, 0))
    u = (exact.u(r)/r*np.array([-y, x])).T
    return row("annularCouette", n, case, (
        distance(u, case.field("U")[:, :2]),
        float(err(exact.omega(r), case.field("omega")))))


def manufactured(path, mesh, n):
    """A manufactured solution."""
    (X, Y), parameters = MESHES[mesh]
    exact = Manufactured(X, Y, *MATERIALS.values())
    shutil.rmtree(path, ignore_errors=True)
    case = Box(path, n=n, fractions=exact.alpha, force=exact.force,
               couple=exact.couple, tolerance=1e-8,
               materials={name: {"eta": m.eta, "etaC": m.etaC, "R": m.R}
                          for name, m in MATERIALS.items()},
               walls={side: ("type noSlip;",
                             "type fixedValue; value uniform 0.5;")
                      for side in ("left", "right", "bottom", "top")},
               **parameters).write()
    switch_on(case)
    case.run("cosseratPicFoam")
    x, y = case.centres()[:, :2].T
    return row(mesh, n, case, (
        distance(exact.u(x, y).T, case.field("U")[:, :2]),
        float(err(exact.omega(x, y), case.field("omega")))))


def jump(path, n, contrast=1e3):
    """SolCx: a classical fluid whose viscosity jumps along faces."""
    exact = SolCx((1.0, contrast))
    shutil.rmtree(path, ignore_errors=True)
    case = Box(path, n=n, tolerance=1e-9, force=exact.force,
               materials={"a": {"eta": 1, "etaC": 0, "R": 0},
                          "b": {"eta": contrast, "etaC": 0, "R": 0}},
               fractions=lambda x, y: x < 0).write()
    switch_on(case)
    case.run("cosseratPicFoam")
    x, y = case.centres()[:, :2].T
    return row("jump", n, case, (
        distance(exact.u(x, y).T, case.field("U")[:, :2]), None))


def at_rest(path, scene, n):
    """The first solve of a tutorial: case, and centres, velocity and
    microrotation."""
    tutorial = "sinkingInclusion" if scene == "inclusion" else scene
    case = fresh_case(path, tutorial)
    case.substitute("system/blockMeshDict", {
        key: max(cells, 1) for key, cells in mesh_entries(n).items()}
                    if scene == "silo" else {"n": n})
    case.substitute("system/controlDict", {
        "endTime": 1e-7, "deltaT": 1e-7, "writeInterval": 1e-7})
    switch_on(case)
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    # omega is half the vorticity where nothing has one of its own
    fields = np.column_stack([case.field("U")[:, :2], case.field("omega")])
    return case, (case.centres(), fields)


@lru_cache
def elements(scene):
    """Finite elements that the first solve of a tutorial is compared with."""
    if scene == "silo":
        return silo_flow(SILO_SCENES["start, 2/3"], contact=1e-100)
    return {"inclusion": tutorials.disc_flow,
            "rayleighTaylor": tutorials.overturn_flow}[scene](False)


def without_exact(path, scene, n):
    """Row of a scene whose reference is that of finite elements; the
    microrotation where there is a granular material."""
    case, (centres, fields) = at_rest(path, scene, n)
    # The silo is solved on its right half
    mirror = (centres[:, 0] < 0) & (scene == "silo")
    sign = np.where(mirror, -1.0, 1.0)
    exact = np.array([elements(scene).at(x, y)[:3] for x, y in zip(
        sign*centres[:, 0], centres[:, 1])])
    exact[:, [0, 2]] *= sign[:, None]
    inside = np.isfinite(exact[:, 2])
    if scene == "silo":
        inside &= case.field("alpha.granular") > 0.999
    return row(scene, n, case, (
        distance(exact[:, :2], fields[:, :2]),
        float(err(exact[inside, 2], fields[inside, 2]))
        if inside.any() else None))


def add_order(rows):
    """Orders of the errors and of the estimates from the row before, on half
    the cells a side."""
    for coarse, fine in zip([None] + rows[:-1], rows):
        for key in ("errorU", "errorOmega", "estimateU", "estimateOmega"):
            fine[f"order{key[0].upper()}{key[1:]}"] = (
                float(np.log2(coarse[key]/fine[key]))
                if coarse and coarse[key] else None)
    return rows
