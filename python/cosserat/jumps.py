"""Stiff against soft: scenes with a jump of the viscosities, on cell faces or
through cells, each one solve at rest.

Units: 1 m (the box |x|, |y| < 1/2), 1 Pa s, 1 N/m3. `contrast` is the ratio of
the viscosities of the body (of the upper layer, the right half) to those of
the rest, which are 1. Fractions of cut cells are exact areas; with `points` a
cell holds a lattice of so many instead.

    python3 -m cosserat.jumps SCENE CONTRAST CELLS [MEAN]

prints the quantities of a scene.
"""

import shutil
import sys
from dataclasses import dataclass
from typing import Callable

import numpy as np

from cosserat.analytic import Layers, Material, SolCx
from cosserat.box import Box, add_points
from cosserat.case import residuals
from cosserat.references import JUMPS

SLIP, FREE = "type slip;", "type zeroGradient;"
HELD = "type fixedValue; value uniform 0;"

#: Half the side of the block, radius and centre of the disc [m]
HALF, RADIUS, CENTRE = 1/8, 0.15, (-0.05, 0.15)

#: Internal length of the Cosserat media of bodies and of layers [m]
R_BODY, R_LAYER = 0.05, 0.1

#: The interface of `tilted` goes this way; it passes (0, 0.03)
TILT, OFFSET = np.arctan(0.5), 0.03


# Fractions

def below(n, d, normal):
    """Function (x, y): part of a square cell, of n a unit length, where
    normal . (x, y) < d; normal is a unit vector. The distance from the centre
    of points of a square is a sum of two uniform numbers, whose distribution
    this is."""
    a, b = (max(abs(c)/(2*n), 1e-9/n) for c in normal)

    def fraction(x, y):
        t = d - normal[0]*x - normal[1]*y
        square = sum(sign*np.maximum(t + shift, 0)**2 for sign, shift in (
            (1, a + b), (-1, a - b), (-1, b - a), (1, -a - b)))
        return np.clip(square/(8*a*b), 0, 1)
    return fraction


def _within(n, lower, upper):
    """Function of coordinates: part of a cell's width between two lines, as
    exact as the coordinates are."""
    def part(x):
        width = (np.minimum(x + 0.5/n, upper) - np.maximum(x - 0.5/n, lower))
        part = np.clip(n*width, 0, 1)
        return np.where(np.abs(part - np.rint(part)) < 1e-8, np.rint(part),
                        part)
    return part


def _square(n):
    side = _within(n, -HALF, HALF)
    return lambda x, y: side(x)*side(y)


def _disc(n):
    """Its part of cells by 32 x 32 samples."""
    s = (np.arange(32) + 0.5)/32 - 0.5
    X, Y = (shift.ravel()/n for shift in np.meshgrid(s, s))

    def fraction(x, y):
        inside = sum(np.hypot(x + a - CENTRE[0], y + b - CENTRE[1]) < RADIUS
                     for a, b in zip(X, Y))
        return inside/len(X)
    return fraction


# Regions of points, of material `first`

def _polygon(corners):
    return "{ type polygon; material first; points (%s); }" % " ".join(
        f"({x!r} {y!r} 0)" for x, y in corners)


def _box(low, high):
    """low, high: pairs."""
    return ("{ type box; material first; min (%r %r -1); max (%r %r 1); }"
            % (*low, *high))


def _circle(corners=256):
    """A polygon of the disc's area."""
    angle = (np.arange(corners) + 0.5)*2*np.pi/corners
    r = RADIUS*np.sqrt(2*np.pi/corners/np.sin(2*np.pi/corners))
    return _polygon(zip((CENTRE[0] + r*np.cos(angle)).tolist(),
                        (CENTRE[1] + r*np.sin(angle)).tolist()))


# Cases

@dataclass(frozen=True)
class Result:
    """value, and its error: relative to a reference, where there is one."""

    value: float
    error: float
    reference: float = None


def against(value, reference):
    """Result of a plain number."""
    return Result(float(value), float(value/reference - 1), float(reference))


def l2(found, exact, where=True):
    """Result of a field: its error in L2, relative."""
    where = np.broadcast_to(where, found.shape)
    error = float(np.sqrt(((found - exact)[where]**2).sum()
                          / (exact[where]**2).sum()))
    return Result(error, error)


@dataclass(frozen=True)
class Scene:
    """box: function (path, contrast, cells, **entries of Box) -> Box;
    measure: function (case, contrast, cells) -> dict of quantity: Result;
    region: of the points of the first material; points: a cell, where not
    told otherwise (None: fractions); cells, contrasts: what the study runs."""

    box: Callable
    measure: Callable
    region: str
    cells: tuple
    contrasts: tuple
    points: int = None


def media(contrast, etaC=None, R=0.0, rho=1.0):
    """Materials of a Box: first is the body; etaC: a pair."""
    etaC = etaC or (0.0, 0.0)
    return {name: {"eta": eta, "etaC": c, "R": R, "rho": weight}
            for name, eta, c, weight in (
                ("first", contrast, etaC[0], rho),
                ("second", 1.0, etaC[1], 0.0))}


def body(fraction, cosserat=False):
    """Box of a heavy body between free-slip walls; fraction: function of the
    number of cells."""
    def box(path, contrast, cells, **entries):
        return Box(path, n=cells, g=(0, -1, 0), fractions=fraction(cells),
                   materials=media(
                       contrast, (contrast, 1.0) if cosserat else None,
                       R_BODY if cosserat else 0.0), **entries)
    return box


def at(case, field, x, y, cells):
    """Value at a point, bilinear between cell centres."""
    centres = case.centres()
    weight = np.clip(1 - cells*np.abs(centres[:, 0] - x), 0, 1)*np.clip(
        1 - cells*np.abs(centres[:, 1] - y), 0, 1)
    return weight @ field/weight.sum()


def _power(case):
    """Power of the weight and of walls [W per m of depth]."""
    row = case.table("power", "powerBalance.dat")[0]
    return (row[1] + row[2])/0.1


def measure_block(name):
    """Mean velocity, its spread over the cells that are all block, difference
    of the pressure in it, and its largest deviation there."""
    def measure(case, contrast, cells):
        x, y = case.centres()[:, :2].T
        v, p = case.field("U")[:, 1], case.field("p")
        inner = np.maximum(np.abs(x), np.abs(y)) < HALF - 0.499/cells
        result = {"u": against(
            -_power(case)/(2*HALF)**2, JUMPS[name, contrast, "u"].value)}
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
        values = {"u": -_power(case)/(np.pi*RADIUS**2),
                  "uCentre": at(case, case.field("U")[:, 1], *CENTRE, cells)}
        if cosserat:
            values["omega"] = at(case, case.field("omega"), *CENTRE, cells)
        return {key: against(value, JUMPS[name, contrast, key].value)
                for key, value in values.items()}
    return measure


# SolCx

def solCx_box(path, contrast, cells, **entries):
    """Its right half is `first`."""
    right = _within(cells, 0, 1)
    return Box(path, n=cells, force=SolCx((1.0, contrast)).force,
               materials=media(contrast, rho=0),
               fractions=lambda x, y: right(x) + 0*y, **entries)


def measure_solCx(case, contrast, cells):
    """v_rms, and errors of u and p; of p without cells that the jump cuts,
    and further than 0.1 from it."""
    exact = SolCx((1.0, contrast))
    x, y = case.centres()[:, :2].T
    U, p = case.field("U")[:, :2].T, case.field("p")
    whole = np.abs(x) > 0.499/cells
    true = exact.p(x, y)
    return {"v_rms": against(np.sqrt((U**2).sum(axis=0).mean()),
                             exact.v_rms),
            "u": l2(U, exact.u(x, y)),
            "p": l2(p - p.mean(), true, whole),
            "pAway": l2(p - p.mean(), true, np.abs(x) > 0.1)}


# Layers

#: Cells along the layers
ALONG = 4


def layers(contrast):
    """Couette flow of two, the upper one stiff."""
    return Layers([Material(1, 1, R_LAYER),
                   Material(contrast, contrast, R_LAYER)],
                  (-0.5, 0, 0.5), velocity=(-0.5, 0.5))


def layers_box(path, contrast, cells, **entries):
    """Strip of the two layers."""
    upper = _within(cells, 0, 1)
    walls = {side: (f"type fixedValue; value uniform ({u} 0 0);", HELD)
             for side, u in (("bottom", -0.5), ("top", 0.5))}
    return Box(path, n=cells, xmin=0.5 - ALONG/cells, cyclic=True,
               materials=media(contrast, (contrast, 1), R_LAYER, 0),
               walls=walls, fractions=lambda x, y: upper(y) + 0*x, **entries)


def columns(contrast):
    """Channel driven by its weight, |y| < 1/4 of another etaC and M."""
    plain = Material(1, 1, R_LAYER)
    return Layers([plain, Material(1, contrast, R_LAYER), plain],
                  (-0.5, -0.25, 0.25, 0.5), G=1.0)


def columns_box(path, contrast, cells, **entries):
    """Strip of the channel."""
    middle = _within(cells, -0.25, 0.25)
    still = ("type noSlip;", HELD)
    materials = media(1.0, (contrast, 1), R_LAYER)
    materials["second"]["rho"] = 1.0
    return Box(path, n=cells, xmin=0.5 - ALONG/cells, cyclic=True,
               g=(1, 0, 0), materials=materials,
               walls={"bottom": still, "top": still},
               fractions=lambda x, y: middle(y) + 0*x, **entries)


def measure_layers(solution, stiff):
    """Errors of u and omega, and of omega in the layer stiff < y < 1/2."""
    def measure(case, contrast, _cells):
        exact, y = solution(contrast), case.centres()[:, 1]
        omega = case.field("omega")
        return {"u": l2(case.field("U")[:, 0], exact.u(y)),
                "omega": l2(omega, exact.omega(y)),
                "omegaStiff": l2(omega, exact.omega(y),
                                 np.abs(y - stiff[0]) < stiff[1])}
    return measure


def _tilted(contrast):
    """Velocity and rotation of the layers, turned by TILT; and the stream
    function, whose differences are the fluxes through the walls."""
    flow = Layers([Material(1, 1, R_LAYER),
                   Material(contrast, contrast, R_LAYER)],
                  (-1, 0, 1), velocity=(-0.5, 0.5))
    along = np.array([np.cos(TILT), np.sin(TILT)])
    t, w = np.polynomial.legendre.leggauss(24)

    def across(x, y):
        return -np.sin(TILT)*x + np.cos(TILT)*(y - OFFSET)

    def psi(x, y):
        s = np.asarray(across(x, y))[..., None]
        return (flow.u(s*(t + 1)/2)*s*w/2).sum(axis=-1)

    return flow, along, across, psi


def tilted_box(path, contrast, cells, **entries):
    """Layers that no face follows; walls hold the exact velocity and omega.
    What passes a face of a wall is its mean, so that no volume is left."""
    flow, along, across, psi = _tilted(contrast)
    h = 0.5/cells

    def U(x, y):
        u = np.array([c*flow.u(across(x, y)) for c in along])
        left, top = np.abs(np.abs(x) - 0.5) < 1e-6, np.abs(
            np.abs(y) - 0.5) < 1e-6
        u[0] = np.where(left, (psi(x, y + h) - psi(x, y - h))/(2*h), u[0])
        u[1] = np.where(top, -(psi(x + h, y) - psi(x - h, y))/(2*h), u[1])
        return u

    lower = below(cells, np.cos(TILT)*OFFSET,
                  (-np.sin(TILT), np.cos(TILT)))
    return Box(path, n=cells, materials=media(
        contrast, (contrast, 1), R_LAYER, 0), U=U,
        omega=lambda x, y: flow.omega(across(x, y)),
        walls={side: ("exact", "exact") for side in (
            "left", "right", "bottom", "top")},
        fractions=lambda x, y: 1 - lower(x, y), **entries)


def measure_tilted(case, contrast, _cells):
    """Errors of velocity and omega."""
    flow, along, across, _ = _tilted(contrast)
    s = across(*case.centres()[:, :2].T)
    exact, omega = np.outer(along, flow.u(s)), case.field("omega")
    return {"u": l2(case.field("U")[:, :2].T, exact),
            "omega": l2(omega, flow.omega(s)),
            "omegaStiff": l2(omega, flow.omega(s), s > 0)}


#: Cells a side. Of 30, 62, 126 the sides of the block leave a quarter of a
#: cell, of 34, 66, 130 three quarters
FACES, ODD = (16, 32, 64, 128), (31, 63, 127)
CUT, CUT_LESS = (30, 62, 126), (34, 66, 130)
BLOCK = _box((-HALF, -HALF), (HALF, HALF))
RIGHT = _box((0, -1), (1, 1))
UPPER = _box((-1, 0), (1, 1))
_HEIGHT = OFFSET - 2*np.tan(TILT), OFFSET + 2*np.tan(TILT)

DISC = ((0.01, 0.1, 10.0, 1e3, 1e6), 16)

SCENES = {
    "disc": Scene(body(_disc), measure_disc("disc"), _circle(),
                  (32, 64, 128), *DISC),
    "disc, Cosserat": Scene(
        body(_disc, True), measure_disc("disc, Cosserat", True), _circle(),
        (32, 64, 128), *DISC),
    "blockOnFaces": Scene(body(_square), measure_block("block"), BLOCK,
                          FACES, (1e-4, 1e3, 1e6)),
    "blockOnFaces, Cosserat": Scene(
        body(_square, True), measure_block("block, Cosserat"), BLOCK, FACES,
        (1e3, 1e6)),
    "blockThroughCells": Scene(body(_square), measure_block("block"), BLOCK,
                               CUT + CUT_LESS, (1e-4, 1e-2, 1e2, 1e6)),
    "solCx": Scene(solCx_box, measure_solCx, RIGHT, FACES, (1e3, 1e6)),
    "solCxThrough": Scene(solCx_box, measure_solCx, RIGHT, ODD, (1e3, 1e6)),
    "layers": Scene(layers_box, measure_layers(layers, (0.25, 0.25)), UPPER,
                    FACES, (10.0,)),
    "layersThrough": Scene(
        layers_box, measure_layers(layers, (0.25, 0.25)), UPPER,
        (15, *ODD), (10.0,)),
    "columns": Scene(
        columns_box, measure_layers(columns, (0, 0.25)),
        _box((-1, -0.25), (1, 0.25)), FACES, (10.0,)),
    "columnsThrough": Scene(
        columns_box, measure_layers(columns, (0, 0.25)),
        _box((-1, -0.25), (1, 0.25)), CUT, (10.0,)),
    "tilted": Scene(
        tilted_box, measure_tilted,
        _polygon([(-2.0, _HEIGHT[0].item()), (2.0, _HEIGHT[1].item()),
                  (2.0, 2.0), (-2.0, 2.0)]), FACES, (10.0, 1e3)),
}


def prepare(path, name, contrast, cells, mean=None, points=0, **entries):
    """Case of a scene, meshed. mean: entry viscosityAverage (None: left out);
    points: a cell (0: the scene's own way; None: fractions)."""
    scene = SCENES[name]
    points = scene.points if points == 0 else points
    shutil.rmtree(path, ignore_errors=True)
    entries = {"tolerance": 1e-8, "average": mean, **entries}
    case = scene.box(path, contrast, cells, **entries).write()
    if points:
        add_points(case, "{ type all; material second; } " + scene.region,
                   pointsPerCell=points)
        case.substitute("system/controlDict", {"endTime": 1e-9,
                                               "deltaT": 1e-9})
    return case


def balance(case):
    """Integral of the field dissipation over the power supplied, less 1."""
    dissipated = case.field("dissipation") @ case.volumes()
    return float(dissipated/0.1/_power(case) - 1)


def run(path, name, contrast, cells, mean=None, points=0, **entries):
    """One solve: quantities (dict of Result), iterations, balance."""
    case = prepare(path, name, contrast, cells, mean, points, **entries)
    case.run("cosseratPicFoam")
    return {"quantities": SCENES[name].measure(case, contrast, cells),
            "iterations": residuals(case.log())[0][3],
            "balance": balance(case)}, case


def main(name, contrast, cells, mean=None):
    """The command line."""
    found, _ = run(f"jumps-{name}", name, float(contrast), int(cells), mean)
    for quantity, result in found.pop("quantities").items():
        print(f"{quantity}: {result}")
    print(found)


if __name__ == "__main__":
    main(*sys.argv[1:])
