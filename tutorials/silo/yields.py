#!/usr/bin/env python3
"""The silo whose fill yields, beside the viscous one: runs in results/, and a
picture with what stagnates outlined."""

import shutil
from pathlib import Path

import matplotlib.pyplot as plt

from cosserat.case import Case
from cosserat.picture import draw_outline, outflow, snapshot
from cosserat.references import Silo
from cosserat.scenes.silo import COARSE
from cosserat.scenes.siloYield import give_yield

#: Yield stresses over the weight of an aperture's height
STRESSES = (0, 0.1, 2)

#: What is slower than this share of the fastest stagnates
STAGNANT = 0.01

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"


def run(stress):
    """The case with a yield stress, 4 cells a unit."""
    path = results/f"yield-{stress}"
    shutil.rmtree(path, ignore_errors=True)
    copy = Case.copy(case.path, path)
    copy.substitute("system/blockMeshDict", COARSE)
    copy.substitute("system/controlDict", {"endTime": 9.5e-4})
    if stress:
        give_yield(copy, stress*Silo.WEIGHT)
    copy.run("blockMesh")
    copy.run("cosseratPicFoam")
    return copy


runs = [run(stress) for stress in STRESSES]
figure, axes = plt.subplots(1, len(runs), figsize=(11, 4.6), dpi=100)
for axis, stress, done in zip(axes, STRESSES, runs):
    last = done.times()[-1]
    snapshot(done, last, [1], axes=axis)
    draw_outline(axis, done, last, "speed", STAGNANT)
    axis.set_title(f"yield stress {stress} rho g a")
    rate = outflow(done)
    print(f"yield stress {stress} rho g a: {rate[-1][1]:.4g} m2 in"
          f" {rate[-1][0]:.4g} s")
figure.tight_layout()
figure.savefig(results/"yield.png")
print(results/"yield.png")
