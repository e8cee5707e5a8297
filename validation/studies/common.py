"""What the studies share: where they run, what they write, the layers of the
paper in its own scaling (h = 1, eta = etaC = 1 Pa s, R = 0.3 m)."""

import json
import re
import shutil
from pathlib import Path

import matplotlib
import numpy as np
matplotlib.use("Agg")

# pylint: disable=wrong-import-position
from cosserat.analytic import GravityChannel, Material, ShearLayer, err
from cosserat.case import TUTORIALS, Case, environment, residuals

NAMES = ["convergence", "significance", "internalLength", "longShear",
         "siloRate", "siloDischarge", "granularContact", "invariants", "manufactured",
         "extremes", "solveCost", "sceneCost", "pointIntegration",
         "rigidShear", "pointDistribution", "pointCoupling", "rayleighTaylor",
         "siloVolume", "pointCost", "freeSurface", "parallel", "speedAccuracy",
         "soak", "mutations", "kills", "errorIndicator", "finiteElements",
         "cornerRelatives", "jumps", "peers"]

HERE = Path(__file__).resolve().parents[1]
RESULTS = HERE/"results"

#: case of the study: what its walls are given
WALLS = {
    "OmegaV": {"V": 1.0, "Omega": 0.0},
    "OmegaSigma": {"sigma": 1.0, "Omega": 0.0},
    "muV": {"V": 1.0, "mu": 0.1},
    "muSigma": {"sigma": 1.0, "mu": 0.1},
}

LABELS = {"OmegaV": r"($\Omega$, V)", "OmegaSigma": r"($\Omega$, $\sigma$)",
          "muV": r"($\mu$, V)", "muSigma": r"($\mu$, $\sigma$)",
          "gravity": "gravity channel"}

environment()


def write(name, rows):
    """Write results/NAME.json."""
    RESULTS.mkdir(exist_ok=True)
    path = RESULTS/f"{name}.json"
    path.write_text(json.dumps({"rows": rows}, indent=1))
    return path


def save(figure, name):
    """Write a figure to results/."""
    RESULTS.mkdir(exist_ok=True)
    figure.tight_layout()
    figure.savefig(RESULTS/f"{name}.png")


def fresh_case(path, tutorial):
    """A fresh copy of a tutorial."""
    shutil.rmtree(path, ignore_errors=True)
    return Case.copy(TUTORIALS/tutorial, path)


def new_case(study, name, tutorial):
    """A fresh copy of a tutorial in runs/STUDY/NAME."""
    return fresh_case(HERE/"runs"/study/name, tutorial)


def cpu_seconds(log):
    """Processor time of a run [s]."""
    return float(re.findall(r"ExecutionTime = (\S+) s", log)[-1])


def add_orders(rows, *keys):
    """Add to each row the order of convergence of its errors from the row
    before, on half its cells: orderU of errU; None in the first."""
    for coarse, fine in zip([None] + rows[:-1], rows):
        for key in keys:
            fine[f"order{key}"] = (
                float(np.log2(coarse[f"err{key}"]/fine[f"err{key}"]))
                if coarse else None)


def cell_ticks(axis, cells, labels=None):
    """Ticks at the numbers of cells of a logarithmic axis, no others."""
    axis.set_xticks(cells, labels or [str(n) for n in cells])
    axis.minorticks_off()


def constant_material(case, material, rho=0):
    """Give a case one material with constant viscosities."""
    path = case.path/"constant/materialProperties"
    head = path.read_text().split("materials\n")[0]
    path.write_text(f"""{head}materials
{{
    granular
    {{
        rho             {rho};
        viscosityLaw    constant;

        constantCoeffs
        {{
            eta         {material.eta!r};
            etaC        {material.etaC!r};
            R           {material.R!r};
            B           infinite;
        }}
    }}
}}
""")


def run_layer(study, name, material, n, walls=None, G=None, tolerance=1e-10,
              grading=None, prepare=None):
    """Run a shear layer (walls) or a gravity channel (G) for one solve;
    prepare: function of the case, called before.

    Returns the case, its analytic solution and a row of errors and costs."""
    case = new_case(study, name, "gravityChannel" if walls is None
                    else "shearLayer")
    case.substitute("system/blockMeshDict", {"n": n})
    case.substitute("system/fvSolution", {"tolerance": tolerance})
    if grading:
        path = case.path/"system/blockMeshDict"
        path.write_text(path.read_text()
                        .replace("($n $n 1)", "(2 $n 1)")
                        .replace("simpleGrading (1 1 1)",
                                 f"simpleGrading (1 {grading} 1)"))
    if walls is None:
        constant_material(case, material, rho=1)
        path = case.path/"constant/g"
        path.write_text(re.sub(r"value.*;", f"value ({G} 0 0);",
                               path.read_text()))
        exact = GravityChannel(material, 1, G)
    else:
        constant_material(case, material)
        (case.path/"constant/materialPointsProperties").unlink()
        case.substitute("system/controlDict", {
            "endTime": 1, "deltaT": 1, "adjustTimeStep": "no",
            "writeInterval": 1})
        case.substitute("system/walls", {
            "velocity": "V" if "V" in walls else "sigma",
            "rotation": "mu" if "mu" in walls else "Omega",
            **{key: repr(value) for key, value in walls.items()}})
        exact = ShearLayer(material, 1, **walls)
    case.substitute("system/controlDict", {"writePrecision": 16})
    if prepare:
        prepare(case)
    case.run("blockMesh")
    case.run("cosseratPicFoam")

    y = case.centres()[:, 1]
    return case, exact, {
        "errU": err(exact.u(y), case.field("U")[:, 0]),
        "errOmega": err(exact.omega(y), case.field("omega")),
        "iterations": residuals(case.log())[0][3],
        "cpu": cpu_seconds(case.log()),
    }


PAPER = Material(1.0, 1.0, 0.3)
