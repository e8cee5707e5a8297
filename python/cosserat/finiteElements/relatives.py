"""The relatives of the silo's corner (cosserat.scenes.relatives) by finite elements:
the scenes are those of the flow solver's cases."""

import numpy as np

from cosserat.scenes.relatives import OPEN, SLIP
from cosserat.finiteElements.flow import Flow, Wall
from cosserat.finiteElements.mesh import Mesh, graded_lines


def relative_flow(scene, degree=4, size=0.25, smallest=1e-20, ratio=0.2):
    """Solution for a scene."""
    fine = min(*np.diff(scene.x), *np.diff(scene.y), 2*size)/2
    x, y = (graded_lines(
        points, size, [corner[i] for corner in scene.corners], fine, 0.5)
            for i, points in enumerate((scene.x, scene.y)))
    keep = scene.solid and (lambda x, y: ~scene.solid(x, y))
    width = scene.x[-1] - scene.x[0]
    mesh = Mesh.tensor(x, y, keep, (width, 0) if scene.periodic else None)
    mesh.grade(scene.corners, smallest, ratio)

    def of(value):
        values = [value(medium) for medium in scene.media]
        if len(values) == 1:
            return values[0]
        return lambda x, y: np.where(scene.first(x, y), *values)

    return Flow(mesh, degree, of(lambda m: m.eta), of(lambda m: m.etaC),
                of(lambda m: 2*m.etaC*m.R**2),
                tuple(of(lambda m, g=g: m.weight*g) for g in scene.gravity),
                [_wall(side) for side in scene.sides])


def _wall(side):
    if side.velocity == SLIP:
        return Wall(side.where, normal=0, omega=side.omega)
    if side.velocity == OPEN:
        return Wall(side.where, omega=side.omega)
    return Wall(side.where, u=side.velocity, omega=side.omega)


def relative_values(scene, **elements):
    """Quantities of a scene, by name."""
    flow = relative_flow(scene, **elements)
    return {name: flow.flux(*where) if kind == "flux"
            else flow.at(*where[0])[{"u": 0, "omega": 2}[kind]]
            for name, (kind, *where) in scene.quantities.items()}
