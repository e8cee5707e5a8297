"""Shear layer and gravity channel against their analytic solutions.

Bounds: errors of equation 30 on 24 cells as measured, rounded up by a third;
the issue asks for 2e-4 in u and 2e-3 in omega.
"""

import numpy as np
import pytest

from cosserat.analytic import (GravityChannel, Material, ShearLayer, err,
                               granular_contact)
from cosserat.case import residuals
from cosserat.scenes import longShear

ETA, ETAC, _ = granular_contact(0, 4, 1e11, 1e11)
MATERIAL = Material(ETA, ETAC, 0.3)
VALUES = {"V": 1e-6, "sigma": 6.3661977e4, "Omega": 0, "mu": 6.3661977e3}

#: case: (velocity, rotation, bound of u, bound of omega)
SHEAR = {
    "OmegaV": ("V", "Omega", 1.6e-5, 1.8e-4),
    "OmegaSigma": ("sigma", "Omega", 7.0e-5, 2.6e-4),
    "muV": ("V", "mu", 2.3e-6, 1.5e-5),
    "muSigma": ("sigma", "mu", 2.0e-5, 6.4e-5),
}


def errors(case, exact):
    """Err of u and omega at the last time."""
    y = case.centres()[:, 1]
    return (err(exact.u(y), case.field("U")[:, 0]),
            err(exact.omega(y), case.field("omega")))


def shear_layer(tutorial, name, n, **changes):
    """Errors of a shear layer without points."""
    velocity, rotation, *_ = SHEAR[name]
    case = tutorial(
        "shearLayer", f"{name}{n}{len(changes)}", mesh={"n": n},
        walls={"velocity": velocity, "rotation": rotation},
        solution={"tolerance": 1e-10},
        control={"endTime": 1, "deltaT": 1, "adjustTimeStep": "no",
                 "writeInterval": 1}, **changes)
    (case.path/"constant/materialPointsProperties").unlink()
    case.run("cosseratPicFoam")
    exact = ShearLayer(MATERIAL, 1, **{name: VALUES[name] for name in
                                       (velocity, rotation)})
    return errors(case, exact), case


@pytest.mark.slow
@pytest.mark.parametrize("name", SHEAR)
def test_shear_layer(tutorial, name):
    """Error on 24 cells; 48 divide it by 3.7 at least."""
    bound_u, bound_omega = SHEAR[name][2:]
    (u, omega), case = shear_layer(tutorial, name, 24)
    assert u < bound_u and omega < bound_omega
    assert residuals(case.log())[0][3] <= 40

    (u48, omega48), _ = shear_layer(tutorial, name, 48)
    assert u/u48 > 3.7 and omega/omega48 > 3.7


@pytest.mark.parametrize("name", SHEAR)
def test_shear_layer_can_fail(tutorial, name):
    """One per cent of a modulus shows: 1.01 k eta_m changes etaC and eta."""
    (u, omega), _ = shear_layer(tutorial, name, 24,
                                materials={"eta_m": 1.01e11})
    assert u > 3*SHEAR[name][2] or omega > 3*SHEAR[name][3]


@pytest.mark.slow
def test_gravity_channel(tutorial):
    """Error on 24 cells; halving cells divides it by 3.7 at least. The error
    of u changes its sign just below 24 cells (2.3e-6 there, 9.4e-7 at 48), so
    its order is taken from 48 to 96."""
    found = {}
    for n in (24, 48, 96):
        case = tutorial("gravityChannel", f"n{n}", mesh={"n": n},
                        solution={"tolerance": 1e-10})
        case.run("cosseratPicFoam")
        found[n] = errors(case, GravityChannel(MATERIAL, 1, 2e4))
    assert found[24][0] < 3.1e-6 and found[24][1] < 1.6e-4
    assert found[48][0]/found[96][0] > 3.7
    assert found[24][1]/found[48][1] > 3.7
    assert found[48][1]/found[96][1] > 3.7


def test_gravity_channel_can_fail(tutorial):
    """One per cent of the internal length shows."""
    case = tutorial("gravityChannel", materials={"R": 0.303})
    case.run("cosseratPicFoam")
    u, omega = errors(case, GravityChannel(MATERIAL, 1, 2e4))
    assert u > 3*3.1e-6 and omega > 3*1.6e-4


@pytest.mark.slow
def test_bands_stay_straight_and_odd(tmp_path):
    """A hundred of the thousand steps of the study: errors, bands and points
    a cell as at the first step."""
    first, last = longShear.run(tmp_path/"case", [1, 100])
    assert last["shear"] > 5
    for key in ("errU", "errOmega"):
        assert abs(last[key]/first[key] - 1) < 1e-6
    assert (first["bands"], last["bands"]) == (1, 5)
    assert last["asymmetry"] < 1e-8
    assert last["bandError"] < 2.7e-3
    assert last["minPoints"] == last["maxPoints"] == 36
    assert last["added"] == 0


@pytest.mark.slow
def test_gravity_channel_on_a_graded_mesh(tutorial):
    """Cells four times smaller at the walls than in the middle: order 2."""
    found = []
    for n in (24, 48):
        case = tutorial("gravityChannel", f"n{n}", mesh={"n": n},
                        solution={"tolerance": 1e-10})
        mesh = case.path/"system/blockMeshDict"
        mesh.write_text(mesh.read_text().replace(
            "simpleGrading (1 1 1)",
            "simpleGrading (1 ((0.5 0.5 4) (0.5 0.5 0.25)) 1)"))
        case.run("blockMesh")
        case.run("cosseratPicFoam")
        found.append(errors(case, GravityChannel(MATERIAL, 1, 2e4)))
    assert found[0][0] < 4.5e-3 and found[0][1] < 4.5e-3
    assert found[0][0]/found[1][0] > 3.7 and found[0][1]/found[1][1] > 3.7


@pytest.mark.parametrize("n", [16, 32])
def test_finite_bulk_viscosity(box, n):
    """A column that settles under its weight between free-slip walls:
    (B + eta) v,yy = rho g, so v = -rho g (1/4 - y^2)/(2 (B + eta))."""
    eta, B = 3, 5
    case = box(n=n, g=(0, -1, 0), tolerance=1e-10,
               materials={"a": {"eta": eta, "etaC": 1, "R": 0.2, "B": B,
                                "rho": 2}})
    case.run("cosseratPicFoam")
    y = case.centres()[:, 1]
    v = case.field("U")[:, 1]
    exact = -2*(0.25 - y**2)/(2*(B + eta))
    assert np.abs(case.field("U")[:, 0]).max() < 1e-8
    assert err(exact, v) < 2.0/n**2
    # p = -B div U
    assert np.allclose(case.field("p"), -B*2*y*2/(2*(B + eta)),
                       atol=0.02*32/n)
