"""The flow solve at the extremes of its parameters: a heavy block with its
edges through cells, the silo at rest, the shear layer."""

import matplotlib.pyplot as plt

from cosserat.analytic import Material, ShearLayer, err
from cosserat.scenes.block import DEFAULT, block, measure
from cosserat.scenes.layers import constant_material
from studies.common import HERE, new_case, save


def blocks():
    """Parameters of the rows of the block."""
    for contrast in (1e-8, 1e-6, 1e-3, 1, 1e3, 1e6, 1e8):
        yield {"contrast": contrast}
        yield {"contrast": contrast, "coupling": 0.0, "R": 0.0}
    for coupling in (1e-6, 1e-3, 3.0, 10.0, 30.0, 1e3, 1e6):
        for R in (0.0, 1e-6, 1e-2, 1e-1, 1.0, 1e4):
            yield {"coupling": coupling, "R": R}
    for R in (1e-6, 1e-2, 1.0, 1e4):
        yield {"R": R}
        yield {"R": R, "contrast": 1e6}
    for contrast in (1e-6, 1e6):
        for coupling in (10.0, 1e6):
            yield {"contrast": contrast, "coupling": coupling}
    for B in (1, 10, 1e3, 1e6):
        yield {"B": B}
    yield {"density": 0.999}
    for aspect in (3.0, 10.0, 100.0, 1000.0):
        yield {"aspect": aspect}
        yield {"graded": aspect}
    for shear in (0.5, 1.0, 1.732):
        yield {"shear": shear}
    for n in (32, 128):
        yield {"n": n}
        yield {"n": n, "coupling": 10.0}
        yield {"n": n, "contrast": 1e6}


def silos():
    """The silo at rest: points a cell; and its first steps at large Courant
    numbers."""
    for points in (1, 4, 16, 100):
        case = new_case("extremes", f"silo{points}", "silo")
        case.substitute("constant/materialPointsProperties", {
            "pointsPerCell": points, "minPointsPerCell": min(points, 4)})
        case.substitute("system/controlDict", {
            "endTime": 1e-9, "deltaT": 1e-9, "writeInterval": 1e-9})
        yield case, {"pointsPerCell": points}
    for courant in (0.1, 1, 3, 10):
        case = new_case("extremes", f"courant{courant}", "silo")
        case.substitute("system/controlDict", {
            "endTime": 1e-4, "writeInterval": 1e-4, "maxCo": courant})
        yield case, {"courant": courant}


def layers(rows):
    """Locking: a layer between walls without rotation at etaC >> eta, whose
    exact solution is at hand."""
    for coupling in (1.0, 10.0, 1e3, 1e6):
        for R in (0.0, 1e-6, 1e-2, 1.0):
            material = Material(1.0, coupling, R)
            case = new_case("extremes", f"layer{coupling:g}-{R:g}",
                            "shearLayer")
            constant_material(case, material)
            (case.path/"constant/materialPointsProperties").unlink()
            case.substitute("system/blockMeshDict", {"n": 64})
            case.substitute("system/controlDict", {
                "endTime": 1, "deltaT": 1, "adjustTimeStep": "no",
                "writeInterval": 1})
            case.substitute("system/walls", {
                "velocity": "sigma", "rotation": "Omega", "sigma": "1"})
            case.run("blockMesh")
            row = measure(case, "layer", {"coupling": coupling, "R": R})
            if row["converged"]:
                y = case.centres()[:, 1]
                delta = material.delta
                exact = (y if delta < 1e-4 else ShearLayer(
                    material, 1, sigma=1.0, Omega=0.0).u(y))
                row["errU"] = err(exact, case.field("U")[:, 0])
            rows.append(row)


def draw(rows):
    """Iterations against R, etaC/eta and the contrast."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 4), dpi=130, sharey=True)
    own = [row for row in rows if row["scene"] == "block"
           and row["iterations"] is not None]
    for coupling in (1e-3, 1.0, 3.0, 10.0, 30.0, 1e3, 1e6):
        line = sorted((row["R"], row["iterations"]) for row in own
                      if row["coupling"] == coupling and row["R"] > 0
                      and all(row[key] == DEFAULT[key] for key in DEFAULT
                              if key not in ("R", "coupling")))
        axes[0].semilogx(*zip(*line), "o-", ms=4,
                         label=rf"$\eta^c/\eta$ = {coupling:g}")
    axes[0].set_xlabel("R [m] in a box of 1 m")
    axes[0].set_ylabel("iterations to 1e-6")
    for coupling, label in ((0.0, "classical"), (1.0, "Cosserat")):
        line = sorted((row["contrast"], row["iterations"]) for row in own
                      if row["coupling"] == coupling
                      and all(row[key] == DEFAULT[key] for key in DEFAULT
                              if key not in ("R", "coupling", "contrast"))
                      and (coupling == 0 or row["R"] == DEFAULT["R"]))
        axes[1].semilogx(*zip(*line), "o-", ms=4, label=label)
    axes[1].set_xlabel("viscosity of the block over that around")
    for axis in axes:
        axis.set_ylim(bottom=0)
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize=8, ncol=2, loc=(0.3, 0.12))
    axes[1].legend(fontsize=8, loc="lower center")
    save(figure, "extremes")
    plt.close(figure)


def study():
    """Rows: scene, the parameters that differ from DEFAULT, iterations (to
    1e-6), iterations8 (to 1e-8), converged, error (the program's message),
    residual, change (of U, relative, from 1e-6 to 1e-8), solver, cpu [s];
    errU for the layer."""
    rows = []
    for parameters in blocks():
        given = {**DEFAULT, **parameters}
        case = block(HERE/"runs/extremes/block", **given, tolerance=1e-6)
        rows.append(measure(case, "block", given))
    for case, parameters in silos():
        case.run("blockMesh")
        rows.append(measure(case, "silo", parameters))
    layers(rows)
    draw(rows)
    return rows
