"""The contact law [14] to [17]: the paper's constants give eta = etaC, and a
layer run from them is the one run from the viscosities."""

import numpy as np

from cosserat.analytic import Material, granular_contact
from cosserat.scenes.layers import constant_material
from studies.common import new_case


def run(name, material=None):
    """U and omega of the shear layer tutorial, from the contact law or from
    viscosities."""
    case = new_case("granularContact", name, "shearLayer")
    (case.path/"constant/materialPointsProperties").unlink()
    case.substitute("system/controlDict", {
        "endTime": 1, "deltaT": 1, "adjustTimeStep": "no", "writeInterval": 1,
        "writePrecision": 16})
    case.substitute("system/fvSolution", {"tolerance": 1e-12})
    if material:
        constant_material(case, material)
    case.run("blockMesh")
    case.run("cosseratPicFoam")
    return case.field("U")[:, 0], case.field("omega")


def study():
    """Rows: eta, etaC, B (Pa s), ratio etaC/eta, differenceU and
    differenceOmega (relative, of the two runs)."""
    eta, etaC, B = granular_contact(0, 4, 1e11, 1e11)
    contact = run("contact")
    viscosities = run("viscosities", Material(eta, etaC, 0.3))
    differences = [float(np.abs(a - b).max()/np.abs(b).max())
                   for a, b in zip(contact, viscosities)]
    return [{"eta": eta, "etaC": etaC, "B": B, "ratio": etaC/eta,
             "differenceU": differences[0], "differenceOmega": differences[1]}]
