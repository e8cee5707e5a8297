"""Lagrange polynomials on the square [-1, 1]^2, and where to integrate."""

import numpy as np
from numpy.polynomial import legendre


def lobatto(degree):
    """Gauss-Lobatto points of [-1, 1], degree + 1 of them."""
    inner = legendre.Legendre.basis(degree).deriv().roots()
    return np.concatenate([[-1.0], np.sort(inner.real), [1.0]])


def gauss(n):
    """Points, shape (n^2, 2), and weights that integrate over the square."""
    x, w = legendre.leggauss(n)
    return np.stack(np.meshgrid(x, x), -1).reshape(-1, 2), np.outer(
        w, w).ravel()


class Lagrange:
    """Polynomials Q_k: node (i, j) of Gauss-Lobatto points has the number
    i + (k + 1) j."""

    def __init__(self, degree):
        self.degree, self.points = degree, lobatto(degree)
        self.coefficients = np.linalg.inv(
            legendre.legvander(self.points, degree))
        self.nodes = np.stack(np.meshgrid(self.points, self.points),
                              -1).reshape(-1, 2)
        i, j = np.arange(degree + 1), degree + 1
        #: Nodes along each side, in the sense of rising coordinate
        self.sides = [i, degree + j*i, j*degree + i, j*i]

    def _line(self, x, derivative=False):
        c = self.coefficients
        return legendre.legval(x, legendre.legder(c) if derivative else c).T

    def values(self, xi):
        """Shape (n, nodes) at points of shape (n, 2)."""
        x, y = self._line(xi[:, 0]), self._line(xi[:, 1])
        return np.einsum("qi,qj->qji", x, y).reshape(len(xi), -1)

    def gradients(self, xi):
        """Shape (n, nodes, 2)."""
        x, y = self._line(xi[:, 0]), self._line(xi[:, 1])
        dx, dy = self._line(xi[:, 0], True), self._line(xi[:, 1], True)
        return np.stack([np.einsum("qi,qj->qji", a, b).reshape(len(xi), -1)
                         for a, b in ((dx, y), (x, dy))], -1)


def monomials(xi, degree):
    """Complete polynomials of two variables, shape (..., terms); the first
    is 1."""
    x, y = xi[..., 0], xi[..., 1]
    return np.stack([x**(n - j)*y**j for n in range(degree + 1)
                     for j in range(n + 1)], -1)
