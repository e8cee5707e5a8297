#!/usr/bin/env python3
"""Pictures of the flow between the cylinders, with the dye. Fails where the
power that turns the inner one is not as expected."""

from pathlib import Path

from cosserat.case import Case
from cosserat.picture import fields, snapshots

#: Power of the walls on this mesh [W], and how far machines may differ
EXPECTED, SPREAD = 3019.7, 0.5

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)
time = case.times()[-1]

fields(case, time, [("U", None, "|U| [m/s]"),
                    ("omega", None, r"$\omega$ [1/s]")],
       results/"flow.png")
snapshots(case, case.times(), [0], results/"dye.png", velocity=False)
power = case.table("power", "powerBalance.dat")[-1, 2]
print(f"Power of the inner cylinder: {power:.5g} W")
print(f"{results/'flow.png'}\n{results/'dye.png'}")
if abs(power - EXPECTED) > SPREAD:
    raise SystemExit(f"Not as expected: {EXPECTED} +- {SPREAD} W")
