"""A block that softens, pushed together: the tutorial shearBand, on other meshes
and with other constants, and the band that it breaks in."""

import shutil

import numpy as np

from cosserat.case import Case, cpu_seconds
from cosserat.scenes.yielding import steps

#: Constants of a medium without internal length
CLASSICAL = {"R": 0, "etaCRatio": 0}


def solve(tutorial, path, n, **law):
    """Copy the tutorial's case and run it on n cells up, with constants of the
    law. Returns the case and what the log says of steps and costs."""
    shutil.rmtree(path, ignore_errors=True)
    case = Case.copy(tutorial.path, path)
    case.substitute("system/blockMeshDict", {"nx": 3*n//2, "ny": n})
    case.substitute("constant/materialProperties", law)
    case.run("blockMesh")
    log = case.run("cosseratPicFoam").stdout
    return case, {**steps(log), "cpu": cpu_seconds(log)}


def _crossing(x, rate, i, step, level):
    """Where a rate falls to a level, from the place i on by steps of 1 or -1;
    the last cell where it does not."""
    while rate[i + step] > level:
        i += step
        if i in (0, len(x) - 1):
            return x[i]
    return np.interp(level, [rate[i + step], rate[i]], [x[i + step], x[i]])


def band(case, time=None):
    """Angle of the band to the horizontal, along which the block is pushed
    [degrees], and its width: across it, where Gamma is above half of its
    largest [m]. Of the rows of cells between 0.4 and 0.8: the angle of the line
    through the places of the largest, the median of the widths."""
    n = int(case.entries("system/blockMeshDict")["ny"])
    centres, rate = case.centres(), case.field("Gamma", time)
    order = np.lexsort(centres[:, :2].round(9).T)
    x, y, rate = (values[order].reshape(n, -1)
                  for values in (*centres[:, :2].T, rate))
    places, heights, widths = [], [], []
    for row in np.flatnonzero((y[:, 0] > 0.4) & (y[:, 0] < 0.8)):
        top = rate[row].argmax()
        around = slice(top - 1, top + 2)
        a, b, c = np.polyfit(x[row, around] - x[row, top], rate[row, around], 2)
        level = (c - b*b/(4*a))/2
        places.append(x[row, top] - b/(2*a))
        heights.append(y[row, 0])
        widths.append(_crossing(x[row], rate[row], top, 1, level)
                      - _crossing(x[row], rate[row], top, -1, level))
    angle = np.arctan2(1, np.polyfit(heights, places, 1)[0])
    return np.degrees(angle), np.median(widths)*np.sin(angle)
