"""Re-entrant corners: flows that are known beside them, and the silo."""

import re
from math import pi, radians

import numpy as np
import pytest

from cosserat.case import TUTORIALS, Case, residuals
from cosserat.scenes.corner import QUADS, TRIANGLES, WedgeCase
from cosserat.references import RELATIVES, SILO, SILO_SCENES
from cosserat.scenes.relatives import SCENES as RELATIVE_SCENES
from cosserat.scenes.relatives import RelativeCase, measure
from cosserat.scenes.silo import prepare, rate
from cosserat.wedge import exponents

SLIP, HOLD, MIXED = (False, False), (True, True), (True, False)

#: Ends of quarters, and the fill above a much softer slot
QUARTERS = [pi/2, pi, 3*pi/2]
START = [(1.0, 0.0), (1.0, 0.0), (1e-3, 0.0)]
COSSERAT = [(1.0, 1.0)]*3


@pytest.mark.parametrize("angle", [1.2*pi, 1.5*pi, 1.75*pi])
def test_exponents_of_free_slip(angle):
    """Between free-slip walls 1 - pi/angle and 2 pi/angle - 1."""
    found = exponents([(angle, 1.0, 0.0)])
    assert sorted(found)[:2] == pytest.approx(
        sorted([1 - pi/angle, 2*pi/angle - 1]), abs=1e-6)


def test_exponents_of_no_slip():
    """270 degrees between no-slip walls: sin(3 pi l/2) = +-l sin(3 pi/2)."""
    for found, sign in zip(exponents([(1.5*pi, 1.0, 0.0)], HOLD), (-1, 1)):
        assert np.sin(1.5*pi*found) == pytest.approx(
            sign*found*np.sin(1.5*pi), abs=1e-6)


#: Wedge: parameters, largest error on 16 cells with corners and without. The
#: flow is a singular solution, exact in all of the wedge
WEDGES = {
    "slip, around": ({"angles": QUARTERS}, 4.20e-4, 1.02e-2),
    "slip, through": ({"angles": QUARTERS, "mode": 1}, 1.00e-3, 1.00e-2),
    "turned": ({"angles": QUARTERS, "turn": 0.3}, 4.20e-4, 1.02e-2),
    "no slip": ({"angles": QUARTERS, "holds": HOLD}, 5.92e-4, 3.74e-3),
    "mixed": ({"angles": QUARTERS, "holds": MIXED}, 7.84e-4, 1.12e-2),
    "triangles": ({"angles": QUARTERS, "mesh": TRIANGLES}, 6.42e-4, 1.05e-2),
    "225 degrees": ({"angles": [radians(75*i) for i in (1, 2, 3)]},
                    7.25e-4, 1.42e-2),
    "315 degrees": ({"angles": [radians(78.75*i) for i in (1, 2, 3, 4)]},
                    2.26e-4, 1.70e-2),
    "plate": ({"angles": [pi/2*i for i in (1, 2, 3, 4)], "holds": HOLD},
              7.19e-4, 5.02e-3),
    "soft slot": ({"angles": QUARTERS, "media": START, "mode": 1},
                  1.44e-3, 4.69e-3),
    "Cosserat": ({"angles": QUARTERS, "media": COSSERAT}, 8.24e-4, 2.56e-2),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", WEDGES)
def test_wedge(tmp_path, name):
    """Not further from the exact flow than measured; without what is done
    about corners as far as the scheme of second order was."""
    parameters, measured, without = WEDGES[name]
    error = WedgeCase(tmp_path/"on", 16, **parameters).error()
    assert error < 1.02*measured
    off = WedgeCase(tmp_path/"off", 16, corners=False, **parameters).error()
    assert off == pytest.approx(without, rel=0.02)


#: Relative errors of the silo's rate on 8 cells an aperture, with corners and
#: without
RATES = {
    "one viscosity, 0": (-0.0112, 0.1688),
    "one viscosity, 2/3": (-0.0145, 0.2234),
    "start, 0": (0.0165, 0.1041),
    "start, 2/3": (0.0353, 0.1564),
    "filled, 0": (-0.0046, 0.2364),
    "filled, 2/3": (-0.0225, 0.4881),
    "rough, one viscosity, 2/3": (0.0111, 0.0813),
    "rough, 2/3": (0.0101, 0.1641),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", RATES)
def test_rate_of_the_silo(tmp_path, name):
    """The silo at rest against finite elements, by measured errors, which a
    per cent of the viscosity of the fill would double; at most 15 % more
    iterations."""
    iterations = {}
    for corners, error in zip((True, False), RATES[name]):
        case = prepare(Case.copy(TUTORIALS/"silo", tmp_path/f"{corners}"),
                       SILO_SCENES[name], 8, corners=corners)
        case.run("cosseratPicFoam")
        assert rate(case)/SILO[name].value - 1 == pytest.approx(
            error, abs=2e-3)
        iterations[corners] = residuals(case.log())[0][3]
    assert iterations[True] <= 1.15*iterations[False]


@pytest.mark.slow
def test_rate_can_fail(tmp_path):
    """One per cent of the viscosities shows in the rate."""
    name = "one viscosity, 2/3"
    case = prepare(Case.copy(TUTORIALS/"silo", tmp_path/"case"),
                   SILO_SCENES[name], 8)
    path = case.path/"constant/materialProperties"
    path.write_text(re.sub(r"(etaC? +1)000", r"\g<1>010", path.read_text()))
    case.run("cosseratPicFoam")
    assert abs(rate(case)/SILO[name].value - 1 - RATES[name][0]) > 5e-3


@pytest.mark.slow
@pytest.mark.parametrize("name, error", [
    ("slip starts", 4.8e-3), ("slip starts, Cosserat", -1.3e-3),
    ("plate 1/8, slip", -3.79e-2), ("plate 1/8, no slip", -8.9e-3)])
def test_relatives(tmp_path, name, error):
    """Where slip begins on a straight wall, and plates one cell thick, on 8
    cells against finite elements."""
    scene = RELATIVE_SCENES[name]
    case = RelativeCase(tmp_path/"case", scene, 8).write()
    case.run("cosseratPicFoam")
    flux = measure(case, scene, 8)["flux"]
    assert flux/RELATIVES[name, "flux"].value - 1 == pytest.approx(
        error, abs=1e-3)


@pytest.mark.slow
def test_factorised_matrix_has_corners(tmp_path):
    """By factorisation the same rate, in 29 iterations instead of 25."""
    iterations, rates = [], []
    for corners in (True, False):
        case = prepare(Case.copy(TUTORIALS/"silo", tmp_path/f"{corners}"),
                       SILO_SCENES["one viscosity, 2/3"], 4, corners=corners)
        path = case.path/"system/fvSolution"
        path.write_text(path.read_text().replace(
            "tolerance", "preconditioner { block direct; } tolerance", 1))
        case.run("cosseratPicFoam")
        rates.append(rate(case))
        iterations.append(residuals(case.log())[0][3])
    assert rates[0] < 0.8*rates[1]
    assert iterations[0] <= 29 and iterations[1] <= 25


@pytest.mark.slow
@pytest.mark.parametrize("mesh", [QUADS, TRIANGLES])
@pytest.mark.parametrize("media", [START, COSSERAT])
def test_rigid_rotation_of_the_walls(tmp_path, media, mesh):
    """Walls and far side that turn about a point as one: a residual of
    rounding for that flow, at a jump of the viscosity too."""
    case = WedgeCase(tmp_path/"case", 8, QUARTERS, media, HOLD, mesh=mesh)

    def listed(places):
        u, v = -2.0*(places[:, 1] - 0.3), 2.0*(places[:, 0] + 0.4)
        return (f"nonuniform List<vector> {len(u)} ("
                + " ".join(f"({a!r} {b!r} 0)"
                           for a, b in zip(u.tolist(), v.tolist())) + ")")

    patches = "\n".join(
        f"{name} {{ type fixedValue; value {listed(case.patch_centres(name))}; }}"
        for name in ("first", "second", "far"))
    inside = listed(case.centres())
    for name, cls, dims, internal, walls in (
            ("U", "volVectorField", "[0 1 -1 0 0 0 0]", inside, patches),
            ("omega", "volScalarField", "[0 0 -1 0 0 0 0]", "uniform 2",
             '"(first|second|far)" { type fixedValue; value uniform 2; }')):
        case.write(f"0/{name}", cls, f"""
dimensions {dims}; internalField {internal};
boundaryField {{ {walls} frontAndBack {{ type empty; }} }}
""")
    case.run("cosseratPicFoam")
    assert max(row[1] for row in residuals(case.log())) < 1e-13


def test_wrong_word_is_refused(tmp_path):
    """Entry corners: automatic or off."""
    case = prepare(Case.copy(TUTORIALS/"silo", tmp_path/"case"),
                   SILO_SCENES["start, 0"], 4)
    case.substitute("system/fvSolution", {"tolerance": "1e-6; corners on"})
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode == 1
    assert "Entry 'corners' is on" in done.stdout
    assert "Allowed: automatic, off" in done.stdout
