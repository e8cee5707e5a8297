"""What a run starts from and ends with: fractions from files, the flow of the
start time alone, starts with nothing left to do, and what cannot be solved."""

import shutil

import numpy as np
import pytest

from cosserat.scenes.box import add_points

LIQUIDS = {"a": {"eta": 1, "etaC": 0, "R": 0, "rho": 2},
           "b": {"eta": 1, "etaC": 0, "R": 0, "rho": 1}}


def put(case, name, cell, value):
    """Write a value into a cell of a field of time 0."""
    path = case.path/"0"/name
    head, rows = path.read_text().split("\n(\n", 1)
    rows = rows.split("\n")
    rows[cell] = repr(value)
    path.write_text(head + "\n(\n" + "\n".join(rows))


def message(case, *options):
    """The error that the solver ends with."""
    done = case.run("cosseratPicFoam", *options, check=False)
    assert done.returncode, done.stdout
    return done.stdout[done.stdout.index("FOAM FATAL"):]


@pytest.fixture(name="layers")
def layers_fixture(box):
    """Function that makes two layers whose fractions are files."""

    def make(target="case", **options):
        return box(target, n=8, materials=LIQUIDS, g=(0, -1, 0),
                   fractions=lambda x, y: y < 0, **options)

    return make


@pytest.mark.slow
@pytest.mark.parametrize("miss", [-2e-16, -3e-7, 1 + 4e-9])
def test_fraction_off_by_rounding_is_clipped(layers, miss):
    """To the nearer end, which the log says; the power is that of the fraction
    that was meant."""
    case = layers()
    cell = 5 if miss > 0.5 else 60
    put(case, "alpha.a", cell, miss)
    case.run("cosseratPicFoam")
    assert "1 values below 0 or above 1" in case.log()
    assert case.field("alpha.a")[cell] == round(miss)
    whole = layers("whole")
    whole.run("cosseratPicFoam")
    assert "below 0 or above 1" not in whole.log()
    assert np.abs(case.field("p") - whole.field("p")).max() < 1e-12


@pytest.mark.parametrize("name, cell, value", [
    ("alpha.a", 60, -0.5), ("alpha.b", 3, 1.001), ("alpha.a", 17, -2e-6)])
def test_fraction_that_is_none_is_refused(layers, name, cell, value):
    """With its file, its cell and where that is."""
    case = layers()
    centre = case.centres()[cell]
    put(case, name, cell, value)
    text = message(case)
    for word in (f"0/{name}", f"in cell {cell} at ({centre[0]:g}", "0 to 1",
                 f"{value:g}"):
        assert word in text, text


def test_overflow_names_what_there_is(layers):
    """The ranges of what the flow is made of, not one of them blamed."""
    case = layers()
    case.substitute("constant/materialProperties", {"rho": 1e40})
    shutil.copy(case.path/"0/U", case.path/"0/bodyForce")
    path = case.path/"0/bodyForce"
    path.write_text(path.read_text().replace(
        "[0 1 -1 0 0 0 0]", "[1 -2 -2 0 0 0 0]").replace(
            "(0.0 0.0 0.0)", "(1e300 0 0)").replace(
                "type slip", "type zeroGradient"))
    text = message(case)
    assert "is not finite" in text
    for word in ("volume of a cell", "rho [kg/m3]: 1e+40 to 1e+40",
                 "eta [Pa s]: 1 to 1", "a load"):
        assert word in text, text


@pytest.mark.slow
def test_solve_once(box):
    """The flow of the start time is written there, of the points as they are
    seeded, with function objects; a run from there is the run from files."""
    region = ("{ type all; material b; } { type disc; material a;"
              " centre (0 0.1 7); radius 0.3; }")
    cases = {}
    for name in ("once", "run"):
        case = cases[name] = box(name, n=8, materials=LIQUIDS, g=(0, -1, 0),
                                 fractions=lambda x, y: x < 0)
        add_points(case, region)
    once, run = cases.values()
    once.run("cosseratPicFoam", "-solveOnce")
    assert once.times() == [] and "Step" not in once.log()
    for name in ("U", "p", "p_rgh", "phi", "alpha.a", "sigma"):
        assert (once.path/"0"/name).is_file(), name
    assert np.abs(once.field("U", "0")).max() > 1e-3
    assert len(once.table("power", "powerBalance.dat")) == 1

    places = once.cloud("positions", "0")
    inside = np.hypot(places[:, 0], places[:, 1] - 0.1) <= 0.3
    assert ((once.cloud("material", "0") == 0) == inside).all()

    once.run("cosseratPicFoam")
    run.run("cosseratPicFoam")
    assert "points: 1024 read" in once.log()
    assert np.allclose(once.field("U"), run.field("U"), atol=1e-9)
    assert np.allclose(once.cloud("positions"), run.cloud("positions"),
                       atol=1e-9)


@pytest.mark.slow
def test_solve_once_on_two_ranks(box):
    """As on one."""
    fields = []
    for ranks in (1, 2):
        case = box(f"{ranks}", n=8, materials=LIQUIDS, g=(0, -1, 0),
                   fractions=lambda x, y: x < 0)
        case.decompose(ranks)
        case.run("cosseratPicFoam", "-solveOnce", ranks=ranks)
        case.reconstruct("-withZero")
        fields.append(case.field("U", "0"))
    assert np.allclose(*fields, atol=1e-9) and np.abs(fields[0]).max() > 1e-3


@pytest.mark.slow
def test_solve_once_at_a_time_that_a_run_has_written(layers):
    """Of the last time, when a constant has changed: twice the viscosity, half
    the speed."""
    case = layers()
    (case.path/"0/alpha.a").write_text(
        (case.path/"0/alpha.a").read_text().replace("1.0\n", "0.5\n", 20))
    (case.path/"0/alpha.b").write_text(
        (case.path/"0/alpha.b").read_text().replace("0.0\n", "0.5\n", 20))
    case.run("cosseratPicFoam")
    before = case.field("U", "1")
    assert np.abs(before).max() > 1e-4
    path = case.path/"constant/materialProperties"
    path.write_text(path.read_text().replace("eta 1;", "eta 2;"))
    case.substitute("system/controlDict", {"startFrom": "latestTime"})
    case.run("cosseratPicFoam", "-solveOnce")
    assert np.allclose(2*case.field("U", "1"), before, rtol=1e-6, atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("entries", [
    {"startFrom": "latestTime"},
    {"startFrom": "startTime", "startTime": 1, "endTime": 0.5},
    {"endTime": 0.4}])
def test_start_with_no_step_to_make(layers, entries):
    """At the end, behind it, or nearer to it than half a step: an error, with
    times and cures."""
    case = layers()
    case.run("cosseratPicFoam")
    case.substitute("system/controlDict", entries)
    before = {p: p.stat().st_mtime_ns for p in case.path.rglob("1/*")}
    text = message(case)
    for word in ("no step to make", "'endTime'", "-solveOnce", "controlDict"):
        assert word in text, text
    assert before == {p: p.stat().st_mtime_ns for p in case.path.rglob("1/*")}


@pytest.mark.slow
def test_dry_run_at_the_end_is_still_one(layers):
    """It asks for no endTime."""
    case = layers()
    case.run("cosseratPicFoam")
    case.substitute("system/controlDict", {"startFrom": "latestTime"})
    assert "Step 1" in case.run("cosseratPicFoam", "-dry-run").stdout


@pytest.mark.slow
@pytest.mark.parametrize("tolerance, eta", [
    ("1e-16", 1), ("5e-17", 1e3), ("3e-17", 1e-3)])
def test_tolerance_below_rounding(box, tolerance, eta):
    """What double precision cannot meet is told as that."""
    case = box(n=8, materials={"a": {"eta": eta, "etaC": eta, "R": .1,
                                     "rho": 1}},
               walls={"top": ("type fixedValue; value uniform (1 0 0);",
                              "type zeroGradient;")}, tolerance=tolerance)
    text = message(case)
    for word in (f"'tolerance' is {float(tolerance):g}", "rounding",
                 "fvSolution", "from about"):
        assert word in text, text
    least = float(text.split("from about ")[1].split()[0])
    assert 1e-16 < least < 1e-10
    case.substitute("system/fvSolution", {"tolerance": least})
    case.run("cosseratPicFoam")


def seeded(box, name, region):
    """Places and materials of the points of a region of b in a."""
    case = box(name, n=10, materials=LIQUIDS, fractions=lambda x, y: x < 0)
    add_points(case, "{ type all; material a; } { material b; %s }" % region)
    case.run("cosseratPicFoam", "-solveOnce")
    return case.cloud("positions", "0"), case.cloud("material", "0")


@pytest.mark.parametrize("centre, radius", [
    ((0, 0, 0), 0.25), ((0.5, -0.5, 3), 0.6), ((-0.31, 0.2, 0), 0.07)])
def test_disc(box, centre, radius):
    """The points of the disc are those within its radius, also where a part
    of it is outside; the place across the plane does not matter."""
    places, material = seeded(
        box, "disc", f"type disc; centre ({centre[0]} {centre[1]} {centre[2]});"
        f" radius {radius};")
    inside = np.hypot(places[:, 0] - centre[0],
                      places[:, 1] - centre[1]) <= radius
    assert inside.any() and (inside == (material == 1)).all()


@pytest.mark.slow
@pytest.mark.parametrize("entries, words", [
    ("centre (0 0 0); radius 0;", ["radius", "above zero"]),
    ("centre (0 0 0); radius -1;", ["radius", "-1"]),
    ("centre (0 0 0);", ["radius"]),
    ("radius 1;", ["centre"]),
    ("centre (0 0 0); radius 1; diameter 2;", ["diameter", "centre"])])
def test_disc_that_is_none(box, entries, words):
    """Mistakes of a disc."""
    case = box(n=4, materials=LIQUIDS, fractions=lambda x, y: x < 0)
    add_points(case, "{ type all; material a; }"
               " { type disc; material b; %s }" % entries)
    text = message(case)
    for word in words + ["materialPointsProperties"]:
        assert word in text, text
