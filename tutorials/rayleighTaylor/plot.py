#!/usr/bin/env python3
"""Pictures of the overturn: v_rms against time and the layers. Fails where
its first peak is not the one of the literature."""

from pathlib import Path

import numpy as np

from cosserat.case import Case
from cosserat.picture import curves, snapshots

#: First peak of v_rms [m/s] and its time [s] by van Keken et al. (1997), and
#: how far this mesh and this time step are from it
PEAK, TIME = 3.09e-3, 209
SPREAD = 0.01, 0.015

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

rows = case.table("vrms", "volFieldValue.dat")
speed = np.sqrt(rows[:, 1])
curves([(rows[:, 0], 1e3*speed, "")], ("time [s]", "$v_{rms}$ [mm/s]"),
       results/"vrms.png")
shown = [t for t in case.times() if float(t) % 100 == 0]
snapshots(case, shown, [1, 0], results/"layers.png", velocity=False)

peak = speed.argmax()
print(f"First peak of v_rms: {speed[peak]:.4g} m/s at {rows[peak, 0]:.4g} s")
print(f"{results/'vrms.png'}\n{results/'layers.png'}")
if (abs(speed[peak]/PEAK - 1) > SPREAD[0]
        or abs(rows[peak, 0]/TIME - 1) > SPREAD[1]):
    raise SystemExit(f"Not as expected: {PEAK} m/s at {TIME} s")
