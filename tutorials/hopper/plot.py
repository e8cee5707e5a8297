#!/usr/bin/env python3
"""Pictures of the hopper: old and fresh material, and how much of each is
inside. Fails where what goes out is not what comes in."""

from pathlib import Path

import numpy as np

from cosserat import picture
from cosserat.case import Case
from cosserat.picture import curves, outflow, snapshots

#: Thickness of the mesh [m], and what the feed brings [m2/s]
DEPTH, RATE = 0.1, 0.1

#: Old material left at the end [m2], and how far machines may differ
EXPECTED, SPREAD = 0.0317, 0.002

# The first material is a background elsewhere, drawn white
picture.MATERIAL[0] = "#b9d3e6"

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

old, fresh = (outflow(case, name) for name in ("old", "fresh"))
time, inside = old[:, 0], old[:, 3] + fresh[:, 3]
area = case.volumes().sum()/DEPTH
curves([(time, old[:, 3], "old"), (time, fresh[:, 3], "fresh"),
        (time, np.maximum(area - RATE*time, 0), "old, if all moved alike")],
       ("time [s]", "material in the hopper [m$^2$]"), results/"washout.png")
snapshots(case, [t for t in case.times() if t in ("2.5", "5", "10", "20")],
          [0, 1], results/"hopper.png", velocity=False)

flux = [case.table(name, "surfaceFieldValue.dat")[-1, 1]/DEPTH
        for name in ("inflow", "outflow")]
print(f"In {-flux[0]:.6g} m2/s, out {flux[1]:.6g} m2/s")
print(f"Inside between {inside.min():.5f} and {inside.max():.5f} m2, the"
      f" hopper has {area:.5f} m2")
print(f"{results/'hopper.png'}\n{results/'washout.png'}")
if not np.allclose(flux, [-RATE, RATE], rtol=1e-5):
    raise SystemExit(f"Not as expected: {RATE} m2/s in and out")
if np.abs(inside/area - 1).max() > 0.005:
    raise SystemExit("Not as expected: the points do not fill the hopper to"
                     " half a per cent")
if abs(old[-1, 3] - EXPECTED) > SPREAD:
    raise SystemExit(f"Not as expected: {old[-1, 3]:.4f} m2 of old material are"
                     f" left, {EXPECTED} +- {SPREAD} m2 were expected")
