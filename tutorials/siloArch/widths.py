#!/usr/bin/env python3
"""Speeds of the slot at several widths, and with two viscosities at rest: what
flows does not depend on them. Writes results/widths.csv."""

import shutil
from pathlib import Path

import numpy as np

from cosserat.case import Case

WIDTHS = (0.20, 0.26, 0.32, 0.35, 0.40)
EPS = (1e-5, 1e-6)

case = Case(Path(__file__).resolve().parent)


def speed(width, eps):
    """Speed in the middle of the outlet."""
    path = case.path/"results/run"
    shutil.rmtree(path, ignore_errors=True)
    run = Case.copy(case.path, path)
    run.substitute("constant/materialProperties", {"eps": eps})
    run.substitute("system/blockMeshDict", {"half": width/2})
    run.run("blockMesh")
    run.run("cosseratPicFoam")
    return -run.field("U")[run.centres()[:, 1] < -0.9, 1].min()


rows = [(width, *(speed(width, eps) for eps in EPS)) for width in WIDTHS]
np.savetxt(case.path/"results/widths.csv", rows, delimiter=",",
           header="width," + ",".join(f"speed at eps {eps:g}" for eps in EPS))
