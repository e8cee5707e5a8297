"""Function object errorIndicator: it orders cells as the true errors of their
strains do, on every kind of mesh, and is the same on several processors, at
ends cyclic by rotation and after the run."""

import shutil

import numpy as np
import pytest

from cosserat.case import FILES
from cosserat.scenes import indicator as scenes
from cosserat.scenes.box import Annulus
from cosserat.strains import errors, quadrature, rank_correlation, switch_on

MATERIAL = {"a": {"eta": 1, "etaC": 1, "R": 0.3}}


#: Scene, cells: bounds of the effectivity; least rank correlation with the
#: true errors and least part of the worst tenth that is found
SCENES = {
    ("annularCouette", 16): (0.94, 0.98, 0.98, 0.99),
    ("wavy", 24): (0.95, 0.99, 0.99, 0.99),
    ("triangles", 24): (0.98, 1.08, 0.90, 0.98),
    ("halved", 12): (0.95, 1.00, 0.98, 0.99),
    ("jump", 32): (0.93, 0.98, 0.97, 0.99),
    ("layer0.05", 24): (0.70, 0.82, 0.70, 0.99),
    ("inclusion", 16): (0.48, 0.62, 0.96, 0.95),
}


@pytest.mark.slow
@pytest.mark.parametrize("scene, n", SCENES)
def test_order_of_cells(tmp_path, scene, n):
    """Sum and order of the cells beside their true errors."""
    low, high, correlation, found = SCENES[scene, n]
    row, true, indicator = scenes.compare(
        scene, n, *scenes.run(tmp_path, scene, n))
    assert low < row["effectivity"] < high
    assert row["correlation"] > correlation
    assert row["found"] > found
    assert (indicator > 0).all() and (true > 0).all()


@pytest.mark.slow
def test_bounds_can_fail(tmp_path):
    """The power that cells dissipate, which is large where the flow is, does
    not order them so."""
    case, exact = scenes.manufactured(tmp_path, "uniform", 12)
    true = errors(case, exact)
    assert rank_correlation(case.field("dissipation"), true) < 0.5
    assert rank_correlation(case.field("errorIndicator"), true) > 0.97


@pytest.mark.slow
def test_halved_where_it_says(tmp_path):
    """Half the cells' size in the tenth of them that the indicator picks takes
    away most of what it does everywhere; in the best tenth, nothing."""
    case, exact = scenes.jump(tmp_path, 16)
    indicator = case.field("errorIndicator")
    before = errors(case, exact).sum()
    for sign, low, high in ((1, 0.35, 0.6), (-1, 0.95, 1.05)):
        chosen = np.zeros(len(indicator), bool)
        chosen[scenes.worst(sign*indicator)] = True
        finer, exact = scenes.jump(tmp_path, 16, halved=lambda x, y, is_so=chosen: is_so)
        assert finer.n_cells() == 256 + 3*26
        assert low < errors(finer, exact).sum()/before < high


def test_true_errors_of_linear_strains():
    """Quadrature of a square and of a triangle: int x^2 dA."""
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])/2
    triangle = np.array([[0, 0], [1, 0], [0, 1]])
    points, weights, cells = quadrature([square, triangle])
    sums = np.bincount(cells, weights*points[:, 0]**2)
    assert sums == pytest.approx([1/12, 1/12])


def test_linear_flow_has_none(box):
    """Simple shear and a rotation that follows: no error, and no division by
    what is zero."""
    case = box(n=6, materials=MATERIAL, tolerance=1e-12,
               U=lambda x, y: (-y, x), omega=lambda x, y: 1 + 0*x,
               walls={side: ("exact", "exact")
                      for side in ("left", "right", "bottom", "top")})
    switch_on(case)
    case.run("cosseratPicFoam")
    assert case.field("errorIndicator").max() < 1e-20
    assert np.isfinite(case.table("error", "errorIndicator.dat")).all()


@pytest.mark.slow
def test_table(box):
    """Sums and the share of the worst tenth are those of the field."""
    case = box(n=10, materials=MATERIAL,
               force=lambda x, y: np.array([np.exp(3*y), 0*x]))
    switch_on(case)
    case.run("cosseratPicFoam")
    field = case.field("errorIndicator")
    time, total, dissipated, relative, share = case.table(
        "error", "errorIndicator.dat")[-1]
    assert time == 1
    assert total == pytest.approx(field.sum(), rel=1e-5)
    assert dissipated == pytest.approx(
        (case.field("dissipation")*case.volumes()).sum(), rel=1e-5)
    assert relative == pytest.approx((total/dissipated)**0.5, rel=1e-4)
    assert share == pytest.approx(
        np.sort(field)[-10:].sum()/field.sum(), rel=1e-4)
    assert 0.1 < share < 0.9


@pytest.mark.slow
def test_cyclic_by_rotation(tmp_path):
    """A flow the same at all angles: so is the indicator, at the ends too."""
    case = Annulus(tmp_path/"case", n=8, materials=MATERIAL, tolerance=1e-12,
                   walls={"left": ("exact", "exact"),
                          "right": ("exact", "exact")},
                   U=lambda x, y: (-y*(x*x + y*y < 1.1), x*(x*x + y*y < 1.1)),
                   omega=lambda x, y: 0*x).write()
    switch_on(case)
    case.run("cosseratPicFoam")
    rings = case.field("errorIndicator").reshape(16, 8)
    assert np.ptp(rings, axis=0).max() < 1e-6*rings.max()
    assert rings[0, 0] > 2*rings[0, -1] > 0


@pytest.mark.slow
@pytest.mark.parametrize("name, method, mesh", [
    ("annularCouette", "scotch", {"nAcross": 8, "nQuarter": 12}),
    ("shearLayer", "simple", {}), ("sinkingInclusion", "simple", {"n": 16})])
def test_parallel(tutorial, name, method, mesh):
    """Table and field of one and three processors agree, cut through curved
    blocks, cyclic patches and mixed cells."""
    tables, fields = [], []
    for ranks in (1, 3):
        case = tutorial(name, target=f"on{ranks}", mesh=mesh,
                        solution={"tolerance": 1e-11},
                        control={"endTime": 1e-6, "deltaT": 1e-6,
                                 "writeInterval": 1e-6})
        switch_on(case)
        if ranks > 1:
            (case.path/FILES["decomposition"]).write_text(f"""
FoamFile {{ version 2.0; format ascii; class dictionary; object x; }}
numberOfSubdomains {ranks}; method {method};
coeffs {{ n (3 1 1); delta 0.001; }}
""")
            case.run("decomposePar")
        case.run("cosseratPicFoam", ranks=ranks)
        if ranks > 1:
            case.run("reconstructPar", "-latestTime")
        tables.append(case.table("error", "errorIndicator.dat")[-1])
        fields.append(case.field("errorIndicator"))
    assert tables[1] == pytest.approx(tables[0], rel=1e-4)
    assert np.abs(fields[1] - fields[0]).max() < 1e-6*fields[0].max()


@pytest.mark.slow
def test_after_the_run(tutorial):
    """-postProcess gives the row and field of the run, from what it has
    written."""
    case = tutorial("sinkingInclusion", mesh={"n": 16}, control={
        "endTime": 1e-6, "deltaT": 1e-6, "writeInterval": 1e-6,
        "writePrecision": 16})
    switch_on(case)
    case.run("cosseratPicFoam")
    row, field = (case.table("error", "errorIndicator.dat")[-1],
                  case.field("errorIndicator"))
    shutil.rmtree(case.path/"postProcessing")
    case.run("cosseratPicFoam", "-postProcess", "-latestTime")
    assert case.table("error", "errorIndicator.dat")[-1] == pytest.approx(
        row, rel=1e-4)
    assert case.field("errorIndicator") == pytest.approx(
        field, abs=1e-4*field.max())
