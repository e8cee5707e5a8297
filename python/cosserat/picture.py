"""Pictures of a case, by matplotlib: flow, material and dye at a time.

    python3 -m cosserat.picture CASE [-time TIME] [-o FILE]
"""

import argparse

import matplotlib
matplotlib.use("Agg")
# pylint: disable=wrong-import-position
import matplotlib.pyplot as plt
import numpy as np

from cosserat.analytic import err
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


def snapshots(case, times, materials, file, velocity=True):
    """Pictures of several times side by side."""
    span = np.ptp(np.array(case.boundary_edges())[:, :, :2], axis=(0, 1))
    width = 3.2*len(times)
    height = 3.2*max(span[1], 1e-9)/max(span[0], 1e-9) + 0.7
    figure, axes = plt.subplots(1, len(times), figsize=(width, height),
                                dpi=130, squeeze=False, sharey=True)
    n_points = len(case.cloud("dye", times[0]))
    # Points as large as their share of the picture
    size = 1.6*(72*3.0)**2*span[1]/span[0]/n_points
    for axis, time in zip(axes[0], times):
        snapshot(case, time, materials, axes=axis, velocity=velocity,
                 size=size)
    for axis in axes[0][1:]:
        axis.set_ylabel("")
    figure.tight_layout()
    figure.savefig(file)
    plt.close(figure)


def outflow(case, name="discharge"):
    """Rows (time, volume beyond the plane, flux, volume of the points, volume
    on the mesh) of a materialOutflow function object, restarts joined."""
    rows = {}
    base = case.path/"postProcessing"/name
    for part in sorted(base.iterdir(), key=lambda d: float(d.name)):
        for row in np.loadtxt(part/"materialOutflow.dat", ndmin=2):
            rows[row[0]] = row
    return np.array([rows[t] for t in sorted(rows)])


def discharge(cases, labels, volume, file):
    """Outgoing volume against time, as the paper's Figure 11."""
    figure, axes = plt.subplots(figsize=(6, 4.2), dpi=130)
    for case, label in zip(cases, labels):
        rows = outflow(case)
        axes.plot(rows[:, 0]*1e3, rows[:, 1], label=label)
    axes.axhline(volume, color="grey", lw=0.8, ls=":")
    axes.set_xlabel("time [ms]")
    axes.set_ylabel("granular volume below the fill [m$^2$]")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    axes.grid(alpha=0.3)
    if len(cases) > 1:
        axes.legend()
    figure.tight_layout()
    figure.savefig(file)
    plt.close(figure)


def profiles(case, exact, file):
    """u and omega across a layer beside the analytic ones; returns their
    errors by [30]."""
    y = case.centres()[:, 1]
    found = case.field("U")[:, 0], case.field("omega")
    errors = (err(exact.u(y), found[0]), err(exact.omega(y), found[1]))

    figure, axes = plt.subplots(1, 2, figsize=(8, 4), dpi=130, sharey=True)
    line = np.linspace(-exact.h/2, exact.h/2, 200)
    for axis, function, values, name, error in zip(
            axes, (exact.u, exact.omega), found,
            ("u [m/s]", r"$\omega$ [1/s]"), errors):
        axis.plot(function(line), line, color="black", lw=1, label="analytic")
        _, first = np.unique(y.round(9), return_index=True)
        axis.plot(values[first], y[first], "o", ms=3.5, color="#b5651d",
                  label=f"computed, error {100*error:.2g} %")
        axis.set_xlabel(name)
        axis.grid(alpha=0.3)
        axis.legend()
    axes[0].set_ylabel("y [m]")
    figure.tight_layout()
    figure.savefig(file)
    plt.close(figure)
    return errors


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
