"""The first steps of every tutorial on a coarse mesh, restarted and on two
processors."""

import shutil

import numpy as np
import pytest
from scipy.spatial import cKDTree

from cosserat.case import TUTORIALS, Case
from cosserat.scenes.roundSilo import round_mesh
from cosserat.scenes.silo import mesh_entries

#: Cells by tutorial; without an entry as they are
MESH = {
    "annularCouette": {"nAcross": 8, "nQuarter": 12},
    "bandedLayer": {"n": 24},
    "cavity": {"n": 16},
    "channelArrest": {"n": 24},
    "columnSlump": {"nx": 16, "ny": 8},
    "conicalHopper": {"n": 8, "nAlong": 12},
    "cylindricalSilo": round_mesh(4),
    "dune": {"nx": 32, "ny": 16},
    "gravityChannel": {"n": 8},
    "heap": {"nx": 16, "ny": 8},
    "hopper": {"nx": 12, "nSpout": 3, "nCone": 10, "nBin": 6},
    "pipe": {"n": 12},
    "punch": {"n": 4, "nBeside": 16, "nDeep": 12},
    "rayleighTaylor": {"n": 16},
    "schemes": {"nx": 20, "ny": 20},
    "shearBand": {"nx": 18, "ny": 12},
    "shearLayer": {"n": 12},
    "silo": mesh_entries(4),
    "siloArch": {"n": 4, "beside": 6},
    "sinkingInclusion": {"n": 16},
    "sphereDrag": {"n": 8, "nQuarter": 8},
    "template": {"nx": 20, "ny": 20},
}

NAMES = sorted(d.name for d in TUTORIALS.iterdir() if (d/"system").is_dir())


def prepared(name, path):
    """The tutorial meshed; four steps."""
    case = Case.copy(TUTORIALS/name, path)
    step = float(case.entries("system/controlDict")["deltaT"])
    case.substitute("system/controlDict", {
        "startFrom": "latestTime", "writePrecision": 17, "endTime": 4*step,
        "adjustTimeStep": "no", "writeInterval": 2*step})
    case.substitute("system/fvSolution", {"tolerance": 1e-8})
    if name in MESH:
        case.substitute("system/blockMeshDict", MESH[name])
        case.run("blockMesh")
    else:
        case.run("gmshToFoam", "constant/cylinders.msh")
        case.run("foamDictionary", "constant/polyMesh/boundary", "-entry",
                 "entry0/frontAndBack/type", "-set", "empty")
    return case


@pytest.mark.slow
@pytest.mark.parametrize("name, block", [
    *((name, "automatic") for name in NAMES),
    ("silo", "direct"), ("rayleighTaylor", "direct")])
def test_first_steps(tmp_path, name, block):
    """Two steps on one processor and two more on two are four on one."""
    whole = prepared(name, tmp_path/"whole")
    whole.run("cosseratPicFoam")
    parts = Case(shutil.copytree(whole.path, tmp_path/"parts"))
    shutil.rmtree(parts.path/whole.times()[-1])
    if block != "automatic":
        parts.override("solution", creepingFlow=f"{{ maxIter 300;"
                       f" preconditioner {{ block {block}; }} }}")
    # By the dictionary of the tutorial
    parts.substitute("system/decomposeParDict", {"numberOfSubdomains": 2})
    parts.run("decomposePar", "-latestTime")
    parts.run("cosseratPicFoam", ranks=2)
    parts.run("reconstructPar", "-latestTime")

    assert len(whole.times()) == 2
    assert parts.times() == whole.times()
    for field in ("U", "p", "omega"):
        expected = whole.field(field)
        miss = np.abs(parts.field(field) - expected).max()
        assert miss < 2e-6*np.abs(expected).max(), field
    if (whole.path/"constant/materialPointsProperties").exists():
        before, here, there = (case.cloud("positions", time) for case, time in (
            (whole, whole.times()[0]), (whole, None), (parts, None)))
        assert len(here) == len(there)
        way = cKDTree(before).query(here)[0].max()
        assert cKDTree(here).query(there)[0].max() < 5e-6*way
