"""Points know their material, and tracers their point, by name over a restart:
whatever becomes of the order of lists."""

import re
import shutil

import numpy as np
import pytest

from cosserat.case import Case, RunError
from cosserat.scenes.box import add_points

LIQUIDS = {"a": {"eta": 1, "etaC": 0, "R": 0, "rho": 2},
           "b": {"eta": 3, "etaC": 0, "R": 0, "rho": 1}}

REGIONS = ("{ type all; material b; } { type disc; material a;"
           " centre (0.1 0.2 0); radius 0.2; }")


def law(eta, rho):
    """A material of the box, as text."""
    return ("{ rho %g; viscosityLaw constant; constantCoeffs"
            " { eta %g; etaC 0; R 0; B infinite; } }" % (rho, eta))


def materials(case, **which):
    """Write the materials of a case, by name: (eta, rho), in their order."""
    path = case.path/"constant/materialProperties"
    path.write_text(path.read_text().split("materials")[0] + "materials\n{\n"
                    + "\n".join(f"{name} {law(*values)}"
                                for name, values in which.items())
                    + "\n}\nviscosityAverage arithmetic;\n")


@pytest.fixture(name="scene")
def scene_fixture(box):
    """Function that makes a scene which has run a step, to go on for one."""

    def make(target="case", ranks=1, places=None):
        case = box(target, n=8, materials=LIQUIDS, g=(0, -1, 0),
                   fractions=lambda x, y: x < 0)
        add_points(case, REGIONS, pointsPerCell=4)
        case.substitute("system/controlDict", {
            "startFrom": "latestTime", "endTime": 0.1, "deltaT": 0.1})
        if places:
            follow(case, places)
        case.decompose(ranks)
        case.run("cosseratPicFoam", ranks=ranks)
        case.substitute("system/controlDict", {"endTime": 0.2})
        return case

    return make


def follow(case, places):
    """Follow the points of these places, and of no others."""
    text = " ".join(f"({x} {y} 0)" for x, y in places)
    case.measure("followed", "pointTracers", f"places ({text});")


@pytest.mark.slow
@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("order", [
    {"b": (3, 1), "a": (1, 2)}, {"air": (1, 0), "a": (1, 2), "b": (3, 1)},
    {"b": (3, 1), "ore": (9, 9), "a": (1, 2)}])
def test_materials_in_another_order(scene, ranks, order):
    """Reordered and extended: the flow is that of the run that was not
    changed, and each point has its material."""
    whole, case = scene("whole", ranks), scene("case", ranks)
    materials(case, **order)
    for each in (whole, case):
        each.run("cosseratPicFoam", ranks=ranks)
        each.reconstruct("-latestTime")
    assert np.allclose(case.field("U"), whole.field("U"), atol=1e-9)
    assert np.allclose(case.cloud("positions"), whole.cloud("positions"),
                       atol=1e-9)
    names = list(order)
    kinds = [names[i] for i in case.cloud("material").astype(int)]
    assert kinds == ["ab"[i] for i in whole.cloud("material").astype(int)]
    assert np.abs(whole.field("U")).max() > 1e-3


@pytest.mark.slow
@pytest.mark.parametrize("left", [
    {"b": (3, 1)}, {"a": (1, 2), "c": (3, 1)}, {"A": (1, 2), "b": (3, 1)}])
def test_material_that_is_gone(scene, left):
    """Its points say whose they are."""
    case = scene()
    materials(case, **left)
    add_points(case, "{ type all; material %s; }" % list(left)[0])
    done = case.run("cosseratPicFoam", check=False)
    text = done.stdout[done.stdout.index("FOAM FATAL"):]
    gone = ({"a", "b"} - set(left)).pop()
    assert done.returncode
    for word in (f"material {gone}", "materialProperties", *left):
        assert word in text, text


@pytest.mark.slow
def test_decomposed_and_reconstructed(scene):
    """The names go with the time, one way and back."""
    case = scene(ranks=2)
    case.run("reconstructPar")
    for folder in case.path.glob("processor*"):
        shutil.rmtree(folder)
    materials(case, b=(3, 1), a=(1, 2))
    case.decompose(2)
    case.run("cosseratPicFoam", ranks=2)
    case.run("reconstructPar", "-latestTime")
    kinds = case.cloud("material").astype(int)
    whole = scene("whole")
    whole.run("cosseratPicFoam")
    before = whole.cloud("material").astype(int)
    assert (kinds == 1).sum() == (before == 0).sum() > 0


@pytest.mark.slow
def test_redistributed(scene):
    """So does redistributePar take points and names along, on two ranks."""
    case, whole = scene(ranks=2), scene("whole", ranks=2)
    path = case.path/"system/decomposeParDict"
    path.write_text(path.read_text().replace("(2 1 1)", "(1 2 1)"))
    case.run("redistributePar", "-latestTime", "-overwrite", ranks=2)
    materials(case, b=(3, 1), a=(1, 2))
    found = []
    for each in case, whole:
        each.run("cosseratPicFoam", ranks=2)
        # By hand: redistributePar may leave nothing for reconstructPar
        parts = [Case(folder) for folder in each.path.glob("processor*")]
        places, kinds = (np.concatenate([part.cloud(name) for part in parts])
                         for name in ("positions", "material"))
        order = np.lexsort(places.T.round(7))
        found.append((places[order], kinds[order].astype(int)))
        assert "does not name" not in each.log()
    assert np.allclose(found[0][0], found[1][0], atol=1e-8)
    assert np.array_equal(1 - found[0][1], found[1][1])
    assert 0 < found[1][1].sum() < found[1][1].size


@pytest.mark.slow
def test_dye_stays_when_patterns_change(scene):
    """A mark is the point's: patterns reordered, another one, or none."""
    case = scene()
    marks = case.cloud("dye", "0.1")
    for dye in ("{ type stripes; along (1 0 0); origin (0 0 0); width 0.1; }",
                "", "{ type bands; across (0 1 0); start -1;"
                " width 0.1; period 0.2; }"):
        add_points(case, REGIONS, dye, pointsPerCell=4)
        shutil.rmtree(case.path/"0.2", ignore_errors=True)
        case.run("cosseratPicFoam")
        assert sorted(case.cloud("dye")) == sorted(marks)


PLACES = [(-0.3, 0.3), (0.1, 0.2), (0.25, -0.4)]


@pytest.mark.slow
@pytest.mark.parametrize("later", [
    [2, 0, 1], [1], [0, 1, 2, (0.4, 0.4)], [(0.4, 0.4), 2, 0]])
def test_tracers_in_another_order(scene, later):
    """Each place keeps its point and its file, a new one gets the next
    number, and one that is gone is told."""
    whole, case = scene("whole", places=PLACES), scene("case", places=PLACES)
    follow(case, [PLACES[p] if isinstance(p, int) else p for p in later])
    for each in (whole, case):
        each.run("cosseratPicFoam")
    kept = [p for p in later if isinstance(p, int)]
    files = {f.name for f in case.path.glob(
        "postProcessing/followed/0.1/tracer*")}
    new = [f"tracer{3 + i}.dat" for i in range(len(later) - len(kept))]
    assert files == {f"tracer{p}.dat" for p in kept} | set(new)
    for p in kept:
        rows = [each.table("followed", f"tracer{p}.dat")
                for each in (whole, case)]
        assert np.allclose(*rows, atol=1e-9) and len(rows[0]) == 3
    for name in new:
        rows = np.loadtxt(case.path/"postProcessing/followed/0.1"/name)
        assert np.hypot(rows[0][1] - 0.4, rows[0][2] - 0.4) < 0.1
        assert rows[0][9] == 0
    for p in set(range(3)) - set(kept):
        assert f"tracer{p}, from" in case.log()


@pytest.mark.slow
def test_case_of_before(scene):
    """A time that does not say the names has them in the present order, and
    this is told."""
    case = scene()
    assert "does not name" not in case.log()
    for file in case.path.glob("0.1/uniform/lagrangian/*/materials*"):
        file.unlink()
    case.run("cosseratPicFoam")
    assert re.search("Time 0.1 does not name the materials of its points: taken"
                     r" in the order of (2)?\(a b\)", case.log())
    with pytest.raises(RunError):
        materials(case, b=(3, 1))
        shutil.rmtree(case.path/"0.2")
        case.run("cosseratPicFoam")
