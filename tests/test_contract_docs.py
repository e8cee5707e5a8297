"""The entries of docs/scenes.md do what the page says."""

import re

import numpy as np
import pytest

from cosserat import analytic
from cosserat.case import ROOT

PAGE = (ROOT/"docs/scenes.md").read_text()


def block(name):
    """An example of the page."""
    return re.search(rf"```{name}\n(.*?)```", PAGE, re.S)[1]


HELD = ("type noSlip;", "type fixedValue; value uniform 0;")
SAND = {"eta": 2, "etaC": 3, "R": 0.2}


@pytest.mark.parametrize("name", [
    "profile-expression", "profile-function", "profile-list"])
def test_profile(box, name):
    """Each gives the parabola at the middle of the faces, and its flux."""
    case = box(n=4, materials={"a": SAND}, walls={
        "left": (block(name), "type fixedValue; value uniform 0;"),
        "right": ("type zeroGradient;", "type zeroGradient;",
                  "type fixedValue; value uniform 0;"),
        "top": HELD, "bottom": HELD})
    case.run("cosseratPicFoam", "-solveOnce")
    y = case.patch_centres("left")[:, 1]
    assert np.allclose(case.patch_field("U", "left", "0")[:, 0],
                       1.5 - 6*y**2, atol=1e-12)
    out = case.patch_field("phi", "right", "0").sum()
    assert out == pytest.approx((1.5 - 6*y**2).mean()*0.1, rel=1e-8)


@pytest.mark.slow
def test_force(box):
    """The channel of its analytic solution, and twice the force is twice the
    flow."""
    exact = analytic.GravityChannel(analytic.Material(2, 3, 0.2), 1, 2.0)
    flows = []
    for name, factor in (("one", 1), ("two", 2)):
        case = box(name, n=32, cyclic=True, materials={"a": SAND},
                   walls={"top": HELD, "bottom": HELD})
        (case.path/"0/bodyForce").write_text(
            "FoamFile { version 2.0; format ascii; class volVectorField;"
            " object bodyForce; }\n" + block("force").replace(
                "(2 0 0)", f"({2*factor} 0 0)"))
        case.run("cosseratPicFoam", "-solveOnce")
        assert "Files that nothing reads" not in case.log()
        flows.append(case.field("U", "0")[:, 0])
    y = case.centres()[:, 1]
    assert np.abs(flows[0] - exact.u(y)).max() < 1e-3*exact.u(0*y).max()
    assert np.allclose(flows[1], 2*flows[0], rtol=1e-7)


@pytest.mark.slow
def test_length_or_bending(box):
    """R and M of the page are the same material, and neither is none."""
    flows = []
    for name in ("length", "bending", "neither"):
        case = box(name, n=8, materials={"a": SAND}, walls={
            "top": ("type fixedValue; value uniform (1 0 0);", HELD[1]),
            "bottom": HELD})
        path = case.path/"constant/materialProperties"
        text = block("length" if name == "neither" else name)
        text = text.replace("R 0.2;", "") if name == "neither" else text
        path.write_text(re.sub(r"constantCoeffs \{[^}]*\}",
                               f"constantCoeffs {{ {text} }}",
                               path.read_text()))
        done = case.run("cosseratPicFoam", "-solveOnce",
                        check=name != "neither")
        if name == "neither":
            assert done.returncode and "one of" in done.stdout
        else:
            flows.append(case.field("U", "0"))
    assert np.abs(flows[0]).max() > 0.1
    assert np.allclose(*flows, atol=1e-9)


def test_load(box):
    """The function object of the page runs, with its bins."""
    case = box(n=4, materials={"a": {**SAND, "rho": 5}}, g=(0, -2, 0))
    case.override("control", functions=f"{{ {block('load')} }}")
    case.run("cosseratPicFoam")
    assert case.table("load", "wallLoad.dat")[-1][2] == pytest.approx(-1)
    rows = np.loadtxt(case.path/"postProcessing/load/0/wallLoad_bins.dat")
    assert len(rows) == 4


def test_stop(box):
    """The stop of the page ends a solve."""
    case = box(n=8, materials={"a": SAND}, walls={
        "top": ("type fixedValue; value uniform (1 0 0);", HELD[1]),
        "bottom": HELD})
    with (case.path/"system/fvSolution").open("a") as text:
        text.write(block("stop"))
    case.run("cosseratPicFoam", "-solveOnce")
    assert "share 0.1" in case.log()


def test_all_examples_are_tried():
    """None of the page is left out."""
    tried = set(re.findall(r'"([a-z-]+)"', open(__file__).read()))
    assert set(re.findall(r"```([a-z-]+)\n", PAGE)) <= tried
