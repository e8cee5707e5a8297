"""Function object errorEstimate: as near to the true error as measured in
validation/Allrun errorEstimate, of its order, the same on several processors
and after the run."""

import shutil

import numpy as np
import pytest

from cosserat.case import FILES
from cosserat.scenes import estimate as study


def test_effectivity_annulus(tmp_path):
    """16 cells across: within 2 % of the measured 0.852 and 0.645."""
    row = study.annulus(tmp_path/"case", 16)
    assert row["effectivityU"] == pytest.approx(0.852, rel=0.02)
    assert row["effectivityOmega"] == pytest.approx(0.645, rel=0.02)


@pytest.mark.slow
def test_effectivity_and_order(tmp_path):
    """Manufactured solution on a wavy mesh: within 2 % of the measured
    effectivities, the order of the estimate is that of the error to 0.1."""
    coarse, fine = study.add_order(
        [study.manufactured(tmp_path/f"{n}", "wavy", n) for n in (24, 48)])
    for row, expected in ((coarse, (1.32, 0.978)), (fine, (1.39, 1.02))):
        found = row["effectivityU"], row["effectivityOmega"]
        assert found == pytest.approx(expected, rel=0.02)
    for key in ("U", "Omega"):
        assert fine[f"orderEstimate{key}"] == pytest.approx(
            fine[f"orderError{key}"], abs=0.1)


@pytest.mark.slow
def test_effectivity_inclusion(tmp_path):
    """Surface in cut cells, 16 cells a side, against finite elements: within
    2 % of the measured 1.65 and 2.20."""
    row = study.without_exact(tmp_path/"case", "inclusion", 16)
    assert row["effectivityU"] == pytest.approx(1.648, rel=0.02)
    assert row["effectivityOmega"] == pytest.approx(2.196, rel=0.02)


def test_order_three(tmp_path):
    """Shear layer: the measured order follows the third order of omega."""
    row = study.layer(tmp_path/"case", "layer0.3", 24)
    assert row["measuredOrderOmega"] > 2.7
    assert row["effectivityOmega"] == pytest.approx(1.14, rel=0.02)


@pytest.mark.slow
@pytest.mark.parametrize("name, method, etaC", [
    ("annularCouette", "scotch", "1000"), ("annularCouette", "scotch", "1e4"),
    ("shearLayer", "simple", None)])
def test_parallel(tutorial, name, method, etaC):
    """Table and field of one and three processors agree, cut through blocks
    and cyclic patches, with multigrid and with the factorisation (etaC 1e4);
    not the place of the worst cell, of which there are several."""
    tables, fields = [], []
    for ranks in (1, 3):
        case = tutorial(name, target=f"on{ranks}",
                        solution={"tolerance": 1e-11},
                        control={"endTime": 1e-6, "deltaT": 1e-6,
                                 "writeInterval": 1e-6})
        study.switch_on(case)
        if etaC:
            case.substitute(FILES["materials"], {"etaC": etaC})
        case.solve(ranks, method=method)
        tables.append(case.table("error", "errorEstimate.dat")[0, :10])
        fields.append(case.field("errorEstimate(U)"))
    assert tables[1] == pytest.approx(tables[0], rel=1e-4)
    assert np.abs(fields[1] - fields[0]).max() < 1e-4*fields[0].max()


def test_after_the_run(tutorial):
    """postProcess gives the row of the run, from what it has written."""
    case = tutorial("sinkingInclusion", mesh={"n": 16}, control={
        "endTime": 1e-6, "deltaT": 1e-6, "writeInterval": 1e-6,
        "writePrecision": 16})
    study.switch_on(case)
    case.run("cosseratPicFoam")
    during = case.table("error", "errorEstimate.dat")[0]
    shutil.rmtree(case.path/"postProcessing")
    (case.path/"system/errorEstimate").write_text(
        "type errorEstimate; libs (cosseratFunctionObjects);")
    case.run("postProcess", "-func", "errorEstimate", "-latestTime")
    after = case.table("errorEstimate", "errorEstimate.dat")[0]
    assert after == pytest.approx(during, rel=1e-6)


@pytest.mark.parametrize("order", ["-1", "0", "second", "(2)"])
def test_wrong_order_is_refused(box, order):
    """File, entry, what was found and what is allowed."""
    case = box(n=4, materials={"a": {"eta": 1, "etaC": 1, "R": 0.1}})
    with (case.path/"system/controlDict").open("a") as text:
        text.write(study.FUNCTION.replace(
            "type ", f"order {order}; type ", 1))
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode
    for word in ("controlDict", "'order'", order.strip("()"), "measured"):
        assert word in done.stdout


def test_given_order(box):
    """A given order: Err = difference/(2^p - 1), no third mesh."""
    case = box(n=8, materials={"a": {"eta": 1, "etaC": 1, "R": 0.1}},
               force=lambda x, y: np.array([y, 0*x]))
    with (case.path/"system/controlDict").open("a") as text:
        text.write(study.FUNCTION.replace("type ", "order 1.5; type ", 1))
    case.run("cosseratPicFoam")
    row = case.table("error", "errorEstimate.dat")[0]
    assert row[1] == pytest.approx(row[7]/(2**1.5 - 1)) and row[1] > 0
    assert row[3] == 1.5 and row[5] == 0


def test_triangles_are_told(box):
    """No estimate, a warning that says why, and the run goes on."""
    case = box(n=8, triangles=True,
               materials={"a": {"eta": 1, "etaC": 1, "R": 0.1}})
    study.switch_on(case)
    case.run("cosseratPicFoam")
    assert "no quadrilaterals" in case.log()
