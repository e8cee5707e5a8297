"""Averages of the points to the mesh, and the flow that they drive."""

import numpy as np
import pytest

from cosserat.results import add_orders
from cosserat.scenes import overturn, rigidShear
from cosserat.scenes.box import add_points


@pytest.mark.slow
@pytest.mark.parametrize("average, order", [
    ("cellMean", 1), ("linearLeastSquares", 2)])
def test_orders_of_rigid_shear(tmp_path, average, order):
    """A density on scattered points: order of its average, and of the
    velocity, which is the discretisation's with both."""
    rows = [rigidShear.run(tmp_path/str(n), average, 16, n) for n in (16, 32)]
    add_orders(rows, "U", "P", "Rho")
    # Measured: 1.16 and 1.98, 2.07 and 1.86, 2.46 and 2.07
    assert abs(rows[1]["orderRho"] - order) < 0.2
    assert 1.8 < rows[1]["orderU"] < 2.15
    assert rows[1]["errU"] < 2.8e-3
    assert rows[1]["errP"] < 1.2e-3


@pytest.mark.slow
def test_average_of_moved_points(tmp_path):
    """The density after half a turn is as good as at the start."""
    row = rigidShear.run(tmp_path/"moved", "linearLeastSquares", 16, 16,
                         steps=32)
    assert row["time"] == 1
    # Measured: 6.4e-4, and 6.6e-4 at the start
    assert row["errRho"] < 7e-4


@pytest.mark.parametrize("average", ["cellMean", "linearLeastSquares"])
def test_fractions_are_limited(box, average):
    """Nothing below 0 or above 1 where points of two materials mix, nor any
    but 1 in cells that have points of one material."""
    fluid = {"eta": 1, "etaC": 0, "R": 0}
    case = box(n=8, g=(0, -1, 0), fractions=lambda x, y: 0*x,
               materials={"heavy": {**fluid, "rho": 1}, "light": fluid})
    add_points(case, "{ type all; material heavy; } { type box; material light;"
               " min (-0.5 -0.5 -1); max (0.17 0.17 1); }", average=average,
               pointsPerCell=9, minPointsPerCell=0,
               volumeCorrection="no")
    case.substitute("system/controlDict", {
        "endTime": 24, "deltaT": 1, "writeInterval": 24})
    case.run("cosseratPicFoam")
    i, j = np.floor((case.cloud("positions")[:, :2] + 0.5)*8).astype(int).T
    light = np.bincount(8*j + i, case.cloud("material"), minlength=64)
    count = np.bincount(8*j + i, minlength=64)
    alpha = case.field("alpha.light")
    assert np.allclose(case.field("alpha.heavy") + alpha, 1, atol=1e-14)
    assert alpha.min() == 0 and alpha.max() == 1
    assert np.all(alpha[light == 0] == 0) and (light == 0).any()
    assert np.all(alpha[light == count] == 1) and (light == count).any()
    mixed = (light > 0) & (light < count)
    assert mixed.sum() > 10
    mean = light[mixed]/count[mixed]
    assert np.allclose(alpha[mixed], mean) == (average == "cellMean")
    assert np.abs(alpha[mixed] - mean).max() < 0.3


@pytest.mark.slow
def test_orders_of_coupling(tmp_path):
    """Halving the step divides the error of the points by 2 with a frozen
    flow and by 4 with an extrapolated one; solved at mid-step it is smaller
    still."""
    def run(coupling, steps):
        return overturn.run(tmp_path/f"{coupling}{steps}", coupling, steps,
                            n=16)

    reference, _ = run("midpoint", 80)
    errors = {}
    for coupling in overturn.COUPLINGS:
        for steps in (5, 10):
            xy, log = run(coupling, steps)
            errors[coupling, steps] = np.sqrt(
                ((xy - reference)**2).sum(axis=1).mean())
            assert log.count("frozen in this step") == (
                coupling == "extrapolated")
            assert log.count("Flow at mid-step") == (
                steps if coupling == "midpoint" else 0)
    print(errors)
    order = {coupling: np.log2(errors[coupling, 5]/errors[coupling, 10])
             for coupling in overturn.COUPLINGS}
    assert abs(order["frozen"] - 1) < 0.15
    assert abs(order["extrapolated"] - 2) < 0.3
    assert errors["extrapolated", 10] < 0.25*errors["frozen", 10]
    assert errors["midpoint", 10] < 0.4*errors["extrapolated", 10]


@pytest.mark.slow
@pytest.mark.parametrize("average", ["layered", "arithmetic", "harmonic"])
def test_etaC_without_internal_length_has_no_effect(box, average):
    """R = 0 is the classical fluid, in cells of two materials too."""
    found = []
    for target, etaC in (("without", 0), ("with", 2)):
        case = box(target, n=8, g=(0, -1, 0), average=average,
                   fractions=lambda x, y: np.clip(1.5 - 8*np.abs(x - 0.03), 0, 1)
                   * (y < 0.2),
                   materials={"body": {"eta": 100, "etaC": 50*etaC, "R": 0,
                                       "rho": 1},
                              "fluid": {"eta": 1, "etaC": etaC, "R": 0}})
        case.run("cosseratPicFoam")
        found.append(case.field("U"))
    assert np.allclose(*found, atol=1e-7*np.abs(found[0]).max())
