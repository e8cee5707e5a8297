"""Layers between walls and channels with one material, without points, whose
analytic solution is at hand; the layers of the paper in its own scaling
(h = 1, eta = etaC = 1 Pa s, R = 0.3 m)."""

import re

from cosserat.analytic import GravityChannel, Material, ShearLayer, err
from cosserat.case import cpu_seconds, fresh_case, residuals

#: Layer: what its walls are given
WALLS = {
    "OmegaV": {"V": 1.0, "Omega": 0.0},
    "OmegaSigma": {"sigma": 1.0, "Omega": 0.0},
    "muV": {"V": 1.0, "mu": 0.1},
    "muSigma": {"sigma": 1.0, "mu": 0.1},
}


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


def run_layer(path, material, n, walls=None, G=None, tolerance=1e-10,
              grading=None, prepare=None):
    """Run a shear layer (walls) or a gravity channel (G) for one solve;
    prepare: function of the case, called before.

    Returns the case, its analytic solution and a row of errors and costs."""
    case = fresh_case(path, "gravityChannel" if walls is None
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
