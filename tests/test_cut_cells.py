"""Cells that hold several materials, in tutorials: beside finite elements whose
cells end on the interface, and what they cost."""

import pytest

from cosserat.case import FILES, fresh_case
from cosserat.finiteElements.tutorials import block
from cosserat.results import power, pressure_work
from cosserat.scenes.silo import COARSE, halve

ONCE = {"endTime": 1e-9, "deltaT": 1e-9, "adjustTimeStep": "no"}


def fallen_block(path, fallen, cells, mean=None):
    """First solve of the template, its block lower by so much [m]."""
    case = fresh_case(path, "template")
    case.substitute(FILES["mesh"], {"nx": cells, "ny": cells})
    case.substitute(FILES["control"], ONCE)
    case.substitute(FILES["points"], {
        "min": f"(0.2 {0.4 - fallen} -1)", "max": f"(0.6 {0.8 - fallen} 1)"})
    if mean:
        case.override("materials", viscosityAverage=mean)
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    return case


def test_block_through_cells(tmp_path):
    """A quarter of a cell lower than as shipped, where it is 1.6 % off since
    its corners are few cells apart: 1.9 %, and not the -2.6 % of the
    arithmetic mean."""
    reference = block(False, fallen=0.00625)

    def difference(mean):
        case = fallen_block(tmp_path/(mean or "default"), 0.00625, 40, mean)
        return power(case)/reference - 1

    assert difference(None) == pytest.approx(0.0194, abs=2e-3)
    assert difference("arithmetic") < -0.02


def test_film_of_air_on_the_floor(tmp_path):
    """One cell of it below the block: the pressure does no work on air that
    cannot go anywhere (it did 12 % of that of gravity)."""
    case = fallen_block(tmp_path/"case", 0.3875, 80)
    assert abs(pressure_work(case)[0]) < 0.025
    assert power(case) == pytest.approx(block(False, fallen=0.3875), rel=0.025)


@pytest.mark.slow
def test_air_beside_a_jet_does_not_race(tmp_path):
    """Half a silo on 4 cells an aperture, 1.5 ms: weight that stays in cells
    of air makes them faster than the jet, and the time steps small: 158, and
    161 to 1e-10, where viscosities' stairs gave 190 and the arithmetic mean
    87."""
    steps = {}
    for mean in ("layered", "arithmetic"):
        case = fresh_case(tmp_path/mean, "silo")
        case.substitute(FILES["mesh"], COARSE)
        halve(case)
        case.substitute(FILES["control"], {"endTime": 1.5e-3})
        case.override("materials", viscosityAverage=mean)
        case.run("blockMesh")
        case.run("cosseratPicFoam")
        steps[mean] = case.log().count("FGMRES:  Solving for p_rgh")
    assert steps["layered"] < 1.9*steps["arithmetic"], steps
