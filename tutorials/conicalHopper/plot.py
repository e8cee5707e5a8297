#!/usr/bin/env python3
"""Velocity in the conical hopper, its pressure, and its layers, beside the sink
flow that is exact. Fails where that is not as expected."""

from pathlib import Path

import numpy as np

from cosserat.analytic import ConeFlow
from cosserat.case import Case
from cosserat.mirrored import opened
from cosserat.picture import fields, snapshots

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

#: Largest errors of the velocity; of the pressure without the weight above over
#: the viscous stress at the narrow end; and share of the points whose dye is not
#: that of where they come from
EXPECTED = 3.1e-3, 2.4e-3, 0.02

x, _, z = case.centres().T
flow = ConeFlow(0.1)
exact = flow.u(z, x)
U = case.field("U")[:, [2, 0]].T
error = np.hypot(*(U - exact)).max()/np.hypot(*exact).max()
# 2 eta u_r,r
stress = 4*100*0.1/0.4**3
spread = np.ptp(case.field("p_rgh"))/stress
fields(case, case.times()[-1],
       [("U", 2, "u [m/s]"), ("p", None, "p [Pa]")], results/"fields.png")

# The cube of the distance from the tip has fallen by 3 C t
x, _, z = case.cloud("positions").T
far = np.hypot(x, z)
before = np.cbrt(far**3 + 3*flow.C*float(case.times()[-1]))
height = z*before/far
dyed = (before < 1) & ((height - 0.4) % 0.1 < 0.05)
wrong = (dyed != (case.cloud("dye") > 0)).mean()
snapshots(opened(case.path), case.times(), [0], results/"dye.png")

print(f"Largest error of U {error:.3g}, range of p_rgh {spread:.3g} of the"
      f" viscous stress, dye of {100*wrong:.2g} % of the points wrong")
for name in ("fields", "dye"):
    print(results/f"{name}.png")
if error > EXPECTED[0] or spread > EXPECTED[1] or wrong > EXPECTED[2]:
    raise SystemExit(f"Not as expected: errors above {EXPECTED}")
