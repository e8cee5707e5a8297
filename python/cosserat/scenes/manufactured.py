"""A manufactured solution with viscosities that vary smoothly, on meshes of
every kind."""

import numpy as np

from cosserat.analytic import Manufactured, Material
from cosserat.case import residuals
from cosserat.results import l2
from cosserat.scenes.box import Box

#: First material at fraction 1, second at 0: eta and etaC 1 to 3 and 2 to 1
MATERIALS = {"a": Material(1.0, 2.0, 0.2), "b": Material(3.0, 1.0, 0.4)}

UNIT = (lambda x, y: x + 0.5, lambda x, y: y + 0.5)

SHEAR = 0.5


def _stretch(s):
    """Cells 7 times larger in the middle than at the ends."""
    return s - 0.12*np.sin(2*np.pi*(s + 0.5))


def _wavy(x, y):
    """Lines bent inside a square."""
    return (x + 0.06*np.sin(2*np.pi*(y + 0.5))*np.cos(np.pi*x),
            y + 0.06*np.sin(2*np.pi*(x + 0.5))*np.cos(np.pi*y))


def _sector(x, y):
    """A quarter of an annulus, 1 < r < 2."""
    angle = (y + 0.5)*np.pi/2
    return (1.5 + x)*np.cos(angle), (1.5 + x)*np.sin(angle)


#: Half the sides of squares of cells refined once and twice
NESTED = (0.25, 0.125)

#: Selections of refine_scene that make them
LEVELS = {f"square{level}": f"type source; levels {level}; source boxToCell;"
          f" box ({-half} {-half} -1) ({half} {half} 1);"
          for level, half in enumerate(NESTED, 1)}


def _from_change(x, y):
    """Way to the nearest change of level."""
    radius = np.maximum(np.abs(x), np.abs(y))
    return np.min([np.abs(radius - half) for half in NESTED], axis=0)


#: mesh: (coordinates that follow the walls, parameters of Box)
MESHES = {
    "uniform": (UNIT, {}),
    "graded": (UNIT, {"warp": lambda x, y: (_stretch(x), _stretch(y))}),
    "sheared": ((lambda x, y: x - SHEAR*y + 0.5, lambda x, y: y + 0.5),
                {"shear": SHEAR}),
    "wavy": (UNIT, {"warp": _wavy}),
    "sector": ((lambda x, y: np.hypot(x, y) - 1,
                lambda x, y: np.arctan2(y, x)*2/np.pi), {"warp": _sector}),
    "triangles": (UNIT, {"triangles": True}),
    "levels": (UNIT, {"refined": LEVELS}),
}


def run(path, mesh, n, tolerance=1e-8):
    """Row of a run: relative L2 errors, iterations; where there are levels also
    errPAway, of p away from where they change. The viscous stresses are
    some sixty times the pressure, so the relative error of the latter is
    large."""
    (X, Y), parameters = MESHES[mesh]
    exact = Manufactured(X, Y, *MATERIALS.values())
    case = Box(path, n=n, fractions=exact.alpha, force=exact.force,
               couple=exact.couple, tolerance=tolerance,
               materials={name: {"eta": m.eta, "etaC": m.etaC, "R": m.R}
                          for name, m in MATERIALS.items()},
               walls={side: ("type noSlip;",
                             "type fixedValue; value uniform 0.5;")
                      for side in ("left", "right", "bottom", "top")},
               **parameters).write()
    case.run("cosseratPicFoam")
    x, y = case.centres()[:, :2].T
    V = case.volumes()

    def rms(values):
        return np.sqrt((V*np.sum(np.atleast_2d(values)**2, axis=0)).sum()
                       / V.sum())

    p, exact_p = case.field("p"), exact.p(x, y)
    offset = (V*(p - exact_p)).sum()/V.sum()
    row = {
        "mesh": mesh, "n": n, "cells": len(V),
        "errU": rms(case.field("U")[:, :2].T - exact.u(x, y))
        / rms(exact.u(x, y)),
        "errOmega": rms(case.field("omega") - exact.omega(x, y))
        / rms(exact.omega(x, y)),
        "errP": rms(p - exact_p - offset)/rms(exact_p),
        "iterations": residuals(case.log())[0][3],
    }
    if mesh == "levels":
        away = _from_change(x, y) > 0.06
        row["errPAway"] = l2(p - offset, exact_p, away).error
    return row
