"""The silo at rest by finite elements: one half of it, mirrored at x = 0."""

from functools import partial

import numpy as np

from cosserat.references import Silo
from cosserat.finiteElements.flow import Flow, Wall
from cosserat.finiteElements.mesh import Mesh, lines
from cosserat.finiteElements.yielding import BinghamFlow


def silo_mesh(scene, size=0.5, smallest=1e-8, contact=1e-40, ratio=0.2):
    """Cells of a size, graded at the corners of the solid to smallest, and to
    contact at those where the fill's surface ends: velocity goes there with
    r^0.012, so that only many more rings tell."""
    half, floor = scene.aperture/2, scene.floor
    x = lines([0, half/2, half, 1.5*half, 2.5, 2.625, 2.75, 3.75], size)
    y = lines([-4, -1.5*floor, -floor, -floor/2, 0, floor/2, 5, 6], size)

    def fluid(x, y):
        bottom = (x > half) & (x < 2.75) & (y < 0) & (y > -floor)
        side = (x > 2.5) & (x < 2.75) & (y < 5) & (y > -floor)
        return ~(bottom | side)

    lips = [(half, 0), (half, -floor)]
    if scene.filled:
        lips.reverse()
    mesh = Mesh.tensor(x, y, keep=fluid)
    mesh.grade([lips[0], (2.5, 5)], contact, ratio)
    return mesh.grade([lips[1], (2.75, 5), (2.75, -floor)], smallest, ratio)


def silo_flow(scene, degree=3, tauY=0, eps=10.0, axial=False, **mesh):
    """Solution for a scene; tauY: yield stress of the fill, with the small rate
    eps; axial: of a silo that is round."""
    bottom = -scene.floor if scene.filled else 0.0

    def inside(x, y):
        return (((x < 2.5) & (y > 0) & (y < 5))
                | ((x < scene.aperture/2) & (y > bottom) & (y < 0)))

    def fill(value, background=0.0):
        return lambda x, y: np.where(inside(x, y), value, background)

    walls = [Wall(lambda x, y: x + y < np.inf, normal=0),
             Wall(lambda x, y: x < 1e-9, omega=0)]
    if scene.rough:
        walls.append(Wall(
            lambda x, y: (x > 1e-9) & (x < 3.7) & (y > -3.9) & (y < 5.9),
            u=(0, 0), omega=0))
    flow = Flow
    if tauY:
        flow = partial(BinghamFlow, tauY=fill(tauY), eps=eps)
    return flow(silo_mesh(scene, **mesh), degree,
                eta=fill(Silo.ETA, scene.background),
                etaC=fill(scene.etaC), M=fill(scene.M),
                force=(0, fill(-Silo.WEIGHT)), walls=walls, axial=axial)


def silo_rate(scene, degree=3, **mesh):
    """Volume that leaves through y = 0 in a time [m2/s]."""
    return 2*silo_flow(scene, degree, **mesh).flux(
        (0, 0), (scene.aperture/2, 0))


def round_rate(scene, degree=3, **options):
    """Volume that leaves a round silo through y = 0 in a time [m3/s]."""
    return 2*np.pi*silo_flow(scene, degree, axial=True, **options).flux(
        (0, 0), (scene.aperture/2, 0))


def silo_limit(scene, degree=4, depths=(1e-40, 1e-70, 1e-100), **mesh):
    """Rates for three depths of grading at the contact corners, whose
    logarithms are equal steps, and the limit that they tend to as a geometric
    series does; two rates where the depth does not tell."""
    rates = [silo_rate(scene, degree, contact=depth, **mesh)
             for depth in depths[:2]]
    first = rates[1] - rates[0]
    if abs(first) < 1e-6*abs(rates[1]):
        return rates, rates[1]
    rates.append(silo_rate(scene, degree, contact=depths[2], **mesh))
    second = rates[2] - rates[1]
    return rates, rates[2] + second**2/(first - second)
