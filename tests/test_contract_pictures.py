"""Cases as arrays and pictures whatever their format and their plane; units,
and the views that one prints."""

import os
import re
import shutil
import subprocess

import numpy as np
import pytest
from matplotlib import pyplot

from cosserat import picture, units
from cosserat.scenes.box import add_points
from cosserat.case import Case

LIQUIDS = {"air": {"eta": 1, "etaC": 0, "R": 0},
           "sand": {"eta": 10, "etaC": 10, "R": 0.1, "rho": 10}}

REGIONS = ("{ type all; material air; } { type box; material sand;"
           " min (-0.25 -0.1 -0.2) ; max (0.1 0.3 0.2); }")

DYE = "{ type bands; across (1 0 0); start -0.25; width 0.05; period 0.1; }"

#: The plane of a case by where its x and y have gone
TURNED = {"xy": (0, 1, 2), "xz": (0, 2, 1), "yz": (1, 2, 0)}


def turned(text, order, flip=False):
    """Vectors of three numbers with their components elsewhere; flip: the
    last of three against its direction, where the turn is a mirror else."""

    def turn(match):
        new = [None]*3
        for i, j in enumerate(order):
            new[j] = match[i + 1]
        if flip:
            new[order[2]] = f"{-float(new[order[2]]):g}"
        return f"({' '.join(new)})"

    number = r"(-?[\d.]+(?:e[-+]?\d+)?)"
    return re.sub(rf"\(\s*{number}\s+{number}\s+{number}\s*\)", turn, text)


def turn(case, plane):
    """Turn a case of the plane xy into another one."""
    order = TURNED[plane]
    for name in ("constant/g", "0/U", "constant/materialPointsProperties"):
        file = case.path/name
        file.write_text(turned(file.read_text(), order))
    file = case.path/"system/blockMeshDict"
    head, vertices, rest = re.split(
        r"(vertices .*;)", file.read_text(), maxsplit=1)
    file.write_text(head + turned(vertices, order, plane == "xz") + rest)


@pytest.fixture(name="scene", scope="module")
def scene_fixture(tmp_path_factory):
    """Function that makes a sinking block in a plane and a format, once."""
    from cosserat.scenes.box import Box
    made = {}

    def make(plane="xy", format="ascii", compression="off", handler=None):
        key = (plane, format, compression, handler)
        if key in made:
            return made[key]
        case = Box(tmp_path_factory.mktemp("p")/"case", n=8, g=(0, -1, 0),
                   materials=LIQUIDS, fractions=lambda x, y: x < 0).write()
        add_points(case, REGIONS, DYE, pointsPerCell=9)
        case.override("control", writeFormat=format,
                      writeCompression=compression)
        turn(case, plane)
        case.run("blockMesh")
        if handler:
            os.environ["FOAM_FILEHANDLER"] = handler
        try:
            case.solve(2 if handler else 1)
        finally:
            os.environ.pop("FOAM_FILEHANDLER", None)
        made[key] = case
        return case

    return make


FORMATS = [("binary", "off", None), ("ascii", "on", None),
           ("binary", "on", None), ("binary", "off", "collated")]


@pytest.mark.slow
@pytest.mark.parametrize("plane", TURNED)
@pytest.mark.parametrize("format, compression, handler", FORMATS[:3])
def test_arrays_are_those_of_ascii(scene, plane, format, compression, handler):
    """Mesh, fields and cloud in each plane and format are those of the plane
    xy in ascii, turned."""
    plain, case = scene(), scene(plane, format, compression, handler)
    i, j = case.plane()
    assert "xyz"[i] + "xyz"[j] == plane
    assert np.allclose(case.field("U")[:, [i, j]], plain.field("U")[:, :2],
                       atol=1e-6)
    assert np.allclose(case.field("alpha.sand"), plain.field("alpha.sand"))
    for ours, theirs in zip(case.polygons(), plain.polygons()):
        assert np.allclose(ours[:, [i, j]].mean(axis=0),
                           theirs[:, :2].mean(axis=0))
    assert np.allclose(case.cloud("positions")[:, [i, j]],
                       plain.cloud("positions")[:, :2], atol=1e-6)
    for name in ("material", "dye", "volume"):
        assert np.allclose(case.cloud(name), plain.cloud(name), rtol=1e-9)
    assert np.allclose(case.patch_field("p", "bottom"),
                       plain.patch_field("p", "bottom"), atol=1e-6)
    assert np.isclose(case.centroid(1)[j], plain.centroid(1)[1], atol=1e-6)


@pytest.mark.slow
def test_collated(scene):
    """Of two ranks, reconstructed."""
    plain, case = scene(), scene("xy", "binary", "off", "collated")
    assert (case.path/"processors2").is_dir()
    assert np.allclose(case.field("U"), plain.field("U"), atol=1e-6)
    assert len(case.cloud("dye")) == len(plain.cloud("dye"))
    assert np.isclose(case.centroid(1)[1], plain.centroid(1)[1], atol=1e-6)


def draw(case, file, *options):
    """foamPicture as a user calls it, from elsewhere."""
    return subprocess.run(
        ["foamPicture", str(case.path), "-o", str(file), *options],
        cwd=file.parent, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        text=True, check=False)


def shares(file):
    """Shares of a picture that have the colours of sand and of dye."""
    colours = pyplot.imread(file)[:, :, :3]
    found = []
    for name in (picture.MATERIAL[1], picture.DYE):
        wanted = [int(name[i:i + 2], 16)/255 for i in (1, 3, 5)]
        found.append((np.abs(colours - wanted).max(axis=2) < 0.02).mean())
    return np.array(found)


@pytest.mark.slow
@pytest.mark.parametrize("plane, format, compression", [
    ("xz", "ascii", "off"), ("yz", "binary", "off"), ("xy", "binary", "on"),
    ("xz", "ascii", "on")])
def test_picture_is_that_of_ascii_in_xy(scene, tmp_path, plane, format,
                                        compression):
    """As much sand and dye."""
    for name, case in (("plain.png", scene()),
                       ("other.png", scene(plane, format, compression))):
        done = draw(case, tmp_path/name)
        assert done.returncode == 0, done.stdout
    plain, other = shares(tmp_path/"plain.png"), shares(tmp_path/"other.png")
    assert (plain > 0.01).all()
    assert np.allclose(other, plain, rtol=0.05)


@pytest.mark.slow
def test_what_is_not_reconstructed_is_told(scene, tmp_path):
    """Without a traceback."""
    case = Case(shutil.copytree(scene("xy", "binary", "off", "collated").path,
                                tmp_path/"case"))
    shutil.rmtree(case.path/"constant/polyMesh")
    for time in case.times():
        shutil.rmtree(case.path/time)
    (case.path/"constant/polyMesh").mkdir()
    done = draw(case, tmp_path/"x.png")
    assert done.returncode and "run blockMesh" in done.stdout
    (case.path/"constant/polyMesh/faces").write_text("")
    done = draw(case, tmp_path/"x.png")
    assert done.returncode and "reconstructPar" in done.stdout
    assert "Traceback" not in done.stdout


@pytest.mark.parametrize("dimensions, unit", [
    ("0 1 -1 0 0 0 0", "m/s"), ("1 -1 -2 0 0 0 0", "Pa"), ("0 0 -1 0 0", "1/s"),
    ("1 0 -2 0 0 0 0", "Pa m"), ("0 0 0 0 0 0 0", ""),
    ("1 -1 -3 0 0 0 0", "W/m$^3$"), ("0 2 -3 1 0 0 0", "m$^{2}$ s$^{-3}$ K"),
    ("m s^-1", "m s$^{-1}$")])
def test_units(dimensions, unit):
    """As one writes them, of known and other dimensions."""
    assert units.unit(dimensions) == unit


@pytest.mark.slow
@pytest.mark.parametrize("field, component, text", [
    ("omega", None, "omega [1/s]"), ("U", None, "|U| [m/s]"),
    ("U", "y", "U$_{y}$ [m/s]"), ("p", None, "p [Pa]"),
    ("sigma", "xy", "sigma$_{xy}$ [Pa]"), ("alpha.sand", None, "alpha.sand"),
    ("coupleStress", "x", "coupleStress$_{x}$ [Pa m]")])
def test_unit_of_the_colour_bar(scene, tmp_path, field, component, text):
    """Of the field that is drawn, in binary and compressed as well."""
    for case in (scene(), scene("xy", "binary", "on")):
        assert picture.quantity(case, field, case.times()[-1],
                                component) == text
    options = ("-component", component) if component else ()
    done = draw(scene(), tmp_path/"a.svg", "-field", field, *options)
    assert done.returncode == 0, done.stdout
    assert f"<!-- {text} -->" in (tmp_path/"a.svg").read_text()


def test_component_of_a_tensor(scene):
    """The xy of sigma is its second number, and a vector has none."""
    values = scene().field("sigma")
    assert (picture.select(values, "xy") == values[:, 1]).all()
    assert (picture.select(values, "yx") == values[:, 3]).all()
    with pytest.raises(ValueError):
        picture.select(scene().field("U"), "xy")


@pytest.mark.slow
def test_arrows_have_a_scale(scene, tmp_path):
    """A key with a speed, to one digit."""
    done = draw(scene(), tmp_path/"a.svg", "-arrows")
    assert done.returncode == 0, done.stdout
    speed = re.search(r"<!-- (\S+) m/s -->", (tmp_path/"a.svg").read_text())[1]
    largest = np.hypot(*scene().field("U")[:, :2].T).max()
    assert float(speed) == pytest.approx(largest, rel=0.35)


@pytest.mark.parametrize("plane", TURNED)
def test_streamlines_are_those_of_the_flow(scene, plane):
    """Of a rigid rotation they are circles, and outside the mesh is none."""
    case = scene(plane)
    centres, _ = picture.flow_in_plane(case, case.times()[-1])
    figure, axes = pyplot.subplots()
    turning = np.stack([-centres[:, 1], centres[:, 0]], axis=1)

    class Turned(Case):
        """The case with another velocity."""

        def field(self, name, time=None):
            values = np.zeros((len(turning), 3))
            values[:, self.plane()] = turning
            return values

    lines = picture.draw_streamlines(axes, Turned(case.path), case.times()[-1])
    pyplot.close(figure)
    segments = np.array(lines.lines.get_segments())
    assert len(segments) > 100 and np.abs(segments).max() <= 0.5 + 1e-9
    radii = np.hypot(segments[..., 0], segments[..., 1])
    assert np.abs(np.diff(radii, axis=1)).max() < 0.02


@pytest.mark.slow
def test_views_of_dye_and_names(scene, tmp_path):
    """Marks in their colours, materials by name, in the legend too."""
    done = draw(scene(), tmp_path/"a.svg", "-dye", "-material", "sand")
    assert done.returncode == 0, done.stdout
    text = (tmp_path/"a.svg").read_text()
    for word in ("sand", "dye 1", "dye 4"):
        assert f"<!-- {word} -->" in text, word
    assert "<!-- air -->" not in text
    done = draw(scene(), tmp_path/"a.png", "-material", "gold")
    assert done.returncode and "air sand" in done.stdout
    done = draw(scene(), tmp_path/"a.pdf", "-streamlines", "-dye", "-arrows")
    assert done.returncode == 0 and (tmp_path/"a.pdf").stat().st_size > 1e4
