"""Pictures and animations of a case: fields, points with dye, velocity.

    foamPicture CASE -field omega          # cells coloured by a field
    foamPicture CASE -arrows -o dye.png    # points, dye and velocity
    foamPicture CASE -streamlines -o a.pdf # lines of the flow, to be printed
    foamPicture CASE -outline speed 0.01   # what stagnates, outlined
    foamPicture CASE -animate              # all times as a GIF

Files may be ascii or binary, compressed or not, the plane any of the three; a
case that ran in parallel is to be reconstructed. Wedges are mirrored at the axis.
"""

import argparse
import re

import matplotlib
matplotlib.use("Agg")
# pylint: disable=wrong-import-position
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.collections import PolyCollection

from matplotlib.lines import Line2D
from matplotlib.path import Path
from scipy.interpolate import LinearNDInterpolator

from cosserat.analytic import err
from cosserat.case import Case
from cosserat.foamfile import FoamFile, find
from cosserat.mirrored import opened
from cosserat.units import label

#: Colours of materials by index, light enough to draw dye on, and of dye
MATERIAL = ["#ffffff", "#e8c88c", "#b9d3e6", "#d8b9d3"]
DYE = "#5a3212"


def material_names(case, time):
    """Names of the materials, by the number that points of a time know."""
    file = case.path/time/"uniform/lagrangian/materialPoints/materials"
    if find(file):
        return re.search(r"names\s+\d*\s*\(([^)]*)\)",
                         FoamFile(file).text())[1].split()
    return []


def draw_points(axes, case, time, materials, size=1.0, marks=False):
    """Draw the points of some materials (indices), dyed ones dark, or each
    mark of the dye in a colour of its own."""
    across, up = case.cloud("positions", time)[:, case.plane()].T
    material = case.cloud("material", time).astype(int)
    dye = case.cloud("dye", time)

    for m in materials:
        plain = (material == m) & (dye == 0)
        axes.scatter(across[plain], up[plain], s=size, lw=0,
                     c=MATERIAL[m % len(MATERIAL)], rasterized=True)
    dark = np.isin(material, materials) & (dye > 0)
    colours = (plt.get_cmap("tab10")((dye[dark].astype(int) - 1) % 10)
               if marks else DYE)
    axes.scatter(across[dark], up[dark], s=size, lw=0, c=colours,
                 rasterized=True)


def draw_legend(axes, case, time, materials, marks=False):
    """Name the colours of materials and dye, below the picture."""
    names = material_names(case, time)
    dye = case.cloud("dye", time).astype(int)
    used = set(case.cloud("material", time).astype(int))
    entries = [(names[m] if m < len(names) else f"material {m}",
                MATERIAL[m % len(MATERIAL)]) for m in materials if m in used]
    if marks:
        entries += [(f"dye {mark}", plt.get_cmap("tab10")((mark - 1) % 10))
                    for mark in sorted(set(dye) - {0})[:10]]
    elif dye.any():
        entries.append(("dye", DYE))
    axes.legend([Line2D([], [], ls="", marker="s", ms=7, mec="grey", mew=0.5,
                        mfc=colour) for _, colour in entries],
                [name for name, _ in entries], loc="upper center",
                bbox_to_anchor=(0.5, -0.14), ncol=min(len(entries), 4),
                frameon=False, fontsize=8)


def select(values, component):
    """A component of vectors ("x") or tensors ("xy"), or the magnitude."""
    if values.ndim == 1:
        return values
    if component is None:
        return np.linalg.norm(values, axis=1)
    indices = ["xyz".index(letter) for letter in component]
    wanted = 3 if len(indices) == 1 else 9
    if values.shape[1] != wanted:
        raise ValueError(f"component {component} of {values.shape[1]} numbers")
    return values[:, sum(i*3**k for k, i in enumerate(reversed(indices)))]


def quantity(case, name, time, component=None):
    """Name of what a field shows, with its unit."""
    file = case.file(name, time)
    scalar = "ScalarField" in file.header
    text = (name if scalar else f"|{name}|" if component is None
            else f"{name}$_{{{component}}}$")
    return label(text, file.dimensions())


def draw_field(axes, case, name, time, component=None, limits=None):
    """Colour the cells by a field: a scalar, a component of a vector or its
    magnitude. Returns what a colour bar needs."""
    values = case.field(name, time)
    if isinstance(component, int):
        component = "xyz"[component]
    values = select(values, component)
    low, high = limits or (values.min(), values.max())
    signed = low < 0 < high
    if signed:
        high = max(-low, high)
        low = -high
    plane = case.plane()
    cells = PolyCollection(
        [corners[:, plane] for corners in case.polygons()], array=values,
        cmap="RdBu_r" if signed else "viridis", edgecolors="face", lw=0.2)
    cells.set_clim(low, high)
    axes.add_collection(cells)
    axes.autoscale_view()
    return cells


def draw_walls(axes, case):
    """Draw the faces of all patches that are neither empty nor cyclic."""
    i, j = case.plane()
    for a, b in case.boundary_edges():
        axes.plot([a[i], b[i]], [a[j], b[j]], color="black", lw=1.5,
                  solid_capstyle="round")


def name_axes(axes, case):
    """Name the axes of the plane."""
    across, up = ("xyz"[i] for i in case.plane())
    axes.set_xlabel(f"{across} [m]")
    axes.set_ylabel(f"{up} [m]")


def flow_in_plane(case, time):
    """Centres and velocities of the cells in the plane, (n, 2) each."""
    plane = case.plane()
    centres = np.array([corners.mean(axis=0)[plane]
                        for corners in case.polygons()])
    return centres, case.field("U", time)[:, plane]


def draw_velocity(axes, case, time, n=25, key=False):
    """Draw velocity arrows, about n along the longer side, and what their
    length means where a key is wanted."""
    xy, velocity = flow_in_plane(case, time)
    span = np.ptp(xy, axis=0).max()
    bins = np.round(xy/span*n).astype(int)
    _, first = np.unique(bins, axis=0, return_index=True)
    arrows = axes.quiver(*xy[first].T, *velocity[first].T, color="#2a5d8a",
                         width=0.0025, pivot="mid")
    if key:
        speed = float(f"{np.hypot(*velocity.T).max():.1g}")
        axes.quiverkey(arrows, 0.86, 1.035, speed, f"{speed:g} m/s",
                       labelpos="E", fontproperties={"size": 8})


def on_grid(case, xy, values, n):
    """Values of the cells on a grid of n places along the longer side, nan
    where there is no cell: the places across and up, and the values."""
    edges = np.array(case.boundary_edges())[:, :, case.plane()]
    low, high = edges.min(axis=(0, 1)), edges.max(axis=(0, 1))
    step = (high - low).max()/n
    places = [np.linspace(a, b, max(int(round((b - a)/step)), 2))
              for a, b in zip(low, high)]
    grid = np.meshgrid(*places)
    u = LinearNDInterpolator(xy, values)(np.stack(grid, axis=-1))

    # Nothing where there is no cell
    inside = np.zeros(grid[0].shape, bool)
    points = np.stack(grid, axis=-1).reshape(-1, 2)
    for corners in case.polygons():
        polygon = corners[:, case.plane()]
        a, b = polygon.min(axis=0), polygon.max(axis=0)
        rows = slice(*np.searchsorted(places[1], [a[1], b[1]] + np.array(
            [-1e-9, 1e-9])*step))
        columns = slice(*np.searchsorted(places[0], [a[0], b[0]] + np.array(
            [-1e-9, 1e-9])*step))
        some = points.reshape(*inside.shape, 2)[rows, columns]
        inside[rows, columns] |= Path(polygon).contains_points(
            some.reshape(-1, 2), radius=1e-9*step).reshape(some.shape[:2])
    u[~inside] = np.nan
    return places, u


def draw_outline(axes, case, time, name, value, n=240):
    """Draw the line on which a field (of vectors, its magnitude) has a value;
    name speed: the velocity over its largest."""
    field = case.field("U" if name == "speed" else name, time)
    values = field if field.ndim == 1 else np.linalg.norm(field, axis=1)
    if name == "speed":
        values = values/max(values.max(), 1e-300)
    centres = np.array([corners.mean(axis=0)[case.plane()]
                        for corners in case.polygons()])
    places, values = on_grid(case, centres, values, n)
    return axes.contour(*places, values, levels=[value], colors="#c22a2a",
                        linewidths=1.6)


def draw_streamlines(axes, case, time, n=120):
    """Draw lines along the velocity, wider where it is faster; returns what
    matplotlib makes of them."""
    xy, velocity = flow_in_plane(case, time)
    places, u = on_grid(case, xy, velocity, n)

    speed = np.hypot(u[..., 0], u[..., 1])
    width = 0.4 + 1.4*np.nan_to_num(speed/max(np.nanmax(speed), 1e-300))
    return axes.streamplot(*places, u[..., 0], u[..., 1], color="#2a5d8a",
                           linewidth=width, density=1.4, arrowsize=0.8)


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
    name_axes(axes, case)
    axes.set_title(f"t = {float(time):.3g} s")
    if figure is not None:
        figure.tight_layout()
        figure.savefig(file)
        plt.close(figure)


def snapshots(case, times, materials, file, velocity=True, columns=None):
    """Pictures of several times side by side, or in so many columns."""
    span = np.ptp(np.array(case.boundary_edges())[:, :, case.plane()],
                  axis=(0, 1))
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


def discharge(cases, labels, volume, file, unit="m$^2$"):
    """Outgoing volume against time, as the paper's Figure 11."""
    figure, axes = plt.subplots(figsize=(6, 4.2), dpi=130)
    for case, label in zip(cases, labels):
        rows = outflow(case)
        axes.plot(rows[:, 0]*1e3, rows[:, 1], label=label)
    axes.axhline(volume, color="grey", lw=0.8, ls=":")
    axes.set_xlabel("time [ms]")
    axes.set_ylabel(f"granular volume below the fill [{unit}]")
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
    span = np.ptp(case.centres()[:, case.plane()], axis=0)
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
    ends = np.array(case.boundary_edges())[:, :, case.plane()]
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

    def points(axes, time):
        """The points, where there are any and no field is asked for."""
        draw_points(axes, case, time, options["material"],
                    options["size"] or point_size(axes, time),
                    options["dye"])
        draw_legend(axes, case, time, options["material"], options["dye"])

    def draw(axes, time):
        axes.set_aspect("equal")
        axes.set_xlim(*limits[0])
        axes.set_ylim(*limits[1])
        if options["field"]:
            cells = draw_field(axes, case, options["field"], time,
                               options["component"], colours)
            if axes.figure.axes == [axes]:
                axes.figure.colorbar(cells, ax=axes, label=quantity(
                    case, options["field"], time, options["component"]))
        elif find(case.path/time/"lagrangian/materialPoints/dye"):
            points(axes, time)
        draw_walls(axes, case)
        if options["streamlines"]:
            draw_streamlines(axes, case, time)
        for name, value in options["outline"]:
            draw_outline(axes, case, time, name, value)
        if options["arrows"]:
            draw_velocity(axes, case, time, key=True)
        axes.set_xlim(*limits[0])
        axes.set_ylim(*limits[1])
        name_axes(axes, case)
        axes.set_title(f"t = {float(time):.4g} s", loc="left")

    return draw


def field_limits(case, name, component, times):
    """Smallest and largest value over all times, for one scale of colours."""
    low, high = np.inf, -np.inf
    for time in times:
        values = select(case.field(name, time), component)
        low, high = min(low, values.min()), max(high, values.max())
    return low, high


def numbers_of(materials, case, time, refuse):
    """Numbers of materials given by name or number."""
    names = material_names(case, time)
    for each in materials or []:
        if not each.isdigit() and each not in names:
            refuse(f"no material {each}; there are {' '.join(names)}")
    return ([int(m) if m.isdigit() else names.index(m) for m in materials]
            if materials else range(len(MATERIAL)))


def arguments():
    """Parser of the command line."""
    parser = argparse.ArgumentParser(
        prog="foamPicture", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", nargs="?", default=".")
    parser.add_argument("-time", help="time, or latest (the default)")
    parser.add_argument("-field", help="colour the cells by a field of the"
                        " time folder; without it the points are drawn")
    parser.add_argument("-component", help="x, y or z of a vector field, xx to"
                        " zz of a tensor field; its magnitude by default")
    parser.add_argument("-material", nargs="+",
                        help="points of these materials, by name or by their"
                        " number from 0; all by default")
    parser.add_argument("-dye", action="store_true",
                        help="each mark of the dye in a colour of its own")
    parser.add_argument("-size", type=float,
                        help="of a point, in points^2")
    parser.add_argument("-arrows", action="store_true",
                        help="draw the velocity, with its scale")
    parser.add_argument("-streamlines", action="store_true",
                        help="draw lines along the velocity")
    parser.add_argument("-outline", nargs=2, metavar=("FIELD", "VALUE"),
                        action="append", default=[],
                        help="draw the line on which a field, or the magnitude"
                        " of vectors, has a value; FIELD speed: the velocity"
                        " over its largest, speed 0.01 around what stagnates")
    parser.add_argument("-half", action="store_true",
                        help="of a wedge the half that is in the mesh, not"
                        " mirrored at the axis")
    parser.add_argument("-animate", action="store_true",
                        help="a GIF of all times")
    parser.add_argument("-dpi", type=float, default=150,
                        help="points an inch of a PNG; 150 by default")
    parser.add_argument("-o", help="file, picture.png or animation.gif by"
                        " default; .pdf and .svg for print")
    return parser


def times_of(case, asked, refuse):
    """The times that are asked for; or what is wrong with them."""
    if not find(case.path/"constant/polyMesh/faces"):
        refuse(f"no mesh in {case.path}: run blockMesh")
    every = case.times()
    if find(case.path/"0/uniform/written"):
        every.insert(0, "0")
    if not every:
        refuse(f"no times in {case.path} but 0: run the solver, and"
               " reconstructPar where it ran in parallel")
    if asked.time in (None, "latest"):
        asked.time = every[-1]
    if asked.time not in every:
        refuse(f"no time {asked.time}; there are {' '.join(every)}")
    times = every if asked.animate else [asked.time]
    if asked.field:
        check_field(case, asked.field, times[-1], refuse)
    return times


def check_field(case, field, time, refuse):
    """Refuse a field that is not there, with those that are."""
    if not find(case.path/time/field):
        names = sorted({f.name.removesuffix(".gz")
                        for f in (case.path/time).iterdir() if f.is_file()})
        refuse(f"no field {field} at {time}; there are {' '.join(names)}")


def outlines_of(case, asked, times, refuse):
    """The outlines that are asked for, (field, value)."""
    rows = []
    for name, value in asked.outline:
        if name != "speed":
            check_field(case, name, times[-1], refuse)
        try:
            rows.append((name, float(value)))
        except ValueError:
            refuse(f"no number {value}, at which {name} is to be outlined")
    return rows


def main():
    """The command line."""
    parser = arguments()
    asked = parser.parse_args()
    times = times_of(Case(asked.case), asked, parser.error)
    case = opened(asked.case, asked.half)

    colours = None
    if asked.component and not re.fullmatch("[xyz]{1,2}", asked.component):
        parser.error(f"no component {asked.component}; there are x, y, z of"
                     " vectors, xx to zz of tensors")
    if asked.field:
        try:
            colours = field_limits(case, asked.field, asked.component, times)
        except ValueError as problem:
            parser.error(f"field {asked.field} has no {problem}")
    figure, axes, limits = frame_of(case)
    draw = drawing(
        case, {"field": asked.field, "component": asked.component,
               "material": numbers_of(asked.material, case, times[0],
                                      parser.error),
               "size": asked.size, "arrows": asked.arrows,
               "streamlines": asked.streamlines, "dye": asked.dye,
               "outline": outlines_of(case, asked, times, parser.error)},
        limits, colours)

    if asked.animate:
        file = asked.o or "animation.gif"
        animation(case, draw, times, file)
        print(f"{file}: {len(times)} times")
        return
    file = asked.o or "picture.png"
    draw(axes, times[0])
    figure.tight_layout()
    figure.savefig(file, dpi=asked.dpi)
    print(f"{file}: t = {times[0]} s")


if __name__ == "__main__":
    main()
