"""The examples of docs/architecture.md: each is applied to a copy of the
sources, its library is built, and a scene runs with what it adds."""

import os
import shutil
import subprocess

import numpy as np
import pytest

from cosserat.case import ROOT, residuals
from cosserat.scenes.box import add_points
from cosserat.scenes.ring import ring

EXAMPLES = ROOT/"docs/examples"

#: Example: the library that it belongs to
LIBRARIES = {"viscosityLaw": "rheology", "pointVelocity": "points",
             "pointProperty": "points", "wallCondition": "flow",
             "preconditioner": "flow"}

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
    """A channel of a shear-thinning fluid, with the shear rate
    tau/(eta0 - lambda tau) of the shear stress tau = rho g y; on two ranks
    too. Without the example the law is unknown."""
    def channel(name):
        case = box(name, n=24, cyclic=True, g=(2, 0, 0), tolerance=1e-9,
                   walls={"top": HELD, "bottom": HELD}, materials={
                       "a": {"eta": 1, "etaC": 0, "R": 0, "rho": 1}})
        path = case.path/"constant/materialProperties"
        path.write_text(path.read_text().split("materials")[0] + """
materials { a { rho 1; viscosityLaw cross;
    crossCoeffs { eta0 1; etaC0 0; R 0; lambda 0.5; } } }
""")
        return case.override("system/fvSolution", creepingFlow=(
            "{ nonlinear { tolerance 1e-8; } }"))

    done = channel("unknown").run("cosseratPicFoam", check=False)
    assert done.returncode and "cross" in done.stdout
    built("viscosityLaw")

    for ranks in (1, 2):
        case = channel(f"on{ranks}")
        if ranks > 1:
            case.decompose(ranks)
        case.run("cosseratPicFoam", ranks=ranks)
        if ranks > 1:
            case.reconstruct()
        y = np.abs(case.centres()[:, 1])
        wall, exact = (-z/0.5 - np.log(1 - z)/(0.25*2) for z in (0.5, y))
        error = case.field("U")[:, 0] - (wall - exact)
        assert 1e-3 < np.abs(error).max()/0.386 < 4e-3


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


@pytest.mark.slow
def test_point_property(built, box):
    """A direction that turns with the grains: in a rotation at rate one, by
    the time."""
    built("pointProperty")
    case = box(n=8, materials={"a": {"eta": 1, "etaC": 1, "R": 0.3}},
               walls={side: ("exact", "exact")
                      for side in ("left", "right", "bottom", "top")},
               U=lambda x, y: (-y, x), omega=lambda x, y: 1 + 0*x)
    add_points(case, "{ type all; material a; }", minPointsPerCell=0,
               properties="{ axis { type grainAxis; start (1 0 0); } }")
    case.substitute("system/controlDict", {
        "endTime": 1, "deltaT": 0.1, "writeInterval": 10})
    case.run("cosseratPicFoam")
    # Those that have flowed in at the corners are younger
    axis = case.cloud("axis")[np.hypot(*case.cloud("positions").T[:2]) < 0.49]
    assert len(axis) > 500
    assert np.abs(axis - [np.cos(1), np.sin(1), 0]).max() < 1e-6


@pytest.mark.slow
def test_preconditioner(built, box):
    """The flow is the same with any preconditioner, in more iterations."""
    built("preconditioner")
    fields, iterations = [], []
    for name in ("multigrid", "diagonal"):
        case = box(name, n=6, walls={"top": ("type fixedValue; value uniform"
                                             " (1 0 0);", HELD[1])},
                   materials={"a": {"eta": 1, "etaC": 1, "R": 0.1}},
                   tolerance=1e-10)
        case.override("system/fvSolution", creepingFlow=(
            f"{{ preconditioner {{ block {name}; }} }}"))
        case.run("cosseratPicFoam")
        fields.append(case.field("U"))
        iterations.append(residuals(case.log())[0][3])
    assert np.abs(fields[1] - fields[0]).max() < 1e-7
    assert iterations[1] > 2*iterations[0]
