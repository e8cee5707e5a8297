"""Media side by side that have a formula: SolCx, layers along a box and
across its cells, a channel of columns.

Of the scenes of cosserat.scenes.jumps; see there for units.
"""

import numpy as np

from cosserat.scenes import regions
from cosserat.analytic import Layers, Material, SolCx
from cosserat.scenes.bodies import media
from cosserat.scenes.box import Box
from cosserat.results import against, l2

HELD = "type fixedValue; value uniform 0;"

#: Internal length of the layers [m], and cells along them
R, ALONG = 0.1, 4

#: The interface of `tilted` goes this way; it passes (0, 0.03)
TILT, OFFSET = np.arctan(0.5), 0.03
RISE = 2*np.tan(TILT)

RIGHT = regions.box((0, -1), (1, 1))
UPPER = regions.box((-1, 0), (1, 1))
MIDDLE = regions.box((-1, -0.25), (1, 0.25))
OVER = regions.polygon([(-2, OFFSET - RISE), (2, OFFSET + RISE), (2, 2),
                        (-2, 2)])


def solCx_box(path, contrast, cells, **entries):
    """Its right half is `first`."""
    right = regions.within(cells, 0, 1)
    return Box(path, n=cells, force=SolCx((1.0, contrast)).force,
               materials=media(contrast, rho=0),
               fractions=lambda x, y: right(x) + 0*y, **entries)


def measure_solCx(case, contrast, cells):
    """v_rms, and errors of u and p; of p without cells that the jump cuts,
    and further than 0.1 from it."""
    exact = SolCx((1.0, contrast))
    x, y = case.centres()[:, :2].T
    U, p = case.field("U")[:, :2].T, case.field("p")
    whole = np.abs(x) > 0.499/cells
    true = exact.p(x, y)
    return {"v_rms": against(np.sqrt((U**2).sum(axis=0).mean()),
                             exact.v_rms),
            "u": l2(U, exact.u(x, y)),
            "p": l2(p - p.mean(), true, whole),
            "pAway": l2(p - p.mean(), true, np.abs(x) > 0.1)}


def layers(contrast):
    """Couette flow of two, the upper one stiff."""
    return Layers([Material(1, 1, R), Material(contrast, contrast, R)],
                  (-0.5, 0, 0.5), velocity=(-0.5, 0.5))


def layers_box(path, contrast, cells, **entries):
    """Strip of the two layers."""
    upper = regions.within(cells, 0, 1)
    walls = {side: (f"type fixedValue; value uniform ({u} 0 0);", HELD)
             for side, u in (("bottom", -0.5), ("top", 0.5))}
    return Box(path, n=cells, xmin=0.5 - ALONG/cells, cyclic=True,
               materials=media(contrast, (contrast, 1), R, 0),
               walls=walls, fractions=lambda x, y: upper(y) + 0*x, **entries)


def columns(contrast):
    """Channel driven by its weight, |y| < 1/4 of another etaC and M."""
    plain = Material(1, 1, R)
    return Layers([plain, Material(1, contrast, R), plain],
                  (-0.5, -0.25, 0.25, 0.5), G=1.0)


def columns_box(path, contrast, cells, **entries):
    """Strip of the channel."""
    middle = regions.within(cells, -0.25, 0.25)
    still = ("type noSlip;", HELD)
    materials = media(1.0, (contrast, 1), R)
    materials["second"]["rho"] = 1.0
    return Box(path, n=cells, xmin=0.5 - ALONG/cells, cyclic=True,
               g=(1, 0, 0), materials=materials,
               walls={"bottom": still, "top": still},
               fractions=lambda x, y: middle(y) + 0*x, **entries)


def _measure(exact, y, case, where):
    """Errors of u and omega, and of omega where the medium is stiff."""
    omega = case.field("omega")
    return {"u": l2(case.field("U")[:, 0], exact.u(y)),
            "omega": l2(omega, exact.omega(y)),
            "omegaStiff": l2(omega, exact.omega(y), where)}


def measure_layers(case, contrast, _cells):
    """Errors of u, and of omega in all and in the upper layer."""
    y = case.centres()[:, 1]
    return _measure(layers(contrast), y, case, y > 0)


def measure_columns(case, contrast, _cells):
    """Errors of u, and of omega in all and in the middle."""
    y = case.centres()[:, 1]
    return _measure(columns(contrast), y, case, np.abs(y) < 0.25)


def _tilted(contrast):
    """Velocity and rotation of the layers, turned by TILT; and the stream
    function, whose differences are the fluxes through the walls."""
    flow = Layers([Material(1, 1, R), Material(contrast, contrast, R)],
                  (-1, 0, 1), velocity=(-0.5, 0.5))
    along = np.array([np.cos(TILT), np.sin(TILT)])
    t, w = np.polynomial.legendre.leggauss(24)

    def across(x, y):
        return -np.sin(TILT)*x + np.cos(TILT)*(y - OFFSET)

    def psi(x, y):
        s = np.asarray(across(x, y))[..., None]
        return (flow.u(s*(t + 1)/2)*s*w/2).sum(axis=-1)

    return flow, along, across, psi


def tilted_box(path, contrast, cells, **entries):
    """Layers that no face follows; walls hold the exact velocity and omega.
    What passes a face of a wall is its mean, so that no volume is left."""
    flow, along, across, psi = _tilted(contrast)
    h = 0.5/cells

    def U(x, y):
        u = np.array([c*flow.u(across(x, y)) for c in along])
        left, top = np.abs(np.abs(x) - 0.5) < 1e-6, np.abs(
            np.abs(y) - 0.5) < 1e-6
        u[0] = np.where(left, (psi(x, y + h) - psi(x, y - h))/(2*h), u[0])
        u[1] = np.where(top, -(psi(x + h, y) - psi(x - h, y))/(2*h), u[1])
        return u

    lower = regions.below(cells, np.cos(TILT)*OFFSET,
                          (-np.sin(TILT), np.cos(TILT)))
    return Box(path, n=cells, materials=media(
        contrast, (contrast, 1), R, 0), U=U,
        omega=lambda x, y: flow.omega(across(x, y)),
        walls={side: ("exact", "exact") for side in (
            "left", "right", "bottom", "top")},
        fractions=lambda x, y: 1 - lower(x, y), **entries)


def measure_tilted(case, contrast, _cells):
    """Errors of velocity and omega."""
    flow, along, across, _ = _tilted(contrast)
    s = across(*case.centres()[:, :2].T)
    exact, omega = np.outer(along, flow.u(s)), case.field("omega")
    return {"u": l2(case.field("U")[:, :2].T, exact),
            "omega": l2(omega, flow.omega(s)),
            "omegaStiff": l2(omega, flow.omega(s), s > 0)}
