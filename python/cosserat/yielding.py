"""Exact and computed values of media that yield, in layers and channels
and on frictional walls (docs/theory.md, sections 13 and 14). Unit yield stress, force and lengths where no
other is given; the Cosserat measure of stress has the weights of the
dissipation."""

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve

#: Limit pressure of a strip on a half space over the yield stress in shear, of
#: Prandtl (1920), smooth or rough
PUNCH = 2 + np.pi


class Channel:
    """A channel of half width h under the force G per volume, classical:
    rate: the shear rate at a shear stress, as a function."""

    def __init__(self, rate, G=1.0, h=1.0):
        self.rate, self.G, self.h = rate, G, h

    def u(self, y):
        """Velocity at a distance from the middle."""
        return quad(lambda z: self.rate(self.G*z), abs(y), self.h,
                    epsabs=1e-14, epsrel=1e-12, limit=400)[0]

    def on_cells(self, n):
        """What n equal cells across make of the flow rate: rates are exact at
        faces, where the stress is, and stand for all between two centres; at
        walls the stress is that halfway to the centre. So what a plug's edge on a
        face misses is the square of a quarter cell."""
        cell = 2*self.h/n
        steps = [0.5*cell*self.rate(self.G*(self.h - 0.25*cell))]
        steps += [cell*self.rate(self.G*y)
                  for y in cell*np.arange(n//2 - 1, 0, -1)]
        return 2*cell*float(np.cumsum(steps).sum())

    def flow(self):
        """Flow rate of the whole width: integral of u, by parts."""
        return 2*quad(lambda z: z*self.rate(self.G*z), 0, self.h,
                      epsabs=1e-14, epsrel=1e-12, limit=400)[0]


def bingham_rate(tauY, eta=1.0):
    """Shear rate of a Bingham medium at a stress."""
    return lambda tau: max(tau - tauY, 0)/eta


def papanastasiou_rate(tauY, eps, eta=1.0):
    """The same regularised; eps: small rate."""
    def rate(tau):
        if tau <= 0:
            return 0.0
        return brentq(lambda g: eta*g - tauY*np.expm1(-g/eps) - tau,
                      0, tau/eta + 1e-300, xtol=1e-16, rtol=1e-14)
    return rate


def power_rate(n, K=1.0):
    """Shear rate of a power law at a stress."""
    return lambda tau: (tau/K)**(1/n)


def layer_depth(a, q=1.0):
    """H/R of the layer of unit yield stress that has the limit stress a
    between walls without rotation; q = etaC/eta, M = 2 etaC R^2.

    Of the couple stress m over R, with slope p = R dm/dy = 2 A R, yield is
    (a - p/2)^2 + p^2/(4 q) + m^2/(2 q) = 1, R once taken out of y. m is zero in
    the middle and largest at the wall, where omega is zero and the two roots
    for p meet; the lower root is the branch between."""
    def root(m):
        # p^2 (1 + 1/q)/4 - a p + a^2 - 1 + m^2/(2 q) = 0
        b = (1 + 1/q)/4
        left = a**2 - 4*b*(a**2 - 1 + m**2/(2*q))
        return (a - np.sqrt(np.maximum(left, 0)))/(2*b)

    top = np.sqrt(2*q*(1 + a**2*(q/(1 + q) - 1)))
    # dy = dm/p, smooth in sqrt(1 - m/top); the other half of the layer is odd
    return 2*top*quad(lambda t: 2*t/root((1 - t**2)*top), 0, 1, epsabs=0,
                      epsrel=1e-11, limit=1000)[0]


def layer_stress(depth, q=1.0):
    """Limit stress of the layer of unit yield stress, H/R = depth."""
    return brentq(lambda a: layer_depth(a, q) - depth,
                  1 + 1e-7, np.sqrt(1 + q)*(1 - 1e-12), xtol=1e-13)


def _bears(f, depth, steps=20000):
    """Can a channel, H/R = depth, bear the load f = G H/2 at unit yield
    stress: is there a couple stress m(y) with (a - m'/2)^2 + m'^2/4
    + m^2/(2 R^2) <= 1, a = G y?

    At the wall m is at most what is left at m' = a; from there inwards it
    falls as slowly as yield lets it, and is not to meet the lower limit.
    (By Runge and Kutta; lengths in R.)"""
    def limit(y):
        return np.sqrt(max(2 - (2*f*y/depth)**2, 0))

    def slope(y, m):
        a = 2*f*y/depth
        return a - np.sqrt(max(2 - a**2 - m**2, 0))

    h = -0.5*depth/steps
    m = limit(0.5*depth)*(1 - 1e-12)
    for i in range(steps):
        y = 0.5*depth + i*h
        k1 = slope(y, m)
        k2 = slope(y + h/2, m + h/2*k1)
        k3 = slope(y + h/2, m + h/2*k2)
        m += h/6*(k1 + 2*k2 + 2*k3 + slope(y + h, m + h*k3))
        if m <= -limit(y + h):
            return False
    return True


def channel_load(depth, steps=20000):
    """Load f = G H/2 at which a channel of unit yield stress starts to flow,
    walls without velocity and rotation, etaC = eta, H/R = depth."""
    low, high = 1.0, np.sqrt(2)
    if _bears(high*(1 - 1e-9), depth, steps):
        return high
    while high - low > 1e-7:
        middle = 0.5*(low + high)
        low, high = ((middle, high) if _bears(middle, depth, steps)
                     else (low, middle))
    return low


class RegularisedChannel:
    """A channel of unit depth between walls without velocity and rotation, of a
    Bingham medium (Bercovier and Engelman) with couple stresses, under the
    force G: the minimum of the dissipation's potential over velocities and
    rotations, n quadratic finite elements on half of it, shorter towards the
    wall and the middle. q = etaC/eta, M = 2 etaC R^2."""

    def __init__(self, G, R, etaP=1.0, q=1.0, n=400):
        self.etaP = etaP
        t = np.linspace(-1, 1, n + 1)
        ends = 0.25*(1 + t + np.sin(np.pi*t)/np.pi*0.98)
        ends[0], ends[-1] = 0, 0.5
        points, weights = np.polynomial.legendre.leggauss(3)
        h = np.diff(ends)[:, None]
        x = 0.5*(1 + points)
        self.w = 0.5*weights*h
        value = np.stack([(1 - x)*(1 - 2*x), 4*x*(1 - x), x*(2*x - 1)])
        slope = np.stack([4*x - 3, 4 - 8*x, 4*x - 1])
        slopes = slope.T[None]/h[:, :, None]
        values = np.broadcast_to(value.T, slopes.shape)
        none = np.zeros_like(slopes)
        # Rates whose squares add to Gamma^2, from the six values of an element
        self.B = np.stack([
            np.concatenate([slopes, none], 2),
            np.sqrt(4*q)*np.concatenate([0.5*slopes, values], 2),
            R*np.sqrt(2*q)*np.concatenate([none, slopes], 2)], 2)
        force = G*self.w[:, :, None]*np.concatenate([values, none], 2)
        node = 2*np.arange(n)[:, None] + np.arange(3)
        self.size = 2*n + 1
        self.dofs = np.concatenate([node, node + self.size], 1)
        held = [self.size - 1, self.size, 2*self.size - 1]
        self.free = np.setdiff1d(np.arange(2*self.size), held)
        self.load = np.bincount(self.dofs.ravel(), force.sum(1).ravel(),
                                2*self.size)

    def _energy(self, x, eps):
        """Potential of the values x."""
        E = np.einsum("eqri,ei->eqr", self.B, x[self.dofs])
        root = np.sqrt((E**2).sum(2) + eps**2)
        return (self.w*(0.5*self.etaP*root**2 + root)).sum() - self.load @ x

    def _step(self, x, eps):
        """Step of Newton's method from x, and the slope of the fall along
        it."""
        E = np.einsum("eqri,ei->eqr", self.B, x[self.dofs])
        root = np.sqrt((E**2).sum(2) + eps**2)
        eta = self.etaP + 1/root
        f = np.einsum("eq,eqr,eqri->ei", self.w*eta, E, self.B)
        C = eta[..., None, None]*np.eye(3) - (
            E[..., None]*E[..., None, :]/root[..., None, None]**3)
        K = np.einsum("eq,eqri,eqrs,eqsj->eij", self.w, self.B, C, self.B)
        r = self.load - np.bincount(self.dofs.ravel(), f.ravel(), x.size)
        rows = np.repeat(self.dofs, 6, 1).ravel()
        cols = np.tile(self.dofs, (1, 6)).ravel()
        K = coo_matrix((K.ravel(), (rows, cols))).tocsc()
        dx = np.zeros_like(x)
        dx[self.free] = spsolve(K[self.free][:, self.free], r[self.free])
        return dx, r @ dx

    def _solve(self, x, eps):
        """Minimum of the potential, from x."""
        for _ in range(200):
            dx, fall = self._step(x, eps)
            if fall < 1e-13*abs(self.load @ x) + 1e-300:
                return x + dx
            length, before = 1.0, self._energy(x, eps)
            while (length > 1e-6 and self._energy(x + length*dx, eps)
                   > before - 1e-4*length*fall + 1e-14*abs(before)):
                length *= 0.5
            x = x + length*dx
        raise RuntimeError(f"no minimum at eps {eps}: {fall}")

    def speeds(self, rests):
        """Speeds in the middle where the viscosity at rest is etaP and one of
        these, of which each is larger than the one before."""
        x, eps, found = np.zeros(2*self.size), 1.0, []
        for rest in rests:
            steps = 1 + int(np.ceil(8*np.log10(eps*rest)))
            for now in np.geomspace(eps, 1/rest, 1 + steps):
                x = self._solve(x, now)
            eps = 1/rest
            found.append(float(x[0]))
        return found


def janssen(z, mu):
    """Pressure at a depth of a plug that slides along both its walls, isotropic,
    without a load on top; of unit width and weight."""
    return -np.expm1(-2*mu*z)/(2*mu)


def arrest_widths(stress, weight, R, depth, slot, mu=0.3):
    """Widths of a slot below a bin of unit width: up to which its own walls bear
    it and the pressure of Janssen on top; and from which it falls with the
    column above, whose sides bear the yield stress."""
    def missing(width, above, sides):
        bears = stress*(slot*channel_load(width/R, 2000) + sides)
        return 0.5*weight*width*(slot + above) - bears

    return tuple(brentq(missing, 0.01, 1, args, xtol=1e-5) for args in (
        (janssen(depth, mu), 0), (depth, depth)))
