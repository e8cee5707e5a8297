"""Numbers of the tutorials that this code did not compute.

Analytic ones are those of analytic.py; `published` says where, and finite
elements are those of validation/finiteElements/tutorials.py.
"""

from dataclasses import dataclass

from cosserat.analytic import AnnularCouette, EccentricCylinders, Material

DEPTH = 0.1     # of the tutorials' meshes [m]


@dataclass(frozen=True)
class Reference:
    """A number, its unit, how well it is known (absolute) and its source."""

    value: float
    unit: str
    uncertainty: float
    source: str


_GRAINS = Material(1000, 1000, 0.2)
_MICHELL = "analytic, Michell's series met at the walls"

#: tutorial, or tutorial and variant: its number
REFERENCES = {
    "annularCouette": Reference(
        DEPTH*AnnularCouette(_GRAINS, (1, 2), (1, 0), (1, 0)).torque,
        "W", 1e-9, "analytic"),
    "eccentricCylinders": Reference(
        DEPTH*EccentricCylinders(1, 2, 0.5, material=_GRAINS).torque(1000),
        "W", 1e-6, _MICHELL),
    "eccentricCylinders, classical": Reference(
        DEPTH*EccentricCylinders(1, 2, 0.5).torque(1000),
        "W", 1e-6, _MICHELL),
    "cavity, classical": Reference(
        -0.100076, "m2/s", 1e-6, "Sahin and Owens (2003)"),
}
