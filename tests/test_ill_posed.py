"""Scenes that have no solution, or more than one, are named before anything
is solved."""

import re

import numpy as np
import pytest

from cosserat.scenes.box import Annulus

HEAVY = {"a": {"eta": 1, "etaC": 1, "R": 0.1, "rho": 2}}

STILL = ("type noSlip;", "type zeroGradient;")

SLIP = ("type slip;", "type zeroGradient;")


def opening(p):
    """No viscous traction, and p_rgh."""
    return ("type zeroGradient;", "type zeroGradient;",
            f"type fixedValue; value uniform {p};")


def through(u):
    """A velocity that is given."""
    return (f"type fixedValue; value uniform ({u} 0 0);", "type zeroGradient;")


UNGIVEN = ("type zeroGradient;", "type zeroGradient;", "type zeroGradient;")

FLUX = ("type zeroGradient;", "type zeroGradient;",
        "type fixedFluxPressure; value uniform 0;")

AIR = ("type zeroGradient;", "type zeroGradient;",
       "type prghPressure; p uniform 0; value uniform 0;")

#: name: (walls, gravity, words of the message)
SCENES = {
    "an outlet without a pressure": (
        {"left": through(1), "right": UNGIVEN, "top": STILL}, (0, 0, 0),
        ["0/p_rgh.boundaryField.right", "zeroGradient", "prghPressure"]),
    "another": (
        {"left": opening(1), "right": FLUX, "top": STILL}, (0, 0, 0),
        ["0/p_rgh.boundaryField.right", "fixedFluxPressure", "zeroGradient"]),
    "a pressure where the velocity is given": (
        {"left": (*through(1), "type fixedValue; value uniform 0;"),
         "right": opening(0)}, (0, 0, 0),
        ["0/p_rgh.boundaryField.left", "fixedValue", "velocity is given"]),
    "a pressure at a wall": (
        {"top": (*STILL, AIR[2]), "right": opening(0)}, (0, -1, 0),
        ["0/p_rgh.boundaryField.top", "prghPressure", "noSlip"]),
    "inflow without an outlet": (
        {"left": through(1), "top": STILL}, (0, 0, 0),
        ["net, with speeds that could bring", "closed and incompressible"]),
    "outflow without an inlet": (
        {"right": through(0.5), "top": STILL}, (0, 0, 0),
        ["bring in -0.05 m3/s net", "closed and incompressible"]),
    "more in than out": (
        {"left": through(1), "right": through(0.9), "top": STILL}, (0, 0, 0),
        ["could bring 0.19 m3/s", "closed and incompressible"]),
    "a pressure difference that nothing holds": (
        {"left": opening(1), "right": opening(0)}, (0, 0, 0),
        ["No wall holds the body along", "a net force of"]),
    "a weight that nothing holds": (
        {"bottom": AIR, "top": AIR}, (0, -10, 0),
        ["No wall holds the body along", "N acts on it"]),
}


def message(case):
    """That of a run that ends before its first solve."""
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode == 1 and "FGMRES" not in done.stdout
    return done.stdout[done.stdout.index("FOAM FATAL"):]


@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
def test_scene_is_named(box, name):
    """Cause and place."""
    walls, g, words = SCENES[name]
    text = message(box(n=8, materials=HEAVY, walls=walls, g=g))
    for word in words:
        assert word in text, text


@pytest.mark.slow
def test_what_is_in_balance_runs(box):
    """Nothing holds the body along x and no net force acts on it: the flow is
    the one without that motion."""
    case = box("rest", n=8, materials=HEAVY,
               walls={"left": opening(3), "right": opening(3)})
    case.run("cosseratPicFoam")
    assert np.abs(case.field("U", 1)).max() < 1e-9
    assert case.field("p_rgh", 1) == pytest.approx(3, abs=1e-9)
    # Pulled at the top and the bottom, a shear: u = y tau/eta
    pulled = {side: ("type tangentialTraction; traction uniform"
                     f" ({sign} 0 0);", "type zeroGradient;")
              for side, sign in (("top", 1), ("bottom", -1))}
    case = box("shear", n=8, cyclic=True, walls=pulled,
               materials={"a": {"eta": 2, "etaC": 0, "R": 0}})
    case.run("cosseratPicFoam")
    y = case.centres()[:, 1]
    assert case.field("U", 1)[:, 0] == pytest.approx(y/2, abs=1e-9)


def test_jump_that_nothing_holds(box):
    """Of the pressure of a periodic channel between walls that slip."""
    case = box(n=4, cyclic=True, materials=HEAVY)
    entry = "type fixedJump; patchType cyclic; jump uniform 1; value uniform 0;"
    path = case.path/"0/p_rgh"
    path.write_text(path.read_text().replace(
        "#includeEtc", f"left {{ {entry} }}\nright {{ {entry} }}\n#includeEtc"))
    assert "No wall holds the body along" in message(case)


def empty_patch(case, U, p, omega="type zeroGradient;"):
    """Add a patch of no faces, with its entries."""
    path = case.path/"constant/polyMesh/boundary"
    text = path.read_text()
    n = int(re.search(r"\n(\d+)\n\(", text)[1])
    faces = sum(int(a) for a in re.findall(r"nFaces\s+(\d+);", text))
    first = min(int(a) for a in re.findall(r"startFace\s+(\d+);", text))
    text = text.replace(f"\n{n}\n(", f"\n{n + 1}\n(", 1)
    end = text.rindex(")")
    path.write_text(text[:end] + "none { type patch; nFaces 0; startFace "
                    f"{first + faces}; }}\n" + text[end:])
    for name, entry in (("U", U), ("p_rgh", p), ("omega", omega)):
        path = case.path/"0"/name
        path.write_text(path.read_text().replace(
            "#includeEtc", f"none {{ {entry} }}\n#includeEtc"))


@pytest.mark.slow
def test_patch_without_faces_is_no_outlet(box):
    """Nor does what it asks for count."""
    case = box("in", n=8, materials=HEAVY, walls={"left": through(1)})
    empty_patch(case, *opening(0)[::2])
    text = message(case)
    assert "m3/s net" in text and "closed and incompressible" in text

    flows = []
    for name in ("without", "with"):
        case = box(name, n=8, materials=HEAVY, walls={
            "left": opening(1), "right": opening(0), "top": STILL})
        if name == "with":
            empty_patch(case, "type zeroGradient;", "type zeroGradient;",
                        "type inletOutlet; inletValue uniform 0;"
                        " value nonuniform List<scalar> 0();")
        case.run("cosseratPicFoam")
        flows.append(case.field("U", 1))
    assert np.array_equal(*flows) and np.abs(flows[0]).max() > 0.01


@pytest.mark.parametrize("g, periodic", [
    ((0, -10, 0), False), ((1, 1, -3), False), ((0, 0, -10), True)])
def test_weight_of_a_part_of_a_ring(tmp_path, g, periodic):
    """Its cyclic patches turn it: a weight in the plane is not periodic."""
    case = Annulus(tmp_path/"case", n=4, materials=HEAVY, g=g, walls={
        "left": ("type noSlip;", "type zeroGradient;")}).write()
    if periodic:
        case.run("cosseratPicFoam")
        assert np.abs(case.field("U", 1)).max() == 0
    else:
        text = message(case)
        assert "is periodic, its weight is not" in text
        assert "bottom" in text or "top" in text
