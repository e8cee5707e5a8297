"""Accuracy against cost: extrapolation, presets that cases include, and the
comparison of a user's own case."""

import json
import re

import numpy as np
import pytest

from cosserat import exploration
from cosserat.case import FILES, ROOT, TUTORIALS, Case, worst_residual
from cosserat.scenes.box import count
from cosserat.tradeoff import extrapolate, front, refine, restrict

PRESETS = sorted(d.name for d in (ROOT/"etc/presets").iterdir())


def test_extrapolation_of_a_known_order():
    """Limit, order and uncertainty of q = 3 + h^p."""
    for p in (1, 2):
        coarse, middle, fine = (np.array([3 + h**p, -1 + 2*h**p])
                                for h in (0.4, 0.2, 0.1))
        limit, order, uncertainty = extrapolate(coarse, middle, fine)
        assert order == pytest.approx(p)
        assert limit == pytest.approx([3, -1])
        assert uncertainty == pytest.approx(0.1**p*(5/10)**0.5)


def test_front():
    """Neither beaten in cost and error at once, nor without an error."""
    assert front([1, 2, 3, 4, 0.5], [9, 5, 6, 1, None]) == [
        True, True, False, True, False]


def test_mean_on_a_coarser_mesh():
    """Weighted by volume."""
    fine = np.array([[0.1, 0], [0.3, 0], [0.8, 0]])
    mean = restrict(fine, np.array([1, 3, 2]), np.array([1.0, 5.0, 7.0]),
                    np.array([[0.25, 0], [0.75, 0]]))
    assert mean.ravel() == pytest.approx([4, 7])


def test_refined_mesh(tutorial):
    """Three halves of the cells of each of the silo's blocks, the one of its
    depth left."""
    case = tutorial("silo")
    before = case.n_cells()
    refine(case, 1.5)
    case.run("blockMesh")
    assert case.n_cells() == pytest.approx(2.25*before, rel=1e-9)


def with_preset(path, preset):
    """The inclusion for a few steps with a preset, by the lines that its page
    gives; without one where it is None."""
    case = Case.copy(TUTORIALS/"sinkingInclusion", path)
    case.substitute(FILES["control"], {"endTime": 8, "writeInterval": 8})
    mesh = case.path/FILES["mesh"]
    points = case.path/FILES["points"]
    points.write_text(re.sub(r"^(minPoints|velocity|integration).*;\n", "",
                             points.read_text(), flags=re.M))
    if preset:
        include = f'#include "$COSSERATPIC_ETC/presets/{preset}/'
        for file, name in (("points", "points"), ("solution", "flow"),
                           ("control", "control")):
            with (case.path/FILES[file]).open("a") as text:
                text.write(f'\n{include}{name}"\n')
        mesh.write_text(re.sub(
            r"^n\s.*;", f'{include}mesh"\n'
            "cells { fast 8; balanced 16; accurate 32; }\n"
            "n ${cells.${preset}};", mesh.read_text(), flags=re.M))
    else:
        case.substitute(FILES["mesh"], {"n": 16})
    count(case)
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    return case


def value(preset, file, key):
    """Entry of a preset as text."""
    text = (ROOT/"etc/presets"/preset/file).read_text()
    return re.search(rf"^\s*{key}\s+(\S+);", text, re.M)[1]


@pytest.mark.parametrize("preset", PRESETS)
def test_preset_runs(tmp_path, preset):
    """Its mesh, points, tolerance and integration are those of the run, and
    all that it says is read."""
    case = with_preset(tmp_path/"case", preset)
    n = {"fast": 8, "balanced": 16, "accurate": 32}[preset]
    log = case.log()
    assert case.n_cells() == n*n
    seeded = case.table("points", "pointStatistics.dat")[0]
    assert seeded[1] - seeded[10] + seeded[11] == (
        n*n*int(value(preset, "points", "pointsPerCell")))
    assert worst_residual(log) <= float(value(preset, "flow", "tolerance"))
    assert re.search(rf"integration {value(preset, 'points', 'integration')},",
                     log)
    assert float(re.search(r"tolerance (\S+),", log)[1]) == float(
        value(preset, "flow", "tolerance"))
    assert "reads" not in log


def test_balanced_is_the_default(tmp_path):
    """The same positions of all points as without it."""
    plain, given = (with_preset(tmp_path/f"{preset}", preset)
                    for preset in (None, "balanced"))
    assert (plain.cloud("positions") == given.cloud("positions")).all()


@pytest.mark.slow
def test_trade_off_of_a_case(tmp_path, monkeypatch, capsys):
    """A case far from the folder of the studies, its error estimate near the
    one on a finer mesh; the original is left alone."""
    case = Case.copy(TUTORIALS/"cavity", tmp_path/"mine")
    case.substitute(FILES["mesh"], {"n": 16})
    case.substitute(FILES["control"], {"endTime": 1e-6, "deltaT": 1e-6})
    before = sorted(case.path.rglob("*"))
    monkeypatch.setenv("COSSERATPIC_CALLER", str(tmp_path))
    exploration.main(["-case", "mine", "-points", "4"], "x", tmp_path)
    assert sorted(case.path.rglob("*")) == before
    rows = json.loads((tmp_path/"results/tradeOff.json").read_text())["rows"]
    assert [row["nCells"] for row in rows] == [64, 256, 1024, 256]
    assert rows[0]["error"] > 2*rows[1]["error"] > 4*rows[2]["error"] > 0
    assert rows[2]["error"] == rows[2]["errorUncertainty"]
    assert rows[2]["onFront"]
    assert (tmp_path/"results/tradeOff.png").stat().st_size > 20000
    assert "Velocity of the case" in capsys.readouterr().out
