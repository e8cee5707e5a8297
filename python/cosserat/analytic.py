"""Analytic solutions of the planar Cosserat creeping flow.

Numbers in brackets are the equations of Dufour, Muehlhaus and Moresi (2001),
with the signs and factors of the consistent form: there, [22] has a factor
2 etaC eta/(eta + etaC) and exchanges sinh and cosh, [25] the sign of g.

SI units throughout; every function takes and returns numpy arrays.
"""

from dataclasses import dataclass

import numpy as np
from scipy.special import iv, ive, kv, kve


@dataclass(frozen=True)
class Material:
    """eta, etaC [Pa s] and R [m]."""

    eta: float
    etaC: float
    R: float

    @property
    def M(self):
        """Bending viscosity [Pa s m2], [17]."""
        return 2*self.etaC*self.R**2

    @property
    def delta(self):
        """Thickness of the boundary layer [m], [24]."""
        return self.R*np.sqrt(0.5*(1 + self.etaC/self.eta))

    @property
    def factor(self):
        """2 etaC delta/(eta + etaC) of the hyperbolic term in u."""
        return 2*self.etaC*self.delta/(self.eta + self.etaC)


def granular_contact(n, k, eta_n, eta_m):
    """(eta, etaC, B) of a packing with contact dashpots, [14] to [16]."""
    density = (1 - n)*k/(2*np.pi)
    return 0.5*density*(eta_n + eta_m), density*eta_m, density*eta_n


class ShearLayer:
    """Infinite layer -h/2 <= y <= h/2 sheared by its walls, [18] to [24].

    Given are two of: V = u(h/2) = -u(-h/2) [m/s] or sigma = sigma_xy [Pa],
    and Omega = omega(+-h/2) [1/s] or mu = mu_zy(h/2) = -mu_zy(-h/2) [Pa m].
    Where sigma is given, u is the odd solution.
    """

    def __init__(self, material, h, V=None, sigma=None, Omega=None, mu=None):
        if (V is None) == (sigma is None) or (Omega is None) == (mu is None):
            raise ValueError("one of V, sigma and one of Omega, mu")

        self.material = m = material
        self.h = h
        sinh, cosh = np.sinh(h/(2*m.delta)), np.cosh(h/(2*m.delta))

        if mu is not None:
            b = mu*m.delta/(m.M*sinh)
            a = sigma if V is None else 2*m.eta/h*(V + b*m.factor*sinh)
        elif V is not None:
            b = (V + Omega*h)/(h*cosh - m.factor*sinh)
            a = 2*m.eta*(b*cosh - Omega)
        else:
            a = sigma
            b = (Omega + sigma/(2*m.eta))/cosh

        self.a, self.b = a, b

    def u(self, y):
        """Velocity along x [m/s]."""
        m = self.material
        return self.a*y/m.eta - m.factor*self.b*np.sinh(y/m.delta)

    def omega(self, y):
        """Microrotation [1/s]."""
        m = self.material
        return -self.a/(2*m.eta) + self.b*np.cosh(y/m.delta)

    def couple_stress(self, y):
        """mu_zy [Pa m]."""
        m = self.material
        return m.M*self.b/m.delta*np.sinh(y/m.delta)


class GravityChannel:
    """Channel -h/2 <= y <= h/2 with U = 0 and omega = 0 on its walls, driven
    by G = rho g [N/m3] along x, [25] to [29]."""

    def __init__(self, material, h, G):
        self.material, self.h, self.G = material, h, G
        m = material
        self.B0 = -G*h/(4*m.eta*np.sinh(h/(2*m.delta)))

    def u(self, y):
        """Velocity along x [m/s]."""
        m = self.material
        return self.G*(self.h**2/4 - y**2)/(2*m.eta) + m.factor*self.B0*(
            np.cosh(self.h/(2*m.delta)) - np.cosh(y/m.delta))

    def omega(self, y):
        """Microrotation [1/s]."""
        m = self.material
        return self.G*y/(2*m.eta) + self.B0*np.sinh(y/m.delta)


class Layers:
    """Layers of several materials between edges[0] < y < edges[-1], one more
    edge than materials, between walls of given velocity and rotation, driven
    by G = rho g [N/m3] along x: what GravityChannel and ShearLayer have, with
    constants of each layer. etaC > 0 in all.

    With the shear stress tau = A - G y of all layers,

        omega = -tau/(2 eta) + H,    H = b e^(-(y - y0)/delta)
                                         + c e^((y - y1)/delta)
        u' = tau/eta - 2 etaC/(eta + etaC) H

    between edges y0 and y1 of a layer; u, omega and M omega' are the same on
    either side of an edge.

    velocity, rotation: u [m/s] and omega [1/s] of the lower and upper wall.
    """

    def __init__(self, materials, edges, velocity=(0, 0), rotation=(0, 0),
                 G=0.0):
        self.materials, self.edges, self.G = materials, np.array(edges), G
        n = len(materials)
        # Unknowns: A, then u at the lower edge, b, c of each layer
        rows, right = [], []

        def condition(value, *terms):
            row, given = np.zeros(3*n + 1), 0.0
            for sign, i, y, which in terms:
                unit, load = self._terms(i, np.float64(y))[which]
                row[0] += sign*unit[0]
                row[3*i + 1:3*i + 4] += sign*np.array(unit[1:])
                given += sign*load
            rows.append(row)
            right.append(value - given)

        for which, walls in enumerate((velocity, rotation)):
            condition(walls[0], (1, 0, edges[0], which))
            condition(walls[1], (1, n - 1, edges[-1], which))
        for i, y in enumerate(edges[1:-1]):
            for which in range(3):
                condition(0.0, (1, i, y, which), (-1, i + 1, y, which))
        self.constants = np.linalg.solve(np.array(rows), np.array(right))

    def _terms(self, i, y):
        """u, omega and couple stress in layer i: each of unit A, u0, b, c,
        and of the force."""
        m, G = self.materials[i], self.G
        y0, y1 = self.edges[i:i + 2]
        low, high = np.exp((y0 - y)/m.delta), np.exp((y - y1)/m.delta)
        full = np.exp((y0 - y1)/m.delta)
        f, k, one = m.factor, m.M/m.delta, 1 + 0*y
        return [
            (((y - y0)/m.eta, one, f*(low - 1), f*(full - high)),
             -G*(y**2 - y0**2)/(2*m.eta)),
            ((-one/(2*m.eta), 0*y, low, high), G*y/(2*m.eta)),
            ((0*y, 0*y, -k*low, k*high), m.M*G/(2*m.eta) + 0*y)]

    def _field(self, which, y):
        y = np.asarray(y, float)
        layer = np.clip(np.searchsorted(self.edges, y, "right") - 1, 0,
                        len(self.materials) - 1)
        total = np.zeros_like(y)
        for i in range(len(self.materials)):
            unit, load = self._terms(i, np.where(layer == i, y,
                                                 self.edges[i]))[which]
            own = self.constants[[0, 3*i + 1, 3*i + 2, 3*i + 3]]
            total += np.where(layer == i, np.tensordot(
                own, np.array(unit), 1) + load, 0)
        return total

    def u(self, y):
        """Velocity along x [m/s]."""
        return self._field(0, y)

    def omega(self, y):
        """Microrotation [1/s]."""
        return self._field(1, y)

    def couple_stress(self, y):
        """mu_zy [Pa m]."""
        return self._field(2, y)


class AnnularCouette:
    """Ring between two cylinders r[0] < r[1] that turn, with

        u_theta = A r + C/r + f (b1 I1(r/delta) - b2 K1(r/delta))
        omega   = A + b1 I0(r/delta) + b2 K0(r/delta)

    and the factor f of Material: the moment balance and the linear one along
    theta, where ((eta + etaC) (r u),r/r - 2 etaC omega),r = 0.

    speed: u_theta of the walls [m/s]; rotation: omega of the walls [1/s].
    """

    def __init__(self, material, r, speed, rotation):
        self.material, self.r = material, r
        rows = [self._u(s) for s in r] + [self._omega(s) for s in r]
        self.constants = np.linalg.solve(
            np.array(rows), np.array([*speed, *rotation]))

    def _u(self, r):
        """u_theta of unit A, C, b1, b2; the last scaled to the walls."""
        m = self.material
        inner, outer = np.array(self.r)/m.delta
        s = r/m.delta
        return [r, 1/r, m.factor*ive(1, s)*np.exp(s - outer),
                -m.factor*kve(1, s)*np.exp(inner - s)]

    def _omega(self, r):
        """omega of unit A, C, b1, b2."""
        inner, outer = np.array(self.r)/self.material.delta
        s = r/self.material.delta
        return [1 + 0*r, 0*r, ive(0, s)*np.exp(s - outer),
                kve(0, s)*np.exp(inner - s)]

    def u(self, r):
        """Velocity along theta [m/s]."""
        return np.tensordot(self.constants, self._u(np.asarray(r)), 1)

    def omega(self, r):
        """Microrotation [1/s]."""
        return np.tensordot(self.constants, self._omega(np.asarray(r)), 1)

    @property
    def torque(self):
        """Torque [N m per m of length] that turns the inner cylinder, of
        stress and couple stress together: that of u = C/r, 4 pi eta C."""
        return 4*np.pi*self.material.eta*self.constants[1]


class EccentricCylinders:
    """Fluid between cylinders of radii a < b, the inner one around (e, 0)
    turning with unit angular velocity, the outer one around the origin at
    rest; classical, or of a Material whose microrotation omega is 1 on the
    inner cylinder and 0 on the outer one.

    The curl of the linear balance and the moment balance together give

        psi = B - 2 etaC delta^2/(eta + etaC) H,    omega = H - div grad B/2

    with B biharmonic, H = delta^2 div grad H and the delta of Material. B is
    the general solution in polar coordinates around the inner axis (Michell
    1899), even in the angle and with a single-valued pressure; H is
    K_n(r/delta) cos(n angle) around the inner axis and I_n(r/delta)
    cos(n angle) around the outer one. Their coefficients satisfy the walls in
    the sense of least squares, which converges as (e/b)^terms.
    """

    def __init__(self, a, b, e, terms=24, material=None):
        self.a, self.b, self.e, self.terms = a, b, e, terms
        self.material = material
        angle = np.linspace(0, 2*np.pi, 8*terms, endpoint=False)
        x = np.concatenate([e + a*np.cos(angle), b*np.cos(angle)])
        y = np.concatenate([a*np.sin(angle), b*np.sin(angle)])
        wall = np.concatenate([np.ones(len(angle)), np.zeros(len(angle))])
        fields, given = self._basis(x, y), [-y*wall, (x - e)*wall, wall]
        if material is None:
            fields, given = fields[:2], given[:2]
        rows, given = np.concatenate(fields, axis=1).T, np.concatenate(given)
        self.constants, *_ = np.linalg.lstsq(rows, given, rcond=None)
        self.residual = np.abs(rows @ self.constants - given).max()

    def _basis(self, x, y):
        """Velocities along x and y and microrotation of each term; f(r)
        cos(n angle) as stream function has u_r = -n f/r sin(n angle) and
        u_angle = -df/dr cos(n angle)."""
        terms = []

        def term(n, f, df, omega, centre=self.e):
            angle, r = np.arctan2(y, x - centre), np.hypot(x - centre, y)
            f, df, omega = f(r), df(r), omega(r)*np.cos(n*angle)
            u_r, u_t = -n*f/r*np.sin(n*angle), -df*np.cos(n*angle)
            terms.append((u_r*np.cos(angle) - u_t*np.sin(angle),
                          u_r*np.sin(angle) + u_t*np.cos(angle), omega))

        def power(n, k, s):
            # Scaled to the wall where it is largest
            term(n, lambda r: (r/s)**k, lambda r: k/s*(r/s)**(k - 1),
                 lambda r: (n**2 - k**2)/(2*s**2)*(r/s)**(k - 2))

        term(0, np.log, lambda r: 1/r, lambda r: 0*r)
        power(0, 2, 1)
        term(1, lambda r: r*np.log(r), lambda r: np.log(r) + 1,
             lambda r: -1/r)
        for n in range(1, self.terms):
            for k, s in ((n, self.b), (n + 2, self.b), (-n, self.a),
                         (2 - n, self.a)):
                if (n, k) != (1, 1) or s == self.b:
                    power(n, k, s)
        if self.material is not None:
            for n in range(self.terms):
                for scaled, sign, s, centre in (
                        (kve, -1, self.a, self.e), (ive, 1, self.b, 0)):
                    term(n, *self._layer(n, scaled, sign, s), centre)
        return [np.array(field) for field in zip(*terms)]

    def _layer(self, n, scaled, sign, wall):
        """Stream function, its derivative and omega of H = K_n(r/delta)
        (sign -1) or I_n(r/delta) (sign 1), scaled to 1 at a wall; `scaled` is
        the function times exp(-sign r/delta)."""
        delta = self.material.delta
        factor = self.material.factor*delta
        one = scaled(n, wall/delta)

        def H(r):
            return scaled(n, r/delta)*np.exp(sign*(r - wall)/delta)/one

        def dH(r):
            mean = (scaled(abs(n - 1), r/delta) + scaled(n + 1, r/delta))/2
            return sign/delta*mean*np.exp(sign*(r - wall)/delta)/one

        return lambda r: -factor*H(r), lambda r: -factor*dH(r), H

    def _field(self, i, x, y):
        return np.tensordot(self.constants, self._basis(x, y)[i], 1)

    def u(self, x, y):
        """Velocity [m/s], shape (2, ...)."""
        return np.array([self._field(i, x, y) for i in (0, 1)])

    def omega(self, x, y):
        """Microrotation [1/s]; of the classical fluid half the curl of u."""
        return self._field(2, x, y)

    def torque(self, eta):
        """Torque [N m per m of length] that turns the inner cylinder, of
        stress and couple stress together. Of all terms only B = C log r has
        one about the axis r = 0: its shear stress is 2 eta C/r^2, and the
        fluid's torque 2 pi r^2 times that. (That of H is the same on all
        circles around its axis, and vanishes with K_n far away, with I_n in
        the centre.)"""
        return -4*np.pi*eta*self.constants[0]


class SolCx:
    """Cell driven by a smooth force across a jump of the viscosity at x = 0
    (the benchmark SolCx, classical fluids): free-slip walls at |x| = |y| =
    1/2, viscosity eta[0] left and eta[1] right of the middle, body force
    (0, sin(pi Y) cos(pi X)) with X = x + 1/2, Y = y + 1/2.

    u = U(X) cos(pi Y), v = -U'(X)/pi sin(pi Y), p = P(X) cos(pi Y), where
    d4U - 2 pi^2 d2U + pi^4 U = -pi^2 sin(pi X)/eta on each side.
    """

    def __init__(self, eta):
        self.eta = eta
        matrix, right = np.zeros((8, 8)), np.zeros(8)

        def row(i, functional, side, sign=1.0):
            for k in range(4):
                matrix[i, 4*side + k] += sign*functional(
                    lambda X, d, k=k: self._basis(k, X, d), eta[side])
            right[i] -= sign*functional(
                lambda X, d: self._particular(X, d, eta[side]), eta[side])

        pi = np.pi
        row(0, lambda U, eta: U(0.0, 0), 0)
        row(1, lambda U, eta: U(0.0, 2), 0)
        row(2, lambda U, eta: U(1.0, 0), 1)
        row(3, lambda U, eta: U(1.0, 2), 1)
        # Across the middle: both velocities, shear stress, normal stress; the
        # force vanishes there
        for i, functional in enumerate((
                lambda U, eta: U(0.5, 0),
                lambda U, eta: U(0.5, 1),
                lambda U, eta: eta*(pi*U(0.5, 0) + U(0.5, 2)/pi),
                lambda U, eta: eta*(3*U(0.5, 1) - U(0.5, 3)/pi**2))):
            row(4 + i, functional, 0)
            row(4 + i, functional, 1, -1.0)
        self.constants = np.linalg.solve(matrix, right).reshape(2, 4)

    @staticmethod
    def _basis(k, X, d):
        """Derivative d of e^(pi X), X e^(pi X), e^(-pi X), X e^(-pi X)."""
        a = np.pi if k < 2 else -np.pi
        value = a**d*np.exp(a*X)
        if k % 2:
            value = X*value + d*a**(d - 1)*np.exp(a*X)
        return value

    @staticmethod
    def _particular(X, d, eta):
        """Derivative d of -sin(pi X)/(4 pi^2 eta)."""
        return -np.pi**(d - 2)*np.sin(np.pi*X + d*np.pi/2)/(4*eta)

    def _derivative(self, X, d):
        X = np.asarray(X, float)
        sides = [sum(c*self._basis(k, X, d) for k, c in enumerate(constants))
                 + self._particular(X, d, eta)
                 for constants, eta in zip(self.constants, self.eta)]
        return np.where(X < 0.5, *sides)

    def u(self, x, y):
        """Velocity [m/s], shape (2, ...)."""
        X, Y = x + 0.5, y + 0.5
        return np.array([
            self._derivative(X, 0)*np.cos(np.pi*Y),
            -self._derivative(X, 1)*np.sin(np.pi*Y)/np.pi])

    def p(self, x, y):
        """Pressure [Pa], of mean zero."""
        X, Y = x + 0.5, y + 0.5
        eta = np.where(X < 0.5, *self.eta)
        P = (eta*(self._derivative(X, 3)/np.pi - np.pi*self._derivative(X, 1))
             - np.cos(np.pi*X))/np.pi
        return P*np.cos(np.pi*Y)

    @property
    def v_rms(self):
        """Root mean square of the velocity [m/s]; cos^2 and sin^2 of Y have
        the mean 1/2."""
        t, w = np.polynomial.legendre.leggauss(40)
        square = 0.0
        for a in (0.0, 0.5):
            X = a + (t + 1)/4
            square += w/4 @ (self._derivative(X, 0)**2/2
                             + self._derivative(X, 1)**2/(2*np.pi**2))
        return float(np.sqrt(square))

    @staticmethod
    def force(x, y):
        """Body force [N/m3], shape (2, ...)."""
        return np.array([0*x, np.sin(np.pi*(y + 0.5))*np.cos(np.pi*(x + 0.5))])


class RigidShear:
    """Benchmark of the averages of points (Gassmoeller et al. 2019,
    doi 10.1093/gji/ggz405): free-slip walls at |x| = |y| = 1/2, eta = 1,
    density 2 + sin(pi X) sin(pi Y) with X = x + 1/2, Y = y + 1/2, and a
    gravity such that

    u = (sin(pi X) cos(pi Y), -cos(pi X) sin(pi Y)),
    p = 2 pi cos(pi X) cos(pi Y).

    u is its own Laplacian times -1/(2 pi^2), so that grad p - div grad u =
    (0, -4 pi^2 cos(pi X) sin(pi Y)). Density and stream function go together,
    so the flow is steady.
    """

    @staticmethod
    def u(x, y):
        """Velocity [m/s], shape (2, ...)."""
        X, Y = np.pi*(x + 0.5), np.pi*(y + 0.5)
        return np.array([np.sin(X)*np.cos(Y), -np.cos(X)*np.sin(Y)])

    @staticmethod
    def p(x, y):
        """Pressure [Pa], of mean zero."""
        X, Y = np.pi*(x + 0.5), np.pi*(y + 0.5)
        return 2*np.pi*np.cos(X)*np.cos(Y)

    @staticmethod
    def density(x, y):
        """Density [kg/m3]."""
        return 2 + np.sin(np.pi*(x + 0.5))*np.sin(np.pi*(y + 0.5))

    @staticmethod
    def force(x, y):
        """Body force [N/m3], shape (2, ...)."""
        X, Y = np.pi*(x + 0.5), np.pi*(y + 0.5)
        return np.array([0*x, -4*np.pi**2*np.cos(X)*np.sin(Y)])


class Manufactured:
    """Solution made up on a box bent to a shape: eta, etaC and M vary
    smoothly by the fraction of a material, loads follow from the balances.

    X, Y: functions (x, y) -> [0, 1], coordinates that follow the walls. With
    stream function sin^2(pi X) sin^2(pi Y) the fluid rests at all walls;
    omega = 1/2 + sin(pi X) sin(pi Y) is 1/2 there, p = cos(pi X) cos(pi Y).
    first and second are the materials, of fractions alpha and 1 - alpha.
    """

    #: Step and weights of central differences of eighth order
    STEP = 5e-3
    WEIGHTS = np.array([4/5, -1/5, 4/105, -1/280])

    def __init__(self, X, Y, first, second):
        self.X, self.Y, self.first, self.second = X, Y, first, second

    def _d(self, function, i):
        """Derivative of a function along x (0) or y (1)."""
        def derivative(x, y):
            total = 0
            for k, weight in enumerate(self.WEIGHTS, start=1):
                step = np.array([0.0, 0.0])
                step[i] = k*self.STEP
                total = total + weight*(
                    function(x + step[0], y + step[1])
                    - function(x - step[0], y - step[1]))
            return total/self.STEP
        return derivative

    def _psi(self, x, y):
        return (np.sin(np.pi*self.X(x, y))*np.sin(np.pi*self.Y(x, y)))**2

    def alpha(self, x, y):
        """Fraction of the first material."""
        return 0.5 + 0.4*np.sin(2*np.pi*self.X(x, y))*np.cos(
            np.pi*self.Y(x, y))

    def _mix(self, name):
        def mean(x, y):
            alpha = self.alpha(x, y)
            return (alpha*getattr(self.first, name)
                    + (1 - alpha)*getattr(self.second, name))
        return mean

    def u(self, x, y):
        """Velocity [m/s], shape (2, ...)."""
        return np.array([self._d(self._psi, 1)(x, y),
                         -self._d(self._psi, 0)(x, y)])

    def omega(self, x, y):
        """Microrotation [1/s]."""
        return 0.5 + np.sin(np.pi*self.X(x, y))*np.sin(np.pi*self.Y(x, y))

    def p(self, x, y):
        """Pressure [Pa]."""
        return np.cos(np.pi*self.X(x, y))*np.cos(np.pi*self.Y(x, y))

    def _stress(self, i, j):
        """sigma_ij, [13]; gamma_ij = u_i,j + e_kij omega_k."""
        def gamma(i, j, x, y):
            return (self._d(lambda a, b: self.u(a, b)[i], j)(x, y)
                    + (j - i)*self.omega(x, y))

        def stress(x, y):
            eta, etaC = self._mix("eta")(x, y), self._mix("etaC")(x, y)
            return ((eta + etaC)*gamma(i, j, x, y)
                    + (eta - etaC)*gamma(j, i, x, y)
                    - (i == j)*self.p(x, y))
        return stress

    def force(self, x, y):
        """Body force [N/m3] that the linear balance needs, shape (2, ...)."""
        return -np.array([
            self._d(self._stress(i, 0), 0)(x, y)
            + self._d(self._stress(i, 1), 1)(x, y) for i in (0, 1)])

    def couple(self, x, y):
        """Body couple [Pa] that the angular balance needs."""
        M = self._mix("M")
        bending = sum(
            self._d(lambda a, b, i=i: M(a, b)*self._d(self.omega, i)(a, b),
                    i)(x, y) for i in (0, 1))
        return -bending + (self._stress(0, 1)(x, y) - self._stress(1, 0)(x, y))


class PipeFlow:
    """Flow along the axis of a pipe of radius a under a gradient G = -dp/dz
    [Pa/m], u(a) = 0; omega(a) = 0, or its couple if free.

    Microrotation about e_theta, positive with (curl u)/2 = -u'/2.
    """

    def __init__(self, material, a, G, free=False):
        self.material, self.a, self.G = material, a, G
        m = material
        i0, i1 = iv(0, a/m.delta), iv(1, a/m.delta)
        if free:
            self.b = -G*m.delta/(4*m.eta*(i0 - i1*m.delta/a))
        else:
            self.b = -G*a/(4*m.eta*i1)

    def u(self, r):
        """Velocity along the axis [m/s]."""
        m = self.material
        return (self.G*(self.a**2 - r**2)/(4*m.eta) + m.factor*self.b
                * (iv(0, self.a/m.delta) - iv(0, r/m.delta)))

    def omega(self, r):
        """Microrotation [1/s]."""
        m = self.material
        return self.G*r/(4*m.eta) + self.b*iv(1, r/m.delta)

    def rate(self):
        """Volume per time [m3/s]."""
        m, a = self.material, self.a
        return (np.pi*self.G*a**4/(8*m.eta) + 2*np.pi*m.factor*self.b
                * (iv(0, a/m.delta)*a**2/2 - m.delta*a*iv(1, a/m.delta)))

    def over_poiseuille(self):
        """Rate over that of the classical fluid of the same eta."""
        return self.rate()*8*self.material.eta/(np.pi*self.G*self.a**4)


class LayeredPipe:
    """The same with a core of another material up to the radius b, where u,
    omega and M omega' are continuous; omega = 0 on the wall."""

    def __init__(self, core, shell, b, a, G):
        self.media, self.b, self.a, self.G = (core, shell), b, a, G
        near, far = self._terms(core, b), self._terms(shell, b)
        wall = self._terms(shell, a)
        rows = [[near[0][0], -far[0][0], -far[0][1]],
                [core.M*near[1][0], -shell.M*far[1][0], -shell.M*far[1][1]],
                [0, *wall[0]]]
        steps = [G*b/4*(1/shell.eta - 1/core.eta),
                 G/4*(shell.M/shell.eta - core.M/core.eta),
                 -G*a/(4*shell.eta)]
        c, d, e = np.linalg.solve(rows, steps)
        self.factors = (c, 0.0), (d, e)

    @staticmethod
    def _terms(m, r):
        """I1 and K1 of r/delta, and their slopes."""
        x = r/m.delta
        return ((iv(1, x), kv(1, x)),
                ((iv(0, x) - iv(1, x)/x)/m.delta,
                 (-kv(0, x) - kv(1, x)/x)/m.delta))

    def _in(self, layer, r):
        m = self.media[layer]
        grow, fall = self._terms(m, r)[0]
        c, d = self.factors[layer]
        return self.G*r/(4*m.eta) + c*grow + (d*fall if d else 0)

    def _lost(self, layer, r):
        """Minus the integral of u', up to a constant."""
        m = self.media[layer]
        c, d = self.factors[layer]
        x = r/m.delta
        return (self.G*r**2/(4*m.eta) + m.factor
                * (c*iv(0, x) - (d*kv(0, x) if d else 0)))

    def omega(self, r):
        """Microrotation [1/s]."""
        return np.where(r < self.b, self._in(0, r), self._in(1, r))

    def u(self, r):
        """Velocity along the axis [m/s]."""
        inner = (self._lost(0, self.b) - self._lost(0, r)
                 + self._lost(1, self.a) - self._lost(1, self.b))
        return np.where(r < self.b, inner,
                        self._lost(1, self.a) - self._lost(1, r))


class SphereFlow:
    """A sphere of radius a at rest in a stream U along x, which does not slip on
    it; omega = 0 there, or the couple if free.

    u_r = U cos(t) A, u_t = -U sin(t) (r^2 A)'/2r with
    A = 1 + c/r^3 + b/r + d k1(kr)/r and omega = U sin(t) (b/2r^2 + e k1(kr)).
    """

    def __init__(self, material, a, U, free=False):
        self.material, self.a, self.U = material, a, U
        m, self.k = material, 1/material.delta
        # omega = b/2r^2 + e k1: (curl u)/2 of the terms, and s of the last
        self.by_e = -4*m.etaC/((m.eta + m.etaC)*self.k**2)
        k1, slope = self._k1(a), self._slope(a)
        if free:
            # M omega,r - 0 omega/r, the couple stress across the surface
            spin = [-1/a**3, slope]
        else:
            spin = [1/(2*a**2), k1]
        # Unknown c, b, e: A(a) = 0, (r^2 A)' = 0 there, spin = 0
        rows = np.array([
            [1/a**3, 1/a, self.by_e*k1/a],
            [-1/a**2, 1, self.by_e*(k1 + a*slope)],
            [0, *spin]])
        self.c, self.b, self.e = np.linalg.solve(rows, [-1, -2*a, 0])

    def _k1(self, r):
        x = self.k*r
        return np.exp(-(x - self.k*self.a))*(1/x + 1/x**2)

    def _slope(self, r):
        x = self.k*r
        return -self.k*np.exp(-(x - self.k*self.a))*(1/x + 2/x**2 + 2/x**3)

    def fields(self, x, y):
        """u_x, u_y [m/s], p [Pa] and omega [1/s] at x along the axis and y
        from it."""
        r = np.hypot(x, y)
        cos, sin = x/r, y/r
        k1 = self._k1(r)
        A = 1 + self.c/r**3 + self.b/r + self.by_e*self.e*k1/r
        # (r^2 A)'/2r
        B = (1 - self.c/(2*r**3) + self.b/(2*r)
             + self.by_e*self.e*(k1 + r*self._slope(r))/(2*r))
        ur, ut = self.U*cos*A, -self.U*sin*B
        p = self.material.eta*self.U*self.b*cos/r**2
        omega = self.U*sin*(self.b/(2*r**2) + self.e*k1)
        return ur*cos - ut*sin, ur*sin + ut*cos, p, omega

    def drag(self):
        """Force along the stream on the sphere [N]."""
        return -4*np.pi*self.material.eta*self.U*self.b

    def over_stokes(self):
        """Drag over 6 pi eta a U."""
        return self.drag()/(6*np.pi*self.material.eta*self.a*self.U)


class ConeFlow:
    """Sink flow of speed C/r^2 towards the tip, in a cone whose walls slip: no
    rotation, no pressure gradient, for every Cosserat medium. The flow is that
    of media whose viscosity follows it, too."""

    def __init__(self, C=1.0):
        self.C = C

    def u(self, x, y):
        """Velocity along the axis and away from it, shape (2, ...)."""
        r3 = np.hypot(x, y)**3
        return -self.C*np.array([x, y])/r3

    def p(self, x, y, n):
        """Pressure [Pa] of a power law, viscosity Gamma^(n - 1), but for a
        constant: p' = tau' + 3 tau/r with tau = sigma_rr + p."""
        C = self.C
        tau = 4*C*(2*np.sqrt(3)*C)**(n - 1)*np.hypot(x, y)**(-3*n)
        return -tau*(1 - n)/n


class ManufacturedAxial(Manufactured):
    """The same around the axis y = 0 of a cylinder 0 < x < 1, y < 1, which is
    in the flow: with stream function y^2 (1 - y^2)^2 sin^2(pi x) the fluid
    rests at all walls; omega is y (1 + sin(pi x)/2), p cos(pi x)(1 - y^2).
    """

    #: No multiple of it is the middle of a cell
    STEP = 4.71e-3

    def __init__(self, first, second):
        super().__init__(lambda x, y: x, lambda x, y: y, first, second)

    def u(self, x, y):
        """Velocity along the axis and away from it [m/s], shape (2, ...)."""
        rest = 1 - y**2
        return np.array([
            2*rest*(1 - 3*y**2)*np.sin(np.pi*x)**2,
            -np.pi*y*rest**2*np.sin(2*np.pi*x)])

    def omega(self, x, y):
        """Microrotation [1/s]."""
        return y*(1 + 0.5*np.sin(np.pi*x))

    def p(self, x, y):
        """Pressure [Pa]."""
        return np.cos(np.pi*x)*(1 - y**2)

    def force(self, x, y):
        """Body force [N/m3] that the linear balance needs, shape (2, ...)."""
        hoop = 2*self._mix("eta")(x, y)*self.u(x, y)[1]/y - self.p(x, y)
        across = [self._stress(i, 1)(x, y) for i in (0, 1)]
        return super().force(x, y) - np.array(
            [across[0]/y, (across[1] - hoop)/y])

    def couple(self, x, y):
        """Body couple [Pa] that the angular balance needs."""
        M = self._mix("M")(x, y)
        slope = self._d(self.omega, 1)(x, y)
        return super().couple(x, y) - M*(slope - self.omega(x, y)/y)/y


def wall_velocity_no_rotation(material, h, sigma):
    """u(h/2) for Omega = 0 and given sigma; [31] where eta = etaC."""
    layer = ShearLayer(material, h, sigma=sigma, Omega=0)
    return layer.u(h/2)


def rayleigh_taylor_growth(ratio, height=0.2, width=0.9142):
    """Rate [1/s] at which the small displacement cos(pi x/width) of the
    interface at a height grows in a box of height 1 m with no slip at the
    bottom and top and free slip at the sides: classical creeping flow of two
    layers, viscosity `ratio` below and 1 Pa s above, 1 N/m3 lighter below.

    In each layer the vertical velocity is (A + B y) cosh ky + (C + D y) sinh ky.
    No velocity at the walls; on the interface both components of velocity and
    the shear stress eta (v'' + k^2 v) are continuous, and the normal stress
    -p + 2 eta v', p = eta (v''' - k^2 v')/k^2, takes the weight of the
    displacement. Gives the 0.01094 of van Keken et al. (1997) at ratio 1."""
    k = np.pi/width

    def derivatives(y):
        """Rows v, v', v'', v''' of the four functions."""
        c, s = np.cosh(k*y), np.sinh(k*y)
        return np.array([
            [c, s, y*c, y*s],
            [k*s, k*c, c + k*y*s, s + k*y*c],
            [k**2*c, k**2*s, 2*k*s + k**2*y*c, 2*k*c + k**2*y*s],
            [k**3*s, k**3*c, 3*k**2*c + k**3*y*s, 3*k**2*s + k**3*y*c]])

    def interface(y, eta):
        """Rows v, v', shear stress, normal stress."""
        v = derivatives(y)
        return np.array([v[0], v[1], eta*(v[2] + k**2*v[0]),
                         2*eta*v[1] - eta/k**2*(v[3] - k**2*v[1])])

    below = interface(height, ratio)
    system = np.zeros((8, 8))
    system[:2, :4] = derivatives(0)[:2]
    system[2:4, 4:] = derivatives(1 - height)[:2]
    system[4:, :4] = below
    system[4:, 4:] = -interface(0, 1)
    solution = np.linalg.solve(system, [0]*7 + [1])
    return below[0] @ solution[:4]


def shear_strain(x, y, rate, time):
    """Shear that a point at (x, y) of the unit square around the origin has
    seen in the flow (rate y, 0) since it was there at time 0 or flowed in by a
    side since: the rate times its age."""
    way = np.where(y > 0, 0.5 + x, 0.5 - x)
    return np.minimum(rate*time, way/np.abs(y))


def err(exact, numeric):
    """Error norm of the paper, [30]."""
    exact, numeric = np.asarray(exact), np.asarray(numeric)
    return np.abs(exact - numeric).sum()/np.abs(numeric).sum()
