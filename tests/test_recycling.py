"""Directions kept from one time step for the next one (recycledDirections):
what they save, and that they change nothing else."""

import numpy as np
import pytest

from cosserat.case import Case, TUTORIALS, residuals
from cosserat.scenes.silo import mesh_entries


def silo(path, entries, steps=12, ranks=1, **control):
    """The silo on half the cells; iterations of the solves."""
    case = Case.copy(TUTORIALS/"silo", path)
    case.substitute("system/blockMeshDict", mesh_entries(4))
    case.substitute("system/controlDict", {
        "endTime": 2e-5*steps, "deltaT": 2e-5, "adjustTimeStep": "no",
        "writeInterval": 2e-5*steps, "writePrecision": 12, **control})
    case.override("solution", creepingFlow=f"{{ {entries} }}")
    case.run("blockMesh")
    case.decompose(ranks, "scotch")
    case.run("cosseratPicFoam", ranks=ranks)
    case.reconstruct()
    return case, np.array([row[3] for row in residuals(case.log())[::3]])


@pytest.fixture(name="plain", scope="module")
def plain_fixture(tmp_path_factory):
    """Without."""
    return silo(tmp_path_factory.mktemp("plain")/"case",
                "tolerance 1e-10; nRecycled 0;")


@pytest.mark.slow
@pytest.mark.parametrize("ranks", [1, 2])
def test_air_around_a_silo(plain, tmp_path, ranks):
    """Air has to go round from one room to another: without, it is found anew
    in each step. The flow is the same to the tolerance."""
    case, found = silo(tmp_path/"case", "tolerance 1e-10;", ranks=ranks)
    expected, before = plain
    print(before, found)
    assert found[0] == (before[0] if ranks == 1
                        else pytest.approx(before[0], rel=0.1))
    assert found[1:].sum() < 0.8*before[1:].sum()
    for name in ("U", "p", "omega"):
        a, b = case.field(name), expected.field(name)
        print(name, np.abs(a - b).max()/np.abs(b).max())
        assert np.abs(a - b).max() < 1e-7*np.abs(b).max()


@pytest.mark.slow
def test_times_written_have_none(tmp_path):
    """What is written can be gone on from to the bit: nothing is kept."""
    _, before = silo(tmp_path/"plain", "nRecycled 0;", 4)
    _, found = silo(tmp_path/"case", "nRecycled 6;", 4, writeInterval=2e-5)
    assert found[0] == before[0] and found[2:].tolist() == before[2:].tolist()


@pytest.mark.slow
def test_newton_keeps_none(tmp_path):
    """Steps of Newton's method are those without."""
    logs = []
    for n in (0, 6):
        case = Case.copy(TUTORIALS/"heap", tmp_path/f"{n}")
        case.substitute("system/blockMeshDict", {"nx": 16, "ny": 8})
        case.substitute("system/controlDict", {"endTime": 2})
        case.override("solution", creepingFlow=f"{{ nRecycled {n}; }}")
        case.run("blockMesh")
        case.run("cosseratPicFoam")
        logs.append([line for line in case.log().splitlines()
                     if line.startswith("Nonlinear: step")])
    assert len(logs[0]) > 10 and logs[0] == logs[1]
