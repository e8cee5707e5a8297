"""The tutorials at their start by finite elements: the numbers of
cosserat.references that nobody has published.

    python3 -m cosserat.finiteElements.tutorials [NAME ...]

solves each scene on two meshes and prints number and difference. SI units;
powers, as all else here, per metre along z.
"""

import sys
from time import process_time

import numpy as np

from cosserat.analytic import granular_contact
from cosserat.case import TUTORIALS
from cosserat.references import SILO_SCENES
from cosserat.finiteElements.flow import Flow, Wall
from cosserat.finiteElements.mesh import Mesh, between, lines
from cosserat.finiteElements.silo import silo_rate

NEAR = 1e-6


def at(x=None, y=None):
    """Sides on a line x or y."""
    return lambda X, Y: np.abs((X - x) if y is None else (Y - y)) < NEAR


def either(*places):
    """Sides on any of the places."""
    return lambda x, y: np.any([place(x, y) for place in places], axis=0)


def rest(*places):
    """Rough wall: no velocity, no rotation."""
    return Wall(either(*places), u=(0, 0), omega=0)


def slip(*places):
    """Smooth wall: no traction along it, no couple."""
    return Wall(either(*places), normal=0)


def mirror(place):
    """Plane of symmetry, where omega is odd."""
    return Wall(place, normal=0, omega=0)


def two_materials(mesh, k, inside, first, second, force, walls):
    """Flow of materials (eta, etaC, R): first where inside(x, y) is true, on
    which alone the force acts [N/m3]."""
    def pick(value):
        return lambda x, y: np.where(inside(x, y), *value)

    eta, etaC, R = zip(first, second)
    M = [2*c*r**2 for c, r in zip(etaC, R)]
    return Flow(mesh, k, pick(eta), pick(etaC), pick(M), walls=walls,
                force=tuple(pick((f, 0.0)) for f in force))


AIR = (10.0, 0.0, 0.0)


def block(fine, grains=(1000.0, 1000.0, 0.1), fallen=0.0):
    """Tutorials template and schemes: power [W/m] of the block's weight;
    fallen: how far [m] it has as it is. The plane of symmetry of schemes is
    one in air, which has no omega."""
    size = 0.05 if fine else 0.1
    low, high = 0.4 - fallen, 0.8 - fallen
    mesh = Mesh.tensor(lines([0, 0.2, 0.6, 1], size),
                       lines([0, low, high, 1], size))
    mesh.grade([(x, y) for x in (0.2, 0.6) for y in (low, high)], 1e-4)

    def inside(x, y):
        return (np.abs(x - 0.4) < 0.2) & (low < y) & (y < high)

    return two_materials(
        mesh, 4 if fine else 3, inside, grains, AIR, (0, -16000.0),
        [slip(at(x=0), at(x=1), at(y=1)), rest(at(y=0))]).power()


def column(fine, R=0.1):
    """Tutorial columnSlump: power [W/m] of the column's weight, of the half
    that is computed."""
    size = 0.1 if fine else 0.2
    mesh = Mesh.tensor(lines([0, 0.5, 2], size), lines([0, 0.8, 1], size))
    mesh.grade([(0.5, 0), (0.5, 0.8)], 1e-4)
    eta, etaC, _ = granular_contact(0.4, 6, 3e4, 1e4)
    return two_materials(
        mesh, 4 if fine else 3, lambda x, y: (x < 0.5) & (y < 0.8),
        (eta, etaC, R), AIR, (0, -16000.0),
        [slip(at(x=2), at(y=1)), mirror(at(x=0)), rest(at(y=0))]).power()


def dune_surface():
    """Corners x, y of the dune's surface, from the tutorial's file."""
    file = TUTORIALS/"dune/constant/triSurface/dune.obj"
    rows = np.array([line.split()[1:] for line in
                     file.read_text().splitlines()
                     if line.startswith("v ")], float)
    return rows[(rows[:, 1] > 0) & (rows[:, 2] > 0), :2].T


def dune(fine, grains=(5000.0, 5000.0, 0.1)):
    """Tutorial dune: power [W/m] of the dune's weight, 20 degrees off the
    vertical, in one period. Every corner of the surface is one of the mesh."""
    x, y = dune_surface()
    s = np.unique(np.concatenate([[0, 2], x[(x > 0) & (x < 2)]]))

    def curve(height):
        return lambda s: (s, height(s))

    floor, top = curve(lambda s: 0*s), curve(lambda s: 1 + 0*s)
    surface = curve(lambda s: np.interp(s, x, y))
    t = np.array([0, 0.1, 0.3, 0.6, 0.85, 1])
    mesh = Mesh([(s, t, between(floor, surface)),
                 (s, 1 - t[::-1], between(surface, top))], periodic=(2, 0))
    slope = np.deg2rad(20)
    return two_materials(
        mesh, 4 if fine else 3, lambda X, Y: np.interp(X, x, y) > Y, grains,
        AIR, (16000*np.sin(slope), -16000*np.cos(slope)),
        [slip(at(y=1)), rest(at(y=0))]).power()


#: Disc of the sinking inclusion: centre at the start, and radius [m]
CENTRE, RADIUS = (0.45, 0.65), 0.15
BOX = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])


def disc_mesh(n, centre):
    """Box around a disc whose edge the cells follow: four blocks outside,
    four inside, and a square in the middle."""
    centre = np.array(centre)

    def straight(a, b):
        """From a to b, at equal angles around the centre."""
        ends = [np.arctan2(*(p - centre)[::-1]) for p in (a, b)]
        ends[1] += 2*np.pi*(ends[1] < ends[0])
        across = np.array([b[1] - a[1], a[0] - b[0]])

        def place(s):
            angle = ends[0] + s*(ends[1] - ends[0])
            way = np.array([np.cos(angle), np.sin(angle)])
            r = ((a - centre) @ across)/np.tensordot(across, way, 1)
            return tuple(c + r*w for c, w in zip(centre, way))
        return place

    def onto_circle(curve):
        """The place on the circle in the direction of that on a curve."""
        def place(s):
            x, y = (p - c for p, c in zip(curve(s), centre))
            r = np.hypot(x, y)/RADIUS
            return centre[0] + x/r, centre[1] + y/r
        return place

    def chord(a, b):
        return lambda s: tuple((1 - s)*p + s*q for p, q in zip(a, b))

    core = [centre + 0.45*RADIUS*(p - centre)/np.hypot(*(p - centre))
            for p in BOX]
    s = np.linspace(0, 1, n + 1)
    towards_edge = np.append(1 - 0.5**np.arange(n), 1)
    blocks = [(s, s, between(chord(core[0], core[1]),
                             chord(core[3], core[2])))]
    for i in range(4):
        side = straight(BOX[i - 1], BOX[i])
        edge = onto_circle(side)
        blocks += [(s, towards_edge, between(side, edge)),
                   (s, s**2, between(edge, chord(core[i - 1], core[i])))]
    return Mesh(blocks)


def disc_flow(fine, matrix=(1.0, 1.0, 0.03), inclusion=(500.0, 500.0, 0.08),
              centre=CENTRE):
    """Flow of tutorial sinkingInclusion, the disc around a centre."""
    x, y = centre
    return two_materials(
        disc_mesh(6 if fine else 4, centre), 4 if fine else 3,
        lambda X, Y: np.hypot(X - x, Y - y) < RADIUS, inclusion, matrix,
        (0, -1.0), [slip(at(x=0), at(x=1), at(y=0), at(y=1))])


def disc(fine, **materials):
    """Tutorial sinkingInclusion: mean speed [m/s] of the disc, that is the
    power of its weight of 1 N/m3 over its area."""
    return disc_flow(fine, **materials).power()/(np.pi*RADIUS**2)


def disc_fall(fine, time=90.0):
    """Tutorial sinkingInclusion: fall [m] of the disc in a time, if it stays
    round (it is 500 times as viscous as the matrix: its centre is 0.14 %
    faster than its mean): Runge and Kutta's scheme of fourth order."""
    steps = 6 if fine else 3
    place, dt = np.array(CENTRE), time/steps

    def velocity(centre):
        flow = disc_flow(False, centre=tuple(centre))
        return np.array([flow.at(*centre)[0],
                         -flow.power()/(np.pi*RADIUS**2)])

    for _ in range(steps):
        k = [velocity(place)]
        for part in (0.5, 0.5, 1):
            k.append(velocity(place + part*dt*k[-1]))
        place = place + dt/6*(k[0] + 2*k[1] + 2*k[2] + k[3])
    return CENTRE[1] - place[1]


def cavity(fine, eta=1000.0, etaC=1000.0, R=0.1):
    """Tutorial cavity: least stream function [m2/s] in the middle between
    the walls, int_0^y u dy down to where u = 0."""
    x = lines([0, 0.5, 1], 0.125)
    mesh = Mesh.tensor(x, x)
    mesh.grade([(x, y) for x in (0, 1) for y in (0, 1)],
               1e-6 if fine else 1e-3)
    everywhere = either(at(x=0), at(x=1), at(y=0), at(y=1))
    flow = Flow(mesh, 4 if fine else 3, eta, etaC, 2*etaC*R**2, walls=[
        Wall(at(y=1), u=(1, 0)), Wall(either(at(x=0), at(x=1), at(y=0)),
                                      u=(0, 0)), Wall(everywhere, omega=0)])
    low, high = 0.6, 0.95
    for _ in range(40):
        y = (low + high)/2
        low, high = (y, high) if flow.at(0.5, y)[0] < 0 else (low, y)
    # Between the rows of cells u is a polynomial
    rows = np.append(x[x < y - NEAR], y)
    points, weights = np.polynomial.legendre.leggauss(4)
    return sum((b - a)/2*w*flow.at(0.5, (a + b + (b - a)*p)/2)[0]
               for a, b in zip(rows, rows[1:])
               for p, w in zip(points, weights))


def hopper_edge(y):
    """Half-width [m] of the hopper at a height."""
    return 0.15 + 0.5*np.clip(y - 0.2, 0, 0.7)


def hopper_flow(fine, etaC=1000.0, R=0.05):
    """Flow of tutorial hopper, full of old material, fed with 0.1 m2/s. One
    half, with a plane of symmetry."""
    s = lines([0, 1], 0.2 if fine else 0.34)

    def widths(ya, yb, a, b):
        return between(lambda s: (a*s, ya + 0*s), lambda s: (b*s, yb + 0*s))

    mesh = Mesh([(s, lines([0, 1], 0.34), widths(0, 0.2, 0.15, 0.15)),
                 (s, lines([0, 1], 0.17), widths(0.2, 0.9, 0.15, 0.5)),
                 (s, lines([0, 1], 0.34), widths(0.9, 1.4, 0.5, 0.5))])
    mesh.grade([(0.15, 0.2), (0.5, 0.9)], 1e-6)

    def wall(x, y):
        return (np.abs(x - hopper_edge(y)) < NEAR) & (y > NEAR) & (y < 0.9)

    return Flow(mesh, 4 if fine else 3, 1000.0, etaC, 2*etaC*R**2, walls=[
        mirror(at(x=0)), slip(lambda x, y: (x > 0.5 - NEAR) & (y > 0.9)),
        Wall(at(y=1.4), u=(0, -0.1)), rest(wall)])


def hopper(fine, etaC=1000.0, R=0.05):
    """Tutorial hopper: mean pressure above that of the weight [Pa] by which
    the feed drives 0.1 m2/s through it, from the power dissipated."""
    return hopper_flow(fine, etaC, R).dissipation()/0.05


def washout(fine, end=10.0):
    """Tutorial hopper with a fresh material that is as viscous as the old one,
    so that the flow is steady: old material left [m2] after a time, by the
    times in which what enters at many places is through (Runge and Kutta's
    scheme of fourth order)."""
    flow = hopper_flow(fine)
    n, dt = (400, 0.05) if fine else (100, 0.1)

    def inside(p):
        y = np.clip(p[:, 1], 1e-9, 1.4)
        return np.stack([np.clip(p[:, 0], 0, hopper_edge(y)*(1 - 1e-9)), y],
                        -1)

    def velocity(p):
        cells, xi = flow.find_all(inside(p))
        return np.einsum("pn,pnd->pd", flow.shape.values(xi),
                         flow.u[flow.nodes[cells]])

    # Ever denser places towards the wall
    share = (np.arange(n) + 0.5)/n
    x, width = 0.5*(1 - (1 - share)**2), (1 - share)/n
    p = np.stack([x, np.full(n, 1.4)], -1)
    through = np.full(n, end)
    for step in range(round(end/dt)):
        on = np.flatnonzero(p[:, 1] > 0)
        before = p[on]
        k = [velocity(before)]
        for part in (0.5, 0.5, 1):
            k.append(velocity(before + part*dt*k[-1]))
        p[on] = before + dt/6*(k[0] + 2*k[1] + 2*k[2] + k[3])
        gone = p[on, 1] <= 0
        fall = before[gone, 1]/(before[gone, 1] - p[on[gone], 1])
        through[on[gone]] = dt*(step + fall)
    return 1.015 - 2*0.1*np.sum(width*through)


def silo(fine):
    """Tutorial silo: flow rate [m2/s] through the aperture at the start."""
    return silo_rate(SILO_SCENES["start, 2/3"], 4 if fine else 3,
                     contact=1e-100)


def overturn_flow(fine):
    """Tutorial rayleighTaylor at the start; the cells follow the interface."""
    width = 0.9142
    s = np.linspace(0, width, 9)

    def level(height, wave=0.0):
        return lambda s: (s, height + wave*np.cos(np.pi*s/width))

    surface = level(0.2, 0.02)
    mesh = Mesh([(s, lines([0, 1], 0.34), between(level(0), surface)),
                 (s, lines([0, 1], 0.17), between(surface, level(1)))])
    return two_materials(
        mesh, 4 if fine else 3, lambda x, y: y > surface(x)[1],
        (1.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0, -1.0),
        [slip(at(x=0), at(x=width)), rest(at(y=0), at(y=1))])


def overturn(fine):
    """Tutorial rayleighTaylor: power [W/m] of the weight at the start."""
    return overturn_flow(fine).power()


SCENES = {"template": block, "columnSlump": column, "dune": dune,
          "sinkingInclusion": disc, "fall": disc_fall, "cavity": cavity,
          "hopper": hopper, "washout": washout,
          "silo": silo, "rayleighTaylor": overturn}


def main(names):
    """Print the numbers of the scenes, and how far two meshes differ."""
    for name in names or SCENES:
        start = process_time()
        coarse, fine = (SCENES[name](fine) for fine in (False, True))
        print(f"{name}: {fine:.8g}, coarse mesh {coarse/fine - 1:+.1e},"
              f" {process_time() - start:.1f} s", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
