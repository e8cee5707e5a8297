"""Accuracy against cost: what each setting buys in four scenes, one at a time
and combined, when the classical model will do, and what the presets give in a
scene that did not choose them."""

import re
import shutil
from functools import lru_cache

import numpy as np

from cosserat.analytic import GravityChannel, Material, ShearLayer, err
from cosserat.case import FILES, RunError, cpu_seconds, residuals
from cosserat.picture import outflow
from cosserat.scenes.layers import PAPER, constant_material
from cosserat.scenes.silo import halve, mesh_entries, refine
from cosserat.tradeoff import (
    distance, extrapolate, front, observed_order, override)
from studies.common import HERE, new_case
from studies.speedAccuracyFigures import draw

DEFAULT = {"pointsPerCell": 16, "velocity": "conservativeLinear",
           "integration": "RK2", "average": "cellMean",
           "viscosityAverage": "layered", "tolerance": 1e-6, "maxCo": 0.5,
           "coupling": "extrapolated", "stabilisation": 0,
           "volumeCorrection": "yes", "nVcycles": 2}

#: Where the tutorial of a scene has chosen another
OWN = {"silo": {"viscosityAverage": "arithmetic"}}

#: What each setting is changed to, alone
CHANGES = {
    "pointsPerCell": [1, 4, 9, 36],
    "velocity": ["faceFlux", "cellPoint"],
    "integration": ["Euler", "RK4"],
    "average": ["linearLeastSquares"],
    "viscosityAverage": ["layered", "arithmetic", "geometric", "harmonic"],
    "tolerance": [1e-1, 1e-2, 1e-3, 1e-4, 1e-8, 1e-10],
    "maxCo": [0.1, 0.25, 1, 2, 5],
    "coupling": ["frozen", "midpoint"],
    "stabilisation": [0.5, 1],
    "volumeCorrection": ["no"],
    "nVcycles": [1, 3],
}

#: Of the combined runs: what each setting is drawn from
DRAWN = {"pointsPerCell": [4, 9, 16, 36], "tolerance": [1e-3, 1e-4, 1e-6],
         "maxCo": [0.25, 0.5, 1, 2], "integration": ["Euler", "RK2", "RK4"],
         "coupling": ["frozen", "extrapolated", "midpoint"],
         "average": ["cellMean", "linearLeastSquares"]}

COMBINED = 8

#: Cells (a side, or a unit of the silo): levels, the default among them, and
#: those of the reference, the finest two levels above at least
CELLS = {"shearLayer": ([32, 64, 96, 128], 64, None),
         "inclusionSolve": ([32, 48, 64, 96], 64, (64, 128, 256)),
         "inclusionFall": ([16, 24, 32, 48], 32, (32, 64, 128)),
         "silo": ([2, 3, 4, 6], 4, (8, 16))}

#: Settings of the silo on a mesh refined into the corners
REFINED = {"pointsPerCell": 9, "maxCo": 1}

#: Ends [s]; the inclusion falls by one radius in the second
END = {"shearLayer": 0.04, "inclusionSolve": 1e-6, "inclusionFall": 60.0,
       "silo": 1.9e-3}

#: Internal lengths of the comparison with the classical model, over the
#: radius of the inclusion or the height of the layer
LENGTHS = [0.003, 0.01, 0.03, 0.1, 0.3, 1, 3, 10]

LAYER = Material(1.0, 1.0, 0.05)


def defaults(scene):
    """Settings of a scene that are not varied."""
    return {**DEFAULT, **OWN.get(scene, {})}


def make(scene, name, cells, half=False):
    """A meshed case of a scene with its default settings. Half a silo is
    behind a mirror; with cells "refined" its mesh is."""
    tutorial = scene if scene in ("shearLayer", "silo") else "sinkingInclusion"
    case = new_case("speedAccuracy", name, tutorial)
    if cells == "refined":
        halve(case)
        refine(case, half=True)
    else:
        case.substitute("system/blockMeshDict", mesh_entries(cells)
                        if scene == "silo" else {"n": cells})
        if half:
            halve(case)
    # Below a point a cell none are added; a quarter is the default
    points = case.path/FILES["points"]
    points.write_text(re.sub(r"minPointsPerCell\s+\d+;", "",
                             points.read_text()))
    if scene == "shearLayer":
        constant_material(case, LAYER)
        case.substitute("system/walls", {"V": 1, "Omega": 0})
    end = END[scene]
    # The first step is cut to what maxCo allows
    case.substitute("system/controlDict", {
        "endTime": end, "deltaT": end,
        "writeInterval": end/2 if scene == "shearLayer" else end})
    with (case.path/FILES["control"]).open("a") as text:
        text.write("\nmaxDeltaT 1e9;\n")
    case.run("blockMesh")
    return case


def blocks(case):
    """Velocity averaged over 8 x 8 blocks of the box."""
    U = case.field("U")[:, :2]
    n = round(len(U)**0.5)
    return U.reshape(8, n//8, 8, n//8, 2).mean(axis=(1, 3))


def measure(scene, case):
    """Results that are compared, and one of them as a plain number: velocity
    in blocks and speed [m/s], fall [m] or outflow [m2] at ten times and at the
    last; of the layer the errors of omega and u, and of the way of its
    points."""
    if scene == "silo":
        rows = outflow(case)
        q = np.interp(END["silo"]*np.arange(1, 11)/10, rows[:, 0], rows[:, 1])
        return q, float(q[-1])
    if scene == "inclusionSolve":
        power = case.table("power", "powerBalance.dat")[0, 1]
        return blocks(case), float(power/(np.pi*0.15**2*0.1))
    if scene == "inclusionFall":
        # Its way by the work of gravity, to where its points are at the end
        t, power = case.table("power", "powerBalance.dat")[:, :2].T
        speed = np.append(power[0], power)
        way = np.append(0, np.cumsum(
            np.diff(t, prepend=0)*(speed[1:] + speed[:-1])/2))
        fall = float(0.65 - case.centroid(1)[1])
        q = np.interp(END[scene]*np.arange(1, 11)/10, np.append(0, t), way)
        return q*fall/q[-1], fall

    n = round(case.n_cells()**0.5)
    y = np.repeat((np.arange(n) + 0.5)/n - 0.5, n)
    exact = ShearLayer(LAYER, 1, V=1, Omega=0)
    errors = (err(exact.omega(y), case.field("omega")),
              err(exact.u(y), case.field("U")[:, 0]))
    early, late = (case.cloud("positions", t)[
        np.argsort(case.cloud("origId", t))] for t in case.times()[-2:])
    way = END[scene]/2*exact.u(early[:, 1])
    miss = late[:, 0] - early[:, 0] - way
    miss -= np.rint(miss)               # periodic along x
    return errors, float(np.sqrt((miss**2).mean()/(way**2).mean()))


@lru_cache(maxsize=None)
def poisson_seconds(scene, cells):
    """Time of a Poisson solve on the mesh of a scene [s]."""
    log = make(scene, f"{scene}-poisson", cells).run(
        "Test-solveCost", "-repeat", 3).stdout
    return float(re.search(r"poissonSeconds (\S+)", log)[1])


def run(scene, cells, **settings):
    """A row without its error, and the results; None where the run failed."""
    settings = {**defaults(scene), **settings}
    case = make(scene, scene, cells)
    override(case, FILES, **{
        key: value for key, value in settings.items()
        if key not in ("viscosityAverage", "volumeCorrection")
        or value != defaults(scene)[key]})
    row = {"scene": scene, "cells": cells, **settings}
    try:
        case.run("cosseratPicFoam")
    except RunError as failure:
        reason = re.search(r"FATAL[^\n]*\n(.*?)\n", str(failure), re.S)
        return {**row, "status": (reason[1].strip() or "failed")
                if reason else "crashed"}, None
    log = case.log()
    cpu = max(cpu_seconds(log), 0.01)
    solves = [r for r in residuals(log) if r[0] == "U"]
    results, value = measure(scene, case)
    row.update({
        "status": "ok", "value": value, "cpu": cpu,
        "poissonUnits": cpu/poisson_seconds(scene, cells),
        "steps": log.count("\nStep "),
        "iterations": sum(r[3] for r in solves),
        "added": max(map(int, re.findall(r"(\d+) added", log)), default=0)})
    return row, results


def design(scene):
    """Settings of the runs of a scene: the default, each changed alone, and
    some combined by chance, the same at each call."""
    levels, default, _ = CELLS[scene]
    yield {"varied": "default", "cells": default}
    for cells in levels:
        if cells != default:
            yield {"varied": "cells", "cells": cells}
    for key, values in CHANGES.items():
        for value in values:
            if value != defaults(scene)[key]:
                yield {"varied": key, "cells": default, key: value}
    draw_from = np.random.default_rng(1)
    for _ in range(COMBINED):
        yield {"varied": "combined", "cells": int(draw_from.choice(levels)), **{
            key: values[draw_from.integers(len(values))]
            for key, values in DRAWN.items()}}


def half_silo(cells, **settings):
    """Outflow of half a silo, as of the whole."""
    case = make("silo", "half", cells, half=True)
    override(case, FILES, **settings)
    case.run("cosseratPicFoam")
    q, _ = measure("silo", case)
    print(f"half a silo, {cells}: {2*q}", flush=True)
    return 2*q


def reference(scene):
    """Results, plain value, and uncertainty of the reference; None for the
    layer, whose errors are those of the analytic solution. Of the silo it is
    the half on the finest mesh, and the largest distance of the others from
    it; else it is extrapolated, or where the steps between the meshes do not
    shrink as those of order one, it is of the finest, and the largest distance
    of the others."""
    cells = CELLS[scene][2]
    if cells is None:
        return None, None, 0.0
    if scene == "silo":
        *others, limit = map(half_silo, cells)
        others.append(half_silo("refined", **REFINED))
        return (limit, float(limit[-1]),
                max(distance(q, limit) for q in others))
    runs = [run(scene, n) for n in cells]
    results = [q for _, q in runs]
    values = [row["value"] for row, _ in runs]
    order = observed_order(*results)
    if order >= 1:
        limit, _, uncertainty = extrapolate(*results)
        value = float(extrapolate(*values)[0])
    else:
        limit, value = results[-1], values[-1]
        uncertainty = max(distance(q, limit) for q in results[:-1])
    print(f"{scene}: order {order:.2f}, uncertain by {uncertainty:.2e}, values"
          f" {values} -> {value:.5g}", flush=True)
    return limit, value, uncertainty


def explore(scene):
    """Rows of a scene."""
    limit, value, uncertainty = reference(scene)
    rows = []
    for settings in design(scene):
        varied = settings.pop("varied")
        row, results = run(scene, **settings)
        if varied == "default":
            plain = results
        row.update({"varied": varied, "error": None,
                    "errorUncertainty": uncertainty,
                    "change": None if results is None
                    else distance(results, plain)})
        if results is not None and limit is None:
            row.update({"error": results[0], "errorU": results[1],
                        "errorPoints": row["value"]})
        elif results is not None:
            row.update({"error": distance(results, limit),
                        "valueError": row["value"]/value - 1})
        rows.append(row)
    for row, on in zip(rows, front(
            [row.get("cpu", np.inf) for row in rows],
            [row["error"] for row in rows])):
        row["onFront"] = on
    return rows


def inclusion_velocity(length, cells=64):
    """Velocity in blocks and processor time with internal lengths of `length`
    radii in both materials; 0 for the classical model."""
    case = make("inclusionSolve", "classical", cells)
    path = case.path/FILES["materials"]
    text = re.sub(r"R  .*;", f"R {0.15*length!r};", path.read_text())
    path.write_text(text if length else re.sub(r"etaC .*;", "etaC 0;", text))
    case.run("cosseratPicFoam")
    return blocks(case), max(cpu_seconds(case.log()), 0.01)


def classical():
    """Rows of the error that the classical model makes in the velocity, by
    internal length over length of the scene."""
    y = np.linspace(-0.5, 0.5, 401)
    plain, cpu = inclusion_velocity(0)
    rows = []
    for length in LENGTHS:
        U, own = inclusion_velocity(length)
        material = Material(1.0, 1.0, length)
        rows.append({
            "scene": "classical", "RoverL": length,
            "errorInclusion": distance(plain, U),
            "errorChannel": float(err(
                (0.25 - y**2)/2, GravityChannel(material, 1, 1).u(y))),
            "errorLayer": float(err(
                2*y, ShearLayer(material, 1, V=1, Omega=0).u(y))),
            "cpu": own, "cpuClassical": cpu})
    return rows


PRESETS = ["fast", "balanced", "accurate"]
PRESET_FILES = {"points": "points", "solution": "flow",
                "control": "control"}


def include_preset(case, preset, cells):
    """The lines by which a case takes a preset; cells a side of balanced."""
    include = f'#include "$COSSERATPIC_ETC/presets/{preset}/'
    for file, name in PRESET_FILES.items():
        with (case.path/FILES[file]).open("a") as text:
            text.write(f'\n{include}{name}"\n')
    path = case.path/FILES["mesh"]
    path.write_text(re.sub(
        r"^n\s+\d+;", f"""{include}mesh"
cells {{ fast {cells//2}; balanced {cells}; accurate {2*cells}; }}
n ${{cells.${{preset}}}};""", path.read_text(), flags=re.M))


def channel(preset, cells=96):
    """Row of the gravity channel with its dye; error is that of omega."""
    case = new_case("speedAccuracy", "channel", "gravityChannel")
    constant_material(case, PAPER, rho=1)
    path = case.path/"constant/g"
    path.write_text(re.sub(r"value.*;", "value (1 0 0);", path.read_text()))
    include_preset(case, preset, cells)
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    n = round(case.n_cells()**0.5)
    y = np.repeat((np.arange(n) + 0.5)/n - 0.5, n)
    exact = GravityChannel(PAPER, 1, 1)
    return {"scene": "gravityChannel", "preset": preset, "cells": n,
            "cpu": max(cpu_seconds(case.log()), 0.01),
            "steps": case.log().count("\nStep "),
            "error": err(exact.omega(y), case.field("omega")),
            "errorU": err(exact.u(y), case.field("U")[:, 0]),
            "errorUncertainty": 0.0}


#: Settings of the reference of the scene that checks the presets
REFERENCE = {"tolerance": 1e-7, "pointsPerCell": 25}

#: The scene that checks the presets: Rayleigh-Taylor, its v_rms up to a time
CHECK_END, CHECK_CELLS = 240.0, 48


def overturn(name, cells, preset=None, **settings):
    """Row of a run of the tutorial and its v_rms at 24 times."""
    case = new_case("speedAccuracy", name, "rayleighTaylor")
    case.substitute("system/blockMeshDict", {"n": cells})
    case.substitute("system/controlDict", {
        "endTime": CHECK_END, "deltaT": CHECK_END, "writeInterval": CHECK_END})
    points = case.path/FILES["points"]
    points.write_text(re.sub(r"minPointsPerCell\s+\d+;", "",
                             points.read_text()))
    with (case.path/FILES["control"]).open("a") as text:
        text.write("\nmaxDeltaT 5;\n")
    override(case, FILES, **settings)
    if preset:
        include_preset(case, preset, cells)
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    rows = case.table("vrms", "volFieldValue.dat")
    speed = np.interp(CHECK_END*np.arange(1, 25)/24, rows[:, 0],
                      np.sqrt(rows[:, 1]))
    return {"scene": "rayleighTaylor", "preset": preset,
            "cells": round(case.n_cells()**0.5),
            "cpu": cpu_seconds(case.log()),
            "steps": case.log().count("\nStep "),
            "value": float(speed.max())}, speed


def check_presets():
    """Rows of the presets in the scenes that did not choose them."""
    rows = [channel(preset) for preset in PRESETS]
    limit, order, uncertainty = extrapolate(*(
        overturn("overturn", n, **REFERENCE)[1] for n in (36, 72, 144)))
    print(f"rayleighTaylor: reference of order {order:.2f}, uncertain by"
          f" {uncertainty:.2e}", flush=True)
    for preset in PRESETS:
        row, speed = overturn("overturn", CHECK_CELLS, preset)
        rows.append({**row, "error": distance(speed, limit),
                     "errorUncertainty": uncertainty})
        print(rows[-1], flush=True)
    return rows


def study():
    """Rows: scene, varied (default, the setting that is not, or combined),
    every setting, error (relative: velocity in 8 x 8 blocks, fall or outflow
    at ten times, omega of the layer), errorUncertainty of the reference,
    change (of the same results from the default's), cpu [s], poissonUnits
    (cpu over that of a Poisson solve on the mesh), onFront, status (ok, or how
    the run failed), value (speed of the inclusion [m/s], fall [m], outflow
    [m2]; of the layer the miss of its points), valueError, steps, iterations,
    added (points). Of the scene classical: RoverL, errorInclusion,
    errorChannel, errorLayer, cpu, cpuClassical. Of gravityChannel and
    rayleighTaylor: preset, cells, cpu, error, errorUncertainty."""
    rows = []
    for scene in CELLS:
        rows += explore(scene)
        print(f"{scene}: {len(rows)} rows", flush=True)
    rows += classical()
    rows += check_presets()
    draw(rows)
    shutil.rmtree(HERE/"runs/speedAccuracy")
    return rows
