#!/usr/bin/env python3
"""The band with and without internal length on the finest mesh, and its width
over the size of the cells. Fails where width or angle are not as expected."""

from pathlib import Path

import matplotlib
matplotlib.use("Agg")

# pylint: disable=wrong-import-position
import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import Case
from cosserat.picture import draw_field

#: Share of the width that the finest mesh leaves at least, and classical at
#: most; angle by Roscoe and what it may be off [degrees]
LEAST, MOST = 0.9, 0.6
ROSCOE, SPREAD = 45, 2

results = Path(__file__).resolve().parent/"results"
table = np.loadtxt(results/"meshes.csv", delimiter=",")

figure, axes = plt.subplots(1, 3, figsize=(12.5, 3.4))
for axis, name, most in zip(axes, ("cosserat", "classical"), (8, 25)):
    run = Case(results/name)
    cells = draw_field(axis, run, "Gamma", run.times()[-1], limits=(0, most))
    figure.colorbar(cells, ax=axis, label=r"$\Gamma$ [1/s]", shrink=0.8)
    axis.set_aspect("equal")
    axis.set_title(name.capitalize())
    axis.set_xlabel("x [m]")
axes[0].set_ylabel("y [m]")
axes[2].loglog(1/table[:, 0], table[:, 2], "o-", label="Cosserat")
axes[2].loglog(1/table[:, 0], table[:, 4], "s-", label="classical")
axes[2].loglog(1/table[:, 0], 5/table[:, 0], "k:", label="five cells")
axes[2].set_xlabel("size of the cells [m]")
axes[2].set_ylabel("width of the band [m]")
axes[2].set_xticks(1/table[:, 0], [f"1/{n:g}" for n in table[:, 0]])
axes[2].set_yticks((0.1, 0.2, 0.4), ("0.1", "0.2", "0.4"))
axes[2].minorticks_off()
axes[2].legend()
figure.tight_layout()
figure.savefig(results/"bands.png", dpi=120)

for n, angle, width, classicalAngle, classicalWidth in table:
    print(f"n {n:g}: width {width:.4f} m at {angle:.1f} degrees; classical"
          f" {classicalWidth:.4f} m at {classicalAngle:.1f} degrees")
before, now = table[-2:]
print(f"from n {before[0]:g} to {now[0]:g} the width changes by"
      f" {100*(now[2]/before[2] - 1):.1f} %, classical"
      f" {100*(now[4]/before[4] - 1):.1f} %")
print(results/"bands.png")

if now[2] < LEAST*before[2] or now[4] > MOST*before[4]:
    raise SystemExit(f"Not as expected: at least {LEAST} of the width before,"
                     f" classical at most {MOST}")
if max(abs(now[1] - ROSCOE), abs(now[3] - ROSCOE)) > SPREAD:
    raise SystemExit(f"Not as expected: {ROSCOE} +- {SPREAD} degrees")
