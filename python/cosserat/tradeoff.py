"""Accuracy and cost of runs: settings that override those of a case,
values at the centres of another mesh, Richardson extrapolation, Pareto front."""

import re

import numpy as np
from scipy.spatial import cKDTree

#: Setting: the dictionary (short name of Case) and its entry there
SETTINGS = {
    "pointsPerCell": ("points", "seeding {{ pointsPerCell {}; }}"),
    "velocity": ("points", "velocity {};"),
    "integration": ("points", "integration {};"),
    "coupling": ("points", "coupling {};"),
    "average": ("points", "average {};"),
    "volumeCorrection": ("points", "volumeCorrection {};"),
    "viscosityAverage": ("materials", "viscosityAverage {};"),
    "tolerance": ("solution", "creepingFlow {{ tolerance {}; }}"),
    "nVcycles": ("solution", "creepingFlow {{ preconditioner {{"
                 " preconditioner GAMG; nVcycles {}; nPostSweeps 1;"
                 " nFinestSweeps 1; smoother GaussSeidel; }} }}"),
    "stabilisation": ("solution",
                      "creepingFlow {{ freeSurfaceStabilisation {}; }}"),
    "maxCo": ("control", "adjustTimeStep yes; maxCo {};"),
}


def override(case, files, **settings):
    """Add entries at the end of a case's dictionaries, where they prevail.

    files: short name: path in the case (cosserat.case.FILES); settings: of
    SETTINGS by name, others raise KeyError."""
    for name, value in settings.items():
        file, entry = SETTINGS[name]
        with (case.path/files[file]).open("a") as text:
            text.write(f"\n{entry.format(value)}\n")
    return case


def refine(case, factor):
    """Multiply the cells of every block of system/blockMeshDict, but not a
    direction of one cell; each stays at least one."""
    blocks = case.run("foamDictionary", "system/blockMeshDict", "-entry",
                      "blocks", "-value", log=False).stdout
    blocks = re.search(r"^\(.*", blocks, re.M | re.S)[0]

    def scaled(match):
        cells = [n if n == 1 else max(1, round(n*factor))
                 for n in map(int, match[2].split())]
        return f"{match[1]}({' '.join(map(str, cells))})"

    blocks, found = re.subn(
        r"(hex\s*\([\d\s]+\)\s*(?:\w+\s*)?)\(\s*(\d+\s+\d+\s+\d+)\s*\)",
        scaled, blocks)
    if not found:
        raise ValueError(f"no blocks in {case.path}/system/blockMeshDict")
    with (case.path/"system/blockMeshDict").open("a") as text:
        text.write(f"\nblocks {blocks.strip()};\n")


def at_points(centres, values, points, n=16):
    """Values at points, (points, columns), by cubics fitted to those of the
    n nearest cells: the values of cells are those of their centres, and means
    over coarser cells would differ from them as much as the scheme errs. A
    point that is a centre has the value there."""
    values = np.reshape(values, (len(values), -1))
    away, near = cKDTree(centres[:, :2]).query(points[:, :2], n)
    size = away[:, -1:]
    x, y = ((centres[near, i] - points[:, i, None])/size for i in (0, 1))
    terms = np.stack([x**i*y**j for i in range(4) for j in range(4 - i)],
                     axis=-1)
    # The nearest count most: few values are as smooth as a cubic
    counts = ((away/size)**2 + 1e-3)**-1.5
    weights = counts*np.linalg.pinv(
        counts[:, :, None]*terms, rcond=1e-6)[:, 0]
    weights[away[:, 0] < 1e-6*size[:, 0]] = np.eye(1, n)[0]
    return np.einsum("pn,pnc->pc", weights, values[near])


def distance(a, b):
    """Relative distance |a - b|/|b| in the Euclidean norm, zero where both
    are."""
    a, b = np.ravel(a), np.ravel(b)
    known = np.isfinite(a) & np.isfinite(b)
    miss = np.linalg.norm((a - b)[known])
    return float(miss/np.linalg.norm(b[known])) if miss > 0 else 0.0


def observed_order(coarse, middle, fine, ratio=2.0):
    """log(|middle - coarse|/|fine - middle|)/log(ratio) of results on three
    meshes: zero or less where the steps between them do not shrink; infinite
    where the second is nothing."""
    first, second = (
        float(np.linalg.norm(np.nan_to_num(np.asarray(a) - np.asarray(b))))
        for a, b in ((middle, coarse), (fine, middle)))
    if second == 0:
        return np.inf
    return float(np.log(max(first, 1e-300)/second)/np.log(ratio))


def verdict(order, orders=(1.0, 3.0)):
    """What an observed order says of an extrapolation within orders."""
    if order <= 0:
        return ("NO ERROR CAN BE GIVEN: the steps between the meshes do not"
                " shrink, so that they tell nothing of the limit")
    if order < orders[0]:
        return (f"A GUESS: the steps between the meshes shrink more slowly"
                f" than those of order {orders[0]:g}, which was taken")
    if order > orders[1]:
        return f"order {orders[1]:g} was taken, the highest of the scheme"
    return ""


def extrapolate(coarse, middle, fine, ratio=2.0, orders=(1.0, 3.0)):
    """Limit of results on three meshes, each finer by `ratio`, by Richardson:

        p = observed_order(), within orders
        limit = fine + (fine - middle)/(ratio^p - 1)

    Below order one results have not begun to converge, and the limit is but
    a guess. Returns limit, p and its uncertainty: what the extrapolation has
    added, |limit - fine|/|limit|."""
    coarse, middle, fine = (np.asarray(q, float)
                            for q in (coarse, middle, fine))
    order = float(np.clip(observed_order(coarse, middle, fine, ratio),
                          *orders))
    limit = fine + (fine - middle)/(ratio**order - 1)
    return limit, order, distance(fine, limit)


def front(costs, errors):
    """True for each run that no other beats in both cost and error; runs
    without an error (None) are never on the front."""
    return [error is not None and not any(
        other is not None and c <= cost and other <= error
        and (c < cost or other < error)
        for c, other in zip(costs, errors))
        for cost, error in zip(costs, errors)]
