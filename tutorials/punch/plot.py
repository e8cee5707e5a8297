#!/usr/bin/env python3
"""The limit pressure over the size of cells beside the exact one, and where the
medium yields. Fails where the limit is not as expected."""

from pathlib import Path

import matplotlib
matplotlib.use("Agg")

# pylint: disable=wrong-import-position
import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import Case
from cosserat.picture import draw_field, draw_outline
from cosserat.scenes.punch import limit
from cosserat.yielding import PUNCH

#: Share by which the limit may differ from the exact one
SPREAD = 0.01

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
n, q = np.loadtxt(results/"meshes.csv", delimiter=",").T
found, fall = limit(q)

figure, (left, right) = plt.subplots(
    1, 2, figsize=(9.5, 3.8), gridspec_kw={"width_ratios": (1, 1.5)})
left.plot(0.5/n, q, "o-", label="computed")
left.plot(0, found, "s", label="their limit")
left.axhline(PUNCH, color="k", ls="--", label=r"$2+\pi$")
left.set_xlabel("size of the cells over the width of the strip")
left.set_ylabel("pressure over yield stress")
left.legend()
cells = draw_field(right, case, "Gamma", case.times()[-1], limits=(0, 5))
figure.colorbar(cells, ax=right, label=r"$\Gamma$ [1/s]", shrink=0.8)
draw_outline(right, case, case.times()[-1], "speed", 0.01)
right.set_aspect("equal")
right.set_xlabel("x [m]")
right.set_ylabel("y [m]")
figure.tight_layout()
figure.savefig(results/"punch.png", dpi=120)

for cells, value in zip(n, q):
    print(f"n {cells:g}: pressure over yield stress {value:.4f}, error"
          f" {100*(value/PUNCH - 1):.2f} %")
print(f"limit of the three {found:.4f}, order {np.log2(fall):.2f}, exact"
      f" {PUNCH:.4f}, error {100*(found/PUNCH - 1):.2f} %")
print(results/"punch.png")

if abs(found/PUNCH - 1) > SPREAD:
    raise SystemExit(f"Not as expected: {PUNCH:.4f} within {100*SPREAD:g} %")
