"""A planar mesh is one layer of cells, straight across: what is not is refused
with the cell and its place, what merely looks unusual is not."""

import re

import numpy as np
import pytest

from cosserat.scenes.box import add_points

LIQUIDS = {"a": {"eta": 1, "etaC": 0, "R": 0, "rho": 0},
           "b": {"eta": 10, "etaC": 10, "R": 0.1, "rho": 10}}


@pytest.fixture(name="block")
def block_fixture(box):
    """Function that makes a heavy block in a box, of points."""

    def make(target="case", **options):
        case = box(target, n=8, materials=LIQUIDS, g=(0, -10, 0),
                   fractions=lambda x, y: x < 0, **options)
        add_points(case, "{ type all; material a; } { type box; material b;"
                   " min (-0.25 -0.1 -1); max (0.1 0.3 1); }")
        return case

    return make


def layered(case, layers):
    """Mesh the case again in so many layers, with fields for any mesh."""
    path = case.path/"system/blockMeshDict"
    path.write_text(path.read_text().replace("(8 8 1)", f"(8 8 {layers})"))
    for field in (case.path/"0").iterdir():
        if field.name not in ("U", "p_rgh", "omega"):
            field.unlink()
            continue
        zero = "(0 0 0)" if field.name == "U" else "0"
        field.write_text(re.sub(r"nonuniform [^;]*;", f"uniform {zero};",
                                field.read_text(), count=1))
    case.run("blockMesh")


def move(case, function):
    """Move the points of the mesh, an array of (x, y, z)."""
    path = case.path/"constant/polyMesh/points"
    head, rows = path.read_text().split("\n(\n", 1)
    points = np.array([row.strip("()").split() for row in rows.split("\n")
                       if row.startswith("(")], float)
    points = function(points)
    path.write_text(head + "\n(\n" + "\n".join(
        f"({x!r} {y!r} {z!r})" for x, y, z in points.tolist()) + "\n)\n")


def message(case):
    """The error that the solver ends with, before the first step."""
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode and "Solving for" not in done.stdout, done.stdout
    return done.stdout[done.stdout.index("FOAM FATAL"):]


def place(case, text):
    """The cell of a message, which is where the message says."""
    cell, *at = re.search(r"cell (\d+) at \((\S+) (\S+) \S+\)", text).groups()
    assert int(cell) < case.n_cells()
    return int(cell), np.array(at, float)


@pytest.mark.slow
@pytest.mark.parametrize("layers", [2, 3])
def test_layers(block, layers):
    """More than one."""
    case = block()
    layered(case, layers)
    text = message(case)
    cell, at = place(case, text)
    assert cell == 0 and np.allclose(at, -0.4375)
    for word in ("not one layer", "1 faces of type empty", "checkMesh"):
        assert word in text, text


@pytest.mark.parametrize("slant", [(0.01, 0), (-0.03, 0.04), (0, 1e-4)])
def test_slanted_extrusion(block, slant):
    """Front and back that are not over each other."""
    case = block()

    def slide(points):
        points[:, :2] += np.outer(points[:, 2], slant)*10
        return points

    move(case, slide)
    text = message(case)
    place(case, text)
    assert "a corner in front that is" in text
    assert float(re.search(r"that is (\S+) m", text)[1]) == pytest.approx(
        np.hypot(*slant), rel=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("change, words", [
    (lambda p: p*(1, 1, -1), "has the volume -"),
    (lambda p: p*(-1, 1, 1), "has the volume -"),
    (lambda p: np.where(p[:, :1] < -0.3, (-0.5, 0, 0) + p*(0, 1, 1), p),
     "has the volume")])
def test_volume(block, change, words):
    """Turned inside out, and flattened by the digits of its points."""
    case = block()
    move(case, change)
    text = message(case)
    place(case, text)
    assert words in text and "positive volume" in text


def test_face_that_is_turned_round(block):
    """One of all faces."""
    case = block()
    path = case.path/"constant/polyMesh/faces"
    text = path.read_text()
    first = re.search(r"4\((\d+) (\d+) (\d+) (\d+)\)", text)
    path.write_text(text[:first.start()] + "4({3} {2} {1} {0})".format(
        *first.groups()) + text[first.end():])
    assert "turned round" in message(case)


def test_one_corner_out_of_place(block):
    """As a file edited by hand."""
    case = block()

    def nudge(points):
        which = np.argmin(np.linalg.norm(points - (0.25, 0.125, 0.1), axis=1))
        points[which, 0] += 0.01
        return points

    move(case, nudge)
    text = message(case)
    _, at = place(case, text)
    assert np.abs(at - (0.25, 0.125)).max() < 0.08
    assert "0.01 m beside" in text


@pytest.mark.slow
def test_what_rounding_leaves_is_borne(block):
    """Corners over each other to a millionth: the flow of the exact mesh."""
    exact, case = block("exact"), block("case")
    generator = np.random.default_rng(3)
    move(case, lambda p: p + generator.uniform(-1, 1, p.shape)
         * np.array([1e-8, 1e-8, 0]))
    power = []
    for each in (exact, case):
        each.run("cosseratPicFoam", "-solveOnce")
        power.append(each.table("power", "powerBalance.dat")[-1][1])
    assert power[1] == pytest.approx(power[0], rel=1e-5)


@pytest.mark.parametrize("options", [
    {"triangles": True},
    {"warp": lambda x, y: (x + 0.2*y**2, y - 0.3*x*(y**2 - 0.25))},
    {"warp": lambda x, y: (1e-5*x, 1e-5*y)},
    {"warp": lambda x, y: (1e5*x, 3e5*y)}])
def test_other_meshes_are_borne(box, options):
    """Triangles, curved and stretched ones, small and large."""
    case = box(n=8, materials={"a": LIQUIDS["b"]},
               walls={"top": ("type fixedValue; value uniform (1 0 0);",
                              "type zeroGradient;")}, tolerance=1e-6,
               **options)
    case.run("cosseratPicFoam", "-solveOnce")


@pytest.mark.slow
def test_on_two_ranks(block):
    """Each rank looks at its part."""
    case = block()
    layered(case, 2)
    case.decompose(2)
    done = case.run("cosseratPicFoam", ranks=2, check=False)
    assert done.returncode and "not one layer" in done.stdout
