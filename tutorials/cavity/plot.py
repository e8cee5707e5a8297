#!/usr/bin/env python3
"""Pictures of the cavity: speed, microrotation and dye. Fails where the flow
is not its own mirror image, as creeping flow must be."""

from pathlib import Path

import numpy as np

from cosserat.case import Case
from cosserat.picture import fields, snapshots

#: Difference from the mirror image over the speed of the lid, at a tolerance
#: of 1e-6
EXPECTED = 1e-5

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)
time = case.times()[-1]

fields(case, time, [("U", None, "|U| [m/s]"),
                    ("omega", None, r"$\omega$ [1/s]")],
       results/"flow.png")
snapshots(case, case.times(), [0], results/"dye.png", velocity=False)

centres = case.centres().round(9)
order = np.lexsort((centres[:, 0], centres[:, 1]))
mirrored = np.lexsort((-centres[:, 0], centres[:, 1]))
U = case.field("U", time)
error = np.abs(U[order, :2] - U[mirrored, :2]*(1, -1)).max()

print(f"Difference from the mirror image: {error:.2g} m/s")
print(f"{results/'flow.png'}\n{results/'dye.png'}")
if error > EXPECTED:
    raise SystemExit(f"Not as expected: above {EXPECTED}")
