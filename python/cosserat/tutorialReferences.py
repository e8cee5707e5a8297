"""Numbers of the tutorials that this code did not compute.

Powers are of the mesh of 0.1 m depth; all else is what its unit says. Analytic
ones are those of analytic.py; finite elements are those of
validation/finiteElements/tutorials.py, their uncertainty the difference of two
meshes, rounded up.
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
_ROUND = "analytic, cosserat.analytic.EccentricCylinders"
_ELEMENTS = "finite elements, validation/finiteElements/tutorials.py"

#: By tutorial, or "tutorial, variant"
REFERENCES = {
    # Power of the inner cylinder
    "annularCouette": Reference(
        DEPTH*AnnularCouette(_GRAINS, (1, 2), (1, 0), (1, 0)).torque,
        "W", 1e-9, "analytic, cosserat.analytic.AnnularCouette"),
    "eccentricCylinders": Reference(
        DEPTH*EccentricCylinders(1, 2, 0.5, material=_GRAINS).torque(1000),
        "W", 1e-6, _ROUND),
    "eccentricCylinders, classical": Reference(
        DEPTH*EccentricCylinders(1, 2, 0.5).torque(1000),
        "W", 1e-6, _ROUND),
    # Stream function of the vortex, in the middle between the walls
    "cavity": Reference(-0.112257, "m2/s", 1e-6, _ELEMENTS),
    "cavity, classical": Reference(
        -0.100076, "m2/s", 1e-6,
        "Sahin, Owens (2003), Int. J. Numer. Meth. Fluids 42, 57"),
    # Power of the weight at the start
    "template": Reference(1132.47, "W", 0.01, _ELEMENTS),
    "columnSlump": Reference(26.8515, "W", 0.001, _ELEMENTS),
    "columnSlump, R 0.5": Reference(25.2293, "W", 0.001, _ELEMENTS),
    "dune": Reference(26.0314, "W", 0.0001, _ELEMENTS),
    "dune, R 0.02": Reference(31.524, "W", 0.002, _ELEMENTS),
    # Mean speed of the disc at the start
    "sinkingInclusion": Reference(2.77508e-3, "m/s", 4e-7, _ELEMENTS),
    "sinkingInclusion, classical": Reference(3.18770e-3, "m/s", 1e-7,
                                             _ELEMENTS),
    # Fall in 90 s of a disc that stays round
    "sinkingInclusion, fall": Reference(0.26458, "m", 1e-3, _ELEMENTS),
    # Mean pressure of the feed beside that of the weight, at the start
    "hopper": Reference(24099.6, "Pa", 0.5, _ELEMENTS),
    "hopper, R 0.5": Reference(33271.0, "Pa", 1.0, _ELEMENTS),
    # Flow rate through the aperture at the start
    "silo": Reference(7017.0, "m2/s", 2.0, _ELEMENTS),
    "silo, classical": Reference(9953.0, "m2/s", 3.0, _ELEMENTS),
}
REFERENCES["schemes"] = REFERENCES["template"]
