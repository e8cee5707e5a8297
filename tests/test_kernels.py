"""Kernels alone: what gradients, halo exchange, velocities in a cell, averages
and corner exponents give on fields that are known."""

from math import pi

import numpy as np
import pytest

from cosserat.scenes.box import ONE, STILL, Annulus, add_points
from cosserat.wedge import exponents

SIDES = ("left", "right", "bottom", "top")

#: Walls that follow the fields of the box
EXACT = {side: ("exact", "exact") for side in SIDES}

#: Rows of a linear velocity without divergence
LINEAR = np.array([[0.3, 0.8], [-0.5, -0.3]])


def linear(x, y):
    """The velocity at places."""
    return LINEAR @ np.array([x, y])


def wavy(x, y):
    """Lines bent inside the box."""
    bump = 0.03*np.cos(pi*x)*np.cos(pi*y)
    return x + bump, y - 0.7*bump


MESHES = {"squares": {}, "sheared": {"shear": 0.5}, "wavy": {"warp": wavy},
          "triangles": {"triangles": True},
          "sheared, halved": {"shear": 0.5, "halved": lambda x, y: (
              np.abs(x) + np.abs(y - 0.1) < 0.3)},
          "halved": {"halved": lambda x, y: np.abs(x) + np.abs(y - 0.1) < 0.3},
          "honeycomb": {"honeycomb": True}}


def kernel(case, name, *options, ranks=1):
    """Rows that Test-kernels writes, of all ranks."""
    case.run("Test-kernels", name, *options, ranks=ranks)
    folders = [case.path] if ranks == 1 else sorted(
        case.path.glob("processor*"))
    return [[float(a) for a in line.split()] for folder in folders
            for line in (folder/name).read_text().splitlines()]


@pytest.mark.slow
@pytest.mark.parametrize("mesh, corners", [
    ("squares", 4), ("sheared", 4), ("triangles", 3)])
def test_corners_of_cells(box, mesh, corners):
    """In order, around the cell, counter-clockwise."""
    case = box(n=8, materials=ONE, **MESHES[mesh])
    rows = np.array(kernel(case, "cells"))
    assert (rows[:, 0] == corners).all()
    x, y = rows[:, 1::2].T, rows[:, 2::2].T
    found = 0.5*(x*np.roll(y, -1, axis=0) - y*np.roll(x, -1, axis=0)).sum(0)
    assert found == pytest.approx(case.volumes()/0.1, rel=1e-9)
    assert np.allclose([x.mean(0), y.mean(0)], case.centres()[:, :2].T)


@pytest.mark.slow
@pytest.mark.parametrize("ranks", [1, 2])
def test_halo_brings_the_other_side(box, ranks):
    """Cyclic sides, whole and cut by processors: values of the cell that is
    one to the left or to the right, around the ends."""
    case = box(n=8, cyclic=True, materials=ONE)
    case.decompose(ranks)
    rows = np.array(kernel(case, "halo", ranks=ranks))
    # Two cyclic sides; the cut through the middle has two as well
    assert len(rows) == 16*ranks
    x, y, s, v0, v1, *t = rows.T
    away = v0 - x
    assert np.allclose(np.abs(away), np.where(np.abs(x) > 0.4, 0.875, 0.125))
    assert np.allclose(v1, y)
    assert np.allclose(s, v0 + 10*v1)
    assert np.allclose(t, [v0*v0, v0*v1, v1*v0, v1*v1])


def test_halo_turns_what_comes_through_a_rotational_patch(tmp_path):
    """A quarter turn: vectors and tensors turn, scalars do not."""
    case = Annulus(tmp_path/"case", n=4, materials=ONE,
                   walls=dict.fromkeys(("left", "right"), STILL)).write()
    x, y, s, v0, v1, *t = np.array(kernel(case, "halo")).T
    # As the other side's cell is seen from here: mirrored in the end
    low = y < x
    assert low.any() and not low.all()
    assert np.allclose(v0, np.where(low, x, -x))
    assert np.allclose(v1, np.where(low, -y, y))
    assert np.allclose(t, [v0*v0, v0*v1, v1*v0, v1*v1])
    # What was sent, before the turn
    assert np.allclose(s, np.where(low, y + 10*x, y + 10*x))


@pytest.mark.parametrize("mesh, velocity", [
    ("squares", "conservativeLinear"), ("sheared", "conservativeLinear"),
    ("triangles", "conservativeLinear"), ("halved", "conservativeLinear"),
    ("sheared, halved", "conservativeLinear"),
    ("honeycomb", "conservativeLinear"), ("squares", "cellPoint"),
    ("sheared", "cellPoint")])
def test_linear_velocity_in_a_cell(box, mesh, velocity):
    """Exact everywhere but beside walls: the gradient that OpenFOAM gives takes
    the value of an oblique wall as if it were at the foot of the normal."""
    case = box(n=8, materials=ONE, walls=EXACT, U=linear,
               omega=lambda x, y: 0*x, **MESHES[mesh])
    add_points(case, "{ type all; material a; }", velocity=velocity)
    rows = np.array(kernel(
        case, "velocity", "-linear", "(0.3 0.8 -0.5 -0.3)"))
    if mesh == "sheared, halved":
        # Its cells of four edges are no parallelograms
        corners = np.array([len(polygon) for polygon in case.polygons()])
        rows = rows[corners[rows[:, 0].astype(int)] > 4]
    _, x, y, u, v, divergence, net = rows.T
    shear = MESHES[mesh].get("shear", 0)
    inner = (np.abs(y) < 0.24) & (np.abs(x - shear*y) < 0.24)
    assert inner.sum() > 50
    assert np.allclose(np.array([u, v])[:, inner], linear(x, y)[:, inner],
                       atol=1e-9)
    assert np.allclose(net, 0, atol=1e-9)
    if velocity == "conservativeLinear":
        # Whatever the gradient
        assert np.allclose(divergence, 0, atol=1e-6)


def test_velocity_of_fluxes_alone_is_not_linear(box):
    """faceFlux has u constant across y; it can fail."""
    case = box(n=4, materials=ONE, walls=EXACT, U=linear,
               omega=lambda x, y: 0*x)
    add_points(case, "{ type all; material a; }", velocity="faceFlux")
    _, x, y, u, *_ = np.array(kernel(
        case, "velocity", "-linear", "(0.3 0.8 -0.5 -0.3)")).T
    assert 0.05 < np.abs(u - linear(x, y)[0]).max() < 0.8/8 + 1e-9


@pytest.mark.parametrize("mesh", ["squares", "sheared", "triangles", "halved",
                                  "honeycomb"])
@pytest.mark.parametrize("velocity", ["conservativeLinear", "faceFlux"])
def test_divergence_in_a_cell_is_that_of_its_fluxes(box, mesh, velocity):
    """Everywhere in the cell, for a velocity that is not without one. (In
    quadrilaterals other than parallelograms, as beside the walls of the
    honeycomb, only their sum is.)"""
    case = box(n=4, materials=ONE, walls=EXACT, omega=lambda x, y: 0*x,
               U=lambda x, y: (np.sin(3*x + y), np.cos(2*x - y)),
               **MESHES[mesh])
    add_points(case, "{ type all; material a; }", velocity=velocity)
    rows = np.array(kernel(case, "velocity"))
    if mesh == "honeycomb":
        corners = np.array([len(polygon) for polygon in case.polygons()])
        rows = rows[corners[rows[:, 0].astype(int)] > 4]
    divergence, net = rows[:, 5:].T
    assert len(net) > 20 and np.ptp(net) > 1
    assert np.allclose(divergence, net, atol=1e-6)


@pytest.mark.parametrize("average", ["cellMean", "linearLeastSquares"])
def test_average_of_points(box, average):
    """Scattered points that carry a linear value: their mean, or the value at
    the centre of the cell."""
    case = box(n=6, materials=ONE)
    add_points(case, "{ type all; material a; }", average=average)
    cell, x, y, volume, found = np.array(kernel(case, "average")).T
    cell = cell.astype(int)
    n = np.bincount(cell)
    assert n.min() >= 6 and n.max() < 16 and len(set(n)) > 3
    value = x + 10*y
    mean = (np.bincount(cell, volume*value)/np.bincount(cell, volume))[cell]
    at_centre = (case.centres()[:, :2] @ [1, 10])[cell]
    assert np.abs(mean - at_centre).max() > 0.1
    expected = mean if average == "cellMean" else at_centre
    assert np.allclose(found, expected, atol=1e-9)


QUARTER, HALF = pi/2, pi

#: Sectors, do walls hold, exponents between 0.004 and 0.85. One material:
#: Moffatt (1964), sin(lambda a) = +-lambda sin(a) between walls that hold, the
#: multiples of pi/a less one between those that let slip, and
#: sin(2 lambda a) = lambda sin(2 a) where one does
CORNERS = {
    "step, no slip": ([(1.5*pi, 1, 0)], (True, True), [0.544484]),
    "plate, no slip": ([(2*pi, 1, 0)], (True, True), [0.5, 0.5]),
    "step, free slip": ([(1.5*pi, 1, 0)], (False, False), [1/3, 1/3]),
    "plate, one wall slips": ([(2*pi, 1, 0)], (True, False), [0.25, 0.5]),
    "silo": ([(QUARTER, 1, 0), (HALF, 1, 0), (1.5*pi, 1e-3, 0)],
             (False, False), None),
    "Cosserat below a fluid": ([(QUARTER, 1, 1), (1.5*pi, 4, 0)],
                               (False, False), None),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", CORNERS)
def test_exponents_of_corners(box, name):
    """Published ones, and those that singular values give in Python."""
    sectors, holds, expected = CORNERS[name]
    case = box(n=2, materials=ONE)
    text = " ".join(f"({' '.join(map(repr, map(float, s)))})" for s in sectors)
    words = " ".join("true" if h else "false" for h in holds)
    (case.path/"wedge").write_text(f"sectors ({text}); holds ({words});\n")
    found = sorted(row[0] for row in kernel(case, "corner"))
    python = sorted(a for a in exponents(sectors, holds)
                    if 0.004 < a < 0.85)[:2]
    assert found == pytest.approx(python, abs=1e-5)
    if expected:
        assert found == pytest.approx(expected, abs=1e-5)


def state(case):
    """Residuals of u0, u1, p, omega and gradients of the cells, as (n, 2, 2)
    with G_ij = u_j,i."""
    case.run("Test-operator", "-state", log=False)
    rows = np.loadtxt(case.path/"state")
    return rows[:, :4], rows[:, 4:].reshape(-1, 2, 2)


@pytest.mark.parametrize("mesh", MESHES)
def test_gradient_of_a_linear_velocity(box, mesh):
    """Exact in every cell, at walls too, and no residual."""
    turn = (LINEAR[1, 0] - LINEAR[0, 1])/2
    case = box(n=6, walls=EXACT, U=linear, omega=lambda x, y: turn + 0*x,
               materials={"a": {"eta": 3, "etaC": 5, "R": 0.2}},
               **MESHES[mesh])
    residual, gradient = state(case)
    assert np.allclose(gradient, LINEAR.T, atol=1e-11)
    assert np.abs(residual).max() < 1e-11


@pytest.mark.parametrize("mesh", ["squares", "sheared"])
def test_gradient_at_a_jump(box, mesh):
    """Two layers that are sheared, whose viscosities are 1 and 50: the
    gradient of each side is its own, and the traction leaves no residual."""
    eta = {"below": 1.0, "above": 50.0}
    case = box(n=6, walls=EXACT, fractions=lambda x, y: y < 0,
               U=lambda x, y: (y/np.where(y < 0, 1.0, 50.0), 0*y),
               omega=lambda x, y: 0*x, materials={
                   name: {"eta": value, "etaC": 0, "R": 0}
                   for name, value in eta.items()}, **MESHES[mesh])
    residual, gradient = state(case)
    y = case.centres()[:, 1]
    expected = np.zeros((len(y), 2, 2))
    expected[:, 1, 0] = 1/np.where(y < 0, 1.0, 50.0)
    assert np.allclose(gradient, expected, atol=1e-11)
    assert np.abs(residual).max() < 1e-10


@pytest.mark.parametrize("mesh", MESHES)
def test_rigid_rotation_at_a_jump(box, mesh):
    """Whatever the viscosities: no residual, and the gradient is the turn."""
    case = box(n=6, walls=EXACT, fractions=lambda x, y: abs(y) < 0.25,
               U=lambda x, y: (-y, x), omega=lambda x, y: 1 + 0*x,
               materials={"a": {"eta": 3, "etaC": 5, "R": 0.2},
                          "b": {"eta": 3000, "etaC": 20, "R": 0.4}},
               **MESHES[mesh])
    residual, gradient = state(case)
    assert np.allclose(gradient, [[0, 1], [-1, 0]], atol=1e-9)
    assert np.abs(residual).max() < 1e-9


def test_force_on_a_face(box):
    """A single cell that moves along x, in a fluid of eta at etaC = 0: across
    a face of squares, area over distance the thickness of 0.1 m, the force is
    2 eta times the change of u along the face's normal, and eta times that
    across it; neighbours get what it loses, and those at corners the part of
    the gradients that the cells share."""
    n, eta, depth = 7, 3.0, 0.1
    case = box(n=n, walls=EXACT, omega=lambda x, y: 0*x,
               materials={"a": {"eta": eta, "etaC": 0, "R": 0}},
               U=lambda x, y: (1.0*((abs(x) < 0.05) & (abs(y) < 0.05)), 0*y))
    residual, _ = state(case)
    force = residual[:, 0].reshape(n, n)
    m = n//2
    print(force/eta/depth)
    assert force.sum() == pytest.approx(0, abs=1e-12)
    assert np.allclose(force, force[::-1]) and np.allclose(force, force[:, ::-1])
    assert force[m, m + 1] == pytest.approx(2*eta*depth)
    assert force[m + 1, m] == pytest.approx(eta*depth)
    assert force[m, m] == pytest.approx(-6*eta*depth)
