"""Reference numbers: what the model gives where no analytic solution is."""

from dataclasses import dataclass

from cosserat.analytic import AnnularCouette, EccentricCylinders, Material


@dataclass(frozen=True)
class Reference:
    """value in a unit, known to +- uncertainty (in the same unit); source:
    what computed it."""

    value: float
    unit: str
    uncertainty: float
    source: str


@dataclass(frozen=True)
class Silo:
    """The silo at rest in units of the tutorial's aperture, walls of free
    slip or rough (no slip, omega = 0, on the two L-shaped solids).

    alpha: internal length R, none: 0; filled: fill through the slot too, not
    only above it; background: its viscosity; aperture, floor: width and depth
    of the slot.
    """

    alpha: float = 0.0
    filled: bool = False
    background: float = 1.0
    aperture: float = 1.0
    floor: float = 0.25
    rough: bool = False

    #: Shear viscosity [Pa s] and weight [N/m3] of the fill
    ETA = 1000.0
    WEIGHT = 1e7

    @property
    def etaC(self):
        """Cosserat viscosity of the fill [Pa s]."""
        return self.ETA if self.alpha else 0.0

    @property
    def M(self):
        """Bending viscosity of the fill [Pa s m2]."""
        return 2*self.etaC*self.alpha**2


#: Scenes by name; the number is the internal length
SILO_SCENES = {
    "start, 0": Silo(),
    "start, 1/3": Silo(1/3),
    "start, 2/3": Silo(2/3),
    "start, 5/3": Silo(5/3),
    "start, 10/3": Silo(10/3),
    "filled, 0": Silo(filled=True),
    "filled, 1/3": Silo(1/3, filled=True),
    "filled, 2/3": Silo(2/3, filled=True),
    "filled, 10/3": Silo(10/3, filled=True),
    "one viscosity, 0": Silo(background=1000.0),
    "one viscosity, 2/3": Silo(2/3, background=1000.0),
    "narrow, 0": Silo(filled=True, aperture=0.5),
    "narrow, 2/3": Silo(2/3, filled=True, aperture=0.5),
    "thick, 0": Silo(filled=True, floor=0.5),
    "thick, 2/3": Silo(2/3, filled=True, floor=0.5),
    "rough, 0": Silo(rough=True),
    "rough, 2/3": Silo(2/3, rough=True),
    "rough, one viscosity, 0": Silo(rough=True, background=1000.0),
    "rough, one viscosity, 2/3": Silo(2/3, rough=True, background=1000.0),
}

ELEMENTS = ("finite elements of degree 4 and 5, graded into the corners: "
            "cosserat.finiteElements")


def _rates(rows):
    return {name: Reference(value, "m2/s", uncertainty, ELEMENTS)
            for name, value, uncertainty in rows}


#: The same at the start, alpha = 2/3, of a fill that yields at 1e6 Pa, law bingham
#: with etaP = eta, regularisation of Bercovier and Engelman, eps = 10 1/s
SILO_YIELD = Reference(
    6200.0, "m2/s", 3.0, "finite elements of degree 3 and 4, rings down to 1e-40 of"
    " a cell: cosserat.finiteElements.silo, silo_rate(scene, 4, tauY=1e6)")

#: Volume that leaves through the aperture in a time: the limit of ever finer
#: rings. Where the surface of a soft medium ends in a corner of free-slip
#: walls, velocity goes with r^0.012, and rings down to 1e-20 of a cell still
#: lack 0.7 % of the rate at the start (alpha = 2/3)
SILO = _rates([
    ("start, 0", 9953.0, 2.0),
    ("start, 1/3", 7577.0, 2.0),
    ("start, 2/3", 7018.0, 2.0),
    ("start, 5/3", 6686.0, 2.0),
    ("start, 10/3", 6604.0, 2.0),
    ("filled, 0", 8891.0, 4.0),
    ("filled, 1/3", 5905.0, 3.0),
    ("filled, 2/3", 5052.0, 3.0),
    ("filled, 10/3", 4390.0, 3.0),
    ("one viscosity, 0", 2821.3, 0.3),
    ("one viscosity, 2/3", 2412.2, 0.4),
    ("narrow, 0", 2086.0, 1.0),
    ("narrow, 2/3", 1107.2, 0.4),
    ("thick, 0", 8821.0, 4.0),
    ("thick, 2/3", 5082.0, 3.0),
    ("rough, 0", 9540.0, 2.0),
    ("rough, 2/3", 5811.0, 2.0),
    ("rough, one viscosity, 0", 1883.5, 0.3),
    ("rough, one viscosity, 2/3", 1680.9, 0.3),
])


#: That of the round silo at the start, of the whole circle, by internal length
ROUND_SILO = {alpha: Reference(
    value, "m3/s", uncertainty, "finite elements of degree 4, rings down to 1e-100 of"
    " a cell: cosserat.finiteElements.silo, round_rate")
    for alpha, value, uncertainty in ((0, 4172.0, 0.5), (2/3, 2851.2, 0.5))}


#: The same of a fill that yields as that of SILO_YIELD
ROUND_SILO_YIELD = Reference(
    2356.0, "m3/s", 2.0, "finite elements of degree 3 and 4, rings down to 1e-40 of"
    " a cell: cosserat.finiteElements.silo, round_rate(scene, 4, tauY=1e6)")


def _relatives(rows):
    return {(scene, quantity): Reference(
        value, {"flux": "m2/s", "u": "m/s", "omega": "1/s"}[quantity],
        uncertainty, ELEMENTS) for scene, quantity, value, uncertainty in rows}


#: Quantities of the scenes of cosserat.scenes.relatives, by scene and quantity
RELATIVES = _relatives([
    ("slip starts", "flux", 0.107264, 2e-6),
    ("slip starts, Cosserat", "flux", 0.067742, 2e-6),
    ("rotation held", "flux", 0.0558513, 2e-7),
    ("lid", "flux", 0.058951, 2e-6),
    ("lid", "u", -0.205185, 2e-5),
    ("lid, Cosserat", "flux", 0.065186, 2e-6),
    ("lid, Cosserat", "u", -0.234085, 2e-5),
    ("lid, Cosserat", "omega", -0.403766, 2e-6),
    ("inlet", "u", 0.414313, 5e-6),
    ("inlet, Cosserat", "u", 0.432960, 1e-5),
    ("inlet, Cosserat", "omega", -0.295791, 2e-6),
    ("column, slip", "flux", 0.0145580, 2e-7),
    ("column, no slip", "flux", 0.0067312, 4e-7),
    ("column, slip, Cosserat", "flux", 0.0134942, 2e-7),
    ("block, slip", "flux", 0.0155430, 1e-7),
    ("block, no slip", "flux", 0.0085514, 4e-7),
    ("plug", "flux", 0.185286, 2e-6),
    ("plate 1/8, slip", "flux", 0.021401, 2e-6),
    ("plate 1/8, no slip", "flux", 0.0212117, 4e-7),
    ("plate 1/16, slip", "flux", 0.021988, 2e-6),
    ("plate 1/16, no slip", "flux", 0.0223609, 4e-7),
    ("plate 1/8, slip, Cosserat", "flux", 0.017470, 2e-6),
    ("plate 1/8, no slip, Cosserat", "flux", 0.0153465, 5e-7),
])

DEPTH = 0.1

_GRAINS = Material(1000, 1000, 0.2)
_ROUND = "analytic, cosserat.analytic.EccentricCylinders"
_TUTORIALS = "finite elements: cosserat.finiteElements.tutorials"

#: Numbers of the tutorials, by tutorial or "tutorial, variant". Powers are of
#: the meshes as they are, of the depth DEPTH [m]; uncertainties of finite
#: elements are the difference of two meshes, rounded up
TUTORIALS = {
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
    "cavity": Reference(-0.112257, "m2/s", 1e-6, _TUTORIALS),
    "cavity, classical": Reference(
        -0.100076, "m2/s", 1e-6,
        "Sahin, Owens (2003), Int. J. Numer. Meth. Fluids 42, 57"),
    # Power of the weight at the start
    "template": Reference(1132.47, "W", 0.01, _TUTORIALS),
    "columnSlump": Reference(26.8515, "W", 0.001, _TUTORIALS),
    "columnSlump, spread": Reference(
        0.1535, "m2", 0.0005, "finite elements on a mesh that follows the "
        "surface: cosserat.finiteElements.slump"),
    "columnSlump, R 0.5": Reference(25.2293, "W", 0.001, _TUTORIALS),
    "dune": Reference(26.0314, "W", 0.0001, _TUTORIALS),
    "dune, R 0.02": Reference(31.524, "W", 0.002, _TUTORIALS),
    # Mean speed of the disc at the start
    "sinkingInclusion": Reference(2.77508e-3, "m/s", 4e-7, _TUTORIALS),
    "sinkingInclusion, classical": Reference(3.18770e-3, "m/s", 1e-7,
                                             _TUTORIALS),
    # Fall in 90 s of a disc that stays round
    "sinkingInclusion, fall": Reference(0.26458, "m", 1e-3, _TUTORIALS),
    # Mean pressure of the feed beside that of the weight, at the start
    "hopper": Reference(24099.6, "Pa", 0.5, _TUTORIALS),
    # Old material left after 10 s of a fresh one that is as viscous
    "hopper, washout": Reference(0.16636, "m2", 2e-5, _TUTORIALS),
    "hopper, R 0.5": Reference(33271.0, "Pa", 1.0, _TUTORIALS),
    # Flow rate through the aperture at the start
    "silo": SILO["start, 2/3"],
    "silo, classical": SILO["start, 0"],
}
TUTORIALS["schemes"] = TUTORIALS["template"]

_JUMP_UNITS = {"u": "m/s", "uCentre": "m/s", "omega": "1/s", "pressure": "Pa",
               "spread": "1"}


def _jumps(source, rows):
    return {(scene, contrast, quantity): Reference(
        value, _JUMP_UNITS[quantity], uncertainty, source)
        for scene, contrast, quantity, value, uncertainty in rows}


#: Quantities of the bodies of cosserat.scenes.jumps, by scene, contrast and quantity.
#: Of the block the finite elements of cosserat.finiteElements.jumps have
#: the same u to 1e-5; their pressure, and their spread at 1e6, are less exact.
#: At 1e8, where round-off shows in both, u and pressure are those at 1e6,
#: which go with 1/contrast to what they are, and spread is a hundredth
JUMPS = _jumps("staggered scheme, limit of three grids: "
               "cosserat.staggered", [
    ("block", 1e-4, "u", -6.03765e-3, 1e-8),
    ("block", 1e-4, "spread", 1.4504, 1e-4),
    ("block", 1e-4, "pressure", -0.0799902, 1e-7),
    ("block", 1e-2, "u", -5.95934e-3, 2e-8),
    ("block", 1e-2, "spread", 1.4251, 1e-4),
    ("block", 1e-2, "pressure", -0.079043, 3e-6),
    ("block", 0.1, "u", -5.47128e-3, 3e-8),
    ("block", 0.1, "spread", 1.2458, 1e-4),
    ("block", 0.1, "pressure", -0.072091, 4e-6),
    ("block", 10.0, "u", -3.34031e-3, 2e-8),
    ("block", 10.0, "spread", 0.27795, 1e-4),
    ("block", 10.0, "pressure", -1.6621e-3, 1e-6),
    ("block", 1e2, "u", -3.03000e-3, 2e-8),
    ("block", 1e2, "spread", 0.043873, 3e-5),
    ("block", 1e2, "pressure", 0.014394, 1e-5),
    ("block", 1e3, "u", -2.98712e-3, 2e-8),
    ("block", 1e3, "spread", 4.682e-3, 4e-5),
    ("block", 1e3, "pressure", 0.016656, 1e-5),
    ("block", 1e6, "u", -2.98215e-3, 2e-8),
    ("block", 1e6, "spread", 4.717e-6, 4e-8),
    ("block", 1e6, "pressure", 0.016918, 1e-5),
    ("block", 1e8, "u", -2.98215e-3, 3e-8),
    ("block", 1e8, "spread", 4.72e-8, 1e-9),
    ("block", 1e8, "pressure", 0.016918, 1e-5),
    ("block, Cosserat", 1e3, "u", -2.44758e-3, 3e-8),
    ("block, Cosserat", 1e3, "spread", 4.415e-3, 4e-5),
    ("block, Cosserat", 1e3, "pressure", 0.011731, 2e-5),
    ("block, Cosserat", 1e6, "u", -2.44156e-3, 3e-8),
    ("block, Cosserat", 1e6, "spread", 4.446e-6, 4e-8),
    ("block, Cosserat", 1e6, "pressure", 0.011992, 2e-5),
    ("block, Cosserat", 1e8, "u", -2.44156e-3, 3e-8),
    ("block, Cosserat", 1e8, "spread", 4.446e-8, 1e-9),
    ("block, Cosserat", 1e8, "pressure", 0.011992, 2e-5),
]) | _jumps("finite elements: cosserat.finiteElements.jumps", [
    ("disc", 1e-4, "u", -0.00559265, 1e-7),
    ("disc", 1e-4, "uCentre", -0.00816233, 1e-7),
    ("disc", 0.01, "u", -0.00556914, 1e-7),
    ("disc", 0.01, "uCentre", -0.00811358, 1e-7),
    ("disc", 0.1, "u", -0.00537482, 1e-7),
    ("disc", 0.1, "uCentre", -0.00771063, 1e-7),
    ("disc", 10.0, "u", -0.00340352, 1e-7),
    ("disc", 10.0, "uCentre", -0.00363651, 1e-7),
    ("disc", 1e3, "u", -0.00318528, 1e-7),
    ("disc", 1e3, "uCentre", -0.00318784, 1e-7),
    ("disc", 1e5, "u", -0.00318288, 1e-7),
    ("disc", 3e5, "u", -0.00318287, 1e-7),
    ("disc", 1e6, "u", -0.00318286, 1e-7),
    ("disc", 1e6, "uCentre", -0.00318286, 1e-7),
    ("disc", 1e8, "u", -0.00318287, 1e-7),
    ("disc", 1e8, "uCentre", -0.00318287, 1e-7),
    ("disc, Cosserat", 1e-4, "u", -0.00539343, 2e-7),
    ("disc, Cosserat", 1e-4, "uCentre", -0.00824522, 2e-7),
    ("disc, Cosserat", 1e-4, "omega", 8.73385e-4, 2e-7),
    ("disc, Cosserat", 0.01, "u", -0.00535690, 2e-7),
    ("disc, Cosserat", 0.01, "uCentre", -0.00815460, 2e-7),
    ("disc, Cosserat", 0.01, "omega", 8.72727e-4, 2e-7),
    ("disc, Cosserat", 0.1, "u", -0.00508300, 2e-7),
    ("disc, Cosserat", 0.1, "uCentre", -0.00748767, 2e-7),
    ("disc, Cosserat", 0.1, "omega", 8.67230e-4, 2e-7),
    ("disc, Cosserat", 10.0, "u", -0.00289750, 2e-7),
    ("disc, Cosserat", 10.0, "uCentre", -0.00312892, 2e-7),
    ("disc, Cosserat", 10.0, "omega", 7.75662e-4, 3e-7),
    ("disc, Cosserat", 1e3, "u", -0.00256666, 2e-7),
    ("disc, Cosserat", 1e3, "uCentre", -0.00256933, 2e-7),
    ("disc, Cosserat", 1e3, "omega", 7.53117e-4, 3e-7),
    ("disc, Cosserat", 1e6, "u", -0.00256271, 2e-7),
    ("disc, Cosserat", 1e6, "uCentre", -0.00256272, 2e-7),
    ("disc, Cosserat", 1e6, "omega", 7.52826e-4, 3e-7),
    ("disc, Cosserat", 1e8, "u", -0.00256272, 2e-7),
    ("disc, Cosserat", 1e8, "uCentre", -0.00256272, 2e-7),
    ("disc, Cosserat", 1e8, "omega", 7.5279e-4, 4e-7),
])
