"""Heavy bodies, stiff or soft, in a box of free-slip walls: a block and a
disc, cells of which the sides or the edge may cut.

Of the scenes of cosserat.jumps; see there for units.
"""

import numpy as np

from cosserat import regions
from cosserat.box import Box
from cosserat.references import JUMPS
from cosserat.results import Result, against, at, power

#: Half the side of the block, radius and centre of the disc [m]
HALF, RADIUS, CENTRE = 1/8, 0.15, (-0.05, 0.15)

#: Internal length of Cosserat media [m]
R = 0.05

BLOCK = regions.box((-HALF, -HALF), (HALF, HALF))
DISC = regions.circle(CENTRE, RADIUS)


def block(cells):
    """Fraction of the block."""
    return regions.rectangle(cells, (-HALF, -HALF), (HALF, HALF))


def disc(cells):
    """Fraction of the disc."""
    return regions.disc(cells, CENTRE, RADIUS)


def media(contrast, etaC=None, length=0.0, rho=1.0):
    """Materials of a Box: first is the body; etaC: a pair; internal length
    of both."""
    etaC = etaC or (0.0, 0.0)
    return {name: {"eta": eta, "etaC": c, "R": length, "rho": weight}
            for name, eta, c, weight in (
                ("first", contrast, etaC[0], rho),
                ("second", 1.0, etaC[1], 0.0))}


def box(fraction, cosserat=False):
    """Maker of boxes with a heavy body; fraction: function of the number of
    cells."""
    def make(path, contrast, cells, **entries):
        return Box(path, n=cells, g=(0, -1, 0), fractions=fraction(cells),
                   materials=media(
                       contrast, (contrast, 1.0) if cosserat else None,
                       R if cosserat else 0.0), **entries)
    return make


def measure_block(name):
    """Mean velocity, its spread over the cells that are all block, difference
    of the pressure in it, and its largest deviation there."""
    def measure(case, contrast, cells):
        x, y = case.centres()[:, :2].T
        v, p = case.field("U")[:, 1], case.field("p")
        inner = np.maximum(np.abs(x), np.abs(y)) < HALF - 0.499/cells
        result = {"u": against(
            -power(case)/(2*HALF)**2, JUMPS[name, contrast, "u"].value)}
        spread = np.ptp(v[inner])/np.abs(v[inner].mean())
        reference = JUMPS[name, contrast, "spread"].value
        result["spread"] = Result(spread, spread - reference, reference)
        result["pressure"] = against(
            at(case, p, 0, 0.04, cells) - at(case, p, 0, -0.04, cells),
            JUMPS[name, contrast, "pressure"].value)
        largest = np.abs(p[inner] - p[inner].mean()).max()
        result["pressureMax"] = Result(largest, largest)
        return result
    return measure


def measure_disc(name, cosserat=False):
    """Mean velocity, that of its middle, and omega there."""
    def measure(case, contrast, cells):
        values = {"u": -power(case)/(np.pi*RADIUS**2),
                  "uCentre": at(case, case.field("U")[:, 1], *CENTRE, cells)}
        if cosserat:
            values["omega"] = at(case, case.field("omega"), *CENTRE, cells)
        return {key: against(value, JUMPS[name, contrast, key].value)
                for key, value in values.items()}
    return measure
