"""A strip pressed into half a half space that yields: the tutorial punch, on
other meshes and with other constants."""

import re
import shutil

from cosserat.case import Case, cpu_seconds
from cosserat.scenes.yielding import set_law, steps


def pressure(case):
    """Mean pressure of the strip over the yield stress, from the power: half of
    the strip, 0.1 m thick, moves with 1 m/s."""
    law = (case.path/"constant/materialProperties").read_text()
    return (case.table("power", "powerBalance.dat")[-1][2]/(0.5*0.1)
            / float(re.search(r"\btauY\s+(\S+);", law)[1]))


def solve(tutorial, path, n, law=None, coeffs=None, **nonlinear):
    """Copy the tutorial's case and solve it on n cells across half of the
    strip, with a law and entries of nonlinear where they are given. Returns the
    pressure and what the log says of steps and costs."""
    shutil.rmtree(path, ignore_errors=True)
    case = Case.copy(tutorial.path, path)
    case.substitute("system/blockMeshDict",
                    {"n": n, "nBeside": 4*n, "nDeep": 3*n})
    if law:
        set_law(case, law, **coeffs)
    case.substitute("system/fvSolution", nonlinear)
    case.run("blockMesh")
    log = case.run("cosseratPicFoam").stdout
    return pressure(case), {**steps(log), "cpu": cpu_seconds(log)}


def limit(values):
    """Limit of three values on meshes of which each halves the cells, by the
    order that they have; and that order."""
    first, second, third = values
    fall = (first - second)/(second - third)
    return third - (second - third)/(fall - 1), fall
