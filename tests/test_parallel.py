"""Several processors, restarts, and runs that were killed."""

import re
import resource
import shutil
import signal
import subprocess

import numpy as np
import pytest

from cosserat.scenes.box import add_points
from cosserat.case import TUTORIALS, Case, RunError
from cosserat.scenes.decomposed import compare, costs
from cosserat.scenes.kills import compare as compare_killed, files
from cosserat.scenes.silo import mesh_entries


def silo(path, end=1e-4, tolerance=1e-10, **control):
    """A silo of half the resolution, meshed; ten steps or so."""
    case = Case.copy(TUTORIALS/"silo", path)
    case.substitute("system/blockMeshDict", mesh_entries(4))
    case.substitute("system/fvSolution", {"tolerance": tolerance})
    case.substitute("system/controlDict", {
        "endTime": end, "deltaT": 1e-5, "adjustTimeStep": "no",
        "writeInterval": 5e-5, "writePrecision": 17, **control})
    with open(case.path/"constant/materialPointsProperties", "a") as file:
        file.write("properties { strain { type accumulatedStrain; onMesh yes; }"
                   " }\n")
    case.run("blockMesh")
    return case


@pytest.fixture(name="serial", scope="module")
def serial_fixture(tmp_path_factory):
    """Ten steps on one processor, with block multigrid and direct."""
    cases = {}
    for block in ("automatic", "direct"):
        case = silo(tmp_path_factory.mktemp(block)/"case")
        choose(case, block)
        case.run("cosseratPicFoam")
        cases[block] = case
    return cases


def choose(case, block):
    """Set the preconditioner's block."""
    case.override("solution", creepingFlow=f"{{ maxIter 300;"
                  f" preconditioner {{ block {block}; }} }}")


@pytest.mark.slow
@pytest.mark.parametrize("method, ranks, n, block", [
    ("simple", 4, "(2 2 1)", "automatic"),
    ("hierarchical", 3, "(1 3 1)", "automatic"),
    ("ptscotch", 2, "(2 1 1)", "automatic"),
    ("scotch", 2, "(2 1 1)", "direct")])
def test_decompositions(serial, tmp_path, method, ranks, n, block):
    """Fields of one processor, measured within 2e-9 (direct: 2e-12), the same
    points, no more than a tenth more iterations."""
    case = silo(tmp_path/"case")
    choose(case, block)
    case.decompose(ranks, method, n)
    case.run("cosseratPicFoam", ranks=ranks)
    case.run("reconstructPar", "-latestTime")
    row = compare(case, serial[block])
    for name in ("U", "p", "omega"):
        assert row[f"diff{name}"] < (1e-8 if block == "automatic" else 1e-10)
    strain, expected = case.field("strain"), serial[block].field("strain")
    assert np.abs(strain - expected).max() < 1e-8*expected.max()
    assert row["points"] == len(serial[block].cloud("dye"))
    assert row["diffPoints"] < 1e-8
    assert row["volume"] == pytest.approx(
        serial[block].cloud("volume").sum(), rel=1e-12)
    assert (costs(case)["iterations"]
            <= 1.1*costs(serial[block])["iterations"])


@pytest.mark.slow
@pytest.mark.parametrize("form, adjust, ranks", [
    ("ascii", "no", 1), ("binary", "yes", 1), ("ascii", "yes", 2)])
def test_restart_is_bitwise(tmp_path, form, adjust, ranks):
    """Stopped and gone on: every file of the end is that of the run that was
    not stopped, with steps fixed or adjusted, older times purged."""
    whole = silo(tmp_path/"whole", 1.5e-4, 1e-6, writeFormat=form,
                 adjustTimeStep=adjust, purgeWrite=2)
    whole.decompose(ranks, "scotch")
    half = Case(shutil.copytree(whole.path, tmp_path/"half"))
    whole.run("cosseratPicFoam", ranks=ranks)
    half.substitute("system/controlDict", {"endTime": 5e-5})
    half.run("cosseratPicFoam", ranks=ranks)
    half.substitute("system/controlDict", {"endTime": 1.5e-4})
    half.run("cosseratPicFoam", ranks=ranks)
    assert " read, " in half.log()
    expected, found = files(whole, ranks), files(half, ranks)
    assert len(expected) >= 20*ranks
    assert {"strain", "gradUBefore", "lagrangian/materialPoints/strain"} <= {
        name for _, name in expected}
    assert expected.keys() == found.keys()
    assert [name for name in expected if expected[name] != found[name]] == []


@pytest.mark.slow
def test_restart_on_other_ranks(serial, tmp_path):
    """Half on one processor, the rest on three: the same to the tolerance."""
    case = silo(tmp_path/"case", 5e-5)
    case.run("cosseratPicFoam")
    case.decompose(3, "scotch")
    case.substitute("system/controlDict", {"endTime": 1e-4})
    case.run("cosseratPicFoam", ranks=3)
    case.run("reconstructPar", "-latestTime")
    assert " read, " in case.log()
    row = compare(case, serial["automatic"])
    assert max(row["diffU"], row["diffp"], row["diffomega"]) < 1e-8
    assert row["points"] == len(serial["automatic"].cloud("dye"))
    assert row["diffPoints"] < 1e-8


@pytest.mark.slow
@pytest.mark.parametrize("ranks, kills", [(1, 3), (2, 2)])
def test_killed_runs_go_on(tmp_path, ranks, kills):
    """kill -9 at random moments; times that are not whole are named and taken
    away; the end is that of the run left alone."""
    row = compare_killed(tmp_path, ranks, kills)
    assert row["files"] >= 20*ranks
    assert row["different"] == 0


def run_on_full_disk(case, size):
    """Run where no file can be longer than a size [bytes]; the log."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

    done = subprocess.run(
        ["cosseratPicFoam"], cwd=case.path, text=True, preexec_fn=limit,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
        timeout=case.timeout)
    assert done.returncode == 1
    return done.stdout


@pytest.mark.slow
@pytest.mark.parametrize("points, size, file", [
    (True, 200_000, "coordinates"), (False, 2500, "U")])
def test_full_disk(box, tmp_path, points, size, file):
    """The run stops and names the file; the time before, though all but one
    are purged, is usable: the end is that of the run left alone."""
    if points:
        case = silo(tmp_path/"case", 5e-5, 1e-6, purgeWrite=1)
    else:
        case = box(n=8, materials={"a": {"eta": 1, "etaC": 1, "R": .1}},
                   walls={"top": ("type fixedValue; value uniform (1 0 0);",
                                  "type zeroGradient;")})
        case.substitute("system/controlDict", {
            "startFrom": "latestTime", "endTime": 5e-5, "deltaT": 5e-5,
            "writeFormat": "ascii"})
        case.override("control", purgeWrite=1)
    case.run("cosseratPicFoam")
    first = case.times()
    case.substitute("system/controlDict", {"endTime": 1e-4})
    whole = Case(shutil.copytree(case.path, tmp_path/"whole"))
    whole.run("cosseratPicFoam")

    log = run_on_full_disk(case, size)
    assert re.search(rf"FATAL(.*\n)+?.*\b0\.0001/.*{file}\W", log), log[-2000:]
    assert case.times() == first + ["0.0001"]
    with pytest.raises(RunError, match="0.0001 of .* is not wholly written"):
        case.run("cosseratPicFoam")
    shutil.rmtree(case.path/"0.0001")
    case.run("cosseratPicFoam")
    assert files(case, 1) == files(whole, 1)


@pytest.mark.slow
def test_half_written_times_are_named(tmp_path):
    """What is missing or cut short stops the restart; nothing is seeded anew."""
    whole = silo(tmp_path/"whole", 1e-4, 1e-6, writeInterval=5e-5)
    whole.run("cosseratPicFoam")
    first, last = whole.times()

    def shorten(path):
        text = path.read_text()
        path.write_text(text[:2*len(text)//3])

    def change(path, pattern, new):
        """The third point, in the fourth row behind the number of points."""
        head, n, rest = re.split(r"^(\d+\n\()", path.read_text(), 1, re.M)
        rows = rest.split("\n")
        rows[3] = re.sub(pattern, new, rows[3])
        path.write_text(head + n + "\n".join(rows))

    cloud = "lagrangian/materialPoints"
    faults = [
        (lambda t: (t/"uniform/written").unlink(),
         rf"Time {last} of .* is not wholly written[^!]* before is {first}"),
        (lambda t: [shutil.rmtree(t), t.mkdir()],
         rf"Time {last} of .* is not wholly written[^!]* before is {first}"),
        (lambda t: shutil.rmtree(t/"lagrangian"),
         f'Time {last} of .* there are no points in "{last}/lagrangian'),
        (lambda t: shorten(t/"lagrangian/materialPoints/coordinates"),
         "lagrangian/materialPoints/coordinates"),
        (lambda t: shorten(t/"lagrangian/materialPoints/material"),
         "lagrangian/materialPoints/material"),
        (lambda t: (t/"lagrangian/materialPoints/volume").unlink(),
         "lagrangian/materialPoints/volume"),
        (lambda t: shorten(t/"U"), f"{last}/U"),
        (lambda t: change(t/cloud/"coordinates", r"\) \d+", ") 99999"),
         f"Point 2 of .*{last}/{cloud}.* is in cell 99999"),
        (lambda t: change(t/cloud/"coordinates", r"^\(\S+", "(7.5"),
         f"Point 2 of .*{last}/{cloud}.* at its coordinates .7.5"),
        (lambda t: change(t/cloud/"volume", ".+", "-1"),
         f"Point 2 of .*{last}/{cloud}.* volume -1"),
        (lambda t: change(t/cloud/"material", ".+", "7"),
         f"Point 2 of .*{last}/{cloud}.* of material 7"),
    ]
    for i, (spoil, message) in enumerate(faults):
        case = Case(shutil.copytree(whole.path, tmp_path/str(i)))
        spoil(case.path/last)
        case.substitute("system/controlDict", {"endTime": 2e-4})
        with pytest.raises(RunError, match=message):
            case.run("cosseratPicFoam")
        assert case.times()[-1] == last


@pytest.mark.slow
@pytest.mark.parametrize("n", ["(8 1 1)", "(2 4 1)"])
def test_points_cross_several_processors(box, n):
    """A rigid motion to the right by 3.2 cells a step, cyclic: slabs of one
    cell, and cyclic patches that are cut."""
    wall = ("type fixedValue; value uniform (1 0 0);", "type zeroGradient;")
    case = box(n=8, cyclic=True, walls={"bottom": wall, "top": wall},
               materials={"a": {"eta": 1, "etaC": 0, "R": 0}})
    add_points(case, "{ type all; material a; }", pointsPerCell=4)
    case.substitute("system/controlDict", {
        "endTime": 2, "deltaT": 0.4, "writeInterval": 5})
    case.solve(8, n=n)
    assert np.allclose(case.field("U"), [1, 0, 0], atol=1e-9)
    # Twice around: where they were
    places = case.cloud("positions")[:, :2]
    assert len(places) == 256
    grid = np.floor(places*16)/16 + 1/32
    assert np.abs(places - grid).max() < 1e-8
    assert len(np.unique(grid, axis=0)) == 256


def keep_points(case, chosen):
    """Take all other points away from the latest time; the cloud's folder."""
    cloud = case.path/case.times()[-1]/"lagrangian/materialPoints"
    for file in cloud.iterdir():
        head, _, rest = file.read_text().partition("* * //\n")
        body = rest[:rest.index("// ***")].strip()
        if "{" in body:
            body = body.replace(str(len(chosen)), str(chosen.sum()), 1)
        else:
            rows = body[body.index("(") + 1:body.rindex(")")].strip().split("\n")
            body = "\n".join([str(chosen.sum()), "(", *(
                row for row, keep in zip(rows, chosen) if keep), ")"])
        file.write_text(f"{head}* * //\n{body}\n")
    return cloud


@pytest.mark.slow
def test_processor_without_points(box):
    """Points of the right half only, carried to the left one, which had none."""
    wall = ("type fixedValue; value uniform (-1 0 0);", "type zeroGradient;")
    case = box(n=8, cyclic=True, walls={"bottom": wall, "top": wall},
               materials={"a": {"eta": 1, "etaC": 0, "R": 0}})
    add_points(case, "{ type all; material a; }", pointsPerCell=4,
               minPointsPerCell=0)
    case.substitute("system/controlDict", {
        "startFrom": "latestTime", "endTime": 0.01, "deltaT": 0.01})
    case.run("cosseratPicFoam")
    right = case.cloud("positions")[:, 0] > 0
    cloud = keep_points(case, right)
    case.substitute("system/controlDict", {
        "endTime": 0.46, "deltaT": 0.05, "writeInterval": 10})
    case.decompose(2)
    assert not (case.path/"processor0"/cloud.relative_to(case.path)
                /"material").exists()
    case.run("cosseratPicFoam", ranks=2)
    case.run("reconstructPar", "-latestTime")
    x = case.cloud("positions")[:, 0]
    assert len(x) == right.sum()
    expected = np.repeat(np.arange(8)/16 + 1/32 - 0.46, 16)
    assert np.abs(np.sort(x) - expected).max() < 1e-8


@pytest.mark.slow
def test_weights_balance_points(box):
    """Points in the right half only: pointStatistics counts them, and
    decomposePar gives each processor as much of cells and points together."""
    case = box(n=16, materials={"a": {"eta": 1, "etaC": 0, "R": 0}})
    add_points(case, "{ type all; material a; }", pointsPerCell=4,
               minPointsPerCell=0)
    case.measure("count", "pointStatistics",
                 "cellCost 2; writeControl writeTime;")
    case.substitute("system/controlDict", {"startFrom": "latestTime"})
    case.run("cosseratPicFoam")
    keep_points(case, case.cloud("positions")[:, 0] > 0)
    case.substitute("system/controlDict", {"endTime": 2})
    case.run("cosseratPicFoam")

    row = case.table("count", "pointStatistics.dat")[-1]
    assert row[:7] == pytest.approx([2, 512, 2, 2, 0, 4, 128])
    # The half of the mesh; nothing has come in or gone since
    assert row[7:14] == pytest.approx([0.05, 0, 0, 0, 0, 0, 0])
    assert set(case.field("pointWeight")) == {2, 6}

    def shares(field):
        case.decompose(2, field=field)
        return [Case(case.path/f"processor{i}").field("pointWeight").sum()
                for i in (0, 1)]

    assert max(shares("pointWeight")) < 1.05*512
    assert max(shares(None)) > 1.2*512
