"""Stiff bodies that turn in something soft: iterations of block multigrid, by
the rotations that it takes out (bodyRotations). In brackets those without."""

import numpy as np
import pytest

from cosserat.case import residuals
from cosserat.scenes.box import SIDES, STILL, Box


def disc(x, y, radius):
    """Cells of a disc."""
    return np.hypot(x - .1, y - .05) < radius


def square(x, y, left, right, low, high):
    """Cells of a rectangle."""
    return (left < x) & (x < right) & (low < y) & (y < high)


def one(x, y):
    """A block off the middle."""
    return square(x, y, -.25, .125, -.1, .3)


def corner(x, y):
    """Two that touch at a corner, which no face joins."""
    return square(x, y, -.25, 0, 0, .3) | square(x, y, 0, .3, -.3, 0)


def faces(x, y):
    """Two that touch along faces: one."""
    return square(x, y, -.25, 0, -.1, .3) | square(x, y, 0, .3, -.3, .1)


def gap(x, y):
    """Two with one cell between them."""
    return square(x, y, -.3, 0, -.1, .3) | square(x, y, 1/32, .3, -.3, .2)


def nested(x, y):
    """A stiff disc in a block of 5e-4 times its viscosity."""
    return np.where(disc(x, y, .15), 1, 5e-4*square(x, y, -.25, .3, -.2, .3))


def below(x, y):
    """A block in a fluid below something a thousand times softer."""
    return np.where(y > .25, 0,
                    np.where(square(x, y, -.25, .125, -.1, .1), 1, 1e-3))


def many(x, y):
    """A hundred discs."""
    return np.hypot((x + .5)*10 % 1 - .57, (y + .5)*10 % 1 - .45) < .33


def held(x, y):
    """A block that the bottom holds."""
    return square(x, y, -.25, .125, -1, -.1)


def across(x, y):
    """A block over the cyclic sides."""
    return square(np.abs(x), y, .3, 1, -.1, .3)


def scene(path, fractions, contrast, cosserat=True, n=32, tolerance=1e-6,
          **entries):
    """A case of heavy bodies, solved by block multigrid, not run yet."""
    def material(eta, rho):
        return {"eta": eta, "etaC": eta if cosserat else 0,
                "R": .1 if cosserat else 0, "rho": rho}

    case = Box(path, n=n, g=(0, -1, 0), tolerance=tolerance,
               fractions=fractions,
               materials={"body": material(contrast, 1),
                          "rest": material(1, 0)}, **entries).write()
    case.override("solution", creepingFlow="{ preconditioner"
                  " { block multigrid; } }")
    return case


def iterations(case, ranks=1):
    """Run; iterations of the first solve."""
    case.run("cosseratPicFoam", ranks=ranks)
    return residuals(case.log())[0][3]


@pytest.mark.slow
@pytest.mark.parametrize("fractions, contrast, cosserat, most", [
    (one, 1e3, True, 26),       # 25 (27)
    (one, 1e3, False, 27),      # 25 (29)
    (one, 1e6, True, 29),       # 27 (40)
    (one, 1e6, False, 31),      # 29 (41)
    (faces, 1e6, True, 40),     # 37 (50)
    (corner, 1e3, True, 33),    # 31 (38)
    (corner, 1e6, True, 36),    # 34 (58)
    (gap, 1e6, True, 43),       # 40 (66)
    (gap, 1e6, False, 40),      # 37 (64)
    (nested, 1e6, True, 34),    # 32 (42)
    (nested, 1e6, False, 36),   # 34 (45)
    (many, 1e3, True, 115),     # 104 (192)
])
def test_bodies_that_turn(tmp_path, fractions, contrast, cosserat, most):
    """Fewer than without their rotations."""
    case = scene(tmp_path/"case", fractions, contrast, cosserat)
    assert iterations(case) <= most


@pytest.mark.slow
def test_body_below_something_softer(tmp_path):
    """All that is stiffer than the softest does not turn, the block does: 39
    iterations (43)."""
    case = scene(tmp_path/"case", below, 1e6,
                 walls={side: STILL for side in SIDES})
    assert iterations(case) <= 41


@pytest.mark.slow
@pytest.mark.parametrize("fractions, most, entries", [
    (held, 28, {"walls": {side: STILL for side in SIDES}}),     # 26 (26)
    (across, 24, {"cyclic": True}),                             # 22 (22)
])
def test_bodies_that_do_not_turn(tmp_path, fractions, most, entries):
    """As many as without: a correction as if they were free would do harm."""
    assert iterations(scene(tmp_path/"case", fractions, 1e6,
                            **entries)) <= most


@pytest.mark.slow
@pytest.mark.parametrize("fractions", [one, nested])
def test_body_on_two_processors(tmp_path, fractions):
    """One body though each has a part of it: the same flow in as many
    iterations."""
    serial = scene(tmp_path/"serial", fractions, 1e4, tolerance=1e-9)
    parallel = scene(tmp_path/"parallel", fractions, 1e4, tolerance=1e-9)
    parallel.decompose(2, "simple", "(2 1 1)")
    expected = iterations(serial)
    assert iterations(parallel, ranks=2) <= expected + 2
    parallel.run("reconstructPar", "-latestTime")
    U = serial.field("U")
    assert np.abs(parallel.field("U") - U).max() < 1e-6*np.abs(U).max()
