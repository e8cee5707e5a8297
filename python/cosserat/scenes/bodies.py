"""Heavy bodies, stiff or soft, in a box of free-slip walls: a block and a
disc, cells of which the sides or the edge may cut.

Of the scenes of cosserat.scenes.jumps; see there for units.
"""

import numpy as np

from cosserat.scenes import regions
from cosserat.scenes.box import Box
from cosserat.references import JUMPS
from cosserat.results import DEPTH, Result, against, at, power
from cosserat.triangles import nearest_side, write_polygons

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


def _square(x, y):
    return np.maximum(np.abs(x), np.abs(y)) < HALF


def _motion(case, name, contrast, inside):
    """Mean velocity of a block, and its spread over cells."""
    v = case.field("U")[inside, 1]
    spread = np.ptp(v)/np.abs(v.mean())
    reference = JUMPS[name, contrast, "spread"].value
    return {"u": against(-power(case)/(2*HALF)**2,
                         JUMPS[name, contrast, "u"].value),
            "spread": Result(spread, spread - reference, reference)}


def measure_block(name):
    """Mean velocity, its spread over the cells that are all block, difference
    of the pressure in it, and its largest deviation there."""
    def measure(case, contrast, cells):
        x, y = case.centres()[:, :2].T
        p = case.field("p")
        inner = np.maximum(np.abs(x), np.abs(y)) < HALF - 0.499/cells
        difference = (at(case, p, 0, 0.04, cells)
                      - at(case, p, 0, -0.04, cells))
        largest = np.abs(p[inner] - p[inner].mean()).max()
        return {**_motion(case, name, contrast, inner),
                "pressure": against(difference, JUMPS[
                    name, contrast, "pressure"].value),
                "pressureMax": Result(largest)}
    return measure


def wavy(x, y):
    """Moves the points of a mesh, but not off lines of whole eighths."""
    wave = 0.012*np.sin(8*np.pi*x)*np.sin(8*np.pi*y)
    return x + wave, y + wave


def wavy_box(path, contrast, cells, **entries):
    """The block, its sides on faces of cells that are not orthogonal."""
    return Box(path, n=cells, g=(0, -1, 0), materials=media(contrast),
               fractions=_square, warp=wavy, **entries)


class Halves(Box):
    """Box whose squares are cut into two triangles, by turns one way and the
    other."""

    def prisms(self):
        n, step = self.n, self.n + 1
        line = np.linspace(-0.5, 0.5, step)
        flat = np.stack(np.meshgrid(line, line), -1).reshape(-1, 2)
        cells = []
        for j in range(n):
            for i in range(n):
                a = i + step*j
                b, c, d = a + 1, a + 1 + step, a + step
                cells += ([(a, b, c), (a, c, d)] if (i + j) % 2
                          else [(a, b, d), (b, c, d)])
        write_polygons(self.case, flat, cells, nearest_side)


def triangles_box(path, contrast, cells, **entries):
    """The block, its sides on faces of triangles."""
    return Halves(path, n=cells, g=(0, -1, 0), materials=media(contrast),
                  fractions=_square, triangles=True, **entries)


def measure_motion(case, contrast, _cells):
    """Mean velocity and its spread."""
    return _motion(case, "block", contrast,
                   _square(*case.centres()[:, :2].T))


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


class Fitted(Box):
    """The box with a mesh whose faces follow the disc's edge: four blocks of
    n/4 cells along the edge outside of it, four inside, and a square in the
    middle. Where the outer blocks meet, cells are far from orthogonal."""

    def mesh(self):
        centre = np.array(CENTRE)
        corners = np.array([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5],
                            [-0.5, 0.5]])
        ways = corners - centre
        ways /= np.hypot(*ways.T)[:, None]
        rings = [corners, centre + RADIUS*ways, centre + 0.45*RADIUS*ways]
        vertices = " ".join(f"({x!r} {y!r} {z})" for z in (0, 0.1)
                            for ring in rings for x, y in ring.tolist())
        around, out, into = (max(round(part*self.n), 1)
                             for part in (1/4, 0.3, 0.09))

        def block(*quad, cells):
            return (f"hex ({' '.join(str(v) for v in quad)} "
                    f"{' '.join(str(v + 12) for v in quad)}) "
                    f"({cells[0]} {cells[1]} 1) simpleGrading (1 1 1)")

        blocks, arcs = [block(8, 9, 10, 11, cells=(around, around))], []
        for i, k in zip(range(4), (1, 2, 3, 0)):
            blocks += [
                block(i, k, k + 4, i + 4, cells=(around, out)),
                block(i + 4, k + 4, k + 8, i + 8, cells=(around, into))]
            way = ways[i] + ways[k]
            x, y = (centre + RADIUS*way/np.hypot(*way)).tolist()
            arcs += [f"arc {i + 4 + z} {k + 4 + z} ({x!r} {y!r} {z/120})"
                     for z in (0, 12)]
        sides = {"bottom": (0, 1), "right": (1, 2), "top": (2, 3),
                 "left": (3, 0)}
        walls = " ".join(
            f"{side} {{ type wall; faces (({a} {b} {b + 12} {a + 12})); }}"
            for side, (a, b) in sides.items())
        self.file("system/blockMeshDict", f"""
scale 1; vertices ({vertices});
blocks ({' '.join(blocks)});
edges ({' '.join(arcs)}); boundary ({walls});
defaultPatch {{ name frontAndBack; type empty; }}
""")


def _inside(x, y):
    return np.hypot(x - CENTRE[0], y - CENTRE[1]) < RADIUS


def fitted_box(path, contrast, cells, **entries):
    """The disc on a mesh of its own."""
    return Fitted(path, n=cells, g=(0, -1, 0), materials=media(contrast),
                  fractions=_inside, **entries)


def measure_fitted(case, contrast, _cells):
    """Mean velocity of the disc, a polygon here, and the largest difference
    of a cell's velocity from the rigid motion that is nearest."""
    x, y = case.centres()[:, :2].T
    inside = _inside(x, y)
    V, U = case.volumes()[inside], case.field("U")[inside, :2]
    one = np.ones(len(V))
    rows = np.concatenate([np.column_stack([one, 0*one, -y[inside]]),
                           np.column_stack([0*one, one, x[inside]])])
    flat = U.T.ravel()
    rigid = rows @ np.linalg.lstsq(rows, flat, rcond=None)[0]
    miss = np.abs(flat - rigid).max()/np.abs(U[:, 1].mean())
    return {"u": against(-power(case)/(V.sum()/DEPTH),
                         JUMPS["disc", contrast, "u"].value),
            "notRigid": Result(miss, miss)}
