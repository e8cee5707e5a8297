"""Reference numbers: what the model gives where no analytic solution is."""

from dataclasses import dataclass


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
            "validation/finiteElements")


def _rates(rows):
    return {name: Reference(value, "m2/s", uncertainty, ELEMENTS)
            for name, value, uncertainty in rows}


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


def _relatives(rows):
    return {(scene, quantity): Reference(
        value, {"flux": "m2/s", "u": "m/s", "omega": "1/s"}[quantity],
        uncertainty, ELEMENTS) for scene, quantity, value, uncertainty in rows}


#: Quantities of the scenes of cosserat.relatives, by scene and quantity
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
