"""A block with friction on a weak layer with a notch, pushed together by its
sides: the benchmark of Spiegelman, May and Wilson (2016).

Lengths in the height of the box, velocities in that of the sides, viscosities
in that of the weak layer; classical media. A cell has one medium, that at its
centre; with 12 cells or a multiple across the notch follows faces, and its
corners are less than a cell. The sides hold what they push: in the benchmark it
slips along them.
"""

import shutil

import numpy as np

from cosserat.case import cpu_seconds
from cosserat.scenes.box import Box
from cosserat.scenes.yielding import entries, steps

#: Height of the box [m], weak viscosity [Pa s], cohesion [Pa], weight [N/m3]
HEIGHT, WEAK, COHESION, WEIGHT = 30e3, 1e21, 1e8, 2700*9.81

YEAR = 365.25*86400

#: Case: velocity of the sides [m/s], viscosity of the block at rest [Pa s]
CASES = {1: (2.5e-3/YEAR, 1e23), 2: (5e-3/YEAR, 1e24),
         3: (12.5e-3/YEAR, 5e24)}

#: Of the notch: half its width and its height, radius of its corners
HALF, RADIUS, LAYER = 1/12, 0.02, 0.25


def weak(x, y):
    """Is a place in the weak layer or in the notch, of which the outer corners
    are rounded, and those at its foot filled?"""
    x, top = np.abs(x), LAYER + HALF
    inside = (y < LAYER) | ((x < HALF) & (y < top))
    cut = ((x > HALF - RADIUS) & (y > top - RADIUS)
           & (np.hypot(x - HALF + RADIUS, y - top + RADIUS) > RADIUS))
    foot = ((x < HALF + RADIUS) & (y < LAYER + RADIUS)
            & (np.hypot(x - HALF - RADIUS, y - LAYER - RADIUS) > RADIUS))
    return (inside & ~cut) | foot


class NotchBox(Box):
    """The box: |x| < 2, 0 < y < 1, 4 n x n cells."""

    def mesh(self):
        self.file("system/blockMeshDict", f"""
scale 1;
vertices ((-2 0 0) (2 0 0) (2 1 0) (-2 1 0)
    (-2 0 0.1) (2 0 0.1) (2 1 0.1) (-2 1 0.1));
blocks (hex (0 1 2 3 4 5 6 7) ({4*self.n} {self.n} 1) simpleGrading (1 1 1));
edges ();
boundary
(
    left {{ type wall; faces ((0 4 7 3)); }}
    right {{ type wall; faces ((1 2 6 5)); }}
    bottom {{ type wall; faces ((0 1 5 4)); }}
    top {{ type patch; faces ((3 7 6 2)); }}
);
defaultPatch {{ name frontAndBack; type empty; }}
""")


def set_media(case, number):
    """Write the media of a case of the benchmark."""
    speed, rest = CASES[number]
    stress = WEAK*speed/HEIGHT
    cohesion, weight = COHESION/stress, WEIGHT*HEIGHT/stress
    block = {"cohesion": cohesion, "angle": 30,
             "leastStress": cohesion*np.cos(np.pi/6), "etaV": rest/WEAK,
             "etaVP": 1, "branch": "harmonic", "etaCRatio": 0, "R": 0,
             "B": "infinite"}
    path = case.path/"constant/materialProperties"
    path.write_text(path.read_text().split("materials\n")[0] + f"""materials
{{
    weak {{ rho {weight}; viscosityLaw constant; constantCoeffs {{ eta 1;
        etaC 0; R 0; B infinite; }} }}
    block {{ rho {weight}; viscosityLaw druckerPrager;
        druckerPragerCoeffs {{ {entries(block)} }} }}
}}
viscosityAverage arithmetic;
""")


def prepare(path, number, n, tolerance=1e-10, **nonlinear):
    """A new case of the benchmark, meshed; nonlinear: entries of that
    dictionary."""
    shutil.rmtree(path, ignore_errors=True)
    moves = {side: (f"type fixedValue; value uniform ({u} 0 0);",
                    "type zeroGradient;")
             for side, u in (("left", 1), ("right", -1))}
    case = NotchBox(
        path, n=n, g=(0, -1, 0), tolerance=tolerance,
        materials={name: {"eta": 1, "etaC": 0, "R": 0}
                   for name in ("weak", "block")},
        fractions=weak,
        walls={**moves, "top": ("type zeroGradient;", "type zeroGradient;",
                                "type prghPressure; p uniform 0;")}).write()
    set_media(case, number)
    return case.override("solution", creepingFlow="{ nonlinear {"
                         f" tolerance {tolerance}; {entries(nonlinear)} }} }}")


def solve(case):
    """Run it. Returns what the log says of steps and costs of its first solve,
    from rest."""
    log = case.run("cosseratPicFoam").stdout
    return {**steps(log.split("\nTime = ")[0]), "cpu": cpu_seconds(log)}
