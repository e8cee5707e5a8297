"""Layers and channels of media that yield, periodic and two cells long, of
which exact values are in cosserat.yielding."""

import re

import numpy as np

from cosserat.case import cpu_seconds, fresh_case
from cosserat.scenes.box import SIDES, Box, add_points


def entries(values):
    """Entries of a dictionary; a dict becomes one in it."""
    return " ".join(
        f"{key} {{ {entries(value)} }}" if isinstance(value, dict)
        else f"{key} {value};" for key, value in values.items())


def set_law(case, law, rho=0, **coeffs):
    """Give a case one material with a law."""
    path = case.path/"constant/materialProperties"
    head = path.read_text().split("materials\n")[0]
    path.write_text(
        f"{head}materials\n{{\n    granular {{ rho {rho}; viscosityLaw {law};"
        f" {law}Coeffs {{ {entries(coeffs)} }} }}\n}}\n")


def strip(path, law, coeffs, n, V=0, G=0, omega=0, grading=1, tolerance=1e-8,
          **nonlinear):
    """A layer of unit height between walls at -V/2 and V/2, and a channel
    driven by the force G; omega: of the walls, None where they give no couple;
    grading: largest over smallest cell, in each half; nonlinear: entries of
    that dictionary. Returns the meshed case."""
    case = fresh_case(path, "gravityChannel")
    mesh = case.path/"system/blockMeshDict"
    mesh.write_text(mesh.read_text().replace(
        "($n $n 1) simpleGrading (1 1 1)",
        f"(2 {n} 1) simpleGrading (1 ((0.5 0.5 {grading})"
        f" (0.5 0.5 {1/grading})) 1)"))
    set_law(case, law, rho=1, **coeffs)
    gravity = case.path/"constant/g"
    gravity.write_text(re.sub(r"value.*;", f"value ({G} 0 0);",
                              gravity.read_text()))
    velocity = case.path/"0/U"
    velocity.write_text(velocity.read_text().replace(
        '"(top|bottom)"\n    {\n        type            noSlip;\n    }',
        f"top {{ type fixedValue; value uniform ({V/2} 0 0); }}\n"
        f"    bottom {{ type fixedValue; value uniform ({-V/2} 0 0); }}"))
    rotation = case.path/"0/omega"
    rotation.write_text(rotation.read_text().replace(
        "type            fixedValue;\n        value           uniform 0;",
        "type zeroGradient;" if omega is None
        else f"type fixedValue; value uniform {omega};"))
    solution = case.path/"system/fvSolution"
    solution.write_text(solution.read_text().split("creepingFlow")[0]
                        + f"creepingFlow {{ tolerance {tolerance};"
                        f" nonlinear {{ tolerance {tolerance};"
                        f" {entries(nonlinear)} }} }}\n")
    case.substitute("system/controlDict", {"writePrecision": 16})
    case.run("blockMesh")
    return case


def disc(path, n, law, coeffs, eta=1):
    """A disc of points that yields, with a law, in a viscous medium that is
    stretched: the interface cuts cells. Returns the case."""
    exact = ("exact", "type zeroGradient;")
    fluid = {"eta": eta, "etaC": 0, "R": 0}
    case = Box(path, n=n, materials={"medium": fluid, "disc": fluid},
               walls={side: exact for side in SIDES}, average=None,
               U=lambda x, y: (x, -y), fractions=lambda x, y: 1 + 0*x,
               tolerance=1e-8).write()
    laws = case.path/"constant/materialProperties"
    first = laws.read_text().split("    disc\n")[0]
    laws.write_text(f"{first}    disc {{ rho 0; viscosityLaw {law};"
                    f" {law}Coeffs {{ {entries(coeffs)} }} }}\n}}\n")
    add_points(case, "{ type all; material medium; } { type disc; material"
               " disc; centre (0.013 0.007 0); radius 0.25; }",
               inflow="{ %s }" % " ".join(
                   f"{side} {{ material medium; }}" for side in SIDES))
    return case


def solve(case):
    """Run a case for one solve. Returns the rows of its cells, sorted by y, as
    a dict, and what the log says of steps and costs."""
    log = case.run("cosseratPicFoam").stdout
    centres = case.centres()
    first = centres[:, 0] < centres[:, 0].mean()
    order = np.argsort(centres[first, 1])
    columns = {"y": centres[first, 1][order]}
    for name in ("U", "omega", "sigma", "coupleStress"):
        columns[name] = case.field(name)[first][order]
    volume = case.volumes()[first][order]
    columns["h"] = volume/volume.sum()
    return columns, {**steps(log), "cpu": cpu_seconds(log)}


def wall_stress(case):
    """Shear stress of a layer whose walls move by one against each other."""
    return case.table("power", "powerBalance.dat")[-1][2]/0.1


def steps(log):
    """Nonlinear steps, linear iterations, residuals and lengths of all solves
    in a log."""
    rows = re.findall(
        r"Nonlinear: step \d+, (\w+), residual = (\S+), inner tolerance ="
        r" \S+, No Iterations (\d+), step length = (\S+)", log)
    return {"nonlinear": len(rows),
            "linear": sum(int(row[2]) for row in rows),
            "residuals": [float(row[1]) for row in rows],
            "lengths": [float(row[3]) for row in rows]}
