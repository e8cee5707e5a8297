"""Singular creeping flow in a wedge between two walls (docs/corners.md, section 1): the
exponents lambda of u ~ r^lambda.

Written apart from the solver's own (cornerFlow.C), as a check of it: all
conditions of all sectors at once, zeros of the smallest singular value.
"""

import numpy as np
from scipy.optimize import minimize_scalar

#: Exponents looked for, and points of the search
RANGE, POINTS = (1e-3, 0.97), 1200


def _rows(exponent, angle, eta, eta_c):
    """u_r, u_theta, sigma_tt, sigma_tr at r = 1 by the four coefficients of
    F = a cos pt + b sin pt + c cos qt + d sin qt, p, q = lambda + 1, lambda - 1,
    where psi = r^(lambda + 1) F."""
    wave = np.array([exponent + 1, exponent - 1]).repeat(2)
    even, odd = np.cos(wave*angle), np.sin(wave*angle)
    sine = np.array([False, True, False, True])
    F = np.where(sine, odd, even)
    F1 = wave*np.where(sine, even, -odd)
    F2, F3 = -wave**2*F, -wave**2*F1
    mu = eta + eta_c
    pressure = mu*((exponent + 1)**2*F1 + F3)/(exponent - 1)
    return np.array([
        F1, -(exponent + 1)*F, -pressure - 2*eta*exponent*F1,
        mu*(F2 + (exponent + 1)*F)
        - (eta - eta_c)*(exponent + 1)*exponent*F])


def _matrix(exponent, sectors, holds):
    """Conditions of walls and interfaces by the coefficients of all sectors;
    sectors: (angle of the end, eta, etaC)."""
    n = len(sectors)
    rows = []

    def row(*parts):
        full = np.zeros(4*n)
        for sector, values in parts:
            full[4*sector:4*sector + 4] = values
        rows.append(full/max(np.abs(full).max(), 1e-300))

    for sector, angle, held in ((0, 0.0, holds[0]),
                                (n - 1, sectors[-1][0], holds[1])):
        state = _rows(exponent, angle, *sectors[sector][1:])
        row((sector, state[1]))
        row((sector, state[0 if held else 3]))
    for sector in range(n - 1):
        angle = sectors[sector][0]
        here = _rows(exponent, angle, *sectors[sector][1:])
        there = _rows(exponent, angle, *sectors[sector + 1][1:])
        for a, b in zip(here, there):
            row((sector, a), (sector + 1, -b))
    return np.array(rows)


def solutions(sectors, holds=(False, False)):
    """Exponents lambda in 0.001 to 0.97, a double one twice, and coefficients
    of F of each by sector.

    sectors: (angle of the end [rad], eta, etaC) from the first wall on; holds:
    does a wall hold the fluid (no slip) or let it slip. Microrotation is taken
    as smooth: r << R."""
    def decompose(exponent):
        return np.linalg.svd(_matrix(exponent, sectors, holds))[1:]

    grid = np.unique(np.r_[np.linspace(*RANGE, POINTS),
                           np.geomspace(RANGE[0], 0.1, POINTS//4)])
    least = np.array([decompose(x)[0][-1] for x in grid])
    found = []
    for i, (a, middle, b) in enumerate(zip(least, least[1:], least[2:])):
        if middle < a and middle <= b:
            best = minimize_scalar(
                lambda x: decompose(x)[0][-1], bounds=(grid[i], grid[i + 2]),
                method="bounded", options={"xatol": 1e-12}).x
            singular, vectors = decompose(best)
            if singular[-1] < 1e-7:
                double = singular[-2] < 1e-5
                found += [(best, vector.reshape(-1, 4))
                          for vector in vectors[-2 if double else -1:]]
    return found


def exponents(sectors, holds=(False, False)):
    """Exponents of solutions()."""
    return [exponent for exponent, _ in solutions(sectors, holds)]


def flow(solution, sectors, x, y):
    """Velocity (u, v), pressure and stream function of a solution at places
    x, y in the wedge, whose first wall is the axis x > 0."""
    exponent, coefficients = solution
    r, angle = np.hypot(x, y), np.mod(np.arctan2(y, x), 2*np.pi)
    which = np.minimum(np.searchsorted([end for end, _, _ in sectors], angle),
                       len(sectors) - 1)
    ur, ut, p, psi = np.zeros((4, *np.shape(x)))
    for sector, (_, eta, eta_c) in enumerate(sectors):
        for place in zip(*np.nonzero(which == sector)):
            a = angle[place]
            state = _rows(exponent, a, eta, eta_c) @ coefficients[sector]
            power = r[place]**exponent
            ur[place], ut[place] = power*state[:2]
            p[place] = power/r[place]*(-state[2] - 2*eta*exponent*state[0])
            psi[place] = -power*r[place]*state[1]/(exponent + 1)
    return (ur*np.cos(angle) - ut*np.sin(angle),
            ur*np.sin(angle) + ut*np.cos(angle), p, psi)
