#!/usr/bin/env python3
"""Speed and microrotation around the sphere, and its drag. Fails where that is
not as expected."""

from pathlib import Path

import numpy as np

from cosserat.analytic import Material, SphereFlow
from cosserat.case import Case
from cosserat.picture import fields

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

#: Largest difference of the drag from the exact one
EXPECTED = 3e-3

drag = case.table("drag", "wallLoad.dat")[-1][1]/(6*np.pi)
exact = SphereFlow(Material(1, 1, R=0.1), a=1, U=1).over_stokes()
fields(case, case.times()[-1],
       [("U", 0, "u [m/s]"), ("omega", None, r"$\omega$ [1/s]")],
       results/"fields.png")
print(f"Drag over Stokes': {drag:.5f}, exact {exact:.5f}")
print(results/"fields.png")
if abs(drag/exact - 1) > EXPECTED:
    raise SystemExit(f"Not as expected: {exact} within {EXPECTED}")
