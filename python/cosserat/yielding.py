"""Exact and computed values of media that yield, in layers and channels
and on frictional walls (docs/theory.md, sections 13 and 14). Unit yield stress, force and lengths where no
other is given; the Cosserat measure of stress has the weights of the
dissipation."""

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq

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
