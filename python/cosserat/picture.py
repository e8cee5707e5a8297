"""Pictures of a case, by matplotlib: flow, material and dye at a time.

    python3 -m cosserat.picture CASE [-time TIME] [-o FILE]
"""

import argparse

import matplotlib
matplotlib.use("Agg")
# pylint: disable=wrong-import-position
import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import Case

#: Colours of materials by index, light enough to draw dye on, and of dye
MATERIAL = ["#ffffff", "#e8c88c", "#b9d3e6", "#d8b9d3"]
DYE = "#5a3212"


def draw_points(axes, case, time, materials, size=1.0):
    """Draw the points of some materials (indices), dyed ones dark."""
    xyz = case.cloud("positions", time)
    material = case.cloud("material", time).astype(int)
    dye = case.cloud("dye", time)

    for m in materials:
        plain = (material == m) & (dye == 0)
        axes.scatter(xyz[plain, 0], xyz[plain, 1], s=size, lw=0,
                     c=MATERIAL[m % len(MATERIAL)], rasterized=True)
    dark = np.isin(material, materials) & (dye > 0)
    axes.scatter(xyz[dark, 0], xyz[dark, 1], s=size, lw=0, c=DYE,
                 rasterized=True)


def draw_walls(axes, case):
    """Draw the faces of all patches that are neither empty nor cyclic."""
    for a, b in case.boundary_edges():
        axes.plot([a[0], b[0]], [a[1], b[1]], color="black", lw=1.5,
                  solid_capstyle="round")


def draw_velocity(axes, case, time, n=25):
    """Draw velocity arrows, about n along the longer side."""
    xyz, velocity = case.centres(), case.field("U", time)
    span = np.ptp(xyz[:, :2], axis=0).max()
    bins = np.round(xyz[:, :2]/span*n).astype(int)
    _, first = np.unique(bins, axis=0, return_index=True)
    axes.quiver(xyz[first, 0], xyz[first, 1],
                velocity[first, 0], velocity[first, 1],
                color="#2a5d8a", width=0.0025, pivot="mid")


def snapshot(case, time, materials, file=None, axes=None, velocity=True,
             size=1.0):
    """A picture of points, walls and flow at a time."""
    figure = None
    if axes is None:
        figure, axes = plt.subplots(figsize=(6, 7), dpi=130)
    draw_points(axes, case, time, materials, size)
    draw_walls(axes, case)
    if velocity:
        draw_velocity(axes, case, time)
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.set_title(f"t = {float(time):.3g} s")
    if figure is not None:
        figure.tight_layout()
        figure.savefig(file)
        plt.close(figure)


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("case")
    parser.add_argument("-time", default=None)
    parser.add_argument("-material", type=int, nargs="+", default=[1])
    parser.add_argument("-o", default="snapshot.png")
    options = parser.parse_args()

    case = Case(options.case)
    time = options.time or case.times()[-1]
    snapshot(case, time, options.material, options.o)
    print(f"{options.o}: t = {time} s")


if __name__ == "__main__":
    main()
