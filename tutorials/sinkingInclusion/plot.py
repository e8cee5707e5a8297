#!/usr/bin/env python3
"""Pictures of the sinking inclusion. Fails where it does not sink as far as
expected."""

from pathlib import Path

from cosserat.case import Case
from cosserat.picture import fields, snapshots

#: Fall of its centre [m] on 48 x 48 cells, and how far machines may differ
EXPECTED, SPREAD = 0.2667, 0.001

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)
times = case.times()

snapshots(case, times, [0, 1], results/"inclusion.png")
fields(case, times[0], [("U", None, "|U| [m/s]"),
                        ("omega", None, r"$\omega$ [1/s]")],
       results/"flow.png")

fall = 0.65 - case.centroid(1)[1]
print(f"The inclusion has sunk by {fall:.4f} m")
print(f"{results/'inclusion.png'}\n{results/'flow.png'}")
if abs(fall - EXPECTED) > SPREAD:
    raise SystemExit(f"Not as expected: {EXPECTED} +- {SPREAD} m")
