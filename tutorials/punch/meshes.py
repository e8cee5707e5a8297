#!/usr/bin/env python3
"""Limit pressures on three meshes, of which the last is that of the case.
Writes results/meshes.csv."""

from pathlib import Path

import numpy as np

from cosserat.case import Case
from cosserat.scenes.punch import pressure, solve

case = Case(Path(__file__).resolve().parent)
n = int(case.entries("system/blockMeshDict")["n"])

rows = [(cells, solve(case, case.path/"results/run", cells)[0])
        for cells in (n//4, n//2)]
rows.append((n, pressure(case)))
np.savetxt(case.path/"results/meshes.csv", rows, delimiter=",",
           header="n,pressure over yield stress")
