"""Scenes of the function object errorIndicator, with the true errors of their
strains, which are known or by finite elements. Cases are run in a folder."""

import shutil
from functools import lru_cache

import numpy as np
from scipy.spatial import cKDTree

from cosserat.analytic import AnnularCouette, Manufactured, Material, SolCx
from cosserat.case import fresh_case
from cosserat.finiteElements import tutorials
from cosserat.finiteElements.silo import silo_flow
from cosserat.references import SILO_SCENES
from cosserat.refined import middles, refine_cells
from cosserat.scenes.box import Box
from cosserat.scenes.layers import PAPER, WALLS, run_layer
from cosserat.scenes.manufactured import MATERIALS, MESHES
from cosserat.scenes.silo import mesh_entries
from cosserat.strains import (differences, errors, found, rank_correlation,
                              switch_on)

THIN = Material(1.0, 1.0, 0.05)


def compare(scene, n, case, exact):
    """Row of a run, and its true errors and indicator by cell."""
    true = errors(case, exact)
    indicator = case.field("errorIndicator")
    _, total, dissipated, relative, share = case.table(
        "error", "errorIndicator.dat")[-1]
    return {
        "scene": scene, "n": n, "cells": case.n_cells(),
        "error": float((true.sum()/dissipated)**0.5),
        "indicator": float(relative),
        "effectivity": float((total/true.sum())**0.5),
        "correlation": rank_correlation(indicator, true),
        "found": found(indicator, true), "worstShare": float(share),
        "trueWorstShare": found(true, true)*float(
            np.sort(true)[-max(1, round(len(true)/10)):].sum()/true.sum()),
    }, true, indicator


def smallest(case):
    """A step for differences."""
    return 1e-4*case.volumes().min()**0.5


def layer(folder, scene, n):
    """A layer or channel."""
    material = THIN if scene == "layer0.05" else PAPER
    walls = None if scene == "channel" else WALLS["OmegaV"]
    case, exact, _ = run_layer(folder/f"{scene}{n}", material, n, walls, G=1,
                               prepare=switch_on)
    return case, differences(
        lambda x, y: (exact.u(y), 0*y, exact.omega(y)), smallest(case))


def annulus(folder, n):
    """The tutorial annularCouette at rest, n cells across."""
    case = fresh_case(folder/f"annularCouette{n}", "annularCouette")
    case.substitute("system/blockMeshDict", {"nAcross": n, "nQuarter": 3*n//2})
    case.substitute("system/fvSolution", {"tolerance": 1e-8})
    case.substitute("system/controlDict", {
        "endTime": 1e-6, "deltaT": 1e-6, "writeInterval": 1e-6})
    switch_on(case)
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    exact = AnnularCouette(Material(1000, 1000, 0.2), (1, 2), (1, 0), (1, 0))

    def fields(x, y):
        r = np.hypot(x, y)
        return -exact.u(r)*y/r, exact.u(r)*x/r, exact.omega(r)

    return case, differences(fields, smallest(case))


def box(path, **parameters):
    """Run a box."""
    shutil.rmtree(path, ignore_errors=True)
    case = Box(path, **parameters).write()
    switch_on(case)
    case.run("cosseratPicFoam")
    return case


def manufactured(folder, mesh, n):
    """A manufactured solution; halved: on a square of twice as fine cells."""
    (X, Y), parameters = MESHES["uniform" if mesh == "halved" else mesh]
    if mesh == "halved":
        parameters = {"halved": lambda x, y: (abs(x) < 0.25) & (abs(y) < 0.25)}
    exact = Manufactured(X, Y, *MATERIALS.values())
    case = box(folder/f"{mesh}{n}", n=n, fractions=exact.alpha, force=exact.force,
               couple=exact.couple, tolerance=1e-8,
               materials={name: {"eta": m.eta, "etaC": m.etaC, "R": m.R}
                          for name, m in MATERIALS.items()},
               walls={side: ("type noSlip;",
                             "type fixedValue; value uniform 0.5;")
                      for side in ("left", "right", "bottom", "top")},
               **parameters)
    return case, differences(
        lambda x, y: (*exact.u(x, y), exact.omega(x, y)), smallest(case))


def jump(folder, n, contrast=1e3, **parameters):
    """SolCx: a classical fluid whose viscosity jumps along faces; parameters
    of Box."""
    exact = SolCx((1.0, contrast))
    case = box(folder/f"jump{n}", n=n, tolerance=1e-9, force=exact.force,
               materials={"a": {"eta": 1, "etaC": 0, "R": 0},
                          "b": {"eta": contrast, "etaC": 0, "R": 0}},
               fractions=lambda x, y: x < 0, **parameters)
    return case, differences(
        lambda x, y: (*exact.u(x, y), 0*x), smallest(case))


@lru_cache
def elements(scene):
    """Finite elements that the first solve of a tutorial is compared with."""
    if scene == "silo":
        return silo_flow(SILO_SCENES["start, 2/3"], contact=1e-100)
    return {"inclusion": tutorials.disc_flow,
            "rayleighTaylor": tutorials.overturn_flow}[scene](False)


def by_elements(scene):
    """Values and gradients of finite elements, like differences()."""
    def at(x, y):
        # The silo is solved on its right half
        left = (x < 0) & (scene == "silo")
        values, gradients = elements(scene).gradients_at(
            np.column_stack([np.where(left, -x, x), y]))
        values[left] *= [-1, 1, -1]
        gradients[left] *= [[1, -1, 1], [-1, 1, -1]]
        return values.T, gradients.transpose(1, 2, 0)

    return at


def at_rest(folder, scene, n, halve=()):
    """The first solve of a tutorial, some of its cells halved both ways."""
    tutorial = "sinkingInclusion" if scene == "inclusion" else scene
    case = fresh_case(folder/f"{scene}{n}{'h'*bool(len(halve))}", tutorial)
    case.substitute("system/blockMeshDict", {
        key: max(cells, 1) for key, cells in mesh_entries(n).items()}
                    if scene == "silo" else {"n": n})
    case.substitute("system/controlDict", {
        "endTime": 1e-7, "deltaT": 1e-7, "writeInterval": 1e-7})
    switch_on(case)
    case.run("blockMesh")
    if len(halve):
        refine_cells(case, halve)
        # The default wants quadrilaterals
        with (case.path/"constant/materialPointsProperties").open("a") as text:
            text.write("\nvelocity cellPoint;\n")
    case.run("cosseratPicFoam")
    return case, by_elements(scene)


def worst(indicator, share=0.1):
    """Cells that are to be refined."""
    return np.argsort(-indicator)[:round(share*len(indicator))]


def around(case, cells):
    """Cells, and those of the same size that share a corner with them."""
    centres = middles(case)
    depth = np.ptp(case.mesh_points()[:, 2])
    size = (case.volumes().min()/depth)**0.5
    return np.flatnonzero(
        cKDTree(centres[cells]).query(centres)[0] < 1.5*size)


def run(folder, scene, n):
    """Case of a scene, and its exact flow."""
    if scene.startswith("layer") or scene == "channel":
        return layer(folder, scene, n)
    if scene in MESHES or scene == "halved":
        return manufactured(folder, scene, n)
    if scene in ("annularCouette", "jump"):
        return {"annularCouette": annulus, "jump": jump}[scene](folder, n)
    return at_rest(folder, scene, n)
