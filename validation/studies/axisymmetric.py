"""Flows around an axis against exact ones: pipes, spheres, a cone, and a
made-up flow; points in a cone; the round silo."""

from cosserat.case import residuals
from cosserat.references import ROUND_SILO
from cosserat.results import add_orders
from cosserat.scenes import roundSilo
from cosserat.scenes.axialFlows import (cone, conical, core, manufactured,
                                        off_the_ways, pipe, points_sphere,
                                        sphere)
from studies.common import HERE, new_case

CELLS = [12, 24, 48]

FLOWS = [
    *((pipe, {"R": R, "free": free}) for R in (0.1, 0.3, 1.0)
      for free in (False, True)),
    (core, {"R": 0.3}),
    *((sphere, {"R": R, "free": free}) for R in (0.1, 0.3, 1.0)
      for free in (False, True)),
    (cone, {}),
    *((manufactured, options) for options in (
        {}, {"wavy": True}, {"triangles": True})),
]


def silo(n, alpha, corners):
    """Rate of the round silo at its start, of n cells a unit."""
    case = roundSilo.prepare(
        new_case("axisymmetric", f"silo_{n}_{alpha:.1f}_{corners}",
                 "cylindricalSilo"), n, alpha, corners)
    case.run("cosseratPicFoam")
    value, reference = roundSilo.rate(case), ROUND_SILO[alpha].value
    return {"test": "silo", "parameters": {"alpha": alpha, "corners": corners},
            "cells": case.n_cells(), "value": value, "reference": reference,
            "error": value/reference - 1,
            "iterations": residuals(case.log())[0][3]}


def ways(n, **mesh):
    """Points that sink in a cone: error of the cube of their distance from the
    tip, and the largest change of their angle [degrees]."""
    case = conical(HERE/"runs/axisymmetric"/f"ways_{n}_{len(mesh)}", n, **mesh)
    case.run("cosseratPicFoam")
    cube, angle = off_the_ways(case)
    return {"test": "ways", "parameters": mesh, "cells": case.n_cells(),
            "value": 1 + cube, "reference": 1.0, "error": cube,
            "angle": angle}


def study():
    """Rows: test, parameters, cells, value, reference, error (relative),
    errU and, where it is not zero, errOmega, errP (relative L2 by volume, of
    the pressure absolute), orderU, orderOmega, iterations; of points angle
    [degrees]."""
    rows = []
    for i, (flow, parameters) in enumerate(FLOWS):
        own = [flow(HERE/"runs/axisymmetric"/f"{i}_{n}", n, **parameters)
               for n in CELLS]
        add_orders(own, *(key[3:] for key in ("errU", "errOmega")
                          if key in own[0]))
        rows += own
    for mesh in ({}, {"triangles": True}):
        rows += [ways(n, **mesh) for n in (8, 16, 32)]
    for R in (0.1, 1.0):
        rows += [points_sphere(HERE/"runs/axisymmetric"/f"sphere_{n}_{R}", n, R)
                 for n in (8, 16, 32)]
    for alpha in ROUND_SILO:
        rows += [silo(n, alpha, corners) for corners in (True, False)
                 for n in (8, 16, 32)]
    return rows
