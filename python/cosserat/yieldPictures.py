"""Tutorials of silos run with several yield stresses, and their picture."""

import shutil

import matplotlib.pyplot as plt

from cosserat.case import Case
from cosserat.mirrored import opened
from cosserat.picture import draw_outline, outflow, snapshot
from cosserat.references import Silo
from cosserat.scenes.siloYield import give_yield


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
