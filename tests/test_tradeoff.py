"""Accuracy against cost: extrapolation, presets that cases include, and the
comparison of a user's own case."""

import json
import re

import numpy as np
import pytest

from cosserat import exploration
from cosserat.analytic import AnnularCouette, Material
from cosserat.case import FILES, ROOT, TUTORIALS, Case, worst_residual
from cosserat.scenes.box import count
from cosserat.tradeoff import (at_points, distance, extrapolate, front,
                               observed_order, refine, verdict)

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


@pytest.mark.parametrize("steps, order, word", [
    ((4.0, 1.0), 2, ""), ((1.0, 1.0), 0, "NO ERROR CAN BE GIVEN"),
    ((1.0, 2.0), -1, "NO ERROR CAN BE GIVEN"), ((2**0.5, 1.0), 0.5, "A GUESS"),
    ((16.0, 1.0), 4, "order 3 was taken"), ((1.0, 0.0), np.inf, "order 3")])
def test_steps_that_do_not_shrink_are_told(steps, order, word):
    """The observed order is not within bounds, and what it is worth is said
    plainly."""
    first, second = steps
    found = observed_order(np.zeros(3), np.full(3, first),
                           np.full(3, first + second))
    assert found == pytest.approx(order)
    assert verdict(found).startswith(word) and bool(word) == bool(
        verdict(found))


def test_front():
    """Neither beaten in cost and error at once, nor without an error."""
    assert front([1, 2, 3, 4, 0.5], [9, 5, 6, 1, None]) == [
        True, True, False, True, False]


def test_values_between_cells():
    """A cubic at the corners of cells, a value where a centre is, and a row of
    cells one wide."""
    def cubic(x, y):
        return np.column_stack([x**3 - 2*x*x*y + y, 1 + x*y*y])

    x, y = (axis.ravel() for axis in np.meshgrid(*[np.arange(8)/8]*2))
    cells = np.column_stack([x, y])
    points = np.array([[0.4375, 0.5625], [0.8125, 0.0625], [0.25, 0.5]])
    assert at_points(cells, cubic(x, y), points) == pytest.approx(
        cubic(*points.T))
    line = np.column_stack([0*y[::8], y[::8]])
    assert at_points(line, y[::8]**2, np.array([[0, 0.3125]]), n=8) == (
        pytest.approx(0.3125**2))


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
    exploration.main(["-case", "mine", "-points", "4", "-time", "2e-6"], "x",
                     tmp_path)
    assert sorted(case.path.rglob("*")) == before
    rows = json.loads((tmp_path/"results/tradeOff.json").read_text())["rows"]
    assert [row["nCells"] for row in rows] == [64, 256, 1024, 256]
    assert rows[0]["error"] > 1.5*rows[1]["error"] > 2.2*rows[2]["error"] > 0
    assert rows[2]["error"] == rows[2]["errorUncertainty"]
    assert rows[2]["onFront"]
    assert (tmp_path/"results/tradeOff.png").stat().st_size > 20000
    out = capsys.readouterr().out
    assert "Errors of the case at 2e-06 s, 256 cells" in out
    assert out.count("observed order") == 3
    assert (tmp_path/"runs/tradeOff/0.5-own/2e-06").is_dir()


@pytest.mark.slow
def test_error_of_a_case_is_the_true_one(tmp_path):
    """The tutorial annularCouette at rest: errors of U and omega beside those
    by the analytic solution."""
    case = Case.copy(TUTORIALS/"annularCouette", tmp_path/"mine")
    case.substitute(FILES["mesh"], {"nAcross": 8, "nQuarter": 12})
    case.substitute(FILES["control"], {"endTime": 1e-6, "deltaT": 1e-6})
    row = exploration.explore(case.path, tmp_path/"runs", 0.5, [])[1]

    middle = Case(tmp_path/"runs/1-own")
    x, y = middle.centres()[:, :2].T
    r = np.hypot(x, y)
    exact = AnnularCouette(Material(1000, 1000, 0.2), (1, 2), (1, 0), (1, 0))
    u = np.column_stack([-exact.u(r)*y/r, exact.u(r)*x/r])
    assert row["error"] == pytest.approx(
        distance(middle.field("U")[:, :2], u), rel=0.3)
    assert row["errorOmega"] == pytest.approx(
        distance(middle.field("omega"), exact.omega(r)), rel=0.3)
    assert 1.5 < row["observedOrder"] < 2.6
    assert 1.5 < row["observedOrderOmega"] < 2.9
