#!/usr/bin/env python3
"""The stress that the layer bears beside the exact one, and its profiles."""

import re
from pathlib import Path

import matplotlib
matplotlib.use("Agg")

# pylint: disable=wrong-import-position
import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import Case
from cosserat.scenes.yielding import wall_stress
from cosserat.yielding import layer_stress

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

law = (case.path/"constant/materialProperties").read_text()
constants = {key: float(re.search(rf"\b{key}\s+(\S+);", law)[1])
             for key in ("R", "tauY", "etaCRatio")}
depth, q = 1/constants["R"], constants["etaCRatio"]
stress = wall_stress(case)/constants["tauY"]
exact = layer_stress(depth, q)

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
y = case.centres()[:, 1]
order = np.argsort(y)
left.plot(case.field("U")[order, 0], y[order], label="u [m/s]")
left.plot(case.field("omega")[order], y[order], label=r"$\omega$ [1/s]")
left.set_ylabel("y [m]")
left.legend()
depths = np.geomspace(0.5, 100, 40)
right.semilogx(depths, [layer_stress(d, q) for d in depths], label="exact")
right.plot(depth, stress, "o", label="this run")
right.set_xlabel("H/R")
right.set_ylabel("stress over yield stress")
right.legend()
figure.tight_layout()
figure.savefig(results/"layer.png", dpi=120)

print(f"stress over yield stress: {stress:.6f}, exact {exact:.6f}, error"
      f" {100*(stress/exact - 1):.3f} %")
print(results/"layer.png")
