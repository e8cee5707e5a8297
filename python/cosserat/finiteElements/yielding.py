"""Bingham media by finite elements: a Flow whose viscosities follow its rates at
the points of integration, by Newton's method."""

import numpy as np

from cosserat.finiteElements.flow import Flow, _sparse

#: Largest change of the unknowns, over the largest of them, at the end; and most
#: steps
CLOSE = 1e-7
MOST = 60


class BinghamFlow(Flow):
    """Flow with the viscosity eta + tauY/sqrt(Gamma^2 + eps^2), and etaC and M as
    many times it as they are of eta: Gamma^2 = 2 D:D + 4 (etaC/eta) s^2
    + (M/eta) |grad omega|^2.

    tauY: yield stress, a number or function of the centres of the cells; eps:
    small rate. Steps are those of Newton's method, searched along for the flow
    of least power."""

    def __init__(self, mesh, degree, tauY, eps, **flow):
        self.tauY, self.eps = tauY, eps
        super().__init__(mesh, degree, **flow)

    def _prepare(self):
        """Strains, weights and moduli of unit viscosity at all points."""
        _, _, self.strains, self.volume = self._integrals()
        eta = self.eta
        self.unit = self._moduli(1 + 0*eta, self.etaC/eta, self.M/eta)
        tauY = self.tauY
        self.yields = (tauY(*self.mesh.centres.T) if callable(tauY)
                       else np.full(len(eta), float(tauY)))
        self.dofs = (3*self.nodes[:, :, None] + np.arange(3)).reshape(
            len(self.nodes), -1)

    def _matrices(self, x, tangent=True):
        """Secant and tangent of the forces at a flow."""
        strain = np.einsum("cqij,cj->cqi", self.strains, x[self.dofs])
        stress = strain*self.unit[:, None]
        small = np.sqrt((strain*stress).sum(axis=-1) + self.eps**2)
        yields = self.yields[:, None]
        eta = self.eta[:, None] + yields/small
        # Twice the derivative by Gamma^2
        slope = -yields/small**3
        size = (3*self.n_nodes,)*2
        result = []
        for rank_one in (False, True)[:1 + tangent]:
            moduli = (eta*self.volume)[..., None]*self.unit[:, None]
            weighted = self.strains*moduli[..., None]
            if rank_one:
                along = np.einsum("cqi,cqij->cqj", stress, self.strains)
                weighted = weighted + np.einsum(
                    "cqi,cqj->cqij", stress,
                    along*(slope*self.volume)[..., None])
            shape = (len(eta), -1, self.dofs.shape[1])
            result.append(_sparse(np.matmul(
                self.strains.reshape(shape).transpose(0, 2, 1),
                weighted.reshape(shape)), self.dofs, self.dofs, size))
        return result

    def _against(self, x, dx):
        """What the loads do in the motion dx beyond what the medium at x takes:
        the slope of what the flow makes least."""
        return dx @ (self.loads - self._matrices(x, tangent=False)[0] @ x)

    def _length(self, x, dx):
        """Share of a step after which the slope is small, by halving."""
        first, low, high, length = self._against(x, dx), 0.0, 1.0, 1.0
        for _ in range(12):
            slope = self._against(x + length*dx, dx)
            if abs(slope) <= 0.3*first or (length == 1 and slope > 0):
                break
            low, high = (length, high) if slope > 0 else (low, length)
            length = 0.5*(low + high)
        return length

    def _solve(self):
        """Steps from the flow of the viscosity eta."""
        self._prepare()
        super()._solve()
        self.loads, x, p = self.rows, self.x, self.p
        self.steps = []
        while len(self.steps) < MOST:
            secant, self.A = self._matrices(x)
            self.rows = self.loads + (self.A - secant) @ x
            super()._solve()
            dx = self.x - x
            length = self._length(x, dx)
            change = np.abs(dx).max()/np.abs(x).max()
            self.steps.append((change, length))
            x, p = x + length*dx, p + length*(self.p - p)
            if change < CLOSE:
                break
        else:
            raise RuntimeError(f"no flow after {MOST} steps: {self.steps[-3:]}")
        self.rows, self.x, self.p = self.loads, x, p
        self.A = self._matrices(x, tangent=False)[0]
        self.reactions = (self.A @ x + self.B.T @ p
                          - self.rows).reshape(self.n_nodes, 3)
