"""Meshes of quadrilaterals: blocks, holes, maps, graded corners."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

#: Vertices of the four sides, in the sense of rising coordinate
SIDES = np.array([[0, 1], [1, 2], [3, 2], [0, 3]])

_CORNERS = 0.25*np.array([[1, -1, -1, 1], [1, 1, -1, -1], [1, 1, 1, 1],
                          [1, -1, 1, -1]])


def bilinear(corners, xi):
    """Points xi (n, 2) of the square put into quadrilaterals (..., 4, 2)."""
    x, y = xi[:, 0], xi[:, 1]
    shape = np.stack([np.ones_like(x), x, y, x*y], -1) @ _CORNERS.T
    return np.einsum("qc,...cd->...qd", shape, corners)


def lines(points, size):
    """Coordinates from the first to the last of the points, all of them
    among these, at most size apart."""
    parts = [np.linspace(a, b, max(1, int(np.ceil((b - a)/size - 1e-9))) + 1)
             for a, b in zip(points, points[1:])]
    return np.concatenate([parts[0]] + [part[1:] for part in parts[1:]])


def graded_lines(points, size, towards, smallest, ratio=0.3):
    """The same, with distances that fall by a ratio down to smallest towards
    some of the points."""
    x = lines(points, size)
    steps = int(np.ceil(np.log(size/smallest)/-np.log(ratio)))
    new = []
    for a, b in zip(x, x[1:]):
        d = (b - a)*ratio**np.arange(1, steps + 1)
        if min(abs(a - t) for t in towards) < 1e-9*size:
            new.append(a + d)
        if min(abs(b - t) for t in towards) < 1e-9*size:
            new.append(b - d)
    return np.unique(np.concatenate([x, *new]))


def between(first, second):
    """Map of (s, t): from the curve first(s) at t = 0 straight to second(s)
    at t = 1; curves are functions s -> (x, y)."""
    def place(s, t):
        (ax, ay), (bx, by) = first(s), second(s)
        return (1 - t)*ax + t*bx, (1 - t)*ay + t*by
    return place


class Mesh:
    """Quadrilaterals: blocks of cells between lines of parameters (s, t),
    each put into the plane by a map.

    blocks: list of (s lines, t lines, map); map: function (s, t) -> (x, y),
    right-handed, or None for x = s, y = t. Vertices of several blocks that
    coincide are one. keep: function (x, y) of the cells' centres, false
    where there is a hole. periodic: vector; what differs by it is the same
    (three cells at least along it).
    """

    def __init__(self, blocks, keep=None, periodic=None):
        #: Corners in parameters, less the cell's origin
        self.local = np.concatenate([_cells(s, t) for s, t, _ in blocks])
        self.origin = np.zeros((len(self.local), 2))
        self.graded = np.zeros(len(self.local), bool)
        self.maps = [place for *_, place in blocks]
        self.block = np.repeat(range(len(blocks)), [
            (len(s) - 1)*(len(t) - 1) for s, t, _ in blocks])
        #: What a cell and its sides are chosen by: centres, middles of sides
        #: of the cell as it was before its corners were graded
        self.centres = self.positions(np.zeros((1, 2)))[:, 0]
        self.middles = self.positions(
            np.array([[0.0, -1], [1, 0], [0, 1], [-1, 0]]))
        if keep is not None:
            self._take(np.flatnonzero(keep(*self.centres.T)))
        self._number(periodic)

    @classmethod
    def tensor(cls, x, y, keep=None, periodic=None):
        """One block with sides along the axes."""
        return cls([(x, y, None)], keep, periodic)

    def _take(self, rows):
        for name in ("local", "origin", "graded", "block", "centres",
                     "middles"):
            setattr(self, name, getattr(self, name)[rows])

    def _number(self, periodic):
        xy = self.positions(np.array([[-1.0, -1], [1, -1], [1, 1],
                                      [-1, 1]])).reshape(-1, 2)
        near = 1e-9*np.ptp(xy)
        tree = cKDTree(xy)
        pairs = tree.query_pairs(near, output_type="ndarray")
        if periodic is not None:
            for i, others in enumerate(tree.query_ball_point(
                    xy + np.asarray(periodic), near)):
                pairs = np.concatenate([pairs, np.array(
                    [(i, j) for j in others], int).reshape(-1, 2)])
        graph = coo_matrix((np.ones(len(pairs)), pairs.T), (len(xy),)*2)
        self.n_vertices, labels = connected_components(graph, False)
        #: Vertices of each cell, counter-clockwise
        self.quads = labels.reshape(-1, 4)

    def positions(self, xi, relative=False):
        """Where points xi (n, 2) of the square lie, (cells, n, 2); relative:
        to a point of each cell's own, to all digits without a map."""
        inner = bilinear(self.local, xi)
        result = inner + self.origin[:, None]
        for i, place in enumerate(self.maps):
            if place is not None:
                rows = self.block == i
                result[rows] = np.stack(
                    place(*np.moveaxis(result[rows], -1, 0)), -1)
        if not relative:
            return result
        plain = np.array([place is None for place in self.maps])[self.block]
        return np.where(plain[:, None, None], inner, result - result[:, :1])

    def grade(self, points, smallest, ratio=0.2):
        """Replace the cells around each of the points (vertices in x, y) by
        rings that shrink by a ratio down to the size smallest, relative to
        the cell's; it may be 1e-60. Every cell may touch one such point."""
        for point in points:
            self._grade(point, int(np.ceil(np.log(smallest)/np.log(ratio))),
                        ratio)
        return self

    def _grade(self, point, layers, ratio):
        xy = self.positions(np.array([[-1.0, -1], [1, -1], [1, 1], [-1, 1]]))
        distance = np.hypot(*np.moveaxis(xy - np.asarray(point), -1, 0))
        size = np.hypot(*(xy[:, 2] - xy[:, 0]).T)[:, None]
        cells, corner = np.nonzero(distance < 1e-6*size)
        if not len(cells) or self.graded[cells].any():
            raise ValueError(f"no vertex at {point}, or a cell with two "
                             "corners to grade")
        numbers, new = {}, []

        def vertex(*key):
            if key not in numbers:
                numbers[key] = self.n_vertices + len(numbers)
            return numbers[key]

        for cell, first in zip(cells, corner):
            turn = (first + np.arange(4)) % 4
            quad, middles = self.quads[cell, turn], self.middles[cell, turn]
            origin = self.local[cell, first] + self.origin[cell]
            a, d, b = (self.local[cell, turn] - self.local[cell, first])[1:]

            def ring(i, quad=quad, cell=cell, arms=(a, d, b)):
                """Vertices and places of layer i."""
                names = quad[1:] if i == 0 else [
                    vertex(quad[1], i), vertex(-cell - 1, i),
                    vertex(quad[3], i)]
                return list(zip(names, np.array(arms)*ratio**i))

            def add(corners, sides, cell=cell, origin=origin,
                    middles=middles):
                new.append((
                    [v for v, _ in corners], [x for _, x in corners], origin,
                    True, self.block[cell], self.centres[cell],
                    [middles[s] if s is not None else [np.nan]*2
                     for s in sides]))

            for i in range(layers):
                (oa, od, ob), (ia, id_, ib) = ring(i), ring(i + 1)
                outer = i == 0
                add([ia, oa, od, id_], [0, 1 if outer else None, None, None])
                add([id_, od, ob, ib], [None, 2 if outer else None, 3, None])
            ia, id_, ib = ring(layers)
            add([(quad[0], np.zeros(2)), ia, id_, ib], [0, None, None, 3])

        rest = np.setdiff1d(np.arange(len(self.quads)), cells)
        quads = self.quads[rest]
        self._take(rest)
        for name, column in zip(
                ("quads", "local", "origin", "graded", "block", "centres",
                 "middles"),
                zip(*new)):
            old = quads if name == "quads" else getattr(self, name)
            setattr(self, name, np.concatenate([old, np.array(column)]))
        self.n_vertices += len(numbers)

    def sides(self):
        """Numbers of the edges, (cells, 4), and how many cells each has."""
        pairs = np.sort(self.quads[:, SIDES], axis=-1).reshape(-1, 2)
        _, edge, count = np.unique(pairs, axis=0, return_inverse=True,
                                   return_counts=True)
        return edge.reshape(-1, 4), count

    def boundary(self, where=None):
        """Cells and sides at the boundary, where a function (x, y) of the
        middles of sides is true."""
        edge, count = self.sides()
        outside = count[edge] == 1
        if where is not None:
            outside &= np.array(where(*np.moveaxis(self.middles, -1, 0)),
                                bool)
        return np.nonzero(outside)

    def nodes(self, degree):
        """Numbers of the nodes of Q_k, (cells, (k + 1)^2), and how many."""
        edge, count = self.sides()
        inner = np.arange(1, degree)
        n, step = len(self.quads), degree + 1
        result = np.empty((n, step, step), int)
        result[:, [0, 0, -1, -1], [0, -1, -1, 0]] = self.quads
        first = self.n_vertices + edge*(degree - 1)
        views = [result[:, 0], result[:, :, -1], result[:, -1],
                 result[:, :, 0]]
        for side, view in enumerate(views):
            a, b = self.quads[:, SIDES[side]].T
            along = np.where((a < b)[:, None], inner - 1, degree - 1 - inner)
            view[:, 1:-1] = first[:, side, None] + along
        total = self.n_vertices + len(count)*(degree - 1)
        result[:, 1:-1, 1:-1] = total + np.arange(
            n*(degree - 1)**2).reshape(n, degree - 1, degree - 1)
        return result.reshape(n, -1), total + n*(degree - 1)**2


def _cells(s, t):
    """Corners of the cells between lines, counter-clockwise, (n, 4, 2)."""
    i, j = (k.ravel() for k in np.meshgrid(np.arange(len(s) - 1),
                                           np.arange(len(t) - 1)))
    s, t = np.asarray(s, float), np.asarray(t, float)
    return np.stack([np.stack([s[i + a], t[j + b]], -1)
                     for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))], 1)
