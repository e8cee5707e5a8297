"""Meshes refined by refineScene beside uniform ones, at rest: the silo with its
slot's corners refined, a disc with its surface, a cavity with the lid's ends or
by the error indicator."""

import matplotlib.pyplot as plt
from matplotlib.ticker import LogLocator, NullFormatter

from cosserat.scenes.levels import SLOT, corners, disc, lid, silo, surface
from studies.common import HERE, new_case, save

FOLDER = HERE/"runs/refinement"

SILOS = ["start, 0", "start, 2/3", "filled, 0", "filled, 2/3",
         "one viscosity, 0", "one viscosity, 2/3"]

DISCS = ["disc", "disc, Cosserat"]

LIDS = ["lid", "lid, Cosserat"]

#: Ratio of the viscosities of the disc and what is around
CONTRAST = 1e3

UNIFORM, REFINED = "uniform", "refined"


def silos():
    """Rows of the silo."""
    for name in SILOS:
        for model in (True, False):
            scene = f"silo {name}" + ("" if model else ", corners off")
            for cells in (4, 8, 16, 32):
                yield scene, cells, 0, silo(
                    new_case("refinement", "silo", "silo"), name, cells,
                    model=model)
            for levels in (2, 4, 6):
                yield scene, 8, levels, silo(
                    new_case("refinement", "silo", "silo"), name, 8,
                    corners(levels, within=SLOT), model)


def discs():
    """Rows of the disc."""
    for name in DISCS:
        for cells in (16, 32, 64, 128, 256):
            yield name, cells, 0, disc(FOLDER/"disc", name, CONTRAST, cells)
        for cells in (16, 32):
            for levels in (1, 2, 3):
                yield name, cells, levels, disc(
                    FOLDER/"disc", name, CONTRAST, cells, surface(levels))


def lids():
    """Rows of the cavity."""
    for name in LIDS:
        for cells in (16, 32, 64, 128):
            yield name, cells, 0, lid(FOLDER/"lid", name, cells)
        for levels in (2, 4, 6):
            yield name, 32, levels, lid(FOLDER/"lid", name, 32,
                                        corners(levels))
        for passes in (1, 2, 3):
            yield f"{name}, by indicator", 32, passes, lid(
                FOLDER/"lid", name, 32, indicator=(passes, 0.2))


def draw(rows):
    """Error against time, one axis for each scene with its references."""
    figure, axes = plt.subplots(2, 3, figsize=(11, 6.6), dpi=120)
    scenes = [f"silo {name}" for name in ("start, 2/3", "filled, 2/3")] + [
        DISCS[0], f"silo {SILOS[3]}, corners off", DISCS[1], LIDS[0]]
    for axis, scene in zip(axes.ravel(), scenes):
        groups = {(UNIFORM, None): "C7s--"}
        groups |= {(REFINED, cells): style for cells, style in
                   zip((8, 16, 32), ("C0o-", "C1o-", "C2o-"))}
        for (kind, base), style in groups.items():
            for name, marks in ((scene, style),
                                (f"{scene}, by indicator", "C3^-")):
                own = [row for row in rows if row["scene"] == name
                       and (row["levels"] > 0) == (kind == REFINED)
                       and (kind == UNIFORM or row["base"] == base)]
                if own:
                    axis.loglog([row["cpu"] for row in own],
                                [100*abs(row["error"]) for row in own], marks,
                                label=(kind if kind == UNIFORM else
                                       f"{base} cells and levels")
                                + name[len(scene):])
        axis.set_title(scene, fontsize=9)
        axis.set_xlabel("time of a run [s]", fontsize=8)
        axis.set_ylabel("error [%]", fontsize=8)
        for side in (axis.xaxis, axis.yaxis):
            side.set_major_locator(LogLocator(subs=(1, 2, 5)))
            side.set_major_formatter("{x:g}")
            side.set_minor_formatter(NullFormatter())
        axis.grid(alpha=0.3)
        axis.legend(fontsize=7)
    save(figure, "refinement")
    plt.close(figure)


def study():
    """Rows: scene, base (cells a unit or a side before), levels (0: uniform),
    cells, error (relative: rate of the silo, speed of the disc, flux of the
    cavity's vortex), iterations, cpu [s] (of the run, refinement aside), points
    (where there are any)."""
    rows = []
    for part in (silos, discs, lids):
        for scene, base, levels, row in part():
            rows.append({"scene": scene, "base": base, "levels": levels} | row)
            print(*(f"{value:.4g}" if isinstance(value, float) else value
                    for value in rows[-1].values()), flush=True)
    draw(rows)
    return rows
