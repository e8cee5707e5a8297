"""refineScene: what it refines, what comes along, and what that is good for."""

import shutil

import numpy as np
import pytest

from cosserat.case import Case, RunError, TUTORIALS, fresh_case, residuals
from cosserat.refined import refine_scene
from cosserat.scenes.box import Box
from cosserat.scenes.levels import SLOT, corners, disc, lid, silo, surface
from cosserat.scenes.silo import prepare
from cosserat.references import SILO_SCENES


def areas(case):
    """Areas of the polygons of a case, whose corners go around."""
    def area(p):
        x, y = p[:, 0], p[:, 1]
        return abs(x @ np.roll(y, -1) - y @ np.roll(x, -1))/2
    return np.array([area(p) for p in case.polygons()])


def sides(case):
    """Nodes hanging on each side of each cell, corners left out."""
    for p in case.polygons():
        a = p[:, :2] - np.roll(p[:, :2], 1, axis=0)
        b = np.roll(a, -1, axis=0)
        straight = np.abs(np.cross(a, b)) < 1e-6*np.hypot(*a.T)*np.hypot(*b.T)
        first = int(np.flatnonzero(~straight)[0])
        run = 0
        for hanging in np.roll(straight, -first)[1:].tolist() + [False]:
            if not hanging:
                yield run
            run = run + 1 if hanging else 0


def levels(case):
    """Levels of the cells."""
    file = case.mesh_file("cellLevel")
    return file.list(file.start, "label")[0].astype(int)


def check(case, area, tolerance=1e-9):
    """The mesh is one, fills what it did, and nodes hang one by one."""
    assert "Mesh OK." in case.run("checkMesh", log=False).stdout
    assert areas(case).sum() == pytest.approx(area, rel=tolerance)
    assert max(sides(case)) == 1


@pytest.mark.parametrize("entries, level, cells", [
    (corners(3, 2), 3, 4), (corners(2, 4, SLOT), 2, 12)])
def test_corners_are_found(tmp_path, entries, level, cells):
    """Those of the silo: twelve re-entrant ones or the four of the slot, with
    rings of cells of each level around."""
    case = prepare(Case.copy(TUTORIALS/"silo", tmp_path/"case"),
                   SILO_SCENES["start, 2/3"], 4)
    refine_scene(case, walls=entries)
    check(case, 71.375)
    found = levels(case)
    assert found.max() == level and found.min() == 0
    places = [(x, y) for x in (-0.5, 0.5) for y in (0, -0.25)]
    if cells == 4:
        places += [(x, y) for x in (-2.75, 2.75) for y in (5, -0.25)]
        places += [(x, y) for x in (-2.5, 2.5) for y in (5,)]
    middle = np.array([p[:, :2].mean(axis=0) for p in case.polygons()])
    way = np.min([np.abs(middle - place).max(axis=1) for place in places],
                 axis=0)
    h = 0.25*0.5**level
    # Rings of the finest cells, and then none
    assert set(found[way < cells/2*h]) == {level}
    assert found[way > (cells/2 + 4)*h].max() < level


#: A box that is not symmetric to the cells, twice refined
PLACE = ("type source; source boxToCell; levels 2;"
         " box (-0.21 -0.5 -1) (0.1 0.3 1);")


@pytest.mark.parametrize("mesh", ["quads", "triangles", "wavy"])
def test_any_polygons(tmp_path, mesh):
    """Cells of three and four corners and their parts; a linear flow stays
    exact on them."""
    def bend(x, y):
        return x + 0.05*np.sin(6*y), y + 0.05*np.sin(5*x)*np.cos(3*y)

    given = {side: ("exact", "type fixedValue; value uniform -1;")
             for side in ("left", "right", "bottom", "top")}
    case = Box(tmp_path/"case", n=8, walls=given,
               materials={"m": {"eta": 1, "etaC": 1, "R": 0.1}},
               U=lambda x, y: (x + 2*y, -y), omega=lambda x, y: 0*x - 1,
               warp=bend if mesh == "wavy" else None,
               triangles=mesh == "triangles",
               refined={"place": PLACE}).write()
    file = case.mesh_file("cellLevel")
    n = 64*(2 if mesh == "triangles" else 1)
    assert case.n_cells() > 2.5*n and len(
        file.list(file.start, "label")[0]) == case.n_cells()
    if mesh != "wavy":
        check(case, 1.0)
    case.run("cosseratPicFoam")
    x, y = case.centres()[:, :2].T
    U = case.field("U")[:, :2].T
    assert np.allclose(U, (x + 2*y, -y), atol=1e-8)
    assert np.allclose(case.field("omega"), -1, atol=1e-7)


def test_cyclic_patches(tmp_path):
    """Faces are split on both sides, and cells beyond are refined where nodes
    would hang two by two."""
    edge = ("type source; source boxToCell; levels 3;"
            " box (0.4 -0.1 -1) (0.5 0.1 1);")
    case = Box(tmp_path/"case", n=8, cyclic=True, g=(1, 0, 0),
               materials={"m": {"eta": 1, "etaC": 0, "R": 0, "rho": 1}},
               walls={side: ("type noSlip;", "type zeroGradient;")
                      for side in ("bottom", "top")},
               refined={"edge": edge}).write()
    check(case, 1.0)
    faces = [np.sort([f[:, 1].mean() for f in case.patch_faces()[name][1]])
             for name in ("left", "right")]
    assert len(faces[0]) > 8 and np.allclose(*faces)
    beyond = [level for level, p in zip(levels(case), case.polygons())
              if p[:, 0].min() < -0.499 and abs(p[:, 1].mean()) < 0.1]
    assert min(beyond) == 2
    case.run("cosseratPicFoam")
    y = case.centres()[:, 1]
    assert np.allclose(case.field("U")[:, 0], (0.25 - y**2)/2, rtol=0.05,
                       atol=2e-3)


@pytest.fixture(name="run", scope="module")
def run_fixture(tmp_path_factory):
    """The template, run for a while on a coarse mesh."""
    case = Case.copy(TUTORIALS/"template", tmp_path_factory.mktemp("run")/"a")
    case.substitute("system/blockMeshDict", {"nx": 16, "ny": 16})
    case.substitute("system/controlDict", {
        "endTime": 0.02, "deltaT": 0.01, "writeInterval": 0.02,
        "adjustTimeStep": "no", "startFrom": "latestTime"})
    case.measure("error", "errorIndicator", "executeControl writeTime;"
                 " writeControl writeTime;")
    case.override("points", properties="{ strain { type accumulatedStrain; } }")
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    return case


def copy(run, path):
    """A copy of a case with all that it has."""
    shutil.copytree(run.path, path)
    return Case(path)


@pytest.mark.slow
def test_points_come_along(run, tmp_path):
    """Those of cells that are refined but little stay as they are; others are
    split; materials keep their volume; the run goes on, also on two
    processors."""
    case = copy(run, tmp_path/"case")
    refine_scene(case, grains=surface(2, 1))
    volume, material = (case.cloud(n) for n in ("volume", "material"))
    before = {n: run.cloud(n) for n in ("volume", "material", "strain",
                                        "positions", "origId")}
    assert len(volume) > len(before["volume"])
    for m in (0, 1):
        assert volume[material == m].sum() == pytest.approx(
            before["volume"][before["material"] == m].sum(), rel=1e-12)
    whole = volume[:len(before["volume"])] == before["volume"]
    assert 0.5 < whole.mean() < 1
    for name, tolerance in (("positions", 1e-9), ("strain", 0), ("origId", 0)):
        now = case.cloud(name)[:len(whole)]
        assert np.allclose(now[whole], before[name][whole], rtol=0,
                           atol=tolerance), name
    # None shares its place with another
    places = case.cloud("positions").round(10)
    assert len(np.unique(places, axis=0)) == len(places)
    assert (case.path/"0.02/polyMesh/cellLevel").exists()
    assert not (case.path/"0.02/phi").exists()

    parallel = copy(case, tmp_path/"parallel")
    for each, ranks in ((case, 1), (parallel, 2)):
        each.substitute("system/controlDict", {"endTime": 0.03,
                                               "writeInterval": 0.01})
        if ranks > 1:
            each.run("decomposePar", "-latestTime")
        each.run("cosseratPicFoam", ranks=ranks)
    serial, shared = (
        residuals(each.log())[0] for each in (case, parallel))
    assert serial[3] < 70 and abs(serial[3] - shared[3]) <= 3
    rows = [each.table("power", "powerBalance.dat")[-1]
            for each in (case, parallel)]
    assert rows[0][0] == 0.03
    assert np.allclose(rows[0][1:3], rows[1][1:3], rtol=1e-4)


def test_without_overwrite(run, tmp_path):
    """The next time has mesh, fields and points; the one before is as it
    was."""
    case = copy(run, tmp_path/"case")
    (case.path/"system/refineSceneDict").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object x; }\n"
        f"refine {{ all {{ {surface(1)} }} }}\n")
    case.run("refineScene")
    assert case.times() == ["0.02", "0.03"]
    same = [(run.path/"0.02"/name).read_bytes()
            == (case.path/"0.02"/name).read_bytes() for name in ("U", "phi")]
    assert same == [True, True]
    file = case.path/"0.03/polyMesh/cellLevel"
    n = int(file.read_text().split("// * ")[1].split("\n", 1)[1].split()[0])
    assert len(case.field("U", "0.03")) == n > 256
    assert len(case.cloud("positions", "0.03")) == len(
        case.cloud("volume", "0.03"))


@pytest.mark.parametrize("entries, share", [
    ("share 0.1; rings 0;", 0.1), ("share 0.25; rings 0;", 0.25)])
def test_indicator(run, tmp_path, entries, share):
    """A share of the cells, once, with those that balance needs."""
    case = copy(run, tmp_path/"case")
    text = refine_scene(case, worst=f"type indicator; levels 3; {entries}")
    assert f"Level 1: {int(256*share)} cells chosen, "\
        f"{256 + 3*int(256*share)} cells" in text
    assert "Level 2" not in text


@pytest.mark.slow
@pytest.mark.parametrize("entries, words", [
    ("type corner; levels 1;", ["corner", "indicator", "surface"]),
    ("type corners; levels 0;", ["levels", "0", "1 to 20"]),
    ("type corners;", ["levels"]),
    ("type corners; levels 1; ring 3;", ["ring", "rings"]),
    ("type surface; levels 1; material sand;", ["sand", "grains"]),
    ("type indicator; levels 1; share 2;", ["share", "up to 1"]),
    ("type indicator; levels 1;", ["share", "threshold"]),
    ("type indicator; levels 1; field none; share 0.1;",
     ["none", "errorIndicator"]),
    ("type source; levels 1; source cellToCell; set a;", ["zoneToCell"]),
    ("type source; levels 20; source boxToCell; box (0 0 -1) (1 1 1);",
     ["maxCells"]),
])
def test_mistakes_are_told(run, entries, words):
    """With what is allowed; and nothing is written."""
    before = (run.path/"0.02/U").read_bytes()
    with pytest.raises(RunError) as said:
        refine_scene(run, here=entries)
    assert all(word in str(said.value) for word in words)
    assert (run.path/"0.02/U").read_bytes() == before


@pytest.mark.slow
@pytest.mark.parametrize("name", ["start, 2/3", "filled, 2/3"])
def test_rate_of_the_silo(tmp_path, name):
    """Below 2 % with six levels at the slot, without more iterations; the
    model of corners is right on refined cells too, and where cells at a corner
    are of two levels."""
    def error(selection, model=True):
        row = silo(fresh_case(tmp_path/"case", "silo"), name, 8, selection,
                   model)
        assert row["iterations"] < 56
        return row["error"]

    slot = corners(6, 4, SLOT)
    assert abs(error(slot)) < 0.006
    assert abs(error(slot, model=False)) < 0.045
    half = "type source; levels 1; source boxToCell; box (0.5 -2 -1) (2 2 1);"
    assert abs(error(half)) < 0.045 < error(half, model=False)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["disc", "disc, Cosserat"])
def test_surface_of_a_disc(tmp_path, name):
    """Three levels at its surface are as good as the finest cells all over, on
    a fifth of the cells."""
    fine = disc(tmp_path/"fine", name, 1e3, 128)
    row = disc(tmp_path/"case", name, 1e3, 16, surface(3))
    assert row["cells"] < fine["cells"]/3.5
    assert abs(row["error"]) < max(1.2*abs(fine["error"]), 1e-3)


def test_ends_of_a_lid_are_found(tmp_path):
    """Where the given velocity jumps."""
    row = lid(tmp_path/"case", "lid", 16, corners(2))
    case = Case(tmp_path/"case")
    finest = np.array([p[:, :2].mean(axis=0) for p, level in zip(
        case.polygons(), levels(case)) if level == 2])
    assert (finest[:, 1] > 1 - 8/64).all()
    assert len(finest) == 128 and abs(row["error"]) < 0.042
