"""The silo whose fill yields: a law for the tutorials' cases, and pictures."""

import re
import shutil

import matplotlib.pyplot as plt

from cosserat.case import Case, FILES
from cosserat.mirrored import opened
from cosserat.picture import draw_outline, outflow, snapshot
from cosserat.references import Silo
from cosserat.scenes.yielding import entries

#: Rate far below those of the flow [1/s]
EPS = 10.0


def give_yield(case, tauY, eps=EPS):
    """Make the fill of a copy of the tutorial yield at tauY [Pa], with the
    viscosities of the tutorial as those beyond it."""
    path = case.path/FILES["materials"]
    law = {"etaP": Silo.ETA, "tauY": tauY, "eps": eps,
           "regularisation": "BercovierEngelman", "etaCRatio": 1,
           "R": "$alpha", "B": "infinite"}
    head, tail = path.read_text().split("    granular\n")
    tail = re.sub(r"viscosityLaw    constant;\s+constantCoeffs\s+\{.*?\}",
                  f"viscosityLaw    bingham;\n        binghamCoeffs"
                  f" {{ {entries(law)} }}", tail, count=1, flags=re.S)
    path.write_text(f"{head}    granular\n{tail}")
    # Cells that the fill's surface cuts have no exact derivative
    case.override("solution", creepingFlow="{ nonlinear { tolerance 1e-4; } }")
    return case


def run_with(case, stress, end, mesh):
    """Run a copy of a tutorial, in its results, with a yield stress (over the
    weight of an aperture's height), to a time [s], on a mesh with entries."""
    path = case.path/"results"/f"yield-{stress}"
    shutil.rmtree(path, ignore_errors=True)
    copy = Case.copy(case.path, path)
    copy.substitute("system/blockMeshDict", mesh)
    copy.substitute("system/controlDict", {"endTime": end})
    if stress:
        give_yield(copy, stress*Silo.WEIGHT)
    copy.run("blockMesh")
    copy.run("cosseratPicFoam")
    return copy


def compare(case, stresses, end, mesh, unit):
    """Run a tutorial with several yield stresses; draw the fills at the end side
    by side, with what is slower than a hundredth of the fastest outlined."""
    runs = [run_with(case, stress, end, mesh) for stress in stresses]
    figure, axes = plt.subplots(1, len(runs), figsize=(11, 4.6), dpi=100)
    for axis, stress, done in zip(axes, stresses, runs):
        last = done.times()[-1]
        both = opened(done.path)
        snapshot(both, last, [1], axes=axis)
        draw_outline(axis, both, last, "speed", 0.01)
        axis.set_title(f"yield stress {stress} rho g a")
        rate = outflow(done)
        print(f"yield stress {stress} rho g a: {rate[-1][1]:.4g} {unit} in"
              f" {rate[-1][0]:.4g} s")
    figure.tight_layout()
    figure.savefig(case.path/"results/yield.png")
    print(case.path/"results/yield.png")
