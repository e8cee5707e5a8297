#!/usr/bin/env python3
"""Pictures of the round silo: the discharge curve, and snapshots with the dye
grid, both halves."""

from pathlib import Path

import numpy as np

from cosserat.mirrored import opened
from cosserat.picture import discharge, snapshots

case = opened(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

discharge([case], ["this run"], np.pi*2.5**2*5, results/"discharge.png", "m$^3$")
times = case.times()
snapshots(case, times[::max(len(times)//3, 1)][:4], [1], results/"silo.png")

for name in ("discharge", "silo"):
    print(results/f"{name}.png")
