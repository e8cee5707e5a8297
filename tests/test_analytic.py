"""The analytic solutions satisfy the equations that they stand for."""

import numpy as np
import pytest

from cosserat.analytic import (AnnularCouette, EccentricCylinders,
                               GravityChannel, Material, RigidShear,
                               ShearLayer, granular_contact,
                               wall_velocity_no_rotation)

MATERIALS = [Material(1, 1, 0.3), Material(2, 0.5, 0.1), Material(1, 7, 0.4)]
CASES = [{"V": 1, "Omega": 0.3}, {"sigma": 2, "Omega": -0.2},
         {"V": 1, "mu": 0.1}, {"sigma": 1, "mu": -0.2}]
Y = np.linspace(-0.5, 0.5, 4001)


def derivative(values):
    """Central differences of fourth order, inner points."""
    h = Y[1] - Y[0]
    return (values[:-4] - 8*values[1:-3] + 8*values[3:-1] - values[4:])/(12*h)


def equations(material, solution):
    """(shear stress, residual of the moment balance) on inner points."""
    m = material
    du = derivative(solution.u(Y))
    dw = derivative(solution.omega(Y))
    omega = solution.omega(Y)[2:-2]
    stress = (m.eta + m.etaC)*du + 2*m.etaC*omega
    h = Y[1] - Y[0]
    moment = (m.M*(dw[2:] - dw[:-2])/(2*h)
              - 4*m.etaC*omega[1:-1] - 2*m.etaC*du[1:-1])
    return stress, moment


@pytest.mark.parametrize("material", MATERIALS)
@pytest.mark.parametrize("given", CASES)
def test_shear_layer(material, given):
    """Constant stress, moment balance and what is given at the walls."""
    layer = ShearLayer(material, 1, **given)
    stress, moment = equations(material, layer)
    scale = np.abs(stress).max()
    assert np.ptp(stress) < 1e-8*scale
    assert np.abs(moment).max() < 1e-5*scale
    assert np.isclose(layer.a, stress.mean(), rtol=1e-8)

    wall = {"V": layer.u(0.5), "Omega": layer.omega(0.5), "sigma": layer.a,
            "mu": layer.couple_stress(0.5)}
    for name, value in given.items():
        assert np.isclose(wall[name], value, rtol=1e-10)


@pytest.mark.parametrize("material", MATERIALS)
def test_gravity_channel(material):
    """The stress falls by G along y; no velocity, no rotation at the walls."""
    channel = GravityChannel(material, 1, 3)
    stress, moment = equations(material, channel)
    assert np.allclose(np.diff(stress), -3*(Y[1] - Y[0]), rtol=1e-4)
    assert np.abs(moment).max() < 1e-5*np.abs(stress).max()
    assert np.allclose([channel.u(0.5), channel.u(-0.5), channel.omega(0.5)],
                       0, atol=1e-12)


def test_classical_where_rotation_fits():
    """k = -sigma/(2 eta Omega) = 1 is the classical solution, b = 0."""
    layer = ShearLayer(MATERIALS[0], 1, sigma=1, Omega=-0.5)
    assert abs(layer.b) < 1e-15
    assert np.allclose(layer.u(Y), Y)


def test_equation_31():
    """Wall velocity for eta = etaC and its limits, 1 and 1/2."""
    for R in (1e-3, 0.3, 100):
        expected = 0.5*(1 - R*np.tanh(1/(2*R)))
        found = wall_velocity_no_rotation(Material(1, 1, R), 1, 1.0)
        assert np.isclose(found, expected, rtol=1e-9)
    assert np.isclose(wall_velocity_no_rotation(Material(1, 1, 100), 1, 1.0),
                      0.25, rtol=1e-4)


def test_granular_contact():
    """The paper's constants give eta = etaC = 2e5/pi MPa s."""
    eta, etaC, B = granular_contact(0, 4, 1e11, 1e11)
    assert np.allclose([eta, etaC, B], 2e11/np.pi, rtol=1e-14)


def test_rigid_shear():
    """Both balances, walls without flow through them or traction along them,
    and a density that the flow does not change."""
    h = 1e-3
    x, y = np.random.default_rng(1).uniform(-0.5, 0.5, (2, 200))

    def d(f, i, x=x, y=y):
        step = h*np.eye(2)[i]
        return (f(x + step[0], y + step[1])
                - f(x - step[0], y - step[1]))/(2*h)

    def laplacian(f):
        return sum(f(x + h*a, y + h*b) - f(x, y)
                   for a, b in ((1, 0), (-1, 0), (0, 1), (0, -1)))/h**2

    exact = RigidShear()
    du, dv = [np.array([d(lambda x, y, k=k: exact.u(x, y)[k], i)
                        for i in (0, 1)]) for k in (0, 1)]
    assert np.allclose(du[0] + dv[1], 0, atol=1e-9)
    for i in (0, 1):
        balance = (laplacian(lambda x, y, i=i: exact.u(x, y)[i])
                   - d(exact.p, i) + exact.force(x, y)[i])
        assert np.abs(balance).max() < 1e-3
    assert np.allclose(du[1] + dv[0], 0, atol=1e-9)
    assert np.allclose(exact.u(0.5 + 0*y, y)[0], 0, atol=1e-12)
    assert np.allclose(exact.u(x, 0.5 + 0*x)[1], 0, atol=1e-12)
    flux = exact.u(x, y)*np.array([d(exact.density, i) for i in (0, 1)])
    assert np.allclose(flux.sum(axis=0), 0, atol=1e-5)


def test_torque_of_eccentric_cylinders():
    """On one axis the torque is 4 pi eta a^2 b^2/(b^2 - a^2); in a thin gap
    c = b - a with e = x c it is that of Sommerfeld's journal bearing (1904),
    4 pi eta a^3/c (1 + 2 x^2)/((2 + x^2) sqrt(1 - x^2)), up to c/a; and it is
    the moment of the shear stress on any circle around the inner cylinder."""
    assert np.isclose(EccentricCylinders(1, 2, 0).torque(3), 16*np.pi)

    c, x = 2e-3, 0.5
    thin = 4*np.pi/c*(1 + 2*x**2)/((2 + x**2)*np.sqrt(1 - x**2))
    assert np.isclose(EccentricCylinders(1, 1 + c, x*c).torque(1), thin,
                      rtol=2*c)

    flow = EccentricCylinders(1, 2, 0.5)
    angle = np.linspace(0, 2*np.pi, 200, endpoint=False)
    direction = np.array([-np.sin(angle), np.cos(angle)])

    def turning(r):
        """u_angle/r on the circle of radius r."""
        u = flow.u(0.5 + r*np.cos(angle), r*np.sin(angle))
        return (u*direction).sum(axis=0)/r

    # The derivative of u_r along the circle has no mean
    stress = 1.2*(turning(1.2 + 1e-4) - turning(1.2 - 1e-4))/2e-4
    moment = 2*np.pi*1.2**2*stress.mean()
    assert np.isclose(-moment, flow.torque(1), rtol=1e-6)


def laplacian(f, x, y, h):
    """By the five points at a distance h."""
    return (f(x + h, y) + f(x - h, y) + f(x, y + h) + f(x, y - h)
            - 4*f(x, y))/h**2


@pytest.mark.slow
def test_eccentric_cylinders_with_microrotation():
    """On one axis the annular Couette flow; beside it the walls are met and
    both balances hold: M div grad omega = 4 etaC omega - 2 etaC curl u, and
    (eta + etaC) curl u - 2 etaC omega is harmonic."""
    m = Material(2, 3, 0.3)
    x = np.linspace(1, 2, 9)
    ring = AnnularCouette(m, (1, 2), (1, 0), (1, 0))
    flow = EccentricCylinders(1, 2, 0, material=m)
    assert np.allclose(flow.u(x, 0*x)[1], ring.u(x), atol=1e-10)
    assert np.allclose(flow.omega(x, 0*x), ring.omega(x), atol=1e-10)
    assert np.isclose(flow.torque(m.eta), ring.torque, rtol=1e-9)

    flow, h = EccentricCylinders(1, 2, 0.5, material=m), 2e-3
    assert flow.residual < 1e-10

    def curl(x, y):
        return (flow.u(x + h, y)[1] - flow.u(x - h, y)[1]
                - flow.u(x, y + h)[0] + flow.u(x, y - h)[0])/(2*h)

    def harmonic(x, y):
        return (m.eta + m.etaC)*curl(x, y) - 2*m.etaC*flow.omega(x, y)

    x, y = np.array([-1.2, 0.3, 1.7]), np.array([0.4, 1.4, -0.2])
    couple = 4*m.etaC*flow.omega(x, y)
    assert np.allclose(m.M*laplacian(flow.omega, x, y, h),
                       couple - 2*m.etaC*curl(x, y),
                       atol=1e-5*np.abs(couple).max())
    assert np.abs(laplacian(harmonic, x, y, 0.02)).max() < 1e-3*np.abs(
        laplacian(curl, x, y, 0.02)).max()
