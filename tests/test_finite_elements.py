"""The finite elements against analytic solutions, and against themselves."""

import numpy as np
import pytest

from cosserat.analytic import (
    AnnularCouette, GravityChannel, Material, PipeFlow, ShearLayer, SolCx)
from cosserat.references import (RELATIVES, ROUND_SILO, SILO, SILO_SCENES,
                                 Silo)
from cosserat.scenes.relatives import SCENES, RelativeCase, measure
from cosserat.finiteElements import (Flow, Mesh, Wall, between, graded_lines,
                                     lines)
from cosserat.finiteElements.relatives import relative_values
from cosserat.finiteElements.silo import round_rate, silo_rate
from cosserat.finiteElements.yielding import BinghamFlow
from cosserat.yielding import layer_stress

MATERIAL = Material(1.0, 2.0, 0.2)


def at_walls(_x, y):
    """Sides of a layer -1/2 < y < 1/2."""
    return np.abs(np.abs(y) - 0.5) < 1e-9


def anywhere(x, y):
    """All sides."""
    return x + y < np.inf


def layer(walls, moduli=(1, 1, 1), **entries):
    """Periodic layer of the material with factors to its moduli."""
    mesh = Mesh.tensor(np.linspace(0, 1, 4), np.linspace(-0.5, 0.5, 9),
                       periodic=(1, 0))
    m = MATERIAL
    eta, etaC, M = np.array([m.eta, m.etaC, m.M])*moduli
    return Flow(mesh, 4, eta, etaC, M, walls=[walls], **entries)


def layer_error(flow, exact):
    """Largest errors of u and omega, relative."""
    y = flow.xy[:, 1]
    u, omega = exact.u(y), exact.omega(y)
    return max(np.abs(flow.u[:, 0] - u).max()/np.abs(u).max(),
               np.abs(flow.omega - omega).max()/np.abs(omega).max())


@pytest.mark.parametrize("moduli", [(1, 1, 1), (1.01, 1, 1), (1, 1.01, 1),
                                    (1, 1, 1.01)])
def test_layers(moduli):
    """Channel, and layers of given omega and of given couple, to 1e-6; one
    per cent of any modulus spoils it."""
    def top(_x, y):
        return np.sign(y)

    cases = [
        (GravityChannel(MATERIAL, 1, 3.0),
         layer(Wall(at_walls, u=(0, 0), omega=0), moduli, force=(3.0, 0))),
        (ShearLayer(MATERIAL, 1, V=1, Omega=-0.2),
         layer(Wall(at_walls, u=(top, 0), omega=-0.2), moduli)),
        (ShearLayer(MATERIAL, 1, V=1, mu=0.1),
         layer(Wall(at_walls, u=(top, 0), couple=0.1), moduli))]
    for exact, flow in cases:
        error = layer_error(flow, exact)
        assert (error < 1e-6) == (moduli == (1, 1, 1)), error
        assert flow.power() == pytest.approx(flow.dissipation(), rel=1e-9)


def test_layer_of_given_traction():
    """Traction at the upper wall."""
    flow = layer(Wall(lambda x, y: y < -0.49, u=(0, 0), omega=0))
    assert not flow.closed
    flow = Flow(flow.mesh, 4, MATERIAL.eta, MATERIAL.etaC, MATERIAL.M, walls=[
        Wall(lambda x, y: y < -0.49, u=(0, 0), omega=0),
        Wall(lambda x, y: y > 0.49, omega=0, traction=(1, 0))])
    exact = ShearLayer(MATERIAL, 1, sigma=1, Omega=0)
    y = flow.xy[:, 1]
    assert flow.u[:, 0] == pytest.approx(exact.u(y) - exact.u(-0.5), abs=1e-6)
    force, _ = flow.wall_load(lambda x, y: y < -0.49)
    assert force == pytest.approx([-1, 0], abs=1e-9)


@pytest.mark.slow
def test_layer_that_yields():
    """Its limit stress, less what plastic viscosity and small rate add."""
    mesh = Mesh.tensor(np.linspace(0, 1, 4), np.linspace(-0.5, 0.5, 25),
                       periodic=(1, 0))
    flow = BinghamFlow(mesh, 3, tauY=1, eps=1e-4, eta=1e-4, etaC=1e-4, M=2e-6,
                       walls=[Wall(at_walls, u=(lambda x, y: y, 0), omega=0)])
    force, _ = flow.wall_load(lambda x, y: y > 0.49)
    assert force[0] == pytest.approx(layer_stress(10), rel=1e-3)


def circle(r):
    """Curve of angle."""
    return lambda s: (r*np.cos(s), r*np.sin(s))


@pytest.mark.parametrize("R", [0.1, 0.3])
def test_pipe(R):
    """Around an axis: its rate, and the power of the force."""
    m = Material(1.0, 1.0, R)
    mesh = Mesh.tensor(np.linspace(0, 1, 9), np.linspace(0, 0.4, 4),
                       periodic=(0, 0.4))
    walls = [Wall(lambda x, y: x < 1e-6, normal=0, omega=0),
             Wall(lambda x, y: x > 1 - 1e-6, u=(0, 0), omega=0)]
    flow, other = (Flow(mesh, 4, m.eta, m.etaC, M, force=(0, 1), walls=walls,
                        axial=True) for M in (m.M, 1.01*m.M))
    exact = PipeFlow(m, 1, 1)
    rate = -2*np.pi*flow.flux((0, 0), (1, 0))
    assert rate == pytest.approx(exact.rate(), rel=1e-7)
    assert flow.power() == pytest.approx(flow.dissipation(), rel=1e-8)
    assert flow.power()*2*np.pi/0.4 == pytest.approx(exact.rate(), rel=1e-7)
    assert abs(other.flux((0, 0), (1, 0))*2*np.pi/exact.rate() + 1) > 1e-4


def test_annulus():
    """Turning cylinders: order of the elements, on curved sides."""
    exact = AnnularCouette(MATERIAL, (1, 2), (1, -0.3), (0.2, 0))
    walls = [
        Wall(lambda x, y: np.hypot(x, y) < 1.1, u=lambda x, y: (-y, x),
             omega=0.2),
        Wall(lambda x, y: np.hypot(x, y) > 1.9,
             u=lambda x, y: (0.15*y, -0.15*x), omega=0)]
    errors = []
    for n in (2, 4):
        mesh = Mesh([(np.linspace(0, 2*np.pi, 4*n + 1),
                      np.linspace(0, 1, n + 1),
                      between(circle(2), circle(1)))])
        m = MATERIAL
        flow = Flow(mesh, 3, m.eta, m.etaC, m.M, walls=walls)
        r = np.hypot(*flow.xy.T)
        u = (flow.xy[:, 0]*flow.u[:, 1] - flow.xy[:, 1]*flow.u[:, 0])/r
        errors.append([np.abs(u - exact.u(r)).max(),
                       np.abs(flow.omega - exact.omega(r)).max()])
    assert np.log2(errors[0])[0] - np.log2(errors[1])[0] > 3.5
    assert max(errors[1]) < 2e-4


def test_curved_free_slip():
    """Between cylinders of free slip that give omega alone the medium turns as
    if rigid."""
    mesh = Mesh([(np.linspace(0, 2*np.pi, 13), np.linspace(0, 1, 3),
                  between(circle(2), circle(1)))])
    m = MATERIAL
    flow = Flow(mesh, 4, m.eta, m.etaC, m.M, walls=[
        Wall(anywhere, normal=0, omega=0.7)])
    x, y = flow.xy.T
    assert flow.u[:, 0] == pytest.approx(-0.7*y, abs=1e-5)
    assert flow.u[:, 1] == pytest.approx(0.7*x, abs=1e-5)
    assert flow.dissipation() < 1e-7


def disc(degree, n=4, radius=0.25):
    """Disc that falls with unit speed in a box of half-width 1: four blocks
    around it."""
    blocks = []
    for quarter in range(4):
        c, s = np.cos(quarter*np.pi/2), np.sin(quarter*np.pi/2)

        def turned(x, y, c=c, s=s):
            return c*x - s*y, s*x + c*y

        def arc(t, turned=turned):
            return turned(radius*np.cos(t*np.pi/4), radius*np.sin(t*np.pi/4))

        def side(t, turned=turned):
            return turned(1 + 0*t, t)

        blocks.append((np.linspace(-1, 1, 2*n + 1),
                       np.linspace(0, 1, n + 1)**1.3, between(side, arc)))
    m = MATERIAL
    return Flow(Mesh(blocks), degree, m.eta, m.etaC, m.M, walls=[
        Wall(anywhere, u=(0, 0), omega=0), Wall(at_disc, u=(0, -1), omega=0)])


def at_disc(x, y):
    """Sides of the disc."""
    return np.hypot(x, y) < 0.3


@pytest.mark.slow
def test_blocks():
    """Blocks around a disc: two degrees give the same drag, whose power is
    dissipated; what it pushes away passes beside it."""
    flow, finer = disc(3), disc(4)
    force, _ = flow.wall_load(at_disc)
    assert force[1] == pytest.approx(finer.wall_load(at_disc)[0][1], rel=1e-3)
    assert -force[1] == pytest.approx(flow.dissipation(), rel=1e-9)
    assert abs(force[0]) < 1e-9
    assert flow.flux((0.25, 0), (1, 0)) == pytest.approx(-0.25, rel=1e-9)


def turned_corner(angle, graded):
    """Flow around the corner of an L with free slip, turned by an angle."""
    c, s = np.cos(angle), np.sin(angle)
    x = lines([-1, 0, 1], 0.5)
    mesh = Mesh([(x, x, lambda x, y: (c*x - s*y, s*x + c*y))],
                keep=lambda x, y: (c*x + s*y < 0) | (c*y - s*x > 0))
    if graded:
        mesh.grade([(0, 0)], 1e-6)
    flow = Flow(mesh, 3, 1.0, 2.0, 0.1, walls=[
        Wall(anywhere, normal=0)],
        smooth=lambda x, y: (-s*(c*x + s*y), c*(c*x + s*y)))
    return flow.flux((-c/2, -s/2), (-c, -s))


def test_slanted_free_slip():
    """The same flow whatever way the scene is turned; graded or not it is
    not."""
    plain = turned_corner(0.0, True)
    assert abs(plain) > 1e-3
    assert turned_corner(0.4, True) == pytest.approx(plain, rel=1e-7)
    assert turned_corner(2.1, True) == pytest.approx(plain, rel=1e-7)
    assert abs(turned_corner(0.4, False)/plain - 1) > 1e-3


def test_jump_of_viscosity():
    """SolCx with a jump of 1e6: order of u, and the jump of p."""
    exact = SolCx((1.0, 1e6))
    errors = []
    for n in (4, 8):
        x = np.linspace(-0.5, 0.5, n + 1)
        flow = Flow(Mesh.tensor(x, x), 3,
                    eta=lambda x, y: np.where(x < 0, 1.0, 1e6),
                    smooth=lambda x, y: tuple(exact.force(x, y)),
                    walls=[Wall(anywhere, normal=0)])
        u = exact.u(*flow.xy.T).T
        errors.append(np.sqrt(np.mean((flow.u - u)**2))/np.abs(u).max())
    assert np.log2(errors[0]/errors[1]) > 3.3
    assert (flow.at(0.2, 0.3)[3] - flow.at(-0.2, -0.1)[3] == pytest.approx(
        float(exact.p(0.2, 0.3) - exact.p(-0.2, -0.1)), rel=2e-3))


def test_omega_only_where_it_is():
    """No couple across to a medium without etaC; its omega is no number."""
    x = lines([-0.5, 0, 0.5], 0.25)
    flow = Flow(Mesh.tensor(x, x), 3, 1.0,
                etaC=lambda x, y: np.where(y < 0, 1.0, 0.0),
                M=lambda x, y: np.where(y < 0, 0.1, 0.0),
                walls=[Wall(at_walls, u=(lambda x, y: 2*y, 0)),
                       Wall(lambda x, y: np.abs(x) > 0.49,
                            u=(lambda x, y: 2*y, 0))])
    # Simple shear with s = 0
    assert flow.at(0.1, -0.2)[2] == pytest.approx(-1, abs=1e-9)
    assert np.isnan(flow.at(0.1, 0.2)[2])
    assert np.isnan(flow.omega[flow.xy[:, 1] > 0.01]).all()


def test_graded_lines():
    """Distances fall towards the points, and only there."""
    x = graded_lines([0, 1, 2], 0.5, [1], 1e-3)
    assert np.diff(x).min() < 1e-3 < 0.3**-1*np.diff(x).min()
    assert {0.0, 0.5, 1.0, 1.5, 2.0} <= set(x)
    assert np.diff(x)[0] == 0.5


@pytest.mark.slow
@pytest.mark.parametrize("name", ["start, 0", "start, 2/3",
                                  "one viscosity, 2/3"])
def test_silo(name):
    """Elements of third degree have the reference flow rates to half a per
    cent, without the innermost rings of the contact."""
    rate = silo_rate(SILO_SCENES[name], 3, contact=1e-40)
    assert rate == pytest.approx(SILO[name].value, rel=5e-3)


@pytest.mark.slow
def test_round_silo():
    """Its rate, by fewer rings and a lower degree."""
    assert round_rate(SILO_SCENES["start, 2/3"], contact=1e-40) == (
        pytest.approx(ROUND_SILO[2/3].value, rel=2.6e-3))


@pytest.mark.slow
def test_viscosity_of_the_silo_tells(monkeypatch):
    """One per cent of it spoils the flow rate."""
    monkeypatch.setattr(Silo, "ETA", 1.01*Silo.ETA)
    rate = silo_rate(SILO_SCENES["start, 0"], 3, contact=1e-40)
    assert rate != pytest.approx(SILO["start, 0"].value, rel=5e-3)


@pytest.mark.parametrize("name", ["slip starts", "inlet, Cosserat",
                                  "plate 1/8, slip", "rotation held"])
def test_relatives(name):
    """Elements of third degree have the other reference numbers."""
    for quantity, value in relative_values(SCENES[name], degree=3,
                                           smallest=1e-8).items():
        assert value == pytest.approx(RELATIVES[name, quantity].value,
                                      rel=2e-3)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["slip starts", "column, no slip"])
def test_solver_tends_to_the_references(tmp_path, name):
    """The flow solver's error falls with the cells."""
    errors = []
    for cells in (8, 32):
        case = RelativeCase(tmp_path/f"{cells}", SCENES[name], cells).write()
        case.run("cosseratPicFoam")
        value = measure(case, SCENES[name], cells)["flux"]
        errors.append(abs(value/RELATIVES[name, "flux"].value - 1))
    assert errors[1] < 0.5*errors[0] < 0.1
