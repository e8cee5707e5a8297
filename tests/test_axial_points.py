"""Material points on wedges.

Bounds: errors as measured, rounded up by a tenth.
"""

import re

import numpy as np
import pytest

from cosserat.analytic import Material
from cosserat.scenes.axial import AxialCase
from cosserat.scenes.axialFlows import (ALL, SLIP, STILL, conical, entries,
                                        narrowing_pipe, narrows,
                                        off_the_ways, points_sphere)
from cosserat.scenes.box import account, add_points

ONE = {"a": entries(Material(1.0, 1.0, 0.1))}

#: Rows of a linear velocity without divergence around the axis
LINEAR = np.array([[1.0, 0.0], [0.0, -0.5]])


def block(s, t):
    """A cylinder of length and radius 1."""
    return s, t


def kernel(case):
    """Rows that Test-kernels writes of the velocity of linear fluxes."""
    case.run("Test-kernels", "velocity", "-linear", "(1 0 0 -0.5)")
    return np.loadtxt(case.path/"velocity", unpack=True)


def drawn(path, **options):
    """A cylinder drawn out along its axis, at rest in no place."""
    given = (lambda x, y: LINEAR @ np.array([x, y]), *STILL[1:])
    case = AxialCase(path, block, (8, 8),
                     {side: given for side in ("left", "right", "top")}, ONE,
                     **options)
    x, y = case.middles()
    case.fill("U", LINEAR @ np.array([x, y]))
    return case


@pytest.mark.parametrize("velocity, bound", [
    ("conservativeLinear", 1e-9), ("faceFlux", 0.07)])
def test_linear_velocity(tmp_path, velocity, bound):
    """Exact with slopes, up to the axis: u = (x, -r/2)."""
    case = drawn(tmp_path)
    add_points(case, ALL, velocity=velocity)
    _, x, y, u, v, divergence, _ = kernel(case)
    assert y.min() < 0.02
    assert np.abs([u, v] - LINEAR @ np.array([x, y])).max() < bound
    assert np.abs(divergence).max() < 1e-6


@pytest.mark.parametrize("velocity", ["conservativeLinear", "faceFlux"])
def test_divergence_is_that_of_the_fluxes(tmp_path, velocity):
    """On triangles too, some of which touch the axis with a corner."""
    case = drawn(tmp_path, triangles=True)
    add_points(case, ALL, velocity=velocity)
    cells, _, y, *_, divergence, net = kernel(case)
    assert np.abs(net).max() > 1e-3
    # In the plane that of r U is even in a cell
    far = case.middles()[1][cells.astype(int)]
    assert np.abs(divergence*y - net*far).max() < 1e-6


def test_seeding_is_even_in_volume(tmp_path):
    """Points of a cell are of one volume, and evenly in r^2; so are those that
    quasi-random places are for, and the volume of a core is its own."""
    for n, far in ((16, 2e-3), (40, 0.05)):
        case = AxialCase(tmp_path/f"{n}", block, (4, 4), {"top": SLIP},
                         {**ONE, "b": ONE["a"]}, cyclic=True)
        add_points(case, ALL + """
            { type box; material b; min (-1 -1 -1); max (2 0.125 1); }""",
                   pointsPerCell=n)
        case.solve()
        places, volume = case.cloud("positions", "1"), case.cloud("volume", "1")
        assert volume.sum() == pytest.approx(case.volumes().sum(), rel=1e-12)
        rows = np.minimum((places[:, 1]*4).astype(int), 3)
        for row in range(4):
            r2 = places[rows == row, 1]**2
            a, b = row/4, (row + 1)/4
            assert r2.mean() == pytest.approx((a*a + b*b)/2, abs=far*b*b)
        if n == 16:
            core = volume[case.cloud("material", "1") == 1].sum()
            assert core == pytest.approx(volume.sum()/64, rel=1e-12)


def sunk(path, n, **mesh):
    """Points that have sunk in a cone."""
    case = conical(path, n, **mesh)
    case.run("cosseratPicFoam")
    return case


@pytest.mark.parametrize("mesh, bound, least", [
    ({}, (1.1e-3, 8e-4), 1.2), ({"triangles": True}, (1.7e-2, 7e-2), 1.5)])
def test_ways_in_a_cone(tmp_path, mesh, bound, least):
    """A sink in the tip, whose flow is known."""
    coarse, fine = (off_the_ways(sunk(tmp_path/f"{n}", n, **mesh))
                    for n in (8, 16))
    assert (fine < bound).all() and np.log2(coarse/fine)[0] > least


def test_ways_can_fail(tmp_path):
    """One per cent of the sink's strength shows."""
    case = sunk(tmp_path, 16)
    assert off_the_ways(case)[0] < 1.1e-3
    assert off_the_ways(case, C=1.01)[0] > 5e-3


def test_walk_and_tracking(tmp_path):
    """The walk over polygons and OpenFOAM's tracking move points alike."""
    cases = [narrowing_pipe(tmp_path/walk, 8, steps=60, planarWalk=walk)
             for walk in ("yes", "no")]
    places, others = (case.cloud("positions") for case in cases)
    assert len(places) == len(others)
    order, order2 = (np.lexsort((case.cloud("origProcId"),
                                 case.cloud("origId"))) for case in cases)
    assert np.abs(places[order] - others[order2]).max() < 1e-10


@pytest.mark.slow
@pytest.mark.parametrize("mesh", [{}, {"triangles": True}])
def test_even_after_a_thousand_steps(tmp_path, mesh):
    """Uniform flow through a narrowing pipe: the volume of points is even over
    the section to counting noise, none nears the axis or leaves it, and the
    books are exact."""
    case = narrowing_pipe(tmp_path, 8, steps=1000, **mesh)
    inside, volume_in, volume_out = (account(case)[i] for i in (1, 3, 7))
    volume = case.cloud("volume").sum()
    assert inside == pytest.approx(volume, rel=1e-9)
    seeded = case.volumes().sum()
    assert seeded + volume_in - volume_out == pytest.approx(volume, rel=1e-11)

    x, y, z = case.cloud("positions").T
    assert y.min() > 0 and np.abs(z).max() < 1e-12
    part = np.bincount((10*(y/narrows(x))**2).astype(int).clip(0, 9),
                       weights=case.cloud("volume"), minlength=10)
    assert np.abs(10*part/part.sum() - 1).max() < 0.03


@pytest.mark.parametrize("R, error", [(0.1, -0.0087), (1.0, -0.0025)])
def test_sphere_of_points(tmp_path, R, error):
    """Drag of a sphere that cuts cells, 8 a radius."""
    assert points_sphere(tmp_path, 8, R)["error"] == pytest.approx(
        error, abs=5e-4)


@pytest.mark.slow
@pytest.mark.parametrize("ranks", [1, 2])
def test_restart(tmp_path, ranks):
    """To the bit, in parts as well."""
    whole, case = (narrowing_pipe(tmp_path/name, 8, steps=8, run=False)
                   for name in ("whole", "case"))
    end = float(re.findall(r"endTime ([^;]*);", (
        whole.path/"system/controlDict").read_text())[-1])
    for each, ends in ((whole, [end]), (case, [end/2, end])):
        each.decompose(ranks)
        for last in ends:
            each.override("control", endTime=last, startFrom="latestTime",
                          writeInterval=4, writeFormat="binary")
            each.run("cosseratPicFoam", ranks=ranks)
        each.reconstruct()
    for name in ("positions", "volume", "origId"):
        assert (case.cloud(name) == whole.cloud(name)).all()
