"""A heavy block with its edges through cells, and what a solve of it takes."""

import re
import shutil

import numpy as np
from scipy.optimize import brentq

from cosserat.case import cpu_seconds, residuals
from cosserat.scenes.box import Box

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
