#!/usr/bin/env python3
"""Pictures of the silo: the discharge curve and snapshots with the dye grid."""

from pathlib import Path

from cosserat.case import Case
from cosserat.picture import discharge, snapshots

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

discharge([case], ["this run"], 25.0, results/"discharge.png")
times = case.times()
# The paper's times: 4.75e-4, 1.42e-3, 2.85e-3, 3.8e-3 s
shown = [t for t in times
         if min(abs(float(t) - wanted) for wanted in
                (4.75e-4, 1.425e-3, 2.85e-3, 3.8e-3)) < 1e-6]
snapshots(case, shown or times[-1:], [1], results/"silo.png")

print(f"{results/'discharge.png'}\n{results/'silo.png'}")
