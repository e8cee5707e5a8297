#!/usr/bin/env python3
"""Pictures of the column: its shape with the dye, and the volume that has
spread. Fails where that is not as expected."""

from pathlib import Path

from cosserat.case import Case
from cosserat.picture import curves, outflow, snapshots

#: Volume beyond the foot of the column at the end [m2], and how far meshes of
#: 16 to 64 cells a unit differ
EXPECTED, SPREAD = 0.152, 0.003

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

rows = outflow(case, "spread")
snapshots(case, case.times(), [1], results/"column.png", columns=2)
curves([(rows[:, 0], rows[:, 1], "")],
       ("time [s]", "volume beyond the foot [m$^2$]"), results/"spread.png")

print(f"Volume beyond the foot: {rows[-1, 1]:.4f} m2")
print(f"{results/'column.png'}\n{results/'spread.png'}")
if abs(rows[-1, 1] - EXPECTED) > SPREAD:
    raise SystemExit(f"Not as expected: {EXPECTED} +- {SPREAD} m2")
