"""Material points: where they come from and where they go."""

import re

import numpy as np
import pytest

from cosserat.scenes.box import STILL, TURN, add_points
from cosserat.scenes.ring import ring


def rotating(box, target, scheme, steps, velocity="conservativeLinear"):
    """Distance by which points miss their start after one turn, rms, of
    those that do not meet the walls of the rotating box."""
    case = box(target, n=8, materials={"a": {"eta": 1, "etaC": 0, "R": 0}},
               walls=TURN, U=lambda x, y: (-y, x), omega=lambda x, y: 1 + 0*x)
    add_points(case, "{ type all; material a; }", integration=scheme,
               velocity=velocity, pointsPerCell=4, minPointsPerCell=0)
    case.substitute("system/controlDict", {
        "endTime": repr(2*np.pi), "deltaT": repr(2*np.pi/steps),
        "writeInterval": steps})
    case.run("cosseratPicFoam")
    last = case.cloud("positions")
    h = 1/16
    start = (np.floor(last/h) + 0.5)*h
    inner = np.hypot(*last[:, :2].T) < 0.35
    return np.sqrt(np.mean((last - start)[inner, :2]**2))


@pytest.mark.slow
@pytest.mark.parametrize("scheme, steps, order", [
    ("Euler", 400, 1), ("RK2", 48, 2), ("RK4", 48, 4)])
def test_order_of_integration(box, scheme, steps, order):
    """A turn in a rigid rotation, which every interpolation has exactly:
    halving the step divides the miss by 2 to the order. (In steps of more than
    a cell points take parts, all the more accurate.)"""
    misses = [rotating(box, f"s{n}", scheme, n) for n in (steps, 2*steps)]
    assert misses[1] < 0.02
    assert abs(np.log2(misses[0]/misses[1]) - order) < 0.25


@pytest.mark.parametrize("velocity", ["conservativeLinear", "cellPoint"])
def test_linear_velocity_is_exact(box, velocity):
    """Both second-order velocities have a linear field exactly, so RK4 turns
    the points back to 1e-5."""
    assert rotating(box, "turn", "RK4", 80, velocity) < 1e-5


def test_points_slide_along_oblique_walls(box):
    """A driven parallelogram in steps of some cells, with velocities that are
    not those of the fluxes: points end on walls and in acute corners, and all
    are there still."""
    case = box(n=8, shear=0.7, materials={"a": {"eta": 1, "etaC": 0, "R": 0}},
               walls={**{side: STILL for side in TURN},
                      "top": ("type fixedValue; value uniform (4 0 0);",
                              "type zeroGradient;")})
    add_points(case, "{ type all; material a; }", velocity="cellPoint",
               minPointsPerCell=0)
    case.substitute("system/controlDict", {
        "endTime": 1, "deltaT": 0.05, "writeInterval": 20})
    case.run("cosseratPicFoam")
    x, y = case.cloud("positions")[:, :2].T
    right, top = 0.5 - (x - 0.7*y), 0.5 - y
    assert right.min() > -1e-9 and top.min() > -1e-9
    free = (right > 1e-9) & (top > 1e-9)
    assert len(x) == 32*32 and 0 < (~free).sum() < 200


@pytest.mark.slow
@pytest.mark.parametrize("mesh", [
    {"triangles": True}, {"honeycomb": True},
    {"halved": lambda x, y: np.abs(x) + np.abs(y - 0.1) < 0.3}],
    ids=["triangles", "honeycomb", "halved"])
def test_linear_velocity_is_exact_on_polygons(tmp_path, mesh):
    """conservativeLinear is linear in triangles, hexagons and beside hanging
    nodes (measured: 6e-7; cellPoint has 2e-3 to 9e-3); faceFlux is not."""
    def miss(velocity):
        parameters = {"velocity": velocity, **mesh}
        start, chosen = ring(tmp_path/"start", "RK4", 1e-12, 1, **parameters)
        xy, _ = ring(tmp_path/velocity, "RK4", 1, 80, **parameters)
        return np.hypot(*(xy[chosen] - start[chosen]).T).max()

    assert miss("conservativeLinear") < 1e-5
    assert miss("faceFlux") > 1e-3


def test_first_order_velocity_is_not(box):
    """faceFlux alone keeps u constant across a cell in y: it misses."""
    assert rotating(box, "turn", "RK4", 80, "faceFlux") > 1e-3


@pytest.mark.slow
def test_points_stay_evenly_spread(box):
    """A driven cavity, 300 steps, no point added: the conservative velocity
    leaves no cell empty, interpolation of cell values does."""
    counts = {}
    for velocity in ("conservativeLinear", "cellPoint"):
        case = box(velocity, n=16, tolerance=1e-7,
                   materials={"a": {"eta": 1, "etaC": 0, "R": 0}},
                   walls={"left": STILL, "right": STILL, "bottom": STILL,
                          "top": ("type fixedValue; value uniform (1 0 0);",
                                  "type zeroGradient;")})
        add_points(case, "{ type all; material a; }", velocity=velocity,
                   minPointsPerCell=0)
        case.substitute("system/controlDict", {
            "endTime": 9, "deltaT": 0.03, "writeInterval": 300})
        case.run("cosseratPicFoam")
        xyz = case.cloud("positions")
        cells = np.floor((xyz[:, :2] + 0.5)*16).astype(int)
        counts[velocity] = np.bincount(
            (16*cells[:, 1] + cells[:, 0]).clip(0, 255), minlength=256)
        assert len(xyz) == 16*256
    # Measured: 7 to 38 with deviation 3.7, 0 to 87 with 6.8
    assert counts["conservativeLinear"].min() >= 5
    assert counts["conservativeLinear"].std() < 4.5
    assert counts["cellPoint"].min() == 0


@pytest.mark.slow
def test_regions_and_dye_decide_at_the_point(box):
    """Box, polygon, interface and surface regions; volumes to the point."""
    materials = {"a": {"eta": 1, "etaC": 0, "R": 0},
                 "b": {"eta": 1, "etaC": 0, "R": 0}}
    scenes = {
        "box": ("type box; min (-0.33 -0.5 -1); max (0.2 0.07 1);",
                lambda x, y: (x > -.33) & (x < .2) & (y < .07)),
        "polygon": ("type polygon; points ((-0.5 -0.5 0) (0.5 -0.5 0)"
                    " (0 0.41 0));",
                    lambda x, y: (y < .41 - 1.82*abs(x))),
        "interface": ("type belowInterface; along (1 0 0); up (0 1 0);"
                      " height polynomial ((0.1 0) (0.3 1));",
                      lambda x, y: y < 0.1 + 0.3*x),
        "surface": ('type surface; file "constant/triSurface/block.obj";',
                    lambda x, y: (abs(x) < .21) & (abs(y) < .31)),
    }
    for name, (region, inside) in scenes.items():
        case = box(name, n=8, materials=materials,
                   fractions=lambda x, y: 0*x)
        add_points(case, "{ type all; material a; } { material b; %s }" % region,
                   "{ type bands; material b; across (0 1 0); start -0.4;"
                   " width 0.1; period 0.2; }")
        surface = case.path/"constant/triSurface"
        surface.mkdir()
        corners = [(x, y, z) for z in (-1, 1) for y in (-.31, .31)
                   for x in (-.21, .21)]
        quads = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4),
                 (1, 5, 7, 3), (2, 4, 8, 6)]
        (surface/"block.obj").write_text(
            "".join("v %g %g %g\n" % c for c in corners)
            + "".join(f"f {a} {b} {c}\nf {a} {c} {d}\n"
                      for a, b, c, d in quads))
        case.run("cosseratPicFoam")
        xyz = case.cloud("positions")
        expected = inside(xyz[:, 0], xyz[:, 1])
        material = case.cloud("material")
        assert np.array_equal(material == 1, expected), name
        assert 0 < expected.sum() < len(xyz)
        band = np.floor((xyz[:, 1] + 0.4)/0.2)
        dyed = (xyz[:, 1] + 0.4 - 0.2*band < 0.1) & (band >= 0) & expected
        assert np.array_equal(case.cloud("dye"), np.where(dyed, band + 1, 0))
        volume = case.volumes()
        alpha = case.field("alpha.b")
        assert np.isclose((alpha*volume).sum(),
                          case.cloud("volume")[material == 1].sum(), rtol=1e-9)


@pytest.mark.slow
def test_mixture_rules(box):
    """Arithmetic, geometric and harmonic means in cells of mixed materials,
    for density and viscosity apart."""
    materials = {"a": {"eta": 1, "etaC": 0.5, "R": 0.1, "rho": 1},
                 "b": {"eta": 100, "etaC": 8, "R": 0.1, "rho": 4}}
    means = {"arithmetic": lambda a, x, y: a*x + (1 - a)*y,
             "geometric": lambda a, x, y: x**a*y**(1 - a),
             "harmonic": lambda a, x, y: 1/(a/x + (1 - a)/y)}
    for rule, mean in means.items():
        case = box(rule, n=4, materials=materials, average=rule,
                   fractions=lambda x, y: 0.5 + 0.8*x)
        case.measure("w", "writeObjects", "objects (rho eta etaC);"
                     " writeControl writeTime;", "utilityFunctionObjects")
        case.run("cosseratPicFoam")
        a = case.field("alpha.a", 0)
        assert np.allclose(case.field("eta"), mean(a, 1, 100), rtol=1e-12)
        assert np.allclose(case.field("etaC"), mean(a, 0.5, 8), rtol=1e-12)
        assert np.allclose(case.field("rho"), a + 4*(1 - a), rtol=1e-12)


def test_end_of_a_run(tutorial):
    """What the run spent, the Courant number it had, what balances."""
    case = tutorial("shearLayer", control={"endTime": 2e5,
                                           "writeInterval": 2e5})
    case.run("cosseratPicFoam")
    log = case.log()
    shares = re.search(r"Run: (\d+) steps, .* flow (\S+) %, output (\S+) %,"
                       r" points (\S+) %, averages (\S+) %\n", log)
    assert int(shares[1]) == log.count("\nTime = ")
    assert sum(map(float, shares.groups()[1:])) == pytest.approx(100, abs=1)
    courant = re.search(r"Largest Courant number (\S+)", log)
    # A step may be a little longer to end at a time that is written
    assert 0.45 < float(courant[1]) < 0.53
    power = re.search(r"supplied (\S+) W, dissipated (\S+) W, relative"
                      r" imbalance (\S+)\n\n?.*Run: ", log, re.S)
    assert abs(float(power[3])) < 1e-4 and float(power[2]) > 0
