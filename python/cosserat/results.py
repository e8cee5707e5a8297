"""What is measured in a case, and its errors."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

#: Depth of the meshes [m]
DEPTH = 0.1


@dataclass(frozen=True)
class Result:
    """value, and its error, where it has one: relative to a reference, where
    there is one."""

    value: float
    error: Optional[float] = None
    reference: Optional[float] = None


def against(value, reference):
    """Result of a plain number."""
    return Result(float(value), float(value/reference - 1), float(reference))


def l2(found, exact, where=True):
    """Result of a field: its error in L2, relative."""
    where = np.broadcast_to(where, found.shape)
    error = float(np.sqrt(((found - exact)[where]**2).sum()
                          / (exact[where]**2).sum()))
    return Result(error, error)


def at(case, field, x, y, cells):
    """Value at a point, bilinear between cell centres."""
    centres = case.centres()
    weight = np.clip(1 - cells*np.abs(centres[:, 0] - x), 0, 1)*np.clip(
        1 - cells*np.abs(centres[:, 1] - y), 0, 1)
    return weight @ field/weight.sum()


def power(case):
    """Power of the weight and of walls [W per m of depth]."""
    row = case.table("power", "powerBalance.dat")[0]
    return (row[1] + row[2])/DEPTH


def pressure_work(case):
    """Work of the discrete pressure over what gravity and walls supply, at
    each time: an error of the discretisation where B is infinite. (That all
    terms together balance is an identity of the discrete system.)"""
    _, gravity, walls, pressure, *_ = case.table("power", "powerBalance.dat").T
    return pressure/(gravity + walls)


def balance(case):
    """Integral of the field dissipation over the power supplied, less 1."""
    dissipated = case.field("dissipation") @ case.volumes()
    return float(dissipated/DEPTH/power(case) - 1)


def add_orders(rows, *keys):
    """Add to each row the order of convergence of its errors from the row
    before, on half its cells: orderU of errU; None in the first."""
    for coarse, fine in zip([None] + rows[:-1], rows):
        for key in keys:
            fine[f"order{key}"] = (
                float(np.log2(coarse[f"err{key}"]/fine[f"err{key}"]))
                if coarse else None)
