"""The round silo at rest: cases of the tutorial cylindricalSilo, and their
rate."""

import numpy as np

from cosserat.case import FILES
from cosserat.scenes.silo import mesh_entries, solve_once
from cosserat.scenes.siloYield import give_yield


def round_mesh(cells):
    """Entries of its blockMeshDict for a number of cells a unit length."""
    return mesh_entries(cells) | {"nAperture": max(round(cells/2), 1)}


def prepare(case, cells, alpha=2/3, corners=True):
    """Make a copy of the tutorial one solve of its start, meshed."""
    case.substitute(FILES["mesh"], round_mesh(cells))
    solve_once(case, alpha, corners)
    case.run("blockMesh")
    return case


def yielding(case, cells, tauY, eps):
    """Solve the start of a copy of the tutorial whose fill yields at tauY [Pa]."""
    give_yield(case, tauY, eps)
    prepare(case, cells).run("cosseratPicFoam")
    return case


def rate(case):
    """Volume that leaves through the aperture, y = 0, in a time [m3/s], of the
    whole circle, by the fluxes of the last time."""
    points, phi = case.mesh_points(), case.field("phi")
    faces = [points[face] for face in case.mesh_file("faces").faces()[:len(phi)]]
    through = [np.abs(face[:, 1]).max() < 1e-9 and face[:, 0].max() < 0.5 + 1e-6
               for face in faces]
    corner = next(face[-1] for face, here in zip(faces, through) if here)
    # All are between the same rows, and their normals alike
    angle = 2*np.abs(corner[2])/corner[0]
    return float(np.abs(phi[through].sum())*2*np.pi/angle)
