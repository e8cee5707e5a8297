#!/usr/bin/env python3
"""Pictures of the ring: profiles beside the analytic ones, and the dye. Fails
where the errors are not those expected."""

from pathlib import Path

import numpy as np

from cosserat.analytic import AnnularCouette, Material
from cosserat.case import Case
from cosserat.picture import comparison, snapshots

#: Errors by [30] of u and omega on 16 cells across, rounded up
EXPECTED = 4.3e-3, 6.4e-3

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

ring = AnnularCouette(Material(1000, 1000, R=0.2), r=(1, 2), speed=(1, 0),
                      rotation=(1, 0))
x, y = case.centres()[:, :2].T
r = np.hypot(x, y)
U = case.field("U")
errors = comparison(
    r, np.linspace(1, 2, 200), "r [m]",
    [(r"$u_\theta$ [m/s]", ring.u, (x*U[:, 1] - y*U[:, 0])/r),
     (r"$\omega$ [1/s]", ring.omega, case.field("omega"))],
    results/"profiles.png")
snapshots(case, case.times(), [0], results/"dye.png", velocity=False)

print(f"Err [30]: u {errors[0]:.3g}, omega {errors[1]:.3g}")
print(f"{results/'profiles.png'}\n{results/'dye.png'}")
if any(np.array(errors) > EXPECTED):
    raise SystemExit(f"Not as expected: errors above {EXPECTED}")
