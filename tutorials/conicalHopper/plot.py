#!/usr/bin/env python3
"""Velocity in the conical hopper and its pressure, beside the sink flow that is
exact. Fails where that is not as expected."""

from pathlib import Path

import numpy as np

from cosserat.analytic import ConeFlow
from cosserat.case import Case
from cosserat.picture import fields

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

#: Largest errors of the velocity, and of the pressure without the weight above
#: over the viscous stress at the narrow end
EXPECTED = 3.1e-3, 2.4e-3

x, _, z = case.centres().T
exact = ConeFlow(0.1).u(z, x)
U = case.field("U")[:, [2, 0]].T
error = np.hypot(*(U - exact)).max()/np.hypot(*exact).max()
# 2 eta u_r,r
stress = 4*100*0.1/0.4**3
spread = np.ptp(case.field("p_rgh"))/stress
fields(case, case.times()[-1],
       [("U", 2, "u [m/s]"), ("p", None, "p [Pa]")], results/"fields.png")
print(f"Largest error of U {error:.3g}, range of p_rgh {spread:.3g} of the"
      " viscous stress")
print(results/"fields.png")
if error > EXPECTED[0] or spread > EXPECTED[1]:
    raise SystemExit(f"Not as expected: errors above {EXPECTED}")
