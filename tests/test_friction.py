"""Frictional walls: exact loads, Janssen's pressure, and what is refused."""

import numpy as np
import pytest

from cosserat import yielding
from cosserat.finiteElements.janssen import plug_pressures
from cosserat.scenes import plug
from cosserat.scenes.axial import AxialCase
from cosserat.scenes.box import Box
from cosserat.scenes.yielding import entries

#: Shear layer of unit height and viscosity, whose top may slide; no load in y
STILL = ("type noSlip;", "type zeroGradient;", "type zeroGradient;")
FREE = {"type": "coulombFriction", "mu": 0, "slipVelocity": 1e-3,
        "value": "uniform (0 0 0)"}
ROLL = {"type": "rollingFriction", "mu": 0.3, "slipRate": 1e-7,
        "value": "uniform 0"}


def loads(case, patch):
    """Force [N] on a patch and couple [N m] at the end."""
    row = case.table("load", f"wallLoad_{patch}.dat")[-1]
    return row[1:4], row[11]


def slid(path, adhesion, V=1.0, **box):
    """Shear stress and speed at the top of a layer, below a plate of speed V
    that holds it by adhesion."""
    top = entries({**FREE, "adhesion": adhesion,
                   "velocity": f"uniform ({V} 0 0)"})
    case = Box(path, n=4, materials={"a": {"eta": 1, "etaC": 0, "R": 0}},
               cyclic=True, walls={"bottom": STILL,
                                   "top": (top, "type zeroGradient;")},
               **box).write().measure("load", "wallLoad")
    case.run("cosseratPicFoam")
    return -loads(case, "top")[0][0]/0.1, case.patch_field("U", "top")[:, 0]


@pytest.mark.parametrize("adhesion", [0.5, 0.99, 2])
def test_a_plate_that_holds_or_slips(tmp_path, adhesion):
    """The stress is that of the law at the slip that the layer leaves: below
    the adhesion it sticks, above it slips at it."""
    stress, speed = slid(tmp_path/"case", adhesion)
    slip = 1 - stress
    assert np.abs(speed - stress).max() < 1e-9
    law = adhesion*slip/np.hypot(slip, FREE["slipVelocity"])
    assert abs(stress/law - 1) < 1e-6
    assert abs(stress/min(adhesion, 1) - 1) < 6e-3


@pytest.mark.slow
def test_a_plate_is_the_same_on_a_sheared_mesh(tmp_path):
    """Where the speed of the wall follows the gradient of its cell."""
    assert abs(slid(tmp_path/"case", 0.5, shear=0.4)[0]
               / slid(tmp_path/"square", 0.5)[0] - 1) < 1e-9


@pytest.mark.slow
def test_janssen(tmp_path):
    """Pressures of a plug that slides along both walls; walls and bottom bear
    its weight; each wall bears mu of its normal load."""
    case = plug.Plug(tmp_path/"case").write()
    did = plug.solve(case)
    assert did["nonlinear"] <= 7
    assert did["residuals"][-1] < 1e-2*did["residuals"][-2]

    depth = -case.centres()[:, 1]
    p = case.field("p")/yielding.janssen(depth, 0.3)
    assert np.abs(p[depth > 1] - 1).max() < 2e-4
    whole = sum(loads(case, side)[0] for side in ("left", "right", "bottom"))
    assert abs(whole[1]/0.5 + 1) < 1e-8
    for side in ("left", "right"):
        force = loads(case, side)[0]
        assert abs(abs(force[1]/force[0])/0.3 - 1) < 1e-6

    power = case.table("power", "powerBalance.dat")[-1]
    assert abs(power[-1]/power[2] - 1) < 1e-3
    assert abs(power[6]) < 1e-6


@pytest.mark.slow
def test_plug_resolved_across(tmp_path):
    """Mean pressures, up to 2 % above Janssen's, are those of finite elements
    that bear the same friction on the wall."""
    case = plug.Plug(tmp_path/"case", n=8, down=40).write()
    plug.solve(case)
    y, level = np.unique(np.round(case.centres()[:, 1], 9),
                         return_inverse=True)
    mean = np.bincount(level, case.field("p"))/np.bincount(level)
    z, exact, _ = plug_pressures(0.3)
    inner = (z > 0.5) & (z < 4)
    error = np.interp(-z, y, mean)/exact - 1
    assert np.abs(error[inner]).max() < 3e-3
    assert (exact/yielding.janssen(z, 0.3))[inner].max() > 1.015


@pytest.mark.parametrize("mu, bound", [(0.3, 2.2e-2), (0.03, 2.6e-4)])
def test_janssen_in_a_round_bin(tmp_path, mu, bound):
    """As between planes, one cell from the axis to the wall: walls and bottom bear
    the weight. The pressure is Janssen's, which has one pressure at a depth, but
    for the square of mu: it falls towards the wall."""
    depth = 1.5/mu
    friction = {"type": "coulombFriction", "mu": mu, "adhesion": 0,
                "slipVelocity": plug.CREEP, "velocity": "uniform (1 0 0)",
                "value": "uniform (0 0 0)"}
    case = AxialCase(
        tmp_path/"case", lambda s, t: (depth*(s - 1), t), (100, 1), {
            "top": (entries(friction), *2*["type zeroGradient;"]),
            "left": STILL, "right": (
                "type zeroGradient;", "type prghPressure; p uniform 0;",
                "type zeroGradient;")},
        {"a": {"eta": 1e3, "etaC": 0, "R": 0, "rho": 1}}, g=(-1, 0, 0))
    case.run("cosseratPicFoam")
    z = -case.middles()[0]
    p = case.field("p")/yielding.janssen(z, mu)
    assert np.abs(p - 1)[z > 0.2*depth].max() < bound
    whole = sum(loads(case, side)[0][0] for side in ("top", "left"))
    assert abs(whole/(np.pi*depth) + 1) < 1e-8


@pytest.mark.slow
@pytest.mark.parametrize("length, rolls", [(1e-3, True), (10, False)])
def test_grains_roll_or_do_not(tmp_path, length, rolls):
    """Walls bear a couple up to length mu N, and otherwise are rough."""
    sides = {}
    for name, omega in (("rolling", entries({**ROLL, "length": length})),
                        ("rough", "type fixedValue; value uniform 0;")):
        case = plug.Plug(tmp_path/name, n=16, down=40, depth=2, eta=1,
                         material={"etaC": 1, "R": 0.2}, omega=omega).write()
        plug.solve(case)
        sides[name] = loads(case, "left")
    (force, couple), rough = sides["rolling"], sides["rough"][1]
    if rolls:
        # Reduced as docs/discretisation.md, (17), has it
        most = 0.3*length*abs(force[0])/(1 + 4*5/12/(0.08*32**2))
        assert abs(abs(couple)/most - 1) < 5e-3
        assert abs(couple) < 0.02*abs(rough)
    else:
        assert abs(couple/rough - 1) < 1e-2


@pytest.mark.slow
def test_parts_of_a_mesh(tmp_path):
    """On two ranks the steps and the pressures are those of one."""
    runs = []
    for ranks in (1, 2):
        case = plug.Plug(tmp_path/f"on{ranks}", n=4, down=20).write()
        did = plug.solve(case, ranks, n="(1 2 1)")
        runs.append((case.field("p"), did["nonlinear"]))
    assert np.abs(runs[0][0] - runs[1][0]).max() < 1e-8
    assert runs[0][1] == runs[1][1]


def test_a_body_without_a_level_of_pressure_is_refused(tmp_path):
    """Friction that follows the pressure needs one."""
    top = entries({**FREE, "mu": 0.3, "adhesion": 1})
    case = Box(tmp_path/"case", n=4, materials={
        "a": {"eta": 1, "etaC": 0, "R": 0}}, walls={
            "bottom": STILL, "top": (top, "type zeroGradient;")}).write()
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode and "a patch with given p_rgh" in done.stdout


@pytest.mark.parametrize("entry, value", [
    ("mu", -0.1), ("adhesion", -1), ("slipVelocity", 0)])
def test_wrong_constants_are_refused(tmp_path, entry, value):
    """By the entry."""
    top = entries({**FREE, "adhesion": 1, entry: value})
    case = Box(tmp_path/"case", n=4, materials={
        "a": {"eta": 1, "etaC": 0, "R": 0}}, walls={
            "bottom": STILL, "top": (top, "type zeroGradient;")}).write()
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode and f"'{entry}'" in done.stdout
