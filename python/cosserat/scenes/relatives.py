"""Relatives of the silo's corner in simple boxes: where a wall's condition
changes, lids and inlets end, two materials meet a wall, plates are thin.

Each scene is said once, for finite elements and for the flow solver. Units:
viscosity of the (stiffer) medium 1 Pa s, weight 1 N/m3, lid or inlet 1 m/s.
"""

from dataclasses import dataclass
from typing import Callable

import numpy as np

from cosserat.scenes.box import Box
from cosserat.case import parse_list

#: Thickness of the solver's meshes [m]
THICKNESS = 0.1

SLIP, OPEN, STUCK = "slip", "open", (0.0, 0.0)


@dataclass(frozen=True)
class Side:
    """Part of the boundary: where the middles (x, y) of sides satisfy where;
    velocity: SLIP, OPEN (no traction) or a pair; omega: a number or None (no
    couple)."""

    name: str
    where: Callable
    velocity: object
    omega: float = None


@dataclass(frozen=True)
class Medium:
    """eta, etaC [Pa s], R [m], weight [N/m3] of a unit of gravity."""

    eta: float = 1.0
    etaC: float = 0.0
    R: float = 0.0
    weight: float = 0.0


@dataclass(frozen=True)
class Scene:
    """Box between the first and last of the lines x and y, which all lie on
    block boundaries; solid: function (x, y), cells left out; first: function
    (x, y), where the first medium is; corners: where the flow is not smooth.

    quantities: name: ("flux", from, to), volume that passes from the left of
    this way to its right, or ("u" or "omega", point)."""

    x: tuple
    y: tuple
    sides: tuple
    corners: tuple
    quantities: dict
    media: tuple = (Medium(),)
    gravity: tuple = (0.0, 0.0)
    solid: Callable = None
    first: Callable = None
    periodic: bool = False


COSSERAT = Medium(1.0, 1.0, 0.2)


def _heavy(medium, weight=1.0):
    return Medium(medium.eta, medium.etaC, medium.R, weight)


def _held(medium):
    """omega at a wall that sticks: held, where there is any."""
    return 0.0 if medium.etaC else None


def slip_starts(medium):
    """Channel driven by gravity; the lower wall sticks for |x| < 1/2 and slips
    elsewhere."""
    omega = _held(medium)
    return Scene(
        (-1, -0.5, 0.5, 1), (0, 1), (
            Side("slippery", lambda x, y: (y < 0.1) & (np.abs(x) > 0.5), SLIP),
            Side("rough", lambda x, y: (y < 0.1) & (np.abs(x) < 0.5), STUCK,
                 omega),
            Side("top", lambda x, y: y > 0.9, STUCK, omega)),
        ((-0.5, 0), (0.5, 0)), {"flux": ("flux", (0.5, 0), (0.5, 1))},
        (_heavy(medium),), (1.0, 0.0), periodic=True)


def rotation_held(medium):
    """Channel with sticking walls driven by gravity; omega of the lower wall
    is 0 for |x| < 1/2 and free elsewhere."""
    return Scene(
        (-1, -0.5, 0.5, 1), (0, 1), (
            Side("free", lambda x, y: (y < 0.1) & (np.abs(x) > 0.5), STUCK),
            Side("held", lambda x, y: (y < 0.1) & (np.abs(x) < 0.5), STUCK,
                 0.0),
            Side("top", lambda x, y: y > 0.9, STUCK, 0.0)),
        ((-0.5, 0), (0.5, 0)), {"flux": ("flux", (0.5, 0), (0.5, 1))},
        (_heavy(medium),), (1.0, 0.0), periodic=True)


def lid(medium):
    """Cavity whose lid moves, velocity jumps at its ends."""
    omega = _held(medium)
    quantities = {"flux": ("flux", (0.5, 0.5), (0.5, 1)),
                  "u": ("u", (0.5, 0.5))}
    if medium.etaC:
        quantities["omega"] = ("omega", (0.5, 0.5))
    return Scene(
        (0, 0.5, 1), (0, 0.5, 1), (
            Side("walls", lambda x, y: y < 0.999, STUCK, omega),
            Side("lid", lambda x, y: y > 0.999, (1.0, 0.0), omega)),
        ((0, 1), (1, 1)), quantities, (medium,))


def inlet(medium):
    """Plug flow through the middle quarter of the left wall, sticking walls,
    right side open."""
    omega = _held(medium)
    quantities = {"u": ("u", (0.5, 0.5))}
    if medium.etaC:
        quantities["omega"] = ("omega", (0.5, 0.25))
    return Scene(
        (0, 0.5, 1), (0, 0.25, 0.375, 0.5, 0.625, 1), (
            Side("walls", lambda x, y: (x < 0.999) & (
                (x > 0.001) | (np.abs(y - 0.5) > 0.125)), STUCK, omega),
            Side("inlet", lambda x, y: (x < 0.001)
                 & (np.abs(y - 0.5) < 0.125), (1.0, 0.0), omega),
            Side("outlet", lambda x, y: x > 0.999, OPEN)),
        ((0, 0.375), (0, 0.625), (1, 0), (1, 1)), quantities, (medium,))


SOFT = Medium(1e-3)


def column(medium, velocity, block=False):
    """Heavy stiff medium in the left half of a box (or its lower left
    quarter, a block), light one of a thousandth of its viscosity beside it."""
    corners = ((0, 0.5), (0.5, 0), (0.5, 0.5)) if block else (
        (0.5, 0), (0.5, 1))
    return Scene(
        (0, 0.5, 1), (0, 0.5, 1), (
            Side("walls", lambda x, y: x + y < np.inf, velocity),),
        corners, {"flux": ("flux", (0, 0.5), (0.5, 0.5))},
        (_heavy(medium), SOFT), (0.0, -1.0),
        first=lambda x, y: (x < 0.5) & ((y < 0.5) | (not block)))


def plug(medium):
    """Channel with sticking walls driven by gravity, stiff for |x| < 1/2,
    of a thousandth of the viscosity and the same density elsewhere."""
    return Scene(
        (-1, -0.5, 0.5, 1), (0, 1), (
            Side("walls", lambda x, y: x + y < np.inf, STUCK),),
        ((-0.5, 0), (0.5, 0), (-0.5, 1), (0.5, 1)),
        {"flux": ("flux", (0.5, 0), (0.5, 1))},
        (_heavy(medium), _heavy(SOFT)), (1.0, 0.0),
        first=lambda x, y: np.abs(x) < 0.5, periodic=True)


def plates(medium, thickness, velocity):
    """Plate of a thickness in units of the apertures (1, half of each by
    mirror) beside it; weight left of its middle."""
    t = thickness
    omega = _held(medium) if velocity == STUCK else None

    def at_plate(x, y):
        return (x > 0.4) & (x < 1.6) & (y > -0.001) & (y < t + 0.001)

    return Scene(
        (0, 0.5, 1, 1.5, 2), (-1, 0, t, 1), (
            Side("box", lambda x, y: ~at_plate(x, y), SLIP),
            Side("mirrors", lambda x, y: ((x < 0.001) | (x > 1.999)), SLIP,
                 0.0 if medium.etaC else None),
            Side("plate", at_plate, velocity, omega)),
        ((0.5, 0), (0.5, t), (1.5, 0), (1.5, t)),
        {"flux": ("flux", (0, 0), (0.5, 0))}, (_heavy(medium), medium),
        (0.0, -1.0), first=lambda x, y: x < 1,
        solid=lambda x, y: (x > 0.5) & (x < 1.5) & (y > 0) & (y < t))


CLASSICAL = Medium()

SCENES = {
    "slip starts": slip_starts(CLASSICAL),
    "slip starts, Cosserat": slip_starts(COSSERAT),
    "rotation held": rotation_held(COSSERAT),
    "lid": lid(CLASSICAL),
    "lid, Cosserat": lid(COSSERAT),
    "inlet": inlet(CLASSICAL),
    "inlet, Cosserat": inlet(COSSERAT),
    "column, slip": column(CLASSICAL, SLIP),
    "column, no slip": column(CLASSICAL, STUCK),
    "column, slip, Cosserat": column(COSSERAT, SLIP),
    "block, slip": column(CLASSICAL, SLIP, block=True),
    "block, no slip": column(CLASSICAL, STUCK, block=True),
    "plug": plug(CLASSICAL),
    "plate 1/8, slip": plates(CLASSICAL, 1/8, SLIP),
    "plate 1/8, no slip": plates(CLASSICAL, 1/8, STUCK),
    "plate 1/16, slip": plates(CLASSICAL, 1/16, SLIP),
    "plate 1/16, no slip": plates(CLASSICAL, 1/16, STUCK),
    "plate 1/8, slip, Cosserat": plates(COSSERAT, 1/8, SLIP),
    "plate 1/8, no slip, Cosserat": plates(COSSERAT, 1/8, STUCK),
}


class RelativeCase(Box):
    """A scene for the flow solver, cells a unit length."""

    def __init__(self, path, scene, cells, **entries):
        names = ["first", "second"]
        super().__init__(
            path, n=cells, g=(*scene.gravity, 0), cyclic=scene.periodic,
            materials={name: {"eta": m.eta, "etaC": m.etaC, "R": m.R,
                              "rho": m.weight}
                       for name, m in zip(names, scene.media)},
            fractions=scene.first, **entries)
        self.scene = scene
        self.walls = {side.name: _entries(side) for side in scene.sides}

    @staticmethod
    def fits(scene, cells):
        """Are all lines on cell faces?"""
        steps = np.diff(scene.x).tolist() + np.diff(scene.y).tolist()
        return all(abs(s*cells - round(s*cells)) < 1e-9 for s in steps)

    def _blocks(self):
        """Indices of the blocks that are not solid."""
        scene = self.scene
        return [(i, j) for j in range(len(scene.y) - 1)
                for i in range(len(scene.x) - 1)
                if scene.solid is None or not scene.solid(
                    *self._middle(i, i + 1, j, j + 1))]

    def _middle(self, i, k, j, m):
        x, y = self.scene.x, self.scene.y
        return (x[i] + x[k])/2, (y[j] + y[m])/2

    def mesh(self):
        x, y = self.scene.x, self.scene.y
        layer = len(x)*len(y)
        blocks, patches = self._blocks(), {}
        cells = []
        for i, j in blocks:
            a = i + len(x)*j
            quad = [a, a + 1, a + 1 + len(x), a + len(x)]
            n = [round((line[k + 1] - line[k])*self.n)
                 for line, k in ((x, i), (y, j))]
            cells.append(f"hex ({' '.join(map(str, quad))} "
                         f"{' '.join(str(q + layer) for q in quad)}) "
                         f"({n[0]} {n[1]} 1) simpleGrading (1 1 1)")
            for beside, ends, middle in (
                    ((i, j - 1), (0, 1), self._middle(i, i + 1, j, j)),
                    ((i + 1, j), (1, 2), self._middle(i + 1, i + 1, j, j + 1)),
                    ((i, j + 1), (2, 3), self._middle(i, i + 1, j + 1, j + 1)),
                    ((i - 1, j), (3, 0), self._middle(i, i, j, j + 1))):
                if beside not in blocks:
                    p, q = (quad[e] for e in ends)
                    patches.setdefault(self._patch(*middle), []).append(
                        f"({p} {q} {q + layer} {p + layer})")
        text = ""
        for name, faces in patches.items():
            kind = "patch" if self.walls.get(name, "")[2:] else "wall"
            if name in ("left", "right"):
                other = "right" if name == "left" else "left"
                kind = f"cyclic; neighbourPatch {other}"
            text += f"{name} {{ type {kind}; faces ({' '.join(faces)}); }}\n"
        self.walls = {name: entry for name, entry in self.walls.items()
                      if name in patches}
        points = " ".join(f"({a} {b} {c})" for c in (0, THICKNESS)
                          for b in y for a in x)
        self.file("system/blockMeshDict", f"""
scale 1; vertices ({points});
blocks ({' '.join(cells)});
edges (); boundary ( {text} );
defaultPatch {{ name frontAndBack; type empty; }}
""")

    def _patch(self, x, y):
        """The last side that a middle is in, or end of a periodic box."""
        if self.scene.periodic and x in (self.scene.x[0], self.scene.x[-1]):
            return "left" if x == self.scene.x[0] else "right"
        return [side.name for side in self.scene.sides
                if side.where(x, y)][-1]

    def write(self):
        case = super().write()
        path = case.path/"system/controlDict"
        path.write_text(path.read_text().replace("functions\n{", """functions
{
    fluxes { type writeObjects; libs (utilityFunctionObjects);
        objects (phi); writeOption anyWrite; }""", 1))
        return case


def _entries(side):
    """Entries of U, omega and, of an opening, p_rgh."""
    omega = ("type zeroGradient;" if side.omega is None
             else f"type fixedValue; value uniform {side.omega};")
    if side.velocity == SLIP:
        return "type slip;", omega
    if side.velocity == OPEN:
        return ("type zeroGradient;", omega,
                "type fixedValue; value uniform 0;")
    return (f"type fixedValue; value uniform ({side.velocity[0]} "
            f"{side.velocity[1]} 0);", omega)


def measure(case, scene, cells):
    """Quantities of a solved case, by name."""
    return {name: _measure(case, cells, *what)
            for name, what in scene.quantities.items()}


def _measure(case, cells, kind, *where):
    if kind == "flux":
        return line_flux(case, *where)
    d = 1 - np.abs(case.centres()[:, :2] - np.asarray(where[0]))*cells
    weight = np.clip(d, 0, 1).prod(axis=1)
    field = case.field("omega") if kind == "omega" else case.field("U")[:, 0]
    return float(weight @ field/weight.sum())


def line_flux(case, start, end):
    """Conserved volume [m2/s] that passes the inner faces on a straight line,
    from the left of the way from start to end to its right."""
    mesh = case.path/"constant/polyMesh"

    def body(name):
        text = (mesh/name).read_text()
        return text[text.index("// * *"):]

    points = parse_list("nonuniform List<vector> " + body("points"), None)
    text = (case.path/case.times()[-1]/"phi").read_text()
    phi = parse_list(text[text.index("internalField") + 13:], None)
    rows = body("faces").split("\n")
    faces = np.array([row[row.index("(") + 1:row.index(")")].split()
                      for row in rows if row[:2] == "4("][:len(phi)], int)
    corners = points[faces]
    normal = np.cross(corners[:, 2] - corners[:, 0],
                      corners[:, 3] - corners[:, 1])[:, :2]
    start, way = np.asarray(start, float), np.subtract(end, start)
    x, y = (corners.mean(axis=1)[:, :2] - start).T
    along = (x*way[0] + y*way[1])/(way @ way)
    across = np.abs(x*way[1] - y*way[0])
    on = (across < 1e-7) & (along > 0) & (along < 1)
    right = np.sign(normal[:, 0]*way[1] - normal[:, 1]*way[0])
    return float((phi*right)[on].sum()/THICKNESS)
