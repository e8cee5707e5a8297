"""wallLoad: what the flow exerts on its walls. At rest they bear the weight;
of a flow they bear what its exact solution says."""

import numpy as np
import pytest

from cosserat import analytic
from cosserat.scenes.box import add_points
from cosserat.scenes.silo import COARSE

LIGHT = {"eta": 1, "etaC": 0, "R": 0, "rho": 3}
HEAVY = {"eta": 40, "etaC": 40, "R": 0.1, "rho": 7}
SIDES = ("left", "right", "bottom", "top")
DEPTH = 0.1

HELD = {side: ("type noSlip;", "type fixedValue; value uniform 0;")
        for side in SIDES}


def measure(case, entries="", name="load"):
    """Give a case the function object."""
    case.measure(name, "wallLoad", entries)


def last(case, file="wallLoad", name="load"):
    """Last row: force, normal part, tangential part, moment, couple."""
    row = case.table(name, f"{file}.dat")[-1]
    return row[1:4], row[4:7], row[7:10], row[10], row[11]


@pytest.mark.slow
@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("scene", ["one", "layers", "offset", "triangles"])
def test_walls_bear_the_weight_at_rest(box, scene, ranks):
    """Resultant, moment about a corner, and each wall by the formulas of
    hydrostatics; the parts add up."""
    options = {"n": 8, "g": (0, -2.5, 0), "tolerance": 1e-13, "walls": HELD,
               "materials": {"light": LIGHT}}
    mass = 3
    if scene == "layers":
        options["materials"] = {"heavy": HEAVY, "light": LIGHT}
        options["fractions"] = lambda x, y: y < -0.25
        mass = 0.25*7 + 0.75*3
    if scene == "offset":
        options["warp"] = lambda x, y: (x + 3e3, y - 2e4)
    if scene == "triangles":
        options["triangles"] = True
    case = box(**options)
    measure(case, "CofR (3000 0 0);" if scene == "offset" else "")
    case.decompose(ranks, n="(1 2 1)")
    case.run("cosseratPicFoam", ranks=ranks)

    weight = 2.5*mass*DEPTH
    force, normal, tangential, moment, couple = last(case)
    digits = 1e-8*weight
    assert abs(force[1] + weight) < digits
    assert abs(force[0]) < digits and abs(force[2]) < digits
    assert np.allclose(force, normal + tangential, atol=digits)
    assert np.abs(tangential).max() < digits
    assert abs(couple) < digits
    # About the middle of the box it has no arm
    arm = 2e4 if scene == "offset" else 1
    assert abs(moment) < 1e-8*arm*weight

    sides = [last(case, f"wallLoad_{side}")[0] for side in SIDES]
    assert np.allclose(sum(sides), force, atol=digits)
    # The level of p floats; what remains is its rise from top to bottom
    assert sides[2][1] + sides[3][1] == pytest.approx(-weight, abs=digits)
    assert sides[0][0] == pytest.approx(-sides[1][0], abs=digits)


def test_each_wall_of_a_vessel(box):
    """Open above at the pressure of 0: rho g h on the bottom, rho g h^2/2 on
    the sides, whose centre of pressure is at a third of their height."""
    walls = dict(HELD)
    walls["top"] = ("type zeroGradient;", "type zeroGradient;",
                    "type fixedValue; value uniform 3.75;")
    case = box(n=10, materials={"light": LIGHT}, g=(0, -2.5, 0), walls=walls,
               tolerance=1e-13)
    measure(case, "CofR (0.5 -0.5 0); patches (right);", "right")
    measure(case, 'patches ("(bottom|left)");')
    case.run("cosseratPicFoam")
    # p_rgh = p - rho g.x, so that p is 0 at y = 1/2
    gauge = 3.75 - 2.5*3*0.5
    assert gauge == 0
    force, normal, _, moment, _ = last(case, name="right")
    assert force[0] == pytest.approx(2.5*3/2*DEPTH, rel=1e-8)
    assert np.allclose(force, normal)
    # Faces have the pressure of their middle: (h - y) y summed over ten
    y = (np.arange(10) + 0.5)/10
    assert moment == pytest.approx(
        -(2.5*3*(1 - y)*y).sum()/10*DEPTH, rel=1e-8)
    assert last(case, "wallLoad_bottom")[0][1] == pytest.approx(
        -2.5*3*DEPTH, rel=1e-8)
    assert not (case.path/"postProcessing/load/0/wallLoad_top.dat").exists()


@pytest.mark.slow
@pytest.mark.parametrize("ranks", [1, 2])
def test_bins(box, ranks):
    """Of the pressure of depth on the walls of a closed box: a bin has the
    mean of its faces."""
    case = box(n=8, materials={"light": LIGHT}, g=(0, -2, 0), walls=HELD,
               tolerance=1e-13)
    measure(case, "patches (left right); bins { direction (0 -3 0); nBin 4; }")
    case.decompose(ranks, n="(1 2 1)")
    case.run("cosseratPicFoam", ranks=ranks)
    rows = np.loadtxt(case.path/"postProcessing/load/0/wallLoad_bins.dat")
    assert rows.shape == (4, 6)
    assert np.allclose(rows[:, 1], [-0.375, -0.125, 0.125, 0.375])
    assert np.allclose(rows[:, 2], 2*DEPTH/4)
    assert np.allclose(np.diff(rows[:, 3]), 6*0.25, rtol=1e-9)
    assert np.abs(rows[:, 4:]).max() < 1e-9


@pytest.mark.slow
def test_shear_layer(box):
    """Couette flow of a Cosserat layer between rough walls: shear traction and
    couple on either wall are those of the analytic solution."""
    eta, etaC, R = 2.0, 3.0, 0.2
    case = box(n=32, cyclic=True, tolerance=1e-12,
               materials={"a": {"eta": eta, "etaC": etaC, "R": R}},
               walls={"top": ("type fixedValue; value uniform (0.5 0 0);",
                              "type fixedValue; value uniform 0;"),
                      "bottom": ("type fixedValue; value uniform (-0.5 0 0);",
                                 "type fixedValue; value uniform 0;")})
    measure(case)
    case.run("cosseratPicFoam")
    exact = analytic.ShearLayer(
        analytic.Material(eta, etaC, R), 1, V=0.5, Omega=0)
    for side, sign in (("top", -1), ("bottom", 1)):
        force, _, tangential, _, couple = last(case, f"wallLoad_{side}")
        assert tangential[0] == pytest.approx(sign*exact.a*DEPTH, rel=5e-4)
        assert force[0] == tangential[0]
        assert couple == pytest.approx(-exact.couple_stress(0.5)*DEPTH,
                                       rel=5e-3)
    assert np.abs(last(case)[0][:2]).max() < 1e-9
    # Fields: traction on the faces, by area
    traction = case.patch_field("wallTraction", "top")
    assert np.allclose(traction[:, 0], -exact.a, rtol=5e-4)
    assert np.allclose(case.patch_field("wallCouple", "top"),
                       -exact.couple_stress(0.5), rtol=5e-3)


@pytest.mark.slow
@pytest.mark.parametrize("region, shear", [
    ("type disc; centre (0.1 0.1 0); radius 0.2;", 0.01),
    ("type box; min (-1 -0.1 -1); max (0.1 0.3 1);", 0.001),
    ("type disc; centre (-0.5 0.5 0); radius 0.7;", 0.001)])
def test_walls_bear_the_weight_of_a_flow(box, region, shear):
    """Without inertia they do so while a heavy body sinks, free or along a
    wall, by pressure and by shear."""
    case = box(n=16, materials={"heavy": HEAVY, "light": LIGHT}, walls=HELD,
               g=(0, -1, 0), tolerance=1e-11, fractions=lambda x, y: x < y)
    add_points(case, "{ type all; material light; } { material heavy; %s }"
               % region)
    measure(case)
    case.run("cosseratPicFoam", "-solveOnce")
    volume = case.cloud("volume", "0")
    mass = volume @ np.where(case.cloud("material", "0") == 0, 7, 3)
    force, _, tangential, _, _ = last(case)
    assert np.abs(case.field("U", "0")).max() > 1e-3
    assert abs(tangential[1]) > shear*mass
    assert force[1] == pytest.approx(-mass, rel=1e-8)
    assert abs(force[0]) < 1e-8*mass


@pytest.mark.slow
@pytest.mark.parametrize("ranks", [1, 2])
def test_silo(tutorial, ranks):
    """The tutorial's walls bear the weight of its fill, with the part of the
    re-entrant corners that is not of a single wall."""
    case = tutorial("silo", mesh=COARSE, solution={"tolerance": 1e-9})
    case.decompose(ranks, n="(1 2 1)")
    case.run("cosseratPicFoam", "-solveOnce", ranks=ranks)
    weight = 25*1e6*10*0.1
    force = last(case)[0]
    assert force[1] == pytest.approx(-weight, rel=1e-8)
    corners = last(case, "wallLoad_corners")[0]
    assert corners[1] < -0.01*weight
    walls = sum(last(case, f"wallLoad_{name}")[0]
                for name in ("siloWalls", "outerWalls"))
    assert np.allclose(walls + corners, force, atol=1e-8*weight)


@pytest.mark.slow
@pytest.mark.parametrize("entries, words", [
    ("patches (left wall);", ["patches", "wall", "left right bottom top"]),
    ("patches (frontAndBack);", ["frontAndBack", "neither empty"]),
    ("bins { direction (1 0 0); }", ["nBin"]),
    ("bins { direction (1 0 0); nBin 0; }", ["nBin", "1 or more"]),
    ("bins { direction (0 0 0); nBin 3; }", ["direction"]),
    ("bins { direction (1 0 0); nBin 3; cumulative yes; }", ["cumulative"]),
    ("patches (left); bins { direction (1 0 0); nBin 3; }", ["no length"])])
def test_mistakes(box, entries, words):
    """With what is allowed."""
    case = box(n=4, materials={"light": LIGHT}, g=(0, -1, 0))
    measure(case, entries)
    done = case.run("cosseratPicFoam", check=False)
    text = done.stdout[done.stdout.index("FOAM FATAL"):]
    assert done.returncode
    for word in words:
        assert word in text, text


@pytest.mark.slow
def test_times_already_written(box):
    """-postProcess gives the rows of the run."""
    case = box(n=8, materials={"light": LIGHT}, g=(0, -1, 0), walls=HELD)
    case.run("cosseratPicFoam")
    measure(case)
    case.run("cosseratPicFoam", "-postProcess", "-latestTime")
    assert last(case)[0][1] == pytest.approx(-3*DEPTH, rel=1e-8)
    assert (case.path/"1/wallTraction").is_file()
