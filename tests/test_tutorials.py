"""The physics of the tutorials beside the paper's, each in a small version.

Bounds: as measured, rounded up by a tenth; each test shows that one per cent
of a parameter breaks them.
"""

import os
import re
import shutil
import subprocess

import numpy as np
import pytest

from cosserat.analytic import (AnnularCouette, EccentricCylinders, Material,
                               err)
from cosserat.case import Case, ROOT, TUTORIALS

ONE_STEP = {"endTime": 1, "deltaT": 1, "adjustTimeStep": "no",
            "writeInterval": 1}


def without_points(case):
    """Leave the dye out."""
    (case.path/"constant/materialPointsProperties").unlink()
    return case


def annulus(tutorial, n, **changes):
    """Errors of the annular Couette flow."""
    case = without_points(tutorial(
        "annularCouette", f"n{n}{len(changes)}", control=ONE_STEP,
        mesh={"nAcross": n, "nQuarter": 3*n//2},
        solution={"tolerance": 1e-9}, **changes))
    case.run("cosseratPicFoam")
    x, y = case.centres()[:, :2].T
    r, U = np.hypot(x, y), case.field("U")
    ring = AnnularCouette(Material(1000, 1000, 0.2), (1, 2), (1, 0), (1, 0))
    return (err(ring.u(r), (x*U[:, 1] - y*U[:, 0])/r),
            err(ring.omega(r), case.field("omega")))


@pytest.mark.slow
def test_annular_couette(tutorial):
    """Order two in both on a curved mesh; the errors are as measured."""
    coarse, fine = annulus(tutorial, 16), annulus(tutorial, 32)
    assert coarse[0] < 4.5e-3 and coarse[1] < 6.7e-3
    assert fine[0] < 1.15e-3 and fine[1] < 1.7e-3
    assert coarse[0]/fine[0] > 3.6 and coarse[1]/fine[1] > 3.6


@pytest.mark.slow
def test_annular_couette_can_fail(tutorial):
    """One per cent of the internal length shows on the fine mesh."""
    assert annulus(tutorial, 32, materials={"R": 0.202})[1] > 4*1.7e-3


def cavity(tutorial, target, n=64, **materials):
    """The cavity's flow as arrays over y and x."""
    case = without_points(tutorial(
        "cavity", target, control=ONE_STEP, mesh={"n": n},
        solution={"tolerance": 1e-9}, materials=materials))
    case.run("cosseratPicFoam")
    centres = case.centres().round(9)
    order = np.lexsort((centres[:, 0], centres[:, 1]))
    return case.field("U")[order, :2].reshape(n, n, 2)


def test_cavity_is_its_mirror_image(tutorial):
    """Reversed in time, as every creeping flow: u even, v odd."""
    U = cavity(tutorial, "case")
    assert np.abs(U - U[:, ::-1]*(1, -1)).max() < 1e-7


@pytest.mark.parametrize("limits", [{"etaC": 0, "R": 0}, {"R": 1e3}])
def test_cavity_in_the_classical_limits(tutorial, limits):
    """Without Cosserat viscosity, and with an internal length that lets no
    grain turn, the vortex is the classical one: -0.100076 at 0.7650."""
    n = 64
    U = cavity(tutorial, "case", n, **limits)
    u = U[:, n//2 - 1:n//2 + 1, 0].mean(axis=1)
    psi = np.concatenate([[0], np.cumsum(u)/n])
    centre = psi.argmin()
    parabola = np.polyfit(np.arange(centre - 1, centre + 2)/n,
                          psi[centre - 1:centre + 2], 2)
    y = -parabola[1]/(2*parabola[0])
    assert np.polyval(parabola, y) == pytest.approx(-0.100076, rel=2e-3)
    assert y == pytest.approx(0.7650, abs=1e-3)


def lost_height(case, material, rho, g):
    """Potential energy [J] that the points have lost between the first and
    the last time, and the work of gravity in the flow then."""
    first, last = case.times()[0], case.times()[-1]
    volume = case.cloud("volume")[case.cloud("material") == material].sum()
    energy = rho*g*volume*(case.centroid(material, first)
                           - case.centroid(material, last))[1]
    rows = case.table("power", "powerBalance.dat")
    t, power = rows[:, 0], rows[:, 1]
    now = (t > float(first)*(1 + 1e-9)) & (t <= float(last)*(1 + 1e-9))
    before = np.flatnonzero(now) - 1
    mean = (power[before] + power[now])/2
    return energy, (mean*(t[now] - t[before])).sum()


@pytest.mark.slow
def test_sinking_inclusion(tutorial):
    """Its fall on 32 x 32 cells; what it loses in height is the work of
    gravity on the flow."""
    case = tutorial("sinkingInclusion", mesh={"n": 32},
                    control={"endTime": 30, "writeInterval": 10})
    case.run("cosseratPicFoam")
    energy, work = lost_height(case, 1, 1, 1)
    assert energy == pytest.approx(work, rel=4e-3)
    assert 0.65 - case.centroid(1)[1] == pytest.approx(0.08846, abs=2e-4)


def overturn(tutorial, **materials):
    """First peak of v_rms [m/s] and its time [s] on 32 x 32 cells."""
    case = tutorial("rayleighTaylor", mesh={"n": 32},
                    control={"endTime": 230}, materials=materials)
    case.run("cosseratPicFoam")
    rows = case.table("vrms", "volFieldValue.dat")
    speed = np.sqrt(rows[:, 1])
    return speed.max(), rows[speed.argmax(), 0]


@pytest.mark.slow
def test_rayleigh_taylor(tutorial):
    """First peak of v_rms: 3.09e-3 at 209 by the benchmark; measured 3.070e-3
    at 211 on this mesh."""
    peak, time = overturn(tutorial)
    assert peak == pytest.approx(3.09e-3, rel=7e-3)
    assert time == pytest.approx(209, abs=2.5)


@pytest.mark.slow
def test_rayleigh_taylor_can_fail(tutorial):
    """One per cent of the viscosity shows in both."""
    peak, time = overturn(tutorial, eta=1.01)
    assert peak < 3.09e-3*(1 - 1.4e-2)
    assert time > 209 + 2.5


def slump(tutorial, target, **materials):
    """The column on 32 x 16 cells."""
    case = tutorial("columnSlump", target, mesh={"nx": 32, "ny": 16},
                    materials=materials,
                    control={"endTime": 4, "writeInterval": 1})
    case.run("cosseratPicFoam")
    return case


@pytest.mark.slow
def test_column_slump(tutorial):
    """The law's viscosities by equations 14 and 15; what the grains lose in
    height is the work of gravity; of two internal lengths the longer one lets
    the same column sink with less power."""
    case = slump(tutorial, "case")
    eta = 0.6/(4*np.pi)*6*4e4
    assert f"eta {eta:.3f}"[:9] in case.log()
    # Given of the floor, where the air was at first and grains are now
    assert (case.patch_field("omega", "floor") == 0).all()
    energy, work = lost_height(case, 1, 1600, 10)
    assert energy == pytest.approx(work, rel=5e-3)
    stiff = slump(tutorial, "stiff", R=0.5)
    power = [c.table("power", "powerBalance.dat")[0, 1] for c in (case, stiff)]
    assert power[1] < 0.95*power[0]


@pytest.mark.slow
def test_dune_is_what_its_surface_holds(tutorial):
    """Points below the surface of the file are grains, point by point."""
    case = tutorial("dune", control={"endTime": 1e-6, "deltaT": 1e-6,
                                     "adjustTimeStep": "no",
                                     "writeInterval": 1e-6})
    case.run("cosseratPicFoam")
    vertices = np.array([
        line.split()[1:] for line in
        (case.path/"constant/triSurface/dune.obj").read_text().splitlines()
        if line.startswith("v ")], float)
    top = vertices[(vertices[:, 1] > 0) & (vertices[:, 2] > 0)]
    x, y = case.cloud("positions")[:, :2].T
    height = np.interp(x, top[:, 0], top[:, 1])
    clear = np.abs(y - height) > 1e-5
    assert clear.mean() > 0.999
    grains = case.cloud("material") == 1
    assert (grains == (y < height))[clear].all()


@pytest.mark.slow
def test_hopper(tutorial):
    """What the feed brings is inside to the last point (96 a face in 5.05 s), and
    as much goes out; the points go on filling the hopper."""
    case = tutorial("hopper",
                    mesh={"nx": 12, "nSpout": 3, "nCone": 10, "nBin": 6},
                    control={"endTime": 5.05, "maxCo": 1})
    case.run("cosseratPicFoam")
    old, fresh = (case.table(name, "materialOutflow.dat")[:, 3]
                  for name in ("old", "fresh"))
    assert fresh[-1] == pytest.approx(0.1*5, rel=1e-6)
    area = case.volumes().sum()/0.1
    assert old[0] == pytest.approx(area, rel=1e-6)
    assert (old + fresh)[-1] == pytest.approx(area, rel=5e-3)
    rates = [case.table(name, "surfaceFieldValue.dat")[-1, 1]/0.1
             for name in ("inflow", "outflow")]
    assert rates == pytest.approx([-0.1, 0.1], rel=1e-5)


def eccentric(path, **substitutes):
    """Error of U between eccentric cylinders, classical fluid."""
    case = without_points(Case.copy(TUTORIALS/"eccentricCylinders", path))
    case.substitute("system/controlDict", ONE_STEP)
    case.substitute("constant/materialProperties", {"etaC": 0, "R": 0})
    for file, entries in substitutes.items():
        case.substitute(f"0/{file}", entries)
    case.run("gmshToFoam", "constant/cylinders.msh")
    case.run("foamDictionary", "constant/polyMesh/boundary", "-entry",
             "entry0/frontAndBack/type", "-set", "empty")
    case.run("cosseratPicFoam")
    x, y = case.centres()[:, :2].T
    exact = EccentricCylinders(1, 2, 0.5)
    assert exact.residual < 1e-10
    return err(exact.u(x, y), case.field("U")[:, :2].T)


@pytest.mark.slow
def test_eccentric_cylinders(tmp_path):
    """Triangles by gmsh against the classical solution, measured 0.99 %."""
    assert eccentric(tmp_path/"case") < 1.05e-2
    assert eccentric(tmp_path/"faster", U={"omega": 1.02}) > 1.05e-2


def copy_template(target, name="template"):
    """What cp -r of a clean checkout copies."""
    shutil.copytree(TUTORIALS/name, target, ignore=
                    shutil.ignore_patterns("[1-9]*", "0", "log.*", "results",
                                           "postProcessing", "polyMesh"))


@pytest.mark.slow
def test_template_becomes_a_case(tmp_path):
    """cp -r and Allrun, nothing else; the picture is there, and named."""
    copy_template(tmp_path/"mine")
    done = subprocess.run(["./Allrun"], cwd=tmp_path/"mine", check=True,
                          stdout=subprocess.PIPE, text=True,
                          timeout=Case.timeout)
    assert done.stdout.rstrip().endswith("points.png")
    assert (tmp_path/"mine/results/points.png").stat().st_size > 20000
    case = Case(tmp_path/"mine")
    assert "\nEnd\n" in case.log()
    energy, work = lost_height(case, 1, 1600, 10)
    assert energy == pytest.approx(work, rel=5e-3)


#: Their minutes are spent in test_silo.py and test_axisymmetric.py, on fewer cells
LONG = {"silo", "cylindricalSilo"}


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(
    {d.name for d in TUTORIALS.iterdir() if (d/"plot.py").exists()} - LONG))
def test_Allrun_finds_what_it_expects(tmp_path, name):
    """Each tutorial as shipped: plot.py, its last line, fails where the run
    is not as its page says."""
    copy_template(tmp_path/"mine", name)
    done = subprocess.run(["./Allrun"], cwd=tmp_path/"mine", check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, timeout=Case.timeout)
    assert done.returncode == 0, done.stdout[-3000:]


@pytest.mark.slow
def test_Allrun_shows_the_error(tmp_path):
    """And not only its log: file, entry and what is allowed."""
    copy_template(tmp_path/"mine")
    case = Case(tmp_path/"mine")
    case.substitute("constant/materialProperties", {"R": -1})
    done = subprocess.run(["./Allrun"], cwd=case.path, check=False,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          text=True, timeout=Case.timeout)
    assert done.returncode != 0
    for words in ("'R'", "is -1", "Allowed", "materialProperties",
                  "log.cosseratPicFoam"):
        assert words in done.stderr, words


@pytest.mark.parametrize("case", sorted(
    d.name for d in TUTORIALS.iterdir() if (d/"system").is_dir()))
def test_tutorial_is_whole(case):
    """Page, scripts that can be run, every picture that the page shows, and a
    number beside one that this code did not compute."""
    folder = TUTORIALS/case
    for name in ("Allrun", "Allrun-parallel", "Allclean"):
        assert os.access(folder/name, os.X_OK), name
    page = (folder/"README.md").read_text()
    assert "\nNumber and reference: " in page
    for picture in re.findall(r"\]\((\w+\.png)\)", page):
        assert (folder/picture).exists(), picture


@pytest.mark.parametrize("name", ["viscosityLaw", "pointVelocity",
                                  "pointProperty", "wallCondition"])
def test_example_of_the_docs_applies(name):
    """Each example is short and fits the code as it is."""
    diff = ROOT/f"docs/examples/{name}.diff"
    assert len(diff.read_text().splitlines()) < 100
    subprocess.run(["patch", "--dry-run", "--fuzz=0", "-p1", "-s", "-i",
                    str(diff)],
                   cwd=ROOT, check=True)
