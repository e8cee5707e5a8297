#!/usr/bin/env python3
"""Pictures of the silo: the discharge curve, snapshots with the dye grid, and
what its walls bear."""

from pathlib import Path

from cosserat.case import Case
from cosserat.loads import along
from cosserat.picture import curves, discharge, snapshots

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

# Of the fill, which is between -2.5 and 2.5 above y = 0: on its right wall from
# below, and on the right half of its floor from the aperture
lines = [
    (*along(case, "siloWalls", times[0], lambda x, y: (x == 2.5) & (y > 0), 1),
     "wall, from the floor up"),
    (*along(case, "siloWalls", times[0],
            lambda x, y: (y == 0) & (x > 0) & (x < 2.5), 0),
     "floor, from the middle outwards")]
curves([(s, p/1e6, name) for s, p, name in lines],
       ("place [m]", "normal traction [MPa]"), results/"load.png")

for name in ("discharge", "silo", "load"):
    print(results/f"{name}.png")
