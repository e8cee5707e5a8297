"""What leaving out saves: scenes that do not need a part of the program,
against the same with that part forced on."""

import shutil

import matplotlib.pyplot as plt

from cosserat.scenes.parts import SCENES, run
from studies.common import HERE, save


def study():
    """Rows: scene, off (what was switched off), seconds [s] of a step,
    secondsForced [s] of one with that forced on, their ratio, iterations of
    the run and of the forced one, difference of U and omega (relative)."""
    rows = [run(HERE/"runs/sceneCost", scene) for scene in SCENES]
    shutil.rmtree(HERE/"runs/sceneCost")

    figure, axes = plt.subplots(figsize=(6, 3), dpi=130)
    axes.barh([row["scene"] for row in rows][::-1],
              [row["ratio"] for row in rows][::-1], color="C0")
    axes.axvline(1, color="k", lw=0.8)
    axes.set_xlabel("time of a step over that with the part forced on")
    save(figure, "sceneCost")
    plt.close(figure)
    return rows
