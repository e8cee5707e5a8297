"""The examples of docs/architecture.md: each is applied to a copy of the
sources, its library is built, and a scene runs with what it adds."""

import os
import shutil
import subprocess

import numpy as np
import pytest

from cosserat.case import ROOT
from cosserat.scenes.ring import ring

EXAMPLES = ROOT/"docs/examples"

#: Example: the library that it belongs to
LIBRARIES = {"viscosityLaw": "rheology", "pointVelocity": "points",
             "wallCondition": "flow"}

HELD = ("type noSlip;", "type fixedValue; value uniform 0;")


@pytest.fixture(name="built")
def built_fixture(tmp_path, monkeypatch):
    """Function that applies an example to a copy of the sources and builds
    its library, which programs then take in place of the project's."""

    def build(name):
        copy = tmp_path/"project"
        # What is compiled already goes with it
        for library in {"base", "rheology", LIBRARIES[name]}:
            shutil.copytree(ROOT/"src"/library, copy/"src"/library,
                            symlinks=True)
        libraries = copy/"lib"
        shutil.copytree(os.environ["COSSERATPIC_LIBBIN"], libraries)
        monkeypatch.setenv("COSSERATPIC_LIBBIN", str(libraries))
        monkeypatch.setenv("LD_LIBRARY_PATH", f"{libraries}:"
                           + os.environ["LD_LIBRARY_PATH"])
        for command in (["git", "apply", str(EXAMPLES/f"{name}.diff")],
                        ["wmake", "-s", "libso", f"src/{LIBRARIES[name]}"]):
            done = subprocess.run(
                command, cwd=copy, stdout=subprocess.PIPE, check=False,
                stderr=subprocess.STDOUT, text=True, timeout=600)
            assert done.returncode == 0, done.stdout[-3000:]
        return copy

    return build


def test_all_examples_are_tried():
    """None is left out, and the page names each."""
    assert {file.stem for file in EXAMPLES.glob("*.diff")} == set(LIBRARIES)
    page = (ROOT/"docs/architecture.md").read_text()
    for name in LIBRARIES:
        assert f"(examples/{name}.diff)" in page


@pytest.mark.slow
def test_viscosity_law(built, box):
    """A channel of a suspension: u = rho g/(8 eta) in its middle, with
    eta = 2 (1 + 5/2 0.08); without the example the law is unknown."""
    case = box(n=16, cyclic=True, g=(1, 0, 0), walls={
        "top": HELD, "bottom": HELD},
               materials={"a": {"eta": 1, "etaC": 0, "R": 0, "rho": 1}})
    path = case.path/"constant/materialProperties"
    path.write_text(path.read_text().split("materials")[0] + """
materials { a { rho 1; viscosityLaw suspension;
    suspensionCoeffs { eta0 2; phi 0.08; } } }
""")
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode and "suspension" in done.stdout
    built("viscosityLaw")
    case.run("cosseratPicFoam")
    y = case.centres()[:, 1]
    assert np.allclose(case.field("U")[:, 0], (0.25 - y**2)/(2*2.4),
                       atol=5e-4)


@pytest.mark.slow
def test_point_velocity(built, tmp_path):
    """The cell's velocity and gradient have a rigid rotation exactly."""
    built("pointVelocity")
    start, chosen = ring(tmp_path/"start", "RK4", 1e-12, 1)
    xy, _ = ring(tmp_path/"turned", "RK4", 1, 80, velocity="cellCentre")
    assert np.hypot(*(xy[chosen] - start[chosen]).T).max() < 1e-5


@pytest.mark.slow
def test_wall_condition(built, box):
    """A wall that turns is one of that microrotation."""
    built("wallCondition")
    fields = []
    for name, entry in (("turns", "type turningWall; rate 2;"),
                        ("fixed", "type fixedValue; value uniform 2;")):
        case = box(name, n=8, walls={"top": ("type noSlip;", entry)},
                   materials={"a": {"eta": 1, "etaC": 1, "R": 0.1}})
        case.run("cosseratPicFoam")
        fields.append(case.field("omega"))
    assert np.array_equal(*fields) and fields[0].max() > 0.1
