"""A stiff plug that slides along frictional walls, by finite elements: what
Janssen's pressure, of which there is one at a depth, leaves out."""

import numpy as np

from cosserat.finiteElements.flow import Flow, Wall
from cosserat.finiteElements.mesh import Mesh
from cosserat.yielding import janssen


def plug_pressures(mu, axial=False, depth=5.0, across=4, down=40):
    """Depths, mean pressures there over a section, and normal tractions of the
    wall, of a plug of unit weight on a fixed bottom, whose wall bears mu of its
    normal load: between planes the distance 1 apart, or in a round bin of the
    radius 1. across: cells from the middle to the wall."""
    half = 1.0 if axial else 0.5
    mesh = Mesh.tensor(np.linspace(0, half, across + 1),
                       np.linspace(-depth, 0, down + 1))

    def side(x, y):
        return np.isclose(x, half)

    heights = np.linspace(-depth, 0, 10*down)
    loads, change = janssen(-heights, mu), 1.0
    while change > 1e-8:
        flow = Flow(mesh, force=(0, -1.0), axial=axial, walls=[
            Wall(lambda x, y: np.isclose(x, 0), normal=0),
            Wall(side, normal=0, traction=(
                0, lambda x, y: mu*np.interp(y, heights, loads))),
            Wall(lambda x, y: np.isclose(y, -depth), u=(0, 0))])
        (_, now), found = flow.wall_tractions(side)
        order = np.argsort(now)
        now, found = now[order], -found[order, 0]
        change = np.abs(found - np.interp(now, heights, loads)).max()
        heights, loads = now, found

    x, y = mesh.centres.T
    levels, level = np.unique(np.round(y, 9), return_inverse=True)
    area = x if axial else np.ones_like(x)
    p = flow.p.reshape(len(x), -1)[:, 0]
    mean = np.bincount(level, p*area)/np.bincount(level, area)
    return -levels, mean, np.interp(levels, heights, loads)
