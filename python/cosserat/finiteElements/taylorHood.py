"""Creeping flow of a Cosserat medium on triangles, for shapes that change.

Elements of Taylor and Hood: u and omega quadratic, p linear and continuous;
straight sides. The weak form is that of cosserat.finiteElements.Flow.
"""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

from cosserat.finiteElements.flow import strains

#: Barycentric coordinates and weights (of area 1/2) that integrate degree 4
_A, _B = 0.445948490915965, 0.091576213509771
PLACES = np.array([np.roll([1 - 2*a, a, a], k)
                   for a in (_A, _B) for k in range(3)])
WEIGHTS = np.repeat([0.223381589678011, 0.109951743655322], 3)/2

#: Corners of the sides, as the nodes in their middles are numbered
SIDES = np.array([[0, 1], [1, 2], [2, 0]])

_SLOPES = np.array([[-1.0, -1], [1, 0], [0, 1]])


def _shapes():
    """Quadratic shape functions and their derivatives at the places, (places,
    nodes) and (places, nodes, 2)."""
    ends = PLACES[:, SIDES]
    values = np.hstack([PLACES*(2*PLACES - 1), 4*ends[..., 0]*ends[..., 1]])
    corners = (4*PLACES - 1)[..., None]*_SLOPES
    middles = 4*(ends[..., 0, None]*_SLOPES[SIDES[:, 1]]
                 + ends[..., 1, None]*_SLOPES[SIDES[:, 0]])
    return values, np.concatenate([corners, middles], 1)


class Triangles:
    """Triangles, counter-clockwise, of points (n, 2)."""

    def __init__(self, points, corners):
        self.points, self.corners = points, corners
        pairs = np.sort(corners[:, SIDES], -1).reshape(-1, 2)
        self.edges, edge, count = np.unique(
            pairs, axis=0, return_inverse=True, return_counts=True)
        self.nodes = np.hstack([corners, len(points) + edge.reshape(-1, 3)])
        self.n_nodes = len(points) + len(self.edges)
        self.outside = count == 1

    def on_boundary(self, where):
        """Nodes on the edges of the boundary with both ends where a function
        (x, y) is true."""
        ends = np.array(where(*self.points.T))[self.edges].all(1)
        found = np.flatnonzero(self.outside & ends)
        return np.unique(np.concatenate([self.edges[found].ravel(),
                                         len(self.points) + found]))


def solve(mesh, material, force, held):
    """Velocities (n, 2) of the corners and the power [W/m] of the force.

    material: eta, etaC [Pa s], M [Pa s m2]; force: a pair [N/m3]; held: list
    of (nodes, components of u, v, omega that are 0 there). The rest of the
    boundary is free.
    """
    eta, etaC, M = material
    values, slopes = _shapes()
    corners = mesh.points[mesh.corners]
    J = np.stack([corners[:, 1] - corners[:, 0],
                  corners[:, 2] - corners[:, 0]], -1)
    area = np.linalg.det(J)
    if area.min() <= 0:
        raise ValueError("a triangle is turned inside out")
    gradients = np.einsum("qna,cad->cqnd", slopes, np.linalg.inv(J))
    w = WEIGHTS*area[:, None]

    E = strains(gradients, values)
    stiffness = np.array([2*eta, 2*eta, eta, 4*etaC, M, M])
    K = np.einsum("cqei,e,cq,cqej->cij", E, stiffness, w, E, optimize=True)
    B = -np.einsum("qp,cq,cqi->cpi", PLACES, w, E[:, :, 0] + E[:, :, 1])
    load = np.zeros((len(w), 6, 3))
    load[..., :2] = np.einsum("cq,qn->cn", w, values)[..., None]*force

    velocities = (3*mesh.nodes[:, :, None] + np.arange(3)).reshape(-1, 18)
    pressures = 3*mesh.n_nodes + mesh.corners
    unknowns = np.hstack([velocities, pressures])
    blocks = np.zeros((len(w), 21, 21))
    blocks[:, :18, :18] = K
    blocks[:, 18:, :18] = B
    blocks[:, :18, 18:] = B.transpose(0, 2, 1)
    n = 3*mesh.n_nodes + len(mesh.points)
    matrix = coo_matrix(
        (blocks.ravel(), (np.repeat(unknowns, 21, 1).ravel(),
                          np.tile(unknowns, (1, 21)).ravel())), (n, n)).tocsr()
    right = np.bincount(velocities.ravel(), load.ravel(), n)

    free = np.ones(n, bool)
    for nodes, components in held:
        for k in components:
            free[3*nodes + k] = False
    x = np.zeros(n)
    x[free] = splu(matrix[free][:, free].tocsc()).solve(right[free])
    return x[:3*len(mesh.points)].reshape(-1, 3)[:, :2], right @ x
