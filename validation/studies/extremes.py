"""The flow solve at the extremes of its parameters: a heavy block with its
edges through cells, the silo at rest, the shear layer."""

import re
import shutil

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import brentq

from cosserat.analytic import Material, ShearLayer, err
from cosserat.box import Box
from cosserat.case import residuals
from studies.common import (HERE, constant_material, cpu_seconds, new_case,
                            save)

N = 64

#: What a run is given unless a row says otherwise
DEFAULT = {"contrast": 1e3, "coupling": 1.0, "R": 0.1, "B": "infinite",
           "density": 0.0, "aspect": 1.0, "graded": 1.0,
           "shear": 0.0, "n": N}


def overlap(centre, width, low, high):
    """Share of cells along a line that lies between low and high."""
    return np.clip((np.minimum(centre + width/2, high)
                    - np.maximum(centre - width/2, low))/width, 0, 1)


def grading(n, graded):
    """Map of [-1/2, 1/2] onto itself, and its inverse, that makes the first
    of n cells smaller by a factor, the others growing geometrically."""
    if graded == 1:
        return lambda y: y, lambda y: y
    ratio = brentq(lambda r: graded*n*(r**(1/n) - 1) - (r - 1), 1.01, 1e8)
    return (lambda y: (ratio**(y + .5) - 1)/(ratio - 1) - .5,
            lambda y: np.log1p((y + .5)*(ratio - 1))/np.log(ratio) - .5)


def block(path, contrast, coupling, R, B, density, aspect, graded, shear, n,
          tolerance):
    """A block of density 1 sinks in a fluid of eta = 1; its edges are inside
    cells. aspect: width over height of the box and of each cell; graded:
    width over height of the lowest cells."""
    h = 1/n
    there, back = grading(n, graded)

    def fraction(x, y):
        # On a sheared mesh the block is sheared with it
        return (overlap(x - shear*y, h, -.2 + .137*h, .13 + .3*h)
                * overlap(back(y*aspect), h, -.05 + .41*h, .3 + .22*h))

    def warp(x, y):
        return x, there(y)/aspect

    def material(eta, rho):
        return {"eta": eta, "etaC": coupling*eta, "R": R, "B": B, "rho": rho}

    shutil.rmtree(path, ignore_errors=True)
    case = Box(path, n=n, g=(0, -1, 0), tolerance=tolerance, shear=shear,
               fractions=fraction,
               warp=warp if aspect != 1 or graded != 1 else None,
               materials={"block": material(contrast, 1),
                          "rest": material(1.0, density)}).write()
    return case


def measure(case, scene, parameters):
    """Run at 1e-6 and at 1e-8; a row."""
    row = {"scene": scene, **parameters, "converged": False, "error": "",
           "iterations": None, "iterations8": None, "change": None,
           "solver": "", "cpu": None}
    found = []
    for tolerance in (1e-6, 1e-8):
        case.substitute("system/fvSolution", {"tolerance": tolerance})
        for time in case.times():
            shutil.rmtree(case.path/time)
        done = case.run("cosseratPicFoam", check=False)
        log = done.stdout
        solves = residuals(log)
        # The first solve, before anything has moved
        solves = solves[:3 if solves[2:3] and solves[2][0] == "omega" else 2]
        if solves:
            key = "iterations" if tolerance == 1e-6 else "iterations8"
            row[key] = solves[0][3]
            row["residual"] = max(solve[2] for solve in solves)
        row["solver"] = ("direct" if "sparse factorisation" in log
                         else "multigrid")
        row["converged"] = done.returncode == 0
        if done.returncode:
            match = re.search(r"FATAL.*?\n(.*?)\n\s*From ", log, re.S)
            row["error"] = " ".join((match[1] if match else log[-300:]).split())
            return row
        if tolerance == 1e-6:
            row["cpu"] = cpu_seconds(log)
        found.append(case.field("U"))
    row["change"] = float(np.abs(found[1] - found[0]).max()
                          / np.abs(found[1]).max())
    return row


def blocks():
    """Parameters of the rows of the block."""
    for contrast in (1e-8, 1e-6, 1e-3, 1, 1e3, 1e6, 1e8):
        yield {"contrast": contrast}
        yield {"contrast": contrast, "coupling": 0.0, "R": 0.0}
    for coupling in (1e-6, 1e-3, 3.0, 10.0, 30.0, 1e3, 1e6):
        for R in (0.0, 1e-6, 1e-2, 1e-1, 1.0, 1e4):
            yield {"coupling": coupling, "R": R}
    for R in (1e-6, 1e-2, 1.0, 1e4):
        yield {"R": R}
        yield {"R": R, "contrast": 1e6}
    for contrast in (1e-6, 1e6):
        for coupling in (10.0, 1e6):
            yield {"contrast": contrast, "coupling": coupling}
    for B in (1, 10, 1e3, 1e6):
        yield {"B": B}
    yield {"density": 0.999}
    for aspect in (3.0, 10.0, 100.0, 1000.0):
        yield {"aspect": aspect}
        yield {"graded": aspect}
    for shear in (0.5, 1.0, 1.732):
        yield {"shear": shear}
    for n in (32, 128):
        yield {"n": n}
        yield {"n": n, "coupling": 10.0}
        yield {"n": n, "contrast": 1e6}


def silos():
    """The silo at rest: points a cell; and its first steps at large Courant
    numbers."""
    for points in (1, 4, 16, 100):
        case = new_case("extremes", f"silo{points}", "silo")
        case.substitute("constant/materialPointsProperties", {
            "pointsPerCell": points, "minPointsPerCell": min(points, 4)})
        case.substitute("system/controlDict", {
            "endTime": 1e-9, "deltaT": 1e-9, "writeInterval": 1e-9})
        yield case, {"pointsPerCell": points}
    for courant in (0.1, 1, 3, 10):
        case = new_case("extremes", f"courant{courant}", "silo")
        case.substitute("system/controlDict", {
            "endTime": 1e-4, "writeInterval": 1e-4, "maxCo": courant})
        yield case, {"courant": courant}


def layers(rows):
    """Locking: a layer between walls without rotation at etaC >> eta, whose
    exact solution is at hand."""
    for coupling in (1.0, 10.0, 1e3, 1e6):
        for R in (0.0, 1e-6, 1e-2, 1.0):
            material = Material(1.0, coupling, R)
            case = new_case("extremes", f"layer{coupling:g}-{R:g}",
                            "shearLayer")
            constant_material(case, material)
            (case.path/"constant/materialPointsProperties").unlink()
            case.substitute("system/blockMeshDict", {"n": 64})
            case.substitute("system/controlDict", {
                "endTime": 1, "deltaT": 1, "adjustTimeStep": "no",
                "writeInterval": 1})
            case.substitute("system/walls", {
                "velocity": "sigma", "rotation": "Omega", "sigma": "1"})
            case.run("blockMesh")
            row = measure(case, "layer", {"coupling": coupling, "R": R})
            if row["converged"]:
                y = case.centres()[:, 1]
                delta = material.delta
                exact = (y if delta < 1e-4 else ShearLayer(
                    material, 1, sigma=1.0, Omega=0.0).u(y))
                row["errU"] = err(exact, case.field("U")[:, 0])
            rows.append(row)


def study():
    """Rows: scene, the parameters that differ from DEFAULT, iterations (to
    1e-6), iterations8 (to 1e-8), converged, error (the program's message),
    residual, change (of U, relative, from 1e-6 to 1e-8), solver, cpu [s];
    errU for the layer."""
    rows = []
    for parameters in blocks():
        given = {**DEFAULT, **parameters}
        case = block(HERE/"runs/extremes/block", **given, tolerance=1e-6)
        rows.append(measure(case, "block", given))
    for case, parameters in silos():
        case.run("blockMesh")
        rows.append(measure(case, "silo", parameters))
    layers(rows)

    figure, axes = plt.subplots(1, 2, figsize=(10, 4), dpi=130, sharey=True)
    own = [row for row in rows if row["scene"] == "block"
           and row["iterations"] is not None]
    for coupling in (1e-3, 1.0, 3.0, 10.0, 30.0, 1e3, 1e6):
        line = sorted((row["R"], row["iterations"]) for row in own
                      if row["coupling"] == coupling and row["R"] > 0
                      and all(row[key] == DEFAULT[key] for key in DEFAULT
                              if key not in ("R", "coupling")))
        axes[0].semilogx(*zip(*line), "o-", ms=4,
                         label=rf"$\eta^c/\eta$ = {coupling:g}")
    axes[0].set_xlabel("R [m] in a box of 1 m")
    axes[0].set_ylabel("iterations to 1e-6")
    for coupling, label in ((0.0, "classical"), (1.0, "Cosserat")):
        line = sorted((row["contrast"], row["iterations"]) for row in own
                      if row["coupling"] == coupling
                      and all(row[key] == DEFAULT[key] for key in DEFAULT
                              if key not in ("R", "coupling", "contrast"))
                      and (coupling == 0 or row["R"] == DEFAULT["R"]))
        axes[1].semilogx(*zip(*line), "o-", ms=4, label=label)
    axes[1].set_xlabel("viscosity of the block over that around")
    for axis in axes:
        axis.set_ylim(bottom=0)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    save(figure, "extremes")
    plt.close(figure)
    return rows
