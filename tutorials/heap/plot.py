#!/usr/bin/env python3
"""Pictures of the heap, and the angle at which its slope comes to rest. Fails
where that is not what friction allows."""

import re
from pathlib import Path

import numpy as np

from cosserat.case import Case
from cosserat.picture import curves, snapshots

#: How far the angle may be off [degrees]
SPREAD = 1

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

centres = case.centres()
x, column = np.unique(np.round(centres[:, 0], 9), return_inverse=True)
width = x[1] - x[0]


def heights(time):
    """Of the grains in each column of cells [m]."""
    grains = case.field("alpha.grains", time)*case.volumes()/0.1
    return np.bincount(column, grains)/width


def slope(time):
    """Angle [degrees] between a fifth and four fifths of the height."""
    h = heights(time)
    steep = (h > 0.2*h.max()) & (h < 0.8*h.max())
    return -np.degrees(np.arctan(np.polyfit(x[steep], h[steep], 1)[0]))


law = (case.path/"constant/materialProperties").read_text()
friction = np.radians(float(re.search(r"\bangle\s+(\S+);", law)[1]))
expected = np.degrees(np.arctan(np.sin(friction)))

times = ["0.2", "0.6", "1", case.times()[-1]]
snapshots(case, times, [1], results/"heap.png", columns=2)
last = heights(times[-1])
line = last.max()/2 - np.tan(np.radians(expected))*(
    x - np.interp(-last.max()/2, -last, x))
curves([(x, heights(time), f"{time} s") for time in times]
       + [(x, np.maximum(line, 0), f"{expected:.1f} degrees")],
       ("x [m]", "height [m]"), results/"slope.png")

angle = slope(times[-1])
print(f"slope {angle:.2f} degrees, arctan(sin phi) {expected:.2f} degrees")
print(f"{results/'heap.png'}\n{results/'slope.png'}")
if abs(angle - expected) > SPREAD:
    raise SystemExit(f"Not as expected: {expected:.2f} +- {SPREAD} degrees")
