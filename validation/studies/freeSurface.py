"""Largest stable Courant number of the silo, with and without the
stabilisation of free surfaces (Kaus, Muehlhaus and May 2010): alpha = 0, 4
cells a unit length, half of the discharge.

A run is stable if it ends, if nothing that has left the fill comes back, and
if what has left at any time is within 5 % of the fill of that of a Courant
number of 0.1 without stabilisation."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import RunError
from cosserat.picture import outflow
from cosserat.scenes.silo import VOLUME, mesh_entries
from studies.common import new_case, save

THETAS = [0, 0.5, 1]

COURANTS = [0.5, 1, 2, 4, 8, 16]

END = 1.9e-3


def run(theta, courant, cells=4, end=END):
    """The case of a discharge, and what ended it early."""
    case = new_case("freeSurface", f"{theta}-{courant}", "silo")
    case.substitute("system/blockMeshDict", mesh_entries(cells))
    case.substitute("constant/materialProperties", {"alpha": 0})
    case.substitute("system/controlDict", {
        "maxCo": courant, "endTime": end, "writeInterval": end,
        "deltaT": 2e-6*courant})
    case.override("solution", creepingFlow="{ tolerance 1e-6;"
                  f" freeSurfaceStabilisation {theta}; }}")
    case.run("blockMesh")
    why = ""
    try:
        case.run("cosseratPicFoam")
    except RunError:
        log = case.log()
        why = " ".join(log[log.index("FOAM FATAL"):].split()[:40])
    return case, why


def row_of(case, why, theta, courant, exact):
    """A row, judged by the outflow (columns time, volume) of small steps."""
    rows = outflow(case)
    volume = np.interp(exact[:, 0], rows[:, 0], rows[:, 1])
    far = np.abs(volume - exact[:, 1]).max()/VOLUME
    back = -np.diff(rows[:, 1]).min()/VOLUME
    if not why and back > 0.005:
        why = f"{100*back:.1f} % of the fill come back in a step"
    if not why and far > 0.05:
        why = f"off by {100*far:.0f} % of the fill"
    return {"theta": theta, "courant": courant, "stable": not why,
            "why": why or "as with small steps", "difference": float(far),
            "steps": len(rows) - 1, "step": float(np.diff(rows[:, 0]).max())}


def study():
    """Rows: theta, courant, stable, why, difference (largest, of the outflow
    to that of Courant 0.1, over the fill), steps, step [s] (largest)."""
    reference, why = run(0, 0.1)
    if why:
        raise RunError(why)
    exact = outflow(reference)[:, :2]
    rows = []
    figure, axes = plt.subplots(1, len(THETAS), figsize=(11, 3.6), dpi=130,
                                sharey=True)
    for theta, axis in zip(THETAS, axes):
        for i, courant in enumerate(COURANTS):
            case, why = run(theta, courant)
            row = row_of(case, why, theta, courant, exact)
            rows.append(row)
            print(row, flush=True)
            own = outflow(case)
            axis.plot(own[:, 0]*1e3, own[:, 1], "-" if row["stable"] else ":",
                      color=f"C{i}", lw=1.2, label=f"Co = {courant}")
        axis.plot(exact[:, 0]*1e3, exact[:, 1], "k--", lw=0.8,
                  label=r"$\theta$ = 0, Co = 0.1")
        axis.set_title(rf"$\theta$ = {theta}", fontsize=10)
        axis.set_xlabel("time [ms]")
        axis.set_ylim(0, 18)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=7)
    axes[0].set_ylabel("volume that has left the fill [m$^2$]")
    save(figure, "freeSurface")
    plt.close(figure)
    return rows
