"""Pictures and animations of a case: fields, points with dye, velocity.

    foamPicture CASE -field omega          # cells coloured by a field
    foamPicture CASE -arrows -o dye.png    # points, dye and velocity
    foamPicture CASE -animate              # all times as a GIF

Fields must be ascii, and the case reconstructed where it ran in parallel.
"""

import argparse

import matplotlib
matplotlib.use("Agg")
# pylint: disable=wrong-import-position
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.collections import PolyCollection

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


def draw_field(axes, case, name, time, component=None, limits=None):
    """Colour the cells by a field: a scalar, a component of a vector or its
    magnitude. Returns what a colour bar needs."""
    values = case.field(name, time)
    if values.ndim > 1:
        values = (np.linalg.norm(values, axis=1) if component is None
                  else values[:, component])
    low, high = limits or (values.min(), values.max())
    signed = low < 0 < high
    if signed:
        high = max(-low, high)
        low = -high
    cells = PolyCollection(
        [corners[:, :2] for corners in case.polygons()], array=values,
        cmap="RdBu_r" if signed else "viridis", edgecolors="face", lw=0.2)
    cells.set_clim(low, high)
    axes.add_collection(cells)
    axes.autoscale_view()
    return cells


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


def snapshots(case, times, materials, file, velocity=True, columns=None):
    """Pictures of several times side by side, or in so many columns."""
    span = np.ptp(np.array(case.boundary_edges())[:, :, :2], axis=(0, 1))
    columns = columns or len(times)
    rows = -(-len(times)//columns)
    each = max(3.2, 12.8/columns if rows > 1 else 0)
    width = each*columns
    height = (each*max(span[1], 1e-9)/max(span[0], 1e-9) + 0.7)*rows
    figure, axes = plt.subplots(rows, columns, figsize=(width, height),
                                dpi=130, squeeze=False, sharey=True)
    n_points = len(case.cloud("dye", times[0]))
    # Points as large as their share of the picture
    size = 1.6*(72*(each - 0.2))**2*span[1]/span[0]/n_points
    for axis, time in zip(axes.flat, times):
        snapshot(case, time, materials, axes=axis, velocity=velocity,
                 size=size)
    for axis in axes[:, 1:].flat:
        axis.set_ylabel("")
    figure.tight_layout()
    figure.savefig(file)
    plt.close(figure)


def outflow(case, name="discharge"):
    """Rows (time, volume beyond the plane, flux, volume of the points, volume
    on the mesh) of a materialOutflow function object, restarts joined."""
    return case.table(name, "materialOutflow.dat")


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
    return comparison(
        y, np.linspace(-exact.h/2, exact.h/2, 200), "y [m]",
        [("u [m/s]", exact.u, case.field("U")[:, 0]),
         (r"$\omega$ [1/s]", exact.omega, case.field("omega"))], file)


def comparison(places, line, label, panels, file):
    """Values at places beside analytic curves along a line. Panels are (name,
    function, values); returns their errors by [30]."""
    figure, axes = plt.subplots(1, len(panels), figsize=(4*len(panels), 4),
                                dpi=130, sharey=True, squeeze=False)
    _, first = np.unique(places.round(6), return_index=True)
    errors = []
    for axis, (name, function, values) in zip(axes[0], panels):
        errors.append(err(function(places), values))
        axis.plot(function(line), line, color="black", lw=1, label="analytic")
        axis.plot(values[first], places[first], "o", ms=3.5, color="#b5651d",
                  label=f"computed, error {100*errors[-1]:.2g} %")
        axis.set_xlabel(name)
        axis.grid(alpha=0.3)
        axis.legend()
    axes[0, 0].set_ylabel(label)
    figure.tight_layout()
    figure.savefig(file)
    plt.close(figure)
    return errors


def fields(case, time, names, file):
    """Fields at a time side by side; names are (field, component or None,
    label)."""
    span = np.ptp(case.centres()[:, :2], axis=0)
    figure, axes = plt.subplots(
        1, len(names), dpi=130, squeeze=False, sharey=True,
        figsize=(4.6*len(names), 3.4*span[1]/span[0] + 0.8))
    for axis, (name, component, label) in zip(axes[0], names):
        cells = draw_field(axis, case, name, time, component)
        draw_walls(axis, case)
        axis.set_aspect("equal")
        axis.set_xlabel("x [m]")
        figure.colorbar(cells, ax=axis, label=label, shrink=0.8)
    axes[0, 0].set_ylabel("y [m]")
    axes[0, 0].set_title(f"t = {float(time):.3g} s")
    figure.tight_layout()
    figure.savefig(file)
    plt.close(figure)


def curves(lines, labels, file):
    """Curves against time: lines are (times, values, name), labels those of
    the axes."""
    figure, axes = plt.subplots(figsize=(6, 4.2), dpi=130)
    for times, values, name in lines:
        axes.plot(times, values, label=name)
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])
    axes.grid(alpha=0.3)
    if len(lines) > 1:
        axes.legend()
    figure.tight_layout()
    figure.savefig(file)
    plt.close(figure)


def frame_of(case):
    """Figure, axes and limits ((x, x), (y, y)) that fit the mesh."""
    ends = np.array(case.boundary_edges())[:, :, :2]
    low, high = ends.min(axis=(0, 1)), ends.max(axis=(0, 1))
    margin = 0.02*(high - low).max()
    height = 5.4*(high - low)[1]/(high - low)[0] + 0.9
    figure, axes = plt.subplots(figsize=(6.8, min(max(height, 2.4), 9)),
                                dpi=110)
    return figure, axes, np.array([low - margin, high + margin]).T


def animation(case, draw, times, file, pause=0.15):
    """An animated GIF of the pictures that draw(axes, time) makes."""
    figure, axes, _ = frame_of(case)

    def frame(time):
        axes.clear()
        draw(axes, time)

    made = FuncAnimation(figure, frame, frames=times, cache_frame_data=False)
    made.save(file, writer=PillowWriter(fps=1/pause))
    plt.close(figure)


def drawing(case, options, limits, colours):
    """Function (axes, time) that draws what the command line asks for."""
    def point_size(axes, time):
        """Points as large as their share of the picture [pt^2]."""
        box = axes.get_window_extent().transformed(
            axes.figure.dpi_scale_trans.inverted())
        return 1.3*72**2*box.width*box.height/len(case.cloud("dye", time))

    def draw(axes, time):
        folder = case.path/time/"lagrangian"
        axes.set_aspect("equal")
        axes.set_xlim(*limits[0])
        axes.set_ylim(*limits[1])
        if options["field"]:
            cells = draw_field(axes, case, options["field"], time,
                               options["component"], colours)
            if axes.figure.axes == [axes]:
                axes.figure.colorbar(cells, ax=axes, label=options["field"])
            axes.set_xlim(*limits[0])
            axes.set_ylim(*limits[1])
        elif folder.exists():
            draw_points(axes, case, time, options["material"],
                        options["size"] or point_size(axes, time))
        draw_walls(axes, case)
        if options["arrows"]:
            draw_velocity(axes, case, time)
        axes.set_xlabel("x [m]")
        axes.set_ylabel("y [m]")
        axes.set_title(f"t = {float(time):.4g} s")

    return draw


def field_limits(case, name, component, times):
    """Smallest and largest value over all times, for one scale of colours."""
    low, high = np.inf, -np.inf
    for time in times:
        values = case.field(name, time)
        if values.ndim > 1:
            values = (np.linalg.norm(values, axis=1) if component is None
                      else values[:, component])
        low, high = min(low, values.min()), max(high, values.max())
    return low, high


def main():
    """The command line."""
    parser = argparse.ArgumentParser(
        prog="foamPicture", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("case", nargs="?", default=".")
    parser.add_argument("-time", help="time, or latest (the default)")
    parser.add_argument("-field", help="colour the cells by a field of the"
                        " time folder; without it the points are drawn")
    parser.add_argument("-component", choices="xyz",
                        help="of a vector field; its magnitude by default")
    parser.add_argument("-material", type=int, nargs="+",
                        help="points of these materials, by their number in"
                        " constant/materialProperties from 0; all by default")
    parser.add_argument("-size", type=float,
                        help="of a point, in points^2")
    parser.add_argument("-arrows", action="store_true",
                        help="draw the velocity")
    parser.add_argument("-animate", action="store_true",
                        help="a GIF of all times")
    parser.add_argument("-o", help="file, picture.png or animation.gif by"
                        " default")
    asked = parser.parse_args()

    case = Case(asked.case)
    if not (case.path/"constant/polyMesh/faces").exists():
        parser.error(f"no mesh in {case.path}: run blockMesh")
    every = case.times()
    if not every:
        parser.error(f"no times in {case.path} but 0: run the solver, and"
                     " reconstructPar where it ran in parallel")
    if asked.time in (None, "latest"):
        asked.time = every[-1]
    if asked.time not in every:
        parser.error(f"no time {asked.time}; there are {' '.join(every)}")
    times = every if asked.animate else [asked.time]
    if asked.field and not (case.path/times[-1]/asked.field).exists():
        names = sorted(f.name for f in (case.path/times[-1]).iterdir()
                       if f.is_file())
        parser.error(f"no field {asked.field} at {times[-1]};"
                     f" there are {' '.join(names)}")

    component = "xyz".index(asked.component) if asked.component else None
    colours = None
    if asked.field:
        colours = field_limits(case, asked.field, component, times)
    figure, axes, limits = frame_of(case)
    draw = drawing(
        case, {"field": asked.field, "component": component,
               "material": asked.material or range(len(MATERIAL)),
               "size": asked.size, "arrows": asked.arrows}, limits, colours)

    if asked.animate:
        file = asked.o or "animation.gif"
        animation(case, draw, times, file)
        print(f"{file}: {len(times)} times")
        return
    file = asked.o or "picture.png"
    draw(axes, times[0])
    figure.tight_layout()
    figure.savefig(file)
    print(f"{file}: t = {times[0]} s")


if __name__ == "__main__":
    main()
