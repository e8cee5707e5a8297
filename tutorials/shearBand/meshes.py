#!/usr/bin/env python3
"""Angle and width of the band on three meshes, of which the last is that of the
case, with its internal length and without. Writes results/meshes.csv."""

from pathlib import Path

import numpy as np

from cosserat.case import Case
from cosserat.scenes.shearBand import CLASSICAL, band, solve

case = Case(Path(__file__).resolve().parent)
n = int(case.entries("system/blockMeshDict")["ny"])

rows = []
for cells in (n//4, n//2, n):
    found = [band(solve(case, case.path/f"results/{name}", cells, **law)[0])
             for name, law in (("cosserat", {}), ("classical", CLASSICAL))]
    rows.append((cells, *np.ravel(found)))
np.savetxt(case.path/"results/meshes.csv", rows, delimiter=",",
           header="n,angle,width,classical angle,classical width")
