"""A column that slumps onto a rough floor, its surface followed by points.

Nothing of the solver's scheme is in it: the mesh is of the column alone and is
made anew each step, the air is left out (in the tutorial it has a thousandth
of the column's viscosity), and what comes down onto the floor stays there.

    python3 -m cosserat.finiteElements.slump [SIZE [SMALLEST [STEP]]]
"""

import sys

import numpy as np
from matplotlib.path import Path
from scipy.spatial import Delaunay, cKDTree

from cosserat.analytic import granular_contact
from cosserat.finiteElements.taylorHood import Triangles, solve

#: Half of the column of tutorial columnSlump [m], and its weight [N/m3]
WIDTH, HEIGHT, WEIGHT = 0.5, 0.8, 16000.0


class Column:
    """The column's surface: points from its toe on the floor up to the middle,
    x = 0, of distances size that fall to smallest at the toe."""

    def __init__(self, size, smallest, material):
        self.size, self.smallest, self.material = size, smallest, material
        corners = np.array([[WIDTH, 0], [WIDTH, HEIGHT], [0, HEIGHT]])
        self.surface = corners[:1]
        for a, b in zip(corners, corners[1:]):
            self.surface = np.vstack([self.surface, self._line(a, b)[1:]])

    def _sizes(self, points):
        """Distance of points that there should be at places."""
        toe = np.hypot(*(points - self.surface[0]).T)
        return np.clip(self.smallest + toe/4, self.smallest, self.size)

    def _line(self, a, b):
        """Points from a to b."""
        s = np.linspace(0, 1, 2001)[:, None]
        fine = (1 - s)*a + s*b
        steps = np.hypot(*(b - a))/2000/self._sizes(fine)
        number = np.concatenate([[0], np.cumsum((steps[1:] + steps[:-1])/2)])
        n = max(int(np.ceil(number[-1])), 2)
        return np.stack([np.interp(np.linspace(0, number[-1], n + 1), number,
                                   x) for x in fine.T], -1)

    def _inner(self, rim):
        """Points inside: hexagonal ones of sizes that grow from the toe."""
        region = Path(rim)
        points = rim
        size = self.smallest
        while True:
            rows = np.arange(0, rim[:, 1].max(), size*np.sqrt(0.75))
            x, y = np.meshgrid(np.arange(0, rim[:, 0].max(), size), rows)
            x = x + size/2*(np.arange(len(rows)) % 2)[:, None]
            new = np.stack([x.ravel(), y.ravel()], -1)
            wanted = self._sizes(new)
            new = new[(wanted >= 0.99*size) & (wanted < 1.5*size)]
            new = new[region.contains_points(new)]
            away = cKDTree(points).query(new)[0] > 0.7*self._sizes(new)
            points = np.vstack([points, new[away]])
            if size >= self.size:
                return points
            size = min(1.5*size, self.size)

    def _mesh(self, surface):
        floor = self._line(np.zeros(2), surface[0])
        middle = self._line(surface[-1], np.zeros(2))
        rim = np.vstack([surface, middle[1:], floor[1:-1]])
        points = self._inner(rim)
        corners = Delaunay(points).simplices
        a, b, c = points[corners].transpose(1, 0, 2)
        area = np.cross(b - a, c - a)
        corners[area < 0] = corners[area < 0][:, ::-1]
        inside = Path(rim).contains_points(points[corners].mean(1))
        if abs(1 - np.abs(area[inside]).sum()/2/_area(rim)) > 1e-3:
            raise ValueError("the triangles do not fill the column")
        return Triangles(points, corners[inside & (np.abs(area) > 1e-9)])

    def velocity(self, surface):
        """Velocity of the surface's points, and power [W/m] of the weight."""
        mesh = self._mesh(surface)
        u, power = solve(mesh, self.material, (0, -WEIGHT), [
            (mesh.on_boundary(lambda x, y: x == 0), (0, 2)),
            (mesh.on_boundary(lambda x, y: y == 0), (0, 1, 2))])
        return u[:len(surface)], power

    def step(self, longest):
        """Move the surface by a step of the midpoint scheme; the step [s], in
        which what is nearest to the floor does not fall through it."""
        self._space()
        u, _ = self.velocity(self.surface)
        falling = max(-u[1:6, 1].min(), 1e-9)
        dt = min(longest, 0.5*self.smallest/falling)
        half = self.surface + dt/2*u
        half[1:, 1] = np.maximum(half[1:, 1], 1e-4*self.smallest)
        self.surface = self.surface + dt*self.velocity(half)[0]
        self._touch()
        return dt

    def _touch(self):
        """The last point on the floor is the new toe."""
        low = self.surface[:, 1] <= 1e-3*self.smallest
        self.surface = self.surface[np.argmin(low) - 1:]
        self.surface[0, 1] = 0
        self.surface[-1, 0] = 0

    def _space(self):
        """Add points where they are far apart, take away where they crowd."""
        while True:
            s = self.surface
            middle = (s[1:] + s[:-1])/2
            gaps = np.hypot(*np.diff(s, axis=0).T)/self._sizes(middle)
            widest, closest = gaps.argmax(), gaps.argmin()
            if gaps[widest] > 1.5:
                self.surface = np.insert(s, widest + 1, self._between(widest),
                                         0)
            elif gaps[closest] < 0.4:
                inner = min(max(closest, 1), len(s) - 2)
                self.surface = np.delete(s, inner, 0)
            else:
                return

    def _between(self, i):
        """Place between points i and i + 1, on a cubic where that is near."""
        s = self.surface
        chord = s[i:i + 2].mean(0)
        if 0 < i < len(s) - 2:
            cubic = 9/8*chord - (s[i - 1] + s[i + 2])/16
            near = np.hypot(*(cubic - chord)) < 0.2*np.hypot(*(s[i+1] - s[i]))
            if near and cubic[1] > 0:
                return cubic
        return chord

    def volume(self, beyond=0.0):
        """Area [m2] of the column beyond a plane x."""
        loop = np.vstack([self.surface, [[0, 0]]])
        inside = []
        for a, b in zip(loop, np.roll(loop, -1, 0)):
            if a[0] >= beyond:
                inside.append(a)
            if (a[0] >= beyond) != (b[0] >= beyond):
                inside.append(a + (b - a)*(beyond - a[0])/(b[0] - a[0]))
        return _area(np.array(inside))


def _area(loop):
    x, y = loop.T
    return abs(np.sum(x*np.roll(y, -1) - y*np.roll(x, -1)))/2


def spread(size=0.03, smallest=0.01, step=0.05, end=8.0, R=0.1):
    """Tutorial columnSlump: volume beyond the foot [m2] after a time, and
    share of the whole volume that was lost on the way."""
    eta, etaC, _ = granular_contact(0.4, 6, 3e4, 1e4)
    column = Column(size, smallest, (eta, etaC, 2*etaC*R**2))
    time = 0.0
    while time < end*(1 - 1e-9):
        time += column.step(min(step, end - time))
    return column.volume(WIDTH), 1 - column.volume()/(WIDTH*HEIGHT)


if __name__ == "__main__":
    print(*spread(*map(float, sys.argv[1:])))
