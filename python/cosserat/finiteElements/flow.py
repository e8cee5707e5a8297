"""Creeping flow of a Cosserat medium in the plane, or around an axis, by finite
elements."""

from dataclasses import dataclass
from typing import Callable

import numpy as np
from scipy.sparse import bmat, bsr_matrix, coo_matrix, diags
from scipy.sparse.linalg import splu

from cosserat.finiteElements.shapes import Lagrange, gauss, monomials

#: Two sides whose normals differ by more than this make a corner [rad]
CORNER = 0.3


@dataclass(frozen=True)
class Wall:
    """What holds at the sides of the boundary whose middles (x, y) satisfy
    where. Values are numbers or functions of (x, y).

    u: velocity, a pair [m/s]; normal: velocity along the outer normal, alone
    (0: free slip); omega [1/s]; traction: a pair [Pa]; couple [Pa m]. What is
    not given is free: no traction, no couple. At a node of two walls the later
    one's values hold; two free-slip walls that meet in a corner hold both
    components.
    """

    where: Callable
    u: tuple = None
    normal: object = None
    omega: object = None
    traction: tuple = None
    couple: object = None


def _value(given, x, y):
    """Values of a number or function, or of a pair of them."""
    if isinstance(given, (tuple, list)):
        return np.stack([_value(part, x, y) for part in given], -1)
    value = given(x, y) if callable(given) else given
    if isinstance(value, tuple):
        return np.stack(np.broadcast_arrays(*value), -1)
    return np.broadcast_to(np.asarray(value, float), np.shape(x))


def strains(gradients, values, radius=None):
    """u,x; v,y; u,y + v,x; s; omega,x; omega,y of each unknown (u, v, omega)
    of a cell: (cells, points, 6, unknowns). With the distances from an axis
    x = 0 also u/x and omega/x."""
    rows = 6 if radius is None else 8
    E = np.zeros(gradients.shape[:2] + (rows, gradients.shape[2], 3))
    x, y = gradients[..., 0], gradients[..., 1]
    E[:, :, 0, :, 0] = x
    E[:, :, 1, :, 1] = y
    E[:, :, 2, :, 0] = y
    E[:, :, 2, :, 1] = x
    E[:, :, 3, :, 0] = 0.5*y
    E[:, :, 3, :, 1] = -0.5*x
    E[:, :, 3, :, 2] = values
    E[:, :, 4, :, 2] = x
    E[:, :, 5, :, 2] = y
    if radius is not None:
        E[:, :, 6, :, 0] = E[:, :, 7, :, 2] = values/radius[..., None]
    return E.reshape(E.shape[:3] + (-1,))


class Flow:
    """Solution of the balances of momentum, moment and mass.

    mesh: Mesh; degree k: Q_k for u and omega, complete polynomials of degree
    k - 1 for p, discontinuous. eta, etaC [Pa s], M [Pa s m2]: numbers, or
    functions of the centres (x, y) of the cells; force, a pair [N/m3]: the
    same; smooth: function (x, y) for a force that varies in the cells. walls:
    list of Wall. omega is not a number where no cell has etaC or M. In a
    closed box p is known up to a constant. axial: around the axis x = 0, of
    which a wall has normal 0 and omega 0; what is an integral is then that of a
    radian, and omega about the direction that goes from x to y.

    Of all u', omega', p' it satisfies

        int 2 eta D:D' + 4 etaC s s' + M grad omega . grad omega'
        - p div u' - p' div u = int force . u' + walls' tractions and couples

    with D = sym grad u, s = omega - (v,x - u,y)/2; around an axis u/x is one
    of D's and omega/x one of grad omega's components.
    """

    def __init__(self, mesh, degree=3, eta=1.0, etaC=0.0, M=0.0,
                 force=(0.0, 0.0), walls=(), smooth=None, axial=False):
        self.mesh, self.degree, self.walls = mesh, degree, walls
        self.axial = axial
        self.shape = Lagrange(degree)
        self.nodes, self.n_nodes = mesh.nodes(degree)
        self.places = mesh.positions(self.shape.nodes)
        self.relative = mesh.positions(self.shape.nodes, relative=True)
        #: x, y of the nodes
        self.xy = np.empty((self.n_nodes, 2))
        self.xy[self.nodes] = self.places
        centres = tuple(mesh.centres.T)
        self.eta, self.etaC, self.M = (
            _value(given, *centres) for given in (eta, etaC, M))
        self.force = _value(force, *centres)
        self.smooth = smooth
        self._assemble()
        self._constrain()
        self._solve()

    # Assembly

    def _geometry(self, xi):
        """Gradients of the shape functions and the Jacobian's determinant at
        points of the square, (cells, points, nodes, 2), (cells, points)."""
        g = self.shape.gradients(xi)
        J = np.einsum("qna,cnd->cqad", g, self.relative)
        det = J[..., 0, 0]*J[..., 1, 1] - J[..., 0, 1]*J[..., 1, 0]
        if det.min() <= 0:
            raise ValueError("a cell is turned inside out")
        return np.einsum("cqda,qna->cqnd", np.linalg.inv(J), g), det

    def _pressures(self, xi):
        """Polynomials of p at points of the square, (cells, points, terms)."""
        middle = np.zeros((1, 2))
        J = np.einsum("qna,cnd->cad", self.shape.gradients(middle),
                      self.relative)
        x = np.einsum("qn,cnd->cqd", self.shape.values(xi)
                      - self.shape.values(middle), self.relative)
        return monomials(np.einsum("cda,cqd->cqa", np.linalg.inv(J), x),
                         self.degree - 1)

    def _integrals(self):
        """Points of integration, shape functions there, strains and weights."""
        xi, weights = gauss(self.degree + 2)
        grads, det = self._geometry(xi)
        values = self.shape.values(xi)
        if not self.axial:
            return xi, values, strains(grads, values), det*weights
        radius = np.einsum("qn,cn->cq", values, self.places[..., 0])
        return (xi, values, strains(grads, values, radius),
                det*weights*radius)

    def _moduli(self, eta, etaC, M):
        """What the strains are multiplied by, (cells, strains)."""
        rows = [2*eta, 2*eta, eta, 4*etaC, M, M]
        return np.stack(rows + [2*eta, M]*self.axial, -1)

    def _assemble(self):
        xi, values, E, volume = self._integrals()
        cells, terms = len(E), self.degree*(self.degree + 1)//2
        moduli = self._moduli(self.eta, self.etaC, self.M)
        flat = E.reshape(cells, -1, E.shape[-1])
        weighted = (E*(volume[:, :, None]*moduli[:, None])[..., None]
                    ).reshape(flat.shape)
        A = np.matmul(flat.transpose(0, 2, 1), weighted)
        divergence = E[:, :, [0, 1] + [6]*self.axial].sum(axis=2)
        divergence *= volume[..., None]
        B = -np.matmul(self._pressures(xi).transpose(0, 2, 1), divergence)

        dofs = (3*self.nodes[:, :, None] + np.arange(3)).reshape(cells, -1)
        pressures = np.arange(cells*terms).reshape(cells, terms)
        size = 3*self.n_nodes
        self.A = _sparse(A, dofs, dofs, (size, size))
        self.B = _sparse(B, pressures, dofs, (cells*terms, size))
        self.rows = np.zeros(size)
        load = np.broadcast_to(self.force[:, None], volume.shape + (2,))
        if self.smooth is not None:
            load = load + _value(self.smooth, *np.moveaxis(
                np.einsum("qn,cnd->cqd", values, self.places), -1, 0))
        for i in range(2):
            np.add.at(self.rows, 3*self.nodes + i, np.einsum(
                "qn,cq->cn", values, volume*load[..., i]))

    # Sides

    def _side(self, cell, side):
        """Nodes, positions of points along a side, shape functions there,
        and the outer normal times the weights (length, or area of a
        radian)."""
        t, w = np.polynomial.legendre.leggauss(self.degree + 2)
        local = self.shape.sides[side]
        values = self.shape._line(t)
        slope = self.shape._line(t, True) @ self.relative[cell, local]
        sign = 1 if side in (0, 1) else -1
        normal = sign*np.stack([slope[:, 1], -slope[:, 0]], -1)
        places = values @ self.places[cell, local]
        if self.axial:
            w = w*places[:, 0]
        return self.nodes[cell, local], places, values, normal*w[:, None]

    def _constrain(self):
        """Loads of walls, fixed unknowns, and rotation of the velocities of
        nodes on slanted free-slip walls to normal and tangent."""
        size = 3*self.n_nodes
        fixed, given = np.zeros(size, bool), np.zeros(size)
        self.frames = np.tile(np.eye(2), (self.n_nodes, 1, 1))
        normals, speeds, full = {}, {}, {}
        enclosed = set()
        for wall in self.walls:
            for cell, side in zip(*self.mesh.boundary(wall.where)):
                nodes, places, values, normal = self._side(cell, side)
                x, y = self.xy[nodes].T
                length = np.hypot(*normal.T)
                if wall.traction is not None:
                    loads = (_value(wall.traction, *places.T)
                             * length[:, None])
                    for i in range(2):
                        np.add.at(self.rows, 3*nodes + i,
                                  values.T @ loads[:, i])
                if wall.couple is not None:
                    np.add.at(self.rows, 3*nodes + 2, values.T @ (
                        _value(wall.couple, *places.T)*length))
                if wall.omega is not None:
                    fixed[3*nodes + 2] = True
                    given[3*nodes + 2] = _value(wall.omega, x, y)
                if wall.u is not None:
                    full.update(zip(nodes, _value(wall.u, x, y)))
                    enclosed.add((cell, side))
                elif wall.normal is not None:
                    enclosed.add((cell, side))
                    n = self._nodal_normals(cell, side)
                    for node, vector, speed in zip(
                            nodes, n, _value(wall.normal, x, y)):
                        normals.setdefault(node, []).append(vector)
                        speeds.setdefault(node, []).append(speed)
        for node, vectors in normals.items():
            if node not in full:
                self._slip(node, np.array(vectors), np.array(speeds[node]),
                           fixed, given)
        for node, u in full.items():
            fixed[[3*node, 3*node + 1]] = True
            given[[3*node, 3*node + 1]] = u
        active = np.zeros(self.n_nodes, bool)
        active[self.nodes[(self.etaC > 0) | (self.M > 0)]] = True
        self.idle = ~active
        fixed[2::3] |= self.idle
        given[2::3][self.idle] = 0
        self.fixed, self.given = fixed, given
        self.closed = len(enclosed) == len(self.mesh.boundary()[0])

    def _nodal_normals(self, cell, side):
        """Outer unit normals at the nodes of a side."""
        local = self.shape.sides[side]
        slope = (self.shape._line(self.shape.points, True)
                 @ self.relative[cell, local])
        normal = np.stack([slope[:, 1], -slope[:, 0]], -1)
        normal *= 1 if side in (0, 1) else -1
        return normal/np.hypot(*normal.T)[:, None]

    def _slip(self, node, vectors, speeds, fixed, given):
        """One normal fixes its component, those of a corner both."""
        first = vectors[0]
        angle = np.abs(np.arctan2(
            first[0]*vectors[:, 1] - first[1]*vectors[:, 0], vectors @ first))
        if angle.max() > CORNER:
            fixed[[3*node, 3*node + 1]] = True
            given[[3*node, 3*node + 1]] = np.linalg.lstsq(
                vectors, speeds, rcond=None)[0]
            return
        n = vectors.mean(axis=0)
        n /= np.hypot(*n)
        i = int(abs(n[1]) > abs(n[0]))
        if abs(n[1 - i]) < 1e-12:
            fixed[3*node + i], given[3*node + i] = True, speeds[0]*n[i]
        else:
            self.frames[node] = [[n[0], -n[1]], [n[1], n[0]]]
            fixed[3*node], given[3*node] = True, speeds[0]

    # Solution

    def _solve(self):
        n = self.n_nodes
        blocks = np.tile(np.eye(3), (n, 1, 1))
        blocks[:, :2, :2] = self.frames
        i = np.arange(3*n).reshape(n, 3)
        T = _sparse(blocks, i, i, (3*n, 3*n))
        A, B = T.T @ self.A @ T, self.B @ T
        right = np.concatenate([T.T @ self.rows - A @ self.given,
                                -B @ self.given])
        fixed = np.concatenate([self.fixed, np.zeros(B.shape[0], bool)])
        fixed[3*n] = self.closed
        right[fixed] = 0
        d = 1/np.sqrt(A.diagonal(), where=~self.fixed, out=np.ones(3*n))
        e = 1/np.sqrt((B @ diags(d*~self.fixed)).power(2).sum(axis=1).A1)
        scale = np.concatenate([d, e])
        keep = diags(scale*~fixed)
        S = (keep @ bmat([[A, B.T], [B, None]], "csr") @ keep
             + diags(fixed.astype(float))).tocsr()
        x = self._condensed(S, scale*right)
        self.x = T @ (scale*x + np.concatenate([self.given, 0*e]))[:3*n]
        self.p = (scale*x)[3*n:]
        #: Force and couple of the walls on the medium, by node
        self.reactions = (self.A @ self.x + self.B.T @ self.p
                          - self.rows).reshape(n, 3)

    def _condensed(self, S, right):
        """Solution of S x = right by way of its Schur complement: the inner
        nodes of a cell and its pressures but the mean see no other cell."""
        cells, step = len(self.nodes), self.degree + 1
        inner = self.nodes.reshape(-1, step, step)[:, 1:-1, 1:-1]
        terms = self.B.shape[0]//cells
        inside = np.concatenate([
            (3*inner.reshape(cells, -1, 1) + np.arange(3)).reshape(cells, -1),
            3*self.n_nodes + terms*np.arange(cells)[:, None]
            + np.arange(1, terms)], axis=1)
        m, inside = inside.shape[1], inside.ravel()
        outside = np.setdiff1d(np.arange(len(right)), inside)
        ii = S[inside][:, inside].tocoo()
        blocks = np.zeros((cells, m, m))
        blocks[ii.row//m, ii.row % m, ii.col % m] = ii.data
        inverse = bsr_matrix((np.linalg.inv(blocks), np.arange(cells),
                              np.arange(cells + 1))).tocsr()
        io, oi = S[inside][:, outside], S[outside][:, inside]
        factors = splu((S[outside][:, outside] - oi @ (inverse @ io)).tocsc())

        def solve(r):
            x = np.empty_like(r)
            x[outside] = factors.solve(
                r[outside] - oi @ (inverse @ r[inside]))
            x[inside] = inverse @ (r[inside] - io @ x[outside])
            return x

        x = solve(right)
        for _ in range(2):
            x += solve(right - S @ x)
        return x

    # Results

    @property
    def u(self):
        """Velocity of the nodes [m/s], (nodes, 2)."""
        return self.x.reshape(-1, 3)[:, :2]

    @property
    def omega(self):
        """Microrotation of the nodes [1/s]."""
        return np.where(self.idle, np.nan, self.x[2::3])

    def flux(self, start, end):
        """Volume that passes the straight line of sides from start to end in
        a time, from the left of it to the right [m2/s; of a radian m3/s]."""
        start, end = np.asarray(start, float), np.asarray(end, float)
        way = end - start
        length = np.hypot(*way)
        x, y = np.moveaxis(self.mesh.middles - start, -1, 0)
        along = (x*way[0] + y*way[1])/length**2
        across = (x*way[1] - y*way[0])/length**2
        with np.errstate(invalid="ignore"):
            on = (np.abs(across) < 1e-9) & (along > 0) & (along < 1)
        edge, _ = self.mesh.sides()
        cells, sides = np.nonzero(on)
        _, first = np.unique(edge[cells, sides], return_index=True)
        total = 0.0
        for cell, side in zip(cells[first], sides[first]):
            nodes, _, values, normal = self._side(cell, side)
            out = np.sum((values @ self.u[nodes])*normal)
            n = normal.sum(axis=0)
            total += out*np.sign(n[0]*way[1] - n[1]*way[0])
        return float(total)

    def wall_load(self, where):
        """Force on the medium [N/m], a pair, and sum of the nodes' couples
        [N] by the walls whose middles of sides (x, y) satisfy where."""
        nodes = {n for cell, side in zip(*self.mesh.boundary(where))
                 for n in self.nodes[cell, self.shape.sides[side]]}
        total = self.reactions[sorted(nodes)].sum(axis=0)
        return total[:2], float(total[2])

    def wall_tractions(self, where):
        """Places (x, y) of the nodes of walls whose middles of sides satisfy
        where, and tractions on the medium there [Pa], from the reactions."""
        weights = np.zeros(self.n_nodes)
        for cell, side in zip(*self.mesh.boundary(where)):
            nodes, _, values, normal = self._side(cell, side)
            weights[nodes] += values.T @ np.hypot(*normal.T)
        nodes = np.flatnonzero(weights)
        return (self.xy[nodes].T,
                self.reactions[nodes, :2]/weights[nodes, None])

    def dissipation(self):
        """int 2 eta D:D + 4 etaC s^2 + M |grad omega|^2 [W/m]."""
        return float(self.x @ (self.A @ self.x))

    def power(self):
        """Power of the force, and of all walls [W/m]."""
        return float(self.rows @ self.x
                     + np.sum(self.reactions.ravel()*self.x))

    def find(self, x, y):
        """Cell of a point, and its place in the square."""
        point = np.array([x, y], float)
        low, high = self.places.min(axis=1), self.places.max(axis=1)
        slack = 0.1*(high - low)
        cells = np.flatnonzero(((point >= low - slack)
                                & (point <= high + slack)).all(axis=1))
        best = None
        for cell in cells:
            xi = np.zeros((1, 2))
            for _ in range(20):
                miss = point - (self.shape.values(xi) @ self.places[cell])[0]
                J = np.einsum("na,nd->da", self.shape.gradients(xi)[0],
                              self.places[cell])
                xi = xi + np.linalg.solve(J, miss)
                if np.abs(xi).max() > 3:
                    break
            outside = np.abs(xi).max() - 1
            if best is None or outside < best[0]:
                best = (outside, cell, xi)
        if best is None or best[0] > 1e-6:
            raise ValueError(f"({x}, {y}) is not in the mesh")
        return best[1:]

    def at(self, x, y):
        """Velocity u, v [m/s], omega [1/s], p [Pa] at a point."""
        cell, xi = self.find(x, y)
        values = self.shape.values(xi)[0]
        nodes = self.nodes[cell]
        u, v = values @ self.u[nodes]
        terms = self._pressures(xi)[cell, 0]
        p = terms @ self.p.reshape(len(self.nodes), -1)[cell]
        omega = (values @ self.omega[nodes]
                 if self.etaC[cell] or self.M[cell] else np.nan)
        return float(u), float(v), float(omega), float(p)

    def find_all(self, points):
        """Cells of many points, (points, 2), and their places in the square."""
        cells = np.full(len(points), -1)
        places, best = np.zeros((len(points), 2)), np.full(len(points), 1e-6)
        low, high = self.places.min(axis=1), self.places.max(axis=1)
        slack = 0.1*(high - low)
        for cell, corners in enumerate(self.places):
            near = np.flatnonzero(
                ((points >= low[cell] - slack[cell])
                 & (points <= high[cell] + slack[cell])).all(axis=1))
            xi = np.zeros((len(near), 2))
            for _ in range(10 if len(near) else 0):
                miss = points[near] - self.shape.values(xi) @ corners
                J = np.einsum("pna,nd->pda", self.shape.gradients(xi), corners)
                step = np.linalg.solve(J, miss[:, :, None])[:, :, 0]
                xi = np.clip(xi + step, -3, 3)
                if np.abs(step).max() < 1e-13:
                    break
            outside = np.abs(xi).max(axis=1) - 1
            closer = outside < best[near]
            cells[near[closer]] = cell
            places[near[closer]] = xi[closer]
            best[near[closer]] = outside[closer]
        if (cells < 0).any():
            raise ValueError(f"{points[cells < 0][0]} is not in the mesh")
        return cells, places

    def gradients_at(self, points):
        """Velocity u, v and omega of many points, (points, 3), and their
        gradients [point, j, i]; no omega where nothing has one."""
        cells, xi = self.find_all(points)
        slopes = self.shape.gradients(xi)
        J = np.einsum("pna,pnd->pda", slopes, self.places[cells])
        slopes = slopes @ np.linalg.inv(J)
        fields = np.concatenate([self.u, self.omega[:, None]],
                                axis=1)[self.nodes[cells]]
        fields[~((self.etaC > 0) | (self.M > 0))[cells], :, 2] = np.nan
        return (np.einsum("pn,pni->pi", self.shape.values(xi), fields),
                np.einsum("pnj,pni->pji", slopes, fields))


def _sparse(blocks, rows, columns, shape):
    """Sum of dense blocks (n, r, c) at rows (n, r) and columns (n, c)."""
    r = np.broadcast_to(rows[:, :, None], blocks.shape)
    c = np.broadcast_to(columns[:, None], blocks.shape)
    return coo_matrix((blocks.ravel(), (r.ravel(), c.ravel())),
                      shape).tocsr()
