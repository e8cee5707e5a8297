#!/usr/bin/env python3
"""Speed of the slot over its width, between the widths that the weight and the
strength allow, and the pressure in the silo. Fails where it is not."""

import re
from pathlib import Path

import matplotlib
matplotlib.use("Agg")

# pylint: disable=wrong-import-position
import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import Case
from cosserat.yielding import arrest_widths, janssen

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"

law = (case.path/"constant/materialProperties").read_text()
stress, R = (float(re.search(rf"\b{name}\s+(\S+);", law)[1])
             for name in ("tauY", "R"))
held, falls = arrest_widths(stress, 1e4, R, depth=2, slot=1)
widths, soft, stiff = np.loadtxt(results/"widths.csv", delimiter=",").T

# Speeds that fall with the viscosity at rest are a creep
flows = stiff > np.sqrt(0.1)*soft
below, above = widths[~flows].max(), widths[flows].min()

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8))
left.semilogy(widths, soft, "o-", label="eps 1e-5")
left.semilogy(widths, stiff, "s-", label="eps 1e-6")
for width, style, name in ((held, ":", "held by the slot alone"),
                           (falls, "--", "column falls")):
    left.axvline(width, color="k", ls=style, label=name)
left.set_xlabel("width of the slot [m]")
left.set_ylabel("speed [m/s]")
left.legend()

centres, p = case.centres(), case.field("p")
wall = (centres[:, 0] > 0.45) & (centres[:, 1] > 0)
middle = centres[:, 0] < 1.01*centres[:, 0].min()
for where, name in ((middle, "middle"), (wall, "wall")):
    order = np.argsort(centres[where, 1])
    right.plot(p[where][order]/1e3, centres[where, 1][order], label=name)
depth = np.linspace(0, 2, 50)
right.plot(10*janssen(depth, 0.3), 2 - depth, "k--", label="Janssen")
right.plot(10*depth, 2 - depth, "k:", label="no friction")
right.set_xlabel("p [kPa]")
right.set_ylabel("y [m]")
right.legend()
figure.tight_layout()
figure.savefig(results/"silo.png", dpi=120)

print(f"at rest up to {below:.2f} m, flows from {above:.2f} m; the slot alone"
      f" holds up to {held:.3f} m, the column falls from {falls:.3f} m")
print(results/"silo.png")
if not held < below < above < falls:
    raise SystemExit("Not as expected: between the two")
