"""Flows around an axis of which the solution is known: rows of errors, on
wedges of their own."""

import numpy as np

from cosserat.analytic import (ConeFlow, LayeredPipe, ManufacturedAxial,
                               Material, PipeFlow, SphereFlow)
from cosserat.case import residuals
from cosserat.scenes.axial import AxialCase
from cosserat.scenes.box import add_points

STILL = ("type noSlip;", "type zeroGradient;",
         "type fixedValue; value uniform 0;")
FREE = ("type noSlip;", "type zeroGradient;", "type zeroGradient;")
SLIP = ("type slip;", "type zeroGradient;", "type zeroGradient;")

#: A region of points
ALL = "{ type all; material a; }"

#: The material in cones
COSSERAT = Material(1.0, 1.0, 0.3)

#: Materials of the manufactured solution
MIXED = {"a": Material(1.0, 2.0, 0.2), "b": Material(3.0, 1.0, 0.4)}


def entries(material, **others):
    """Entries of a law constant."""
    return {"eta": material.eta, "etaC": material.etaC, "R": material.R,
            **others}


def row(test, case, errors, value, reference, **parameters):
    """Row of a study."""
    return {"test": test, "parameters": parameters, **errors, "value": value,
            "reference": reference, "error": value/reference - 1,
            "iterations": residuals(case.log())[0][3]}


def pipe(path, n, R, etaC=1.0, free=False, **options):
    """Rate of a periodic pipe of n cells along the radius, over Poiseuille's."""
    material = Material(1.0, etaC, R)
    exact = PipeFlow(material, 1.0, 1.0, free)
    case = AxialCase(path, lambda s, t: (0.2*s, t), (2, n),
                     {"top": FREE if free else STILL},
                     {"a": entries(material, rho=1)}, cyclic=True,
                     g=(1, 0, 0), **options)
    errors = case.solve_and_compare(lambda x, y: (exact.u(y), 0*y),
                                    lambda x, y: exact.omega(y))
    rate = (case.volumes()*case.field("U")[:, 0]).sum()*case.to_circle/0.2
    return row("pipe", case, errors, rate*8/np.pi, exact.over_poiseuille(),
               R=R, etaC=etaC, wall="free" if free else "rough")


def core(path, n, R=0.3):
    """Speed in the middle of a pipe with a core of three times the viscosity."""
    media = Material(3.0, 1.0, R), Material(1.0, 1.0, R)
    exact = LayeredPipe(*media, 0.5, 1.0, 1.0)
    case = AxialCase(path, lambda s, t: (0.2*s, t), (2, n), {"top": STILL},
                     {name: entries(m, rho=1)
                      for name, m in zip("ab", media)}, cyclic=True,
                     g=(1, 0, 0), fractions=lambda x, y: (y < 0.5)*1.0)
    errors = case.solve_and_compare(lambda x, y: (exact.u(y), 0*y),
                                    lambda x, y: exact.omega(y))
    middle = case.middles()[1].argmin()
    return row("core", case, errors, case.field("U")[middle, 0],
               exact.u(case.middles()[1])[middle], R=R)


def sphere(path, n, R, free=False, ratio=4.0):
    """Drag of a sphere in a body-fitted mesh of 2n x n cells, with the exact
    flow at `ratio` radii, over Stokes'."""
    material = Material(1.0, 1.0, R)
    exact = SphereFlow(material, 1.0, 1.0, free)

    def shape(s, t):
        angle, r = np.pi*(1 - s), ratio**t
        return (r*np.cos(angle),
                np.where((s == 0) | (s == 1), 0, r*np.sin(angle)))

    def part(i):
        return lambda x, y: exact.fields(x, y)[i]

    case = AxialCase(
        path, shape, (2*n, n),
        {"bottom": FREE if free else STILL,
         "top": (lambda x, y: np.array(exact.fields(x, y)[:2]),
                 "type zeroGradient;", part(3))},
        {"a": entries(material)})
    errors = case.solve_and_compare(
        lambda x, y: exact.fields(x, y)[:2], part(3), part(2))
    drag = case.table("load", "wallLoad_bottom.dat")[-1][1]
    return row("sphere", case, errors, drag/(6*np.pi), exact.over_stokes(),
               R=R, wall="free" if free else "rough")


def points_sphere(path, n, R, stiffness=1e4):
    """Drag of a sphere of stiff points in n cells a radius, which its weight
    holds in the exact flow at 3 radii, over Stokes'. It stays where it is but for
    the error, a speed over that of the flow."""
    material = Material(1.0, 1.0, R)
    exact = SphereFlow(material, 1.0, 1.0)

    def given(x, y):
        return np.array(exact.fields(x, y)[:2])

    side = (given, "type zeroGradient;", lambda x, y: exact.fields(x, y)[3])
    case = AxialCase(
        path, lambda s, t: (6*s - 3, 3*t), (6*n, 3*n),
        dict.fromkeys(("left", "right", "top"), side),
        {"a": entries(material),
         "b": {"eta": stiffness, "etaC": stiffness, "R": R,
               "rho": 4.5*exact.over_stokes()}},
        g=(-1, 0, 0), tolerance=1e-7, average="layered")
    add_points(case, ALL + " { type disc; material b; centre (0 0 0);"
               " radius 1; }", inflow="{ left { material a; }"
               " top { material a; } right { material a; } }")
    case.run("cosseratPicFoam")
    time = case.times()[0]
    part, V = case.field("alpha.b", time), case.volumes()
    inside = V*(part > 0.999)
    speed = (inside*case.field("U", time)[:, 0]).sum()/inside.sum()
    weight = (V*part).sum()*case.to_circle/(4/3*np.pi)
    return row("pointsSphere", case, {"cells": len(V)},
               exact.over_stokes()*weight/(1 - speed), exact.over_stokes(), R=R)


def cone_case(path, n, half, material, **options):
    """A cone of n x n/2 cells, half its angle in degrees, with the sink flow
    given at both ends and a wall that slips."""
    def shape(s, t):
        angle = np.radians(half)*t
        return ((1 + s)*np.cos(angle),
                np.where(t == 0, 0, (1 + s)*np.sin(angle)))

    given = (ConeFlow().u, *STILL[1:])
    return AxialCase(path, shape, (n, n//2),
                     {"left": given, "right": given, "top": SLIP},
                     {"a": material}, tolerance=1e-8, **options)


def cone(path, n, half=25.0, power=None):
    """Sink flow in a cone with walls that slip; the value is the largest
    difference of pressures over that of the viscous stress, which is zero; of a
    power law it is the error of the pressure over its difference."""
    exact = ConeFlow()

    case = cone_case(
        path, n, half, entries(COSSERAT) if power is None else {
            "law": "powerLaw", "coeffs": f"K 1; n {power}; eps 1e-8;"
            " etaCRatio 0; R 0; B infinite;"})
    errors = case.solve_and_compare(exact.u)
    if power is not None:
        p = exact.p(*case.middles(), power)
        off = case.field("p") - p
        spread = np.abs(off - np.average(off, weights=case.volumes())).max()
        return {**errors, "errP": spread/np.ptp(p)}
    # 2 eta u_r,r at the narrow end
    spread = np.ptp(case.field("p"))/4
    return row("cone", case, errors, 1 + spread, 1.0, half=half)


def conical(path, n, half=25.0, end=0.3, **options):
    """The same with points, of which 25 are followed for a time [s]."""
    case = cone_case(path, n, half, entries(COSSERAT), **options)
    add_points(case, ALL, minPointsPerCell=1)
    steps = 10*n//8
    case.step(end/steps, steps)
    r, angle = np.meshgrid(np.linspace(1.2, 1.9, 5),
                           np.radians([0.5, 3, 8, 15, 23]))
    places = " ".join(f"({x:.6g} {y:.6g} 0)" for x, y in zip(
        (r*np.cos(angle)).ravel(), (r*np.sin(angle)).ravel()))
    case.measure("t", "pointTracers", f"places ({places});")
    return case


def off_the_ways(case, C=1.0):
    """How far points in a cone are from the ways in a sink of strength C: the
    cube of the distance from the tip falls evenly, the angle [degrees] stays."""
    off = []
    for file in case.path.glob("postProcessing/t/0/tracer[0-9]*.dat"):
        t, x, y = np.loadtxt(file).T[:3]
        cube, angle = np.hypot(x, y)**3, np.degrees(np.arctan2(y, x))
        off.append((np.abs(cube - cube[0] + 3*C*t).max(),
                    np.abs(angle - angle[0]).max()))
    return np.max(off, axis=0)


def narrows(x):
    """Radius of a pipe of length 3 that narrows from 1 to 0.6 in its middle."""
    return 1 - 0.2*(1 - np.cos(np.pi*np.clip(x - 1, 0, 1)))


def narrowing_pipe(path, n, steps, co=0.5, run=True, triangles=False,
                   **points):
    """Points in a flow through that pipe, along its wall, 1 m/s at the start,
    3n x n cells; entries of materialPointsProperties."""
    enter = ("type fixedValue; value uniform (1 0 0);", *STILL[1:])
    leave = ("type zeroGradient;", "type fixedValue; value uniform 0;",
             "type zeroGradient;")
    case = AxialCase(path, lambda s, t: (3*s, t*narrows(3*s)), (3*n, n),
                     {"left": enter, "right": leave, "top": SLIP},
                     {"a": entries(Material(1.0, 1.0, 0.1))},
                     triangles=triangles)
    add_points(case, ALL, **points)
    case.step(co/n/2.8, steps)
    if run:
        case.run("cosseratPicFoam")
    return case


def manufactured(path, n, wavy=False, tolerance=1e-8, triangles=False):
    """A made-up flow of varying materials with the axis in it, on n x n cells,
    straight or wavy, or halved; the value is that of the velocity's norm."""
    exact = ManufacturedAxial(*MIXED.values())
    wave = 0.06*wavy

    def shape(s, t):
        return (s + wave*np.sin(2*np.pi*t)*np.sin(np.pi*s),
                np.where(t == 0, 0, t + wave*np.sin(2*np.pi*s)
                         * np.sin(np.pi*t)))

    wall = ("type noSlip;", "type zeroGradient;", exact.omega)
    case = AxialCase(path, shape, (n, n),
                     {"left": wall, "right": wall, "top": wall},
                     {name: entries(m) for name, m in MIXED.items()},
                     fractions=exact.alpha, force=exact.force,
                     couple=exact.couple, tolerance=tolerance,
                     triangles=triangles)
    errors = case.solve_and_compare(exact.u, exact.omega, exact.p)
    V = case.volumes()

    def norm(u):
        return np.sqrt((V*(np.asarray(u)**2).sum(axis=0)).sum())

    return row("manufactured", case, errors, norm(case.field("U")[:, :2].T),
               norm(exact.u(*case.middles())),
               mesh="triangles" if triangles else "wavy" if wavy
               else "straight")
