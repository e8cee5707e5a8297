"""Flows around an axis against exact ones: pipes, spheres, a cone, and a
made-up flow."""

from cosserat.results import add_orders
from cosserat.scenes.axialFlows import cone, core, manufactured, pipe, sphere
from studies.common import HERE

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


def study():
    """Rows: test, parameters, cells, value, reference, error (relative),
    errU and, where it is not zero, errOmega, errP (relative L2 by volume, of
    the pressure absolute), orderU, orderOmega, iterations."""
    rows = []
    for i, (flow, parameters) in enumerate(FLOWS):
        own = [flow(HERE/"runs/axisymmetric"/f"{i}_{n}", n, **parameters)
               for n in CELLS]
        add_orders(own, *(key[3:] for key in ("errU", "errOmega")
                          if key in own[0]))
        rows += own
    return rows
