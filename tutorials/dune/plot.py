#!/usr/bin/env python3
"""Pictures of the dune. Fails where its volume is not that of its surface."""

from pathlib import Path

from cosserat.case import Case
from cosserat.picture import snapshots

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

snapshots(case, case.times(), [1], results/"dune.png", columns=2)

#: Area under the surface [m2], and what a row of points is of it
EXPECTED, SPREAD = 0.8, 1e-3

volume = case.cloud("volume")[case.cloud("material") == 1].sum()/0.1
print(f"Volume: {volume:.4f} m2")
print(results/"dune.png")
if abs(volume - EXPECTED) > SPREAD:
    raise SystemExit(f"Not as expected: {EXPECTED} +- {SPREAD} m2")
