"""Flow around an axis, on wedges.

Bounds: errors as measured, rounded up by a tenth.
"""

import re

import numpy as np
import pytest

from cosserat.analytic import (LayeredPipe, Material, PipeFlow, SphereFlow)
from cosserat.case import Case, RunError
from cosserat.references import ROUND_SILO, ROUND_SILO_YIELD
from cosserat.scenes import roundSilo
from cosserat.scenes.axial import AxialCase
from cosserat.scenes.axialFlows import (STILL, cone, core, entries,
                                        manufactured, pipe, sphere)
from cosserat.scenes.box import Box

ONE = {"a": entries(Material(1.0, 1.0, 0.1))}
HEAVY = {"a": entries(Material(1.0, 1.0, 0.1), rho=1)}


def block(s, t):
    """A cylinder of length and radius 1."""
    return s, t


def wavy(s, t):
    """The same with bent lines, the axis straight."""
    return (s + 0.06*np.sin(2*np.pi*t)*np.sin(np.pi*s),
            t + 0.06*np.sin(2*np.pi*s)*np.sin(np.pi*t))


def order(function, path, n, *arguments, key="errU", **options):
    """Order of an error from n to 2n cells, and the row of the latter."""
    coarse = function(path/f"{n}", n, *arguments, **options)
    fine = function(path/f"{2*n}", 2*n, *arguments, **options)
    return np.log2(coarse[key]/fine[key]), fine


def test_exact_values():
    """Rates over Poiseuille's and drags over Stokes' as derived apart."""
    media = [Material(1, 1, R) for R in (0.1, 0.3, 1)]
    assert [PipeFlow(m, 1, 1).over_poiseuille() for m in media] == (
        pytest.approx([0.82916294, 0.63875953, 0.51961255], abs=1e-8))
    assert [PipeFlow(m, 1, 1, True).rate() for m in media] == pytest.approx(
        [0.38566821, 0.34552119, 0.24058760], abs=1e-8)
    assert [SphereFlow(m, 1, 1).over_stokes() for m in media] == (
        pytest.approx([1.047619, 1.130435, 4/3], abs=1e-6))
    assert [SphereFlow(m, 1, 1, True).over_stokes() for m in media] == (
        pytest.approx([1.008264, 1.053254, 1.25], abs=1e-6))
    same = LayeredPipe(media[1], media[1], 0.4, 1, 1)
    r = np.linspace(0.01, 1, 9)
    assert same.u(r) == pytest.approx(PipeFlow(media[1], 1, 1).u(r), abs=1e-12)


@pytest.mark.parametrize("R, free, bounds", [
    (0.1, False, (5.1e-4, 1.6e-3)), (0.3, False, (1.8e-4, 1.6e-4)),
    (1, False, (8.8e-6, 6.3e-4)), (0.1, True, (1.5e-4, 5.2e-4)),
    (0.3, True, (2.0e-4, 3.9e-4)), (1, True, (5.7e-6, 1.3e-4))])
def test_pipe(tmp_path, R, free, bounds):
    """Profiles on 24 cells; the sum over cells of the rate is off by what
    the parabola's values in their middles are from its means."""
    row = pipe(tmp_path, 24, R, free=free)
    assert row["errU"] < bounds[0] and row["errOmega"] < bounds[1]
    assert abs(row["error"]) < 1.2e-3


def test_pipe_can_fail(tmp_path):
    """One per cent of the internal length shows."""
    exact, other = (PipeFlow(Material(1, 1, R), 1, 1).over_poiseuille()
                    for R in (0.3, 0.303))
    rate = pipe(tmp_path, 48, 0.3)["value"]
    assert abs(rate/exact - 1) < 2.7e-4 < 1e-3 < abs(rate/other - 1)


@pytest.mark.parametrize("free", [False, True])
def test_order_in_a_pipe(tmp_path, free):
    """Order two in velocity and microrotation, with the axis in the flow."""
    for key in ("errU", "errOmega"):
        found, _ = order(pipe, tmp_path/key, 24, 0.3, free=free, key=key)
        assert found > 1.5


@pytest.mark.parametrize("axis, radius, sense", [
    ("z", "x", 1), ("y", "x", -1), ("x", "z", -1)])
def test_any_axis(tutorial, axis, radius, sense):
    """The tutorial's pipe turned: the same flow, and omega about the normal of
    the plane, which is e_theta or the direction against it."""
    case = tutorial("pipe", materials={"R": 0.3})
    turns = {"z": "(0 0 1) (0 0 1)", "y": "(0 0 1) (0 1 0)",
             "x": "(1 0 0) (0 0 1)"}
    case.run("transformPoints", "-rotate", f"({turns[axis]})")
    along = np.array([c == axis for c in "xyz"])
    case.substitute("constant/g", {
        "value": f"({' '.join(str(int(c)) for c in along)})"})
    case.run("cosseratPicFoam")
    exact = PipeFlow(Material(1, 1, 0.3), 1, 1)
    r = np.abs(case.centres()[:, "xyz".index(radius)])
    assert case.field("U") @ along == pytest.approx(exact.u(r), abs=1e-4)
    assert case.field("omega") == pytest.approx(
        sense*exact.omega(r), abs=1e-4)


def test_core(tmp_path):
    """A core of another material, its surface on faces."""
    found, row = order(core, tmp_path, 12)
    assert row["errU"] < 2.1e-4 and row["errOmega"] < 1.2e-3
    assert found > 1.3


def test_coupling_of_thousand_times(tmp_path):
    """etaC far above eta, where the block is factorised."""
    row = pipe(tmp_path, 24, 0.1, etaC=10.0)
    assert row["errU"] < 1.1e-2 and row["errOmega"] < 5.3e-3


@pytest.mark.parametrize("R, free", [(0.1, False), (0.1, True), (1, False)])
def test_sphere(tmp_path, R, free):
    """Drag within half a per cent on 48 x 24 cells, velocity to order 2."""
    found, row = order(sphere, tmp_path, 12, R, free)
    assert abs(row["error"]) < 5e-3
    assert row["errU"] < 7.7e-4 and found > 1.9


def test_cone(tmp_path):
    """Free slip along a cone: velocity to order 2, no pressure."""
    found, row = order(cone, tmp_path, 12)
    assert row["errU"] < 8.9e-4 and found > 1.9
    assert row["error"] < 1.3e-3


@pytest.mark.parametrize("mesh, bounds", [
    ({}, (8.4e-3, 1.5e-2, 0.16)), ({"wavy": True}, (1.1e-2, 1.9e-2, 0.18)),
    ({"triangles": True}, (7.0e-3, 8.1e-3, 0.96))])
def test_manufactured(tmp_path, mesh, bounds):
    """Varying materials around the axis, all terms of the balances."""
    found, row = order(manufactured, tmp_path, 12, **mesh)
    assert found > 1.8
    for key, bound in zip(("errU", "errOmega", "errP"), bounds):
        assert row[key] < bound


def test_thin_ring(tmp_path):
    """Far from the axis a ring between walls is the layer of the plane."""
    far = AxialCase(tmp_path/"ring", lambda s, t: (0.1*s, 1e6 + t), (2, 24),
                    {"top": STILL, "bottom": STILL}, ONE, cyclic=True,
                    angle=0.001,
                    force=lambda x, y: np.array([1 + 0*x, 0*x]))
    wall = ("type noSlip;", "type fixedValue; value uniform 0;")
    plane = Box(tmp_path/"plane", n=24, materials=HEAVY,
                walls={"top": wall, "bottom": wall}, g=(1, 0, 0),
                cyclic=True, xmin=0.5 - 2/24).write()
    for case in (far, plane):
        case.run("cosseratPicFoam")
    for field in ("U", "omega"):
        a, b = far.field(field), plane.field(field)
        assert np.abs(a - b).max() < 1e-6*np.abs(b).max()


@pytest.mark.slow
def test_cut_cells(tmp_path):
    """So is a ring of two materials with a leaning surface through cells."""
    materials = {"a": {"eta": 1, "etaC": 1, "R": 0.1},
                 "b": {"eta": 30, "etaC": 30, "R": 0.1}}

    def part(x, y):
        return np.clip((0.33 + 0.3*x - y)*24 + 0.5, 0, 1)

    def push(x, y):
        return np.array([np.sin(3*y), np.cos(2*x)])

    far = AxialCase(
        tmp_path/"ring", lambda s, t: (s - 0.5, 1e6 + t - 0.5), (24, 24),
        {side: STILL for side in ("left", "right", "bottom", "top")},
        materials, average="layered",
        fractions=lambda x, y: part(x, y - 1e6),
        force=lambda x, y: push(x, y - 1e6))
    wall = ("type noSlip;", "type fixedValue; value uniform 0;")
    plane = Box(tmp_path/"plane", n=24, materials=materials, average="layered",
                walls=dict.fromkeys(("left", "right", "bottom", "top"), wall),
                fractions=part, force=push).write()
    for case in (far, plane):
        case.run("cosseratPicFoam")
    for field in ("U", "omega"):
        a, b = far.field(field), plane.field(field)
        assert np.abs(a - b).max() < 1e-6*np.abs(b).max()


def test_rest(tmp_path):
    """Two fluids one over the other in a closed cylinder are at rest, and its
    walls bear their weight, of the whole circle."""
    case = AxialCase(tmp_path, block, (16, 8),
                     {side: STILL for side in ("left", "right", "top")},
                     {**HEAVY, "b": {**HEAVY["a"], "rho": 2}},
                     fractions=lambda x, y: (x > 0.5)*1.0, g=(-1, 0, 0))
    case.run("cosseratPicFoam")
    assert np.abs(case.field("U")).max() < 1e-12
    load = case.table("load", "wallLoad.dat")[-1]
    assert load[1] == pytest.approx(-1.5*np.pi, rel=1e-10)
    assert load[2:4] == pytest.approx(0, abs=1e-12)


def test_uniform_dilation(tmp_path):
    """Stretched and thinned uniformly, with a finite bulk viscosity: the
    pressure is -B times the dilation, hoop strain included, and power as
    2 eta D:D + (B - eta) tr(D)^2."""
    stretch = (lambda x, y: np.array([x, -0.3*y]), "type zeroGradient;",
               "type zeroGradient;")
    case = AxialCase(tmp_path, block, (8, 8),
                     {side: stretch for side in ("left", "right", "top")},
                     {"a": {**ONE["a"], "B": 2}})
    case.run("cosseratPicFoam")
    assert case.field("p") == pytest.approx(-2*0.4, abs=1e-7)
    supplied = case.table("power", "powerBalance.dat")[-1][2]
    assert supplied == pytest.approx(
        np.pi*(2*(1 + 2*0.3**2) + 0.4**2), rel=1e-7)


def test_angle_does_not_matter(tmp_path):
    """Flow and numbers of the whole circle are those of any wedge."""
    rows, fields = [], []
    for angle in (1.0, 20.0):
        case = AxialCase(tmp_path/f"{angle}", wavy, (8, 8),
                         {"left": STILL, "top": STILL, "right": (
                             lambda x, y: np.array([0*x, y**2*(1 - y)]),
                             *STILL[1:])},
                         {"a": {**ONE["a"], "B": 3}}, angle=angle)
        case.run("cosseratPicFoam")
        fields.append(case.field("U"))
        rows.append(case.table("power", "powerBalance.dat")[-1][[2, 4, 5, 7]])
    assert np.abs(fields[0] - fields[1]).max() < 1e-8
    assert rows[0] == pytest.approx(rows[1], rel=1e-7)


def test_power_closes(tmp_path):
    """Supply is dissipation, and the integral over gradients nears it."""
    sphere(tmp_path, 24, 0.3)
    gravity, walls, pressure, viscous, bending, _, cells, _ = Case(
        tmp_path).table("power", "powerBalance.dat")[-1][1:]
    assert gravity == 0
    assert walls + pressure == pytest.approx(viscous + bending, rel=1e-8)
    assert cells == pytest.approx(viscous + bending, rel=1e-2)
    assert abs(pressure) < 1e-3*walls


def test_bingham_pipe(tmp_path):
    """Rate by Buckingham and Reiner, of a core that yields not at x = 0.4 of
    the radius."""
    case = AxialCase(tmp_path, lambda s, t: (0.2*s, t), (2, 24),
                     {"top": STILL}, {"a": {
                         "law": "bingham", "rho": 1,
                         "coeffs": "etaP 1; tauY 0.2; eps 1e-5; etaCRatio 0;"
                                   " regularisation BercovierEngelman; R 0;"
                                   " B infinite;"}},
                     cyclic=True, g=(1, 0, 0), tolerance=1e-8)
    case.run("cosseratPicFoam")
    rate = (case.volumes()*case.field("U")[:, 0]).sum()*case.to_circle/0.2
    x = 0.4
    assert rate == pytest.approx(np.pi/8*(1 - 4*x/3 + x**4/3), rel=1.1e-3)


@pytest.mark.parametrize("n, bound", [(0.5, 8.9e-3), (1.5, 2e-2)])
def test_power_law_in_a_cone(tmp_path, n, bound):
    """The strain around the axis is half of that along the way to the tip: the
    pressure by which a power law answers has it. Newton's method takes few
    steps."""
    found, row = order(cone, tmp_path, 12, power=n)
    assert row["errU"] < 8.9e-4 and found > 1.9
    assert row["errP"] < bound
    steps = re.search(r"Nonlinear: .* at most (\d+) in one",
                      Case(tmp_path/"24").log())
    assert int(steps[1]) < 20


@pytest.mark.slow
def test_round_silo_that_yields(tutorial):
    """Its rate at the start, by finite elements with the same small rate; far
    above that yield stress what is left of it goes with the small rate."""
    rates = [roundSilo.rate(roundSilo.yielding(
        tutorial("cylindricalSilo", f"{tauY:.0f}-{eps:.0f}"), 8, tauY, eps))
        for tauY, eps in ((1e6, 10.0), (2e7, 100.0), (2e7, 10.0))]
    assert rates[0]/ROUND_SILO_YIELD.value - 1 == pytest.approx(
        0.0885, abs=2e-3)
    assert rates[1] < 25 and rates[2] == pytest.approx(rates[1]/10, rel=0.02)


@pytest.mark.parametrize("change, words", [
    ({"g": (0, 0, -1)}, ["constant/g", "gravity along the axis"]),
    ({"B": 1}, ["materialProperties", "follows the flow", "B infinite"])])
def test_refused(tmp_path, change, words):
    """Gravity across the axis, and laws that follow a compressible flow."""
    law = {"law": "powerLaw", "rho": 1, "coeffs":
           f"K 1; n 0.5; eps 1e-3; etaCRatio 1; R 0.1; B {change.get('B', 1)};"}
    case = AxialCase(tmp_path, block, (4, 4),
                     {side: STILL for side in ("left", "right", "top")},
                     {"a": law} if "B" in change else HEAVY,
                     g=change.get("g", (-1, 0, 0)))
    with pytest.raises(RunError) as refused:
        case.run("cosseratPicFoam")
    for word in words:
        assert word in str(refused.value)


@pytest.mark.parametrize("cells, alpha, corners, error", [
    (8, 2/3, True, 0.0821), (8, 2/3, False, 0.232), (8, 0, True, 0.0425),
    pytest.param(16, 2/3, True, 0.0275, marks=pytest.mark.slow)])
def test_round_silo(tutorial, cells, alpha, corners, error):
    """Rate at the start against finite elements; the corners' resistance is that
    of the plane by the depth of the mesh there."""
    case = roundSilo.prepare(tutorial("cylindricalSilo"), cells, alpha, corners)
    case.run("cosseratPicFoam")
    found = roundSilo.rate(case)/ROUND_SILO[alpha].value - 1
    assert found == pytest.approx(error, abs=2e-3)
