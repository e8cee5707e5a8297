"""Reference solutions by a staggered scheme (numpy and scipy): stiff and soft
rectangles whose sides are grid lines, classical and Cosserat.

    python3 -m cosserat.staggered [CELLS]

prints the numbers of the block of cosserat.scenes.jumps on three grids, with their
limit. It shares nothing with the solver, nor with the finite elements, but the
equations.

Velocities are in the middles of the faces that they pass, p in those of the
cells, omega in the corners of the cells, as is the shear. The scheme is that
of the least power: the solution makes

    sum over cells    (2 eta (u,x^2 + v,y^2)) V/2
    + over corners    (A11 g1^2 + 2 A12 g1 g2 + A22 g2^2) V/2
    + over edges      M omega,s^2 V/2
    - power of the force

least among those without divergence, with g1 = u,y + omega, g2 = v,x - omega.
The matrix of a corner is that of its four cells in series: g2 and the stress
that belongs to g1 are the same above and below, g1 and the other beside one
another. Walls hold no velocity along themselves: the traction is 0 there.
"""

import sys
from time import process_time

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.sparse import bmat, coo_matrix, diags
from scipy.sparse.linalg import splu


def graded(points, towards, cells, power=3.0):
    """Lines from the first to the last of the points with the same number of
    cells between any two; distances fall towards some of them."""
    s = np.linspace(0, 1, cells + 1)
    parts = []
    for a, b in zip(points, points[1:]):
        ends = tuple(any(abs(t - c) < 1e-12 for t in towards) for c in (a, b))
        f = {(True, False): s**power, (False, True): 1 - (1 - s)**power,
             (False, False): s,
             (True, True): np.where(s < 0.5, (2*s)**power/2,
                                    1 - (2*(1 - s))**power/2)}[ends]
        parts.append(a + (b - a)*f)
    return np.concatenate([parts[0]] + [part[1:] for part in parts[1:]])


def in_series(first, second, weights, axis):
    """Matrix (A11, A12, A22) of two media side by side, of which strain
    `1 - axis` and stress `axis` are the same; weights: their parts."""
    if axis == 1:
        return in_series(first[::-1], second[::-1], weights, 0)[::-1]
    compliance = sum(w/m[0] for w, m in zip(weights, (first, second)))
    ratio = sum(w*m[1]/m[0] for w, m in zip(weights, (first, second)))
    rest = sum(w*(m[2] - m[1]**2/m[0])
               for w, m in zip(weights, (first, second)))
    return 1/compliance, ratio/compliance, rest + ratio**2/compliance


class Staggered:
    """Flow in the box of the lines x and y.

    eta, etaC [Pa s], M [Pa s m2]: functions of the centres (x, y) of cells;
    force: function (x, y) -> pair [N/m3] of the middles of cells or of faces.
    All walls are of free slip and take no couple; mirror: True, where the
    first of x is a plane of symmetry, which omega vanishes on.
    """

    def __init__(self, x, y, eta, etaC=None, M=None, force=None,
                 mirror=False):
        self.x, self.y = np.asarray(x, float), np.asarray(y, float)
        nx, ny = len(x) - 1, len(y) - 1
        self.xc, self.yc = (self.x[1:] + self.x[:-1])/2, (
            self.y[1:] + self.y[:-1])/2
        self.dx, self.dy = np.diff(self.x), np.diff(self.y)
        #: Distances of the middles, of walls half a cell
        self.hx = np.diff(np.concatenate([[self.x[0]], self.xc,
                                          [self.x[-1]]]))
        self.hy = np.diff(np.concatenate([[self.y[0]], self.yc,
                                          [self.y[-1]]]))
        X, Y = np.meshgrid(self.xc, self.yc, indexing="ij")
        self.eta = eta(X, Y) + 0*X
        self.etaC = etaC(X, Y) + 0*X if etaC else None
        self.M = M(X, Y) + 0*X if M else None
        # Unknowns, with the velocities along walls at both ends
        shapes = [(nx + 1, ny + 2), (nx + 2, ny + 1)]
        if self.etaC is not None:
            shapes.append((nx + 1, ny + 1))
        starts = np.cumsum([0] + [a*b for a, b in shapes])
        self.size = starts[-1]
        self.u, self.v, *rest = (
            start + np.arange(a*b).reshape(a, b)
            for start, (a, b) in zip(starts, shapes))
        self.omega = rest[0] if rest else None
        fixed = np.zeros(self.size, bool)
        fixed[self.u[[0, -1]]] = True
        fixed[self.v[:, [0, -1]]] = True
        if mirror and rest:
            fixed[self.omega[0]] = True
        self._solve(fixed, force)

    def _rows(self, *terms):
        """Sparse rows; terms: (indices, factors), all of one shape."""
        shape = np.broadcast_shapes(*(np.shape(f) for _, f in terms),
                                    terms[0][0].shape)
        n = int(np.prod(shape))
        row = np.arange(n)
        return sum(coo_matrix(
            (np.broadcast_to(f, shape).ravel(), (row, i.ravel())),
            (n, self.size)) for i, f in terms).tocsr()

    def _corners(self):
        """A11, A12, A22 of the corners."""
        c = 0 if self.etaC is None else self.etaC
        a, b = (np.pad(m, 1, mode="edge") for m in (self.eta + c,
                                                    self.eta - c))
        wx = np.diff(self.x, prepend=self.x[0], append=self.x[-1])/2
        wy = np.diff(self.y, prepend=self.y[0], append=self.y[-1])/2
        left = (wx[:-1]/(wx[:-1] + wx[1:]))[:, None]
        lower = (wy[:-1]/(wy[:-1] + wy[1:]))[None]

        def column(i):
            low, high = (tuple(m[i, j] for m in (a, b, a)) for j in (
                slice(None, -1), slice(1, None)))
            return in_series(low, high, (lower, 1 - lower), 0)

        return in_series(column(slice(None, -1)), column(slice(1, None)),
                         (left, 1 - left), 1)

    def _matrix(self):
        """Of the power: size x size."""
        V = np.outer(self.dx, self.dy)
        parts = [
            (self._rows((self.u[1:, 1:-1], 1/self.dx[:, None]),
                        (self.u[:-1, 1:-1], -1/self.dx[:, None])),
             2*self.eta*V),
            (self._rows((self.v[1:-1, 1:], 1/self.dy[None]),
                        (self.v[1:-1, :-1], -1/self.dy[None])),
             2*self.eta*V)]
        A = sum(B.T @ diags(w.ravel()) @ B for B, w in parts)
        g1 = [(self.u[:, 1:], 1/self.hy[None]),
              (self.u[:, :-1], -1/self.hy[None])]
        g2 = [(self.v[1:], 1/self.hx[:, None]),
              (self.v[:-1], -1/self.hx[:, None])]
        if self.omega is not None:
            g1, g2 = g1 + [(self.omega, 1.0)], g2 + [(self.omega, -1.0)]
        g1, g2 = self._rows(*g1), self._rows(*g2)
        V = np.outer(self.hx, self.hy)
        w11, w12, w22 = (diags((w*V).ravel()) for w in self._corners())
        A = A + g1.T @ w11 @ g1 + g2.T @ w22 @ g2
        A = A + g1.T @ w12 @ g2 + g2.T @ w12 @ g1
        if self.omega is not None:
            ends = np.pad(self.M*self.dy, ((0, 0), (1, 1)))
            w = (ends[:, 1:] + ends[:, :-1])/2/self.dx[:, None]
            B = self._rows((self.omega[1:], 1.0), (self.omega[:-1], -1.0))
            A = A + B.T @ diags(w.ravel()) @ B
            ends = np.pad(self.M*self.dx[:, None], ((1, 1), (0, 0)))
            w = (ends[1:] + ends[:-1])/2/self.dy
            B = self._rows((self.omega[:, 1:], 1.0), (self.omega[:, :-1],
                                                      -1.0))
            A = A + B.T @ diags(w.ravel()) @ B
        return A

    def _load(self, force):
        """Force of each velocity: half of what acts in either cell."""
        load = np.zeros(self.size)
        X, Y = np.meshgrid(self.xc, self.yc, indexing="ij")
        fx, fy = (f + 0*X for f in force(X, Y))
        V = np.outer(self.dx, self.dy)
        np.add.at(load, self.u[1:, 1:-1], fx*V/2)
        np.add.at(load, self.u[:-1, 1:-1], fx*V/2)
        np.add.at(load, self.v[1:-1, 1:], fy*V/2)
        np.add.at(load, self.v[1:-1, :-1], fy*V/2)
        return load

    def _solve(self, fixed, force):
        A, self.load = self._matrix(), self._load(force)
        D = self._rows((self.u[1:, 1:-1], self.dy[None]),
                       (self.u[:-1, 1:-1], -self.dy[None]),
                       (self.v[1:-1, 1:], self.dx[:, None]),
                       (self.v[1:-1, :-1], -self.dx[:, None]))
        # p of the first cell is 0
        keep = diags((~fixed).astype(float))
        A = keep @ A @ keep + diags(fixed.astype(float))
        first = diags(np.append(0.0, np.ones(D.shape[0] - 1)))
        pin = diags(np.append(1.0, np.zeros(D.shape[0] - 1)))
        D = first @ D @ keep
        d = 1/np.sqrt(A.diagonal())
        e = 1/np.sqrt((D @ diags(d)).power(2).sum(axis=1).A1 + pin.diagonal())
        scale = diags(np.append(d, e))
        S = (scale @ bmat([[A, -D.T], [-D, pin]]) @ scale).tocsc()
        right = scale @ np.append(np.where(fixed, 0, self.load),
                                  np.zeros(len(e)))
        factors = splu(S)
        z = factors.solve(right)
        for _ in range(3):
            z += factors.solve(right - S @ z)
        z = scale @ z
        self.z = z[:self.size]
        p = z[self.size:].reshape(len(self.dx), len(self.dy))
        V = np.outer(self.dx, self.dy)
        self.p = p - (p*V).sum()/V.sum()

    def power(self):
        """Power of the force [W/m]."""
        return float(self.load @ self.z)


#: Half the side of the block [m], and the internal length of Cosserat media
HALF, R = 1/8, 0.05


def block(cells, contrast, cosserat=False):
    """The block of cosserat.scenes.jumps, the right half of the box: mean velocity
    [m/s], its largest difference over the mean, and difference of pressure
    [Pa] at y = 0.04 and -0.04 on the axis. cells: of each part of a line."""
    x = graded([0, HALF, 0.5], [HALF], cells)
    y = graded([-0.5, -HALF, 0.0, HALF, 0.5], [-HALF, HALF], cells)

    def inside(value, other):
        return lambda x, y: np.where((x < HALF) & (np.abs(y) < HALF), value,
                                     other)

    flow = Staggered(
        x, y, inside(contrast, 1.0),
        inside(contrast, 1.0) if cosserat else None,
        inside(2*contrast*R**2, 2*R**2) if cosserat else None,
        lambda x, y: (0*x, inside(-1.0, 0.0)(x, y)), mirror=True)
    v = flow.z[flow.v[1:-1]][flow.xc < HALF][:, np.abs(y) < HALF + 1e-9]
    u = -flow.power()/(2*HALF**2)
    # On the axis p is even
    a, b = flow.xc[:2]
    axis = (b**2*flow.p[0] - a**2*flow.p[1])/(b**2 - a**2)
    inner = np.abs(flow.yc) < HALF
    p = CubicSpline(flow.yc[inner], axis[inner])
    return {"u": u, "spread": float(np.ptp(v)/abs(u)),
            "pressure": float(p(0.04) - p(-0.04))}


def limit(coarse, middle, fine):
    """Limit of three values on grids of twice the cells each."""
    q = (middle - coarse)/(fine - middle)
    return fine + (fine - middle)/(q - 1)


def main(cells=18):
    """Print the numbers of the block; cells: of a part of the coarsest."""
    for name, cosserat, contrasts in (
            ("block", False, (1e-4, 1e-2, 1e2, 1e3, 1e6)),
            ("block, Cosserat", True, (1e3, 1e6))):
        for contrast in contrasts:
            start = process_time()
            rows = [block(n*cells, contrast, cosserat) for n in (1, 2, 4)]
            for quantity in rows[0]:
                values = [row[quantity] for row in rows]
                print(f"{name}, {contrast:g}, {quantity}:",
                      *(f"{v:.8g}" for v in values), "->",
                      f"{limit(*values):.8g}, {process_time() - start:.1f} s",
                      flush=True)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
