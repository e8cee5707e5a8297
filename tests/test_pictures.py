"""What users look at: VTK files read back, pictures and animations."""

import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
from matplotlib.image import imread
from PIL import Image

from cosserat import picture
from cosserat.case import Case, TUTORIALS
from cosserat.mirrored import opened
from cosserat.scenes.axialFlows import narrowing_pipe


@pytest.fixture(name="slump", scope="module")
def slump_fixture(tmp_path_factory):
    """The slumping column, small, at two times."""
    case = Case.copy(TUTORIALS/"columnSlump",
                     tmp_path_factory.mktemp("pictures")/"case")
    case.substitute("system/blockMeshDict", {"nx": 16, "ny": 8})
    case.substitute("system/controlDict",
                    {"endTime": 1, "writeInterval": 0.5})
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    return case


def arrays(path):
    """Arrays of a VTK XML file in ascii by the part they are in and name."""
    found = {}
    for part in ElementTree.parse(path).iter():
        for array in part.findall("DataArray"):
            values = np.array(array.text.split(), float)
            n = int(array.get("NumberOfComponents", 1))
            found[part.tag, array.get("Name")] = (
                values.reshape(-1, n) if n > 1 else values)
    return found


def test_foamToVTK(slump):
    """Mesh, fields and cloud in VTK files are those of the case."""
    slump.run("foamToVTK", "-ascii", "-latestTime")
    (points,) = slump.path.glob("VTK/lagrangian/materialPoints/*.vtp")
    found = arrays(points)
    assert np.allclose(found["Points", "Points"], slump.cloud("positions"),
                       atol=1e-6)
    for name in ("material", "dye", "volume"):
        assert np.allclose(found["PointData", name], slump.cloud(name),
                           rtol=1e-6)
    (mesh,) = slump.path.glob("VTK/*/internal.vtu")
    found = arrays(mesh)
    for name in ("U", "p", "omega", "alpha.grains"):
        assert np.allclose(found["CellData", name], slump.field(name),
                           rtol=1e-5, atol=1e-6)


def draw(monkeypatch, case, file, *options):
    """Run foamPicture."""
    monkeypatch.setattr("sys.argv", ["foamPicture", str(case.path), "-o",
                                     str(file), *options])
    picture.main()


def test_picture_of_the_points(slump, tmp_path, monkeypatch):
    """As much of the picture has the grains' colours as they have of the
    scene: a fifth."""
    draw(monkeypatch, slump, tmp_path/"points.png")
    colours = imread(tmp_path/"points.png")[:, :, :3]
    wanted = [int(picture.MATERIAL[1][i:i + 2], 16)/255 for i in (1, 3, 5)]
    dye = [int(picture.DYE[i:i + 2], 16)/255 for i in (1, 3, 5)]
    share = sum((np.abs(colours - c).max(axis=2) < 0.02).mean()
                for c in (wanted, dye))
    assert 0.08 < share < 0.2


@pytest.mark.slow
@pytest.mark.parametrize("options", [
    ("-field", "omega"), ("-field", "U", "-component", "y", "-arrows")])
def test_picture_of_a_field(slump, tmp_path, monkeypatch, options):
    """A field colours the scene."""
    draw(monkeypatch, slump, tmp_path/"field.png", *options)
    colours = imread(tmp_path/"field.png")[:, :, :3]
    assert len(np.unique(colours.reshape(-1, 3).round(2), axis=0)) > 50


@pytest.mark.slow
def test_outlines(slump, tmp_path, monkeypatch):
    """A line where the speed is a tenth of its largest, and another one of a
    field: both add to the picture, and lie where the values do."""
    pictures = []
    for i, options in enumerate((
            (), ("-outline", "speed", "0.1"),
            ("-outline", "speed", "0.1", "-outline", "alpha.grains",
                                          "0.5"))):
        file = tmp_path/f"{i}.png"
        draw(monkeypatch, slump, file, "-field", "alpha.grains", *options)
        pictures.append(imread(file)[:, :, :3])
    red = [(np.abs(p - (0xc2/255, 0x2a/255, 0x2a/255)).max(axis=2) < 0.05).sum()
           for p in pictures]
    assert red[0] < 5 and red[1] > 200 and red[2] > red[1] + 200

    axes = picture.plt.figure().gca()
    lines = picture.draw_outline(axes, slump, slump.times()[-1], "speed", 0.1)
    at = np.concatenate(lines.allsegs[0])
    speed = np.linalg.norm(slump.field("U"), axis=1)
    near = np.abs(slump.centres()[:, None, :2] - at).sum(axis=2).argmin(axis=0)
    assert np.median(speed[near])/speed.max() == pytest.approx(0.1, abs=0.05)


def test_animation(slump, tmp_path, monkeypatch):
    """One frame a time, which differ."""
    draw(monkeypatch, slump, tmp_path/"all.gif", "-animate", "-field", "U")
    with Image.open(tmp_path/"all.gif") as moving:
        assert moving.n_frames == 2
        frames = []
        for i in range(2):
            moving.seek(i)
            frames.append(np.array(moving.convert("RGB")))
    assert (frames[0] != frames[1]).any()


@pytest.mark.parametrize("options, words", [
    (("-field", "velocity"), "alpha.grains"), (("-time", "7"), "0.5 1"),
    (("-outline", "Gamma", "1"), "alpha.grains"),
    (("-outline", "speed", "slow"), "no number slow")])
def test_what_is_not_there(slump, tmp_path, monkeypatch, capsys, options,
                           words):
    """Mistakes are told with what there is."""
    with pytest.raises(SystemExit):
        draw(monkeypatch, slump, tmp_path/"x.png", *options)
    assert words in capsys.readouterr().err


def test_wedges_are_mirrored(tmp_path, monkeypatch):
    """Cells, points and fields of both halves; omega about the normal of the
    plane, which turns round behind the axis."""
    pipe = narrowing_pipe(tmp_path/"case", 4, steps=2)
    both = opened(pipe.path)
    n = pipe.n_cells()
    assert len(both.polygons()) == 2*n == len(both.field("U"))
    assert np.allclose(both.centres()[n:], pipe.centres()*[1, -1, 1])
    assert np.allclose(both.field("U")[n:], pipe.field("U")*[1, -1, 1])
    assert np.allclose(both.field("omega")[n:], -pipe.field("omega"))
    assert np.allclose(both.field("p")[n:], pipe.field("p"))
    y = both.cloud("positions")[:, 1]
    assert len(y) == 2*len(pipe.cloud("dye")) and abs(y.sum()) < 1e-9
    assert opened(pipe.path, half=True).n_cells() == n
    shapes = []
    for options in ([], ["-half"]):
        draw(monkeypatch, pipe, tmp_path/"a.png", "-field", "U", "-arrows",
             *options)
        shapes.append(imread(tmp_path/"a.png").shape)
    assert shapes[0][0] > 1.3*shapes[1][0]
