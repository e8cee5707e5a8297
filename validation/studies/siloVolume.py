"""Granular volume on the mesh through the full discharge of the silo, default
settings, 64 x 80 cells, 16 points a cell, and without the correction of
volume: what the points have stays exactly, what the mesh has then differs by
the chance of the cells that the surface cuts."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import cpu_seconds
from cosserat.picture import outflow
from cosserat.scenes.silo import ALPHAS, VOLUME
from studies.common import new_case, save

#: 64 columns: those of the corridors and of the floor one more than the 60
MESH = {"nCorridor": 9, "nFloor": 17}


def run(name, correction="yes"):
    """The case of one discharge, with the correction of volume or without."""
    case = new_case("siloVolume", f"{name.replace('/', '_')}-{correction}", "silo")
    case.substitute("system/blockMeshDict", MESH)
    case.substitute("constant/materialProperties", {
        "alpha": repr(ALPHAS[name])})
    if correction != "yes":
        with (case.path/"constant/materialPointsProperties").open("a") as file:
            file.write(f"\nvolumeCorrection {correction};\n")
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    return case


def study():
    """Rows: alpha, correction (of volume; yes is the default), t [s],
    volume [m2] on the mesh, drift (relative), pointDrift (of the points),
    every twentieth of the discharge, the largest drift of all steps last as
    maxDrift; cpu [s]."""
    rows = []
    figure, axes = plt.subplots(figsize=(6.4, 3.8), dpi=130)
    for i, name in enumerate(("0", "2/3")):
        for correction, style in (("no", ":"), ("yes", "-")):
            case = run(name, correction)
            steps = outflow(case)
            drift = steps[:, 4]/VOLUME - 1
            axes.plot(steps[:, 0]*1e3, drift*100, style, color=f"C{i}",
                      lw=1.2, label=rf"$\alpha$ = {name}, correction {correction}")
            for t in np.linspace(0, steps[-1, 0], 21):
                j = np.abs(steps[:, 0] - t).argmin()
                rows.append({
                    "alpha": ALPHAS[name], "correction": correction,
                    "t": float(steps[j, 0]), "volume": float(steps[j, 4]),
                    "drift": float(drift[j]),
                    "pointDrift": float(steps[j, 3]/VOLUME - 1),
                    "maxDrift": float(np.abs(drift).max()),
                    "cpu": cpu_seconds(case.log())})
            print(rows[-1], flush=True)
    for limit in (-0.2, 0.2):
        axes.axhline(limit, color="grey", lw=0.8, ls="--")
    axes.set_xlabel("time [ms]")
    axes.set_ylabel("drift of the volume on the mesh [%]")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    save(figure, "siloVolume")
    plt.close(figure)
    return rows
