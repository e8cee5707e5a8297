"""The flow solve at extreme parameters: iterations, which solver is chosen,
and no work where nothing has changed. Bounds from validation/Allrun extremes,
on half its cells."""

import re

import numpy as np
import pytest

from cosserat.analytic import Material
from cosserat.case import residuals
from cosserat.scenes.block import DEFAULT, block, measure
from cosserat.results import pressure_work
from cosserat.scenes.layers import WALLS, run_layer
from cosserat.scenes.parts import run as run_scene

#: parameters: (iterations to 1e-6 at most, solver)
ROWS = [
    ({"contrast": 1e-6, "coupling": 0.0, "R": 0.0}, 22, "multigrid"),
    ({"contrast": 1e3}, 29, "multigrid"),
    ({"contrast": 1e6}, 28, "multigrid"),
    ({"contrast": 2e7}, 4, "direct"),
    ({"coupling": 1e-6}, 31, "multigrid"),
    ({"R": 1e4}, 31, "multigrid"),
    ({"coupling": 10.0, "R": 1e-6}, 3, "direct"),
    ({"coupling": 10.0, "R": 1.0}, 3, "direct"),
    ({"coupling": 1e6, "R": 1e4}, 3, "direct"),
    ({"aspect": 3.0}, 44, "multigrid"),
    ({"graded": 100.0}, 80, "multigrid"),
    ({"B": 1e6}, 40, "multigrid"),
    ({"density": 0.999}, 29, "multigrid"),
    # 150 by multigrid, which then gives way
    ({"aspect": 100.0}, 153, "direct"),
    ({"shear": 1.732}, 153, "direct"),
]


@pytest.mark.slow
@pytest.mark.parametrize("parameters, iterations, solver", ROWS)
def test_block(tmp_path, parameters, iterations, solver):
    """A heavy block with its edges through cells."""
    given = {**DEFAULT, **parameters, "n": 32}
    row = measure(block(tmp_path/"case", **given, tolerance=1e-6), "block",
                  given)
    assert row["converged"] and row["solver"] == solver
    assert row["iterations"] <= iterations
    # Inside a body of a millionth of the viscosity 3.2e-4
    assert row["change"] < (4e-4 if given["contrast"] < 1 else 4e-6)


@pytest.mark.slow
@pytest.mark.parametrize("coupling", [1.0, 1e3, 1e6])
def test_one_material_takes_as_many_iterations(tmp_path, coupling):
    """The factorised matrix is that of the residual: in one material at most
    16 iterations at any etaC/eta and R, but for 32 where M is 2e14 times as
    large as eta."""
    for R, most in ((1e-6, 17), (1e-1, 17), (1e4, 34 if coupling > 1e5 else 17)):
        given = {**DEFAULT, "contrast": 1, "coupling": coupling, "R": R,
                 "n": 24}
        case = block(tmp_path/f"R{R}", **given, tolerance=1e-6)
        case.override("solution", creepingFlow="{ preconditioner"
                      " { block direct; } }")
        assert measure(case, "block", given)["iterations"] <= most


@pytest.mark.slow
def test_all_unknowns_factorised(tmp_path):
    """That of all unknowns leaves nothing to iterate; the flow is that by
    multigrid."""
    given = {**DEFAULT, "n": 24}
    flows = []
    for name in ("multigrid", "whole"):
        case = block(tmp_path/name, **given, tolerance=1e-10)
        case.override("solution", creepingFlow="{ preconditioner"
                      f" {{ block {name}; }} }}")
        row = measure(case, "block", given)
        assert row["converged"]
        flows.append(case.field("U"))
        if name == "whole":
            assert row["iterations"] <= 2
    assert np.abs(flows[0] - flows[1]).max() < 1e-8*np.abs(flows[0]).max()


@pytest.mark.slow
def test_an_even_weight_does_no_work(tmp_path):
    """A block as heavy as before in a medium that has weight too: a pressure
    holds that of both, and the power balance does not know it."""
    work = []
    for density in (0.0, 0.999):
        given = {**DEFAULT, "density": density, "n": 24}
        case = block(tmp_path/f"rho{density}", **given, tolerance=1e-9)
        assert measure(case, "block", given)["converged"]
        work.append(pressure_work(case)[0])
    assert work[1] == pytest.approx(work[0], rel=1e-3)


@pytest.mark.slow
def test_no_locking(tmp_path):
    """etaC/eta = 1000 and R -> 0: the classical flow, where a compact form
    is off by a third."""
    # The hyperbolic functions of its boundary layer overflow, and are not used
    with np.errstate(all="ignore"):
        case, _, row = run_layer(tmp_path/"case", Material(1.0, 1e3, 1e-6), 64,
                                 WALLS["OmegaSigma"], tolerance=1e-8)
    y = case.centres()[:, 1]
    u = case.field("U")[:, 0]
    assert np.abs(u - y).max() < 1e-5
    assert row["iterations"] <= 2


def test_steady_scene_is_solved_once(tutorial):
    """One material: what the points do changes nothing."""
    case = tutorial("shearLayer", control={"endTime": 1e6,
                                           "writeInterval": 1e6})
    case.run("cosseratPicFoam")
    solves = [row[3] for row in residuals(case.log())]
    assert solves[0] > 0 and len(solves) > 100
    assert not any(solves[3:])


@pytest.mark.slow
@pytest.mark.parametrize("scene, parts", [
    ("no etaC anywhere", ["microrotation"]),
    ("no density anywhere", ["gravity"]),
    ("two materials at rest; steady", ["matrices"]),
])
def test_part_left_out(tmp_path, scene, parts):
    """What a scene does not need changes nothing if forced on."""
    row = run_scene(tmp_path/"case", scene, n=16, repeat=1)
    assert row["off"].split() == parts
    assert row["difference"] < 1e-12
    assert row["iterations"] == row["iterationsForced"]


@pytest.mark.slow
@pytest.mark.parametrize("parameters, tolerance", [
    ({"contrast": 1e6, "R": 1e4}, 5e-9), ({"coupling": 1e3, "R": 1e4}, 2e-9)])
def test_more_digits_than_are_written(tmp_path, parameters, tolerance):
    """The last digit of the velocities makes forces of 1e-8 and more: the rest
    of the solution is kept beside it until the end."""
    case = block(tmp_path/"case", **{**DEFAULT, **parameters, "n": 32},
                 tolerance=tolerance)
    case.run("cosseratPicFoam")
    rounded = float(re.search(r"solution has a residual of (\S+)",
                              case.log())[1])
    print(rounded, [row[2] for row in residuals(case.log())[:3]])
    assert tolerance < rounded < 1e-5
    assert max(row[2] for row in residuals(case.log())) < tolerance


@pytest.mark.slow
def test_rounding_of_the_residual_is_not_convergence(tmp_path):
    """With more digits of the solution any residual can be computed; it means
    nothing below what rounding makes of it, which is told."""
    given = {**DEFAULT, "contrast": 1e8, "n": 32}
    case = block(tmp_path/"case", **given, tolerance=1e-9)
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode
    text = " ".join(done.stdout.split())
    assert max(row[2] for row in residuals(done.stdout)[:3]) < 1e-9
    least = float(re.search(r"here from about (\S+) on", text)[1])
    assert 1e-9 < least < 1e-6
    case.substitute("system/fvSolution", {"tolerance": least})
    case.run("cosseratPicFoam")


def test_one_material_needs_no_average(tutorial):
    """Dye alone: no fractions, nothing averaged; the table says so."""
    case = tutorial("shearLayer", control={"endTime": 4e4,
                                           "writeInterval": 4e4})
    case.run("cosseratPicFoam")
    assert re.search(r"averages +no\n", case.log())
    assert not list(case.path.glob("*/alpha.*"))


@pytest.mark.parametrize("mesh, aspect, angle", [
    ({"graded": 20.0}, 20, 0), ({"shear": 0.5}, 1.2, 26.565)])
def test_not_converged_names_cause_and_cure(tmp_path, mesh, aspect, angle):
    """The message of a flow that does not converge."""
    given = {**DEFAULT, "n": 16, **mesh}
    case = block(tmp_path/"case", **given, tolerance=1e-6)
    case.override("solution", creepingFlow="{ maxIter 5; }")
    row = measure(case, "block", given)
    assert not row["converged"]
    found = re.search(r"etaC/eta (\S+), largest jump of eta between cells (\S+)"
                      r" Mesh: distances to neighbours up to (\S+) : 1, faces"
                      r" up to (\S+) degrees", row["error"])
    coupling, jump, ratio, degrees = map(float, found.groups())
    assert coupling == 1 and 300 < jump <= 1000
    assert aspect*0.8 < ratio < aspect*1.2
    assert abs(degrees - angle) < 1e-2
    for part in ("Cures", "nDirections", "block whole", "cells nearer to"):
        assert part in row["error"]
