#!/usr/bin/env python3
"""Speeds of the channel at several loads, and with two viscosities at rest:
what flows does not depend on them. Writes results/loads.csv."""

import re
import shutil
from pathlib import Path

import numpy as np

from cosserat.case import Case

LOADS = (1.30, 1.34, 1.38, 1.39, 1.40, 1.41, 1.42, 1.46, 1.50)
EPS = (1e-5, 1e-6)

case = Case(Path(__file__).resolve().parent)


def speed(load, eps):
    """Speed in the middle; load: half of G over the yield stress."""
    path = case.path/"results/run"
    shutil.rmtree(path, ignore_errors=True)
    run = Case.copy(case.path, path)
    run.substitute("constant/materialProperties", {"eps": eps})
    gravity = run.path/"constant/g"
    gravity.write_text(re.sub(r"value.*;", f"value ({2*load} 0 0);",
                              gravity.read_text()))
    run.run("blockMesh")
    run.run("cosseratPicFoam")
    return run.field("U")[:, 0].max()


rows = [(load, *(speed(load, eps) for eps in EPS)) for load in LOADS]
np.savetxt(case.path/"results/loads.csv", rows, delimiter=",",
           header="load," + ",".join(f"speed at eps {eps:g}" for eps in EPS))
