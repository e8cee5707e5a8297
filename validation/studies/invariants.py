"""The five invariants of the theory, on the discrete system, as figures: rigid
motion, power balance, the limits of the internal length, mirror and quarter
turn, scaling."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import residuals
from cosserat.scenes.box import Box
from studies.common import HERE, save

SOFT = {"eta": 3, "etaC": 5, "R": 0.2}
STIFF = {"eta": 1000, "etaC": 200, "R": 0.4}
SIDES = ("left", "right", "bottom", "top")


def scene(name, **parameters):
    """A box that is run; its case."""
    case = Box(HERE/"runs/invariants"/name, **parameters).write()
    case.run("cosseratPicFoam")
    return case


def rigid(rows):
    """Residual of a rigid rotation across a jump of the viscosity, on meshes
    of several shears."""
    for contrast in (1, 1e3, 1e6):
        for shear in (0.0, 0.5, 1.0):
            case = scene(
                f"rigid{contrast:g}-{shear}", shear=shear,
                walls={side: ("exact", "exact") for side in SIDES},
                U=lambda x, y: (-y, x), omega=lambda x, y: 1 + 0*x,
                materials={"a": SOFT,
                           "b": {**SOFT, "eta": 3*contrast,
                                 "etaC": 5*contrast}},
                fractions=lambda x, y: abs(y) > 0.25)
            rows.append({
                "invariant": "rigidMotion", "contrast": contrast,
                "shear": shear, "value": max(
                    row[1] for row in residuals(case.log())[:3])})


def blob(name, **parameters):
    """A heavy blob that falls in a box with free-slip walls."""
    return scene(name, **{**dict(
        materials={"blob": {**STIFF, "rho": 10}, "rest": SOFT},
        fractions=lambda x, y: (x - 0.1)**2 + (y - 0.2)**2 < 0.04,
        g=(0, -1, 0), tolerance=1e-11), **parameters})


def power(rows):
    """Imbalance of supply and dissipation, against the tolerance."""
    for tolerance in (1e-4, 1e-6, 1e-8, 1e-10):
        case = blob(f"power{tolerance:g}", tolerance=tolerance)
        balance = np.loadtxt(
            case.path/"postProcessing/power/0/powerBalance.dat", ndmin=2)
        rows.append({"invariant": "powerBalance", "tolerance": tolerance,
                     "value": abs(float(balance[-1, 6]))})


def limits(rows):
    """Speed of a channel between walls without rotation, over the classical
    one of viscosity eta, against R: from 1 to eta/(eta + etaC) = 1/2."""
    wall = ("type noSlip;", "type fixedValue; value uniform 0;")

    def speed(name, R):
        case = scene(name, n=32, cyclic=True, g=(1, 0, 0), tolerance=1e-11,
                     materials={"a": {"eta": 1, "etaC": 1, "R": R, "rho": 1}},
                     walls={"top": wall, "bottom": wall})
        return case.field("U")[:, 0].mean()

    classical = speed("R0", 0)
    for R in np.logspace(-4, 3, 15):
        rows.append({"invariant": "internalLength", "R": float(R),
                     "value": float(speed(f"R{R:g}", float(R))/classical)})


def symmetry(rows, n=32):
    """Largest difference, over the largest value, of the mirrored and of the
    turned scene."""
    def fields(name, **parameters):
        case = blob(name, n=n, **parameters)
        return (case.field("U").reshape(n, n, 3),
                case.field("omega").reshape(n, n))

    U, omega = fields("one")
    Um, omegam = fields(
        "mirror", fractions=lambda x, y: (-x - .1)**2 + (y - .2)**2 < .04)
    Ut, omegat = fields(
        "turn", g=(1, 0, 0),
        fractions=lambda x, y: (y - .1)**2 + (-x - .2)**2 < .04)
    turn = Ut[:, ::-1].transpose(1, 0, 2)
    differences = {
        "mirror U": np.abs(Um[:, ::-1]*[-1, 1, 1] - U).max()/np.abs(U).max(),
        "mirror omega": np.abs(omegam[:, ::-1] + omega).max()
        / np.abs(omega).max(),
        "turn U": max(np.abs(turn[..., 0] + U[..., 1]).max(),
                      np.abs(turn[..., 1] - U[..., 0]).max())
        / np.abs(U).max(),
        "turn omega": np.abs(omegat[:, ::-1].T - omega).max()
        / np.abs(omega).max()}
    for what, value in differences.items():
        rows.append({"invariant": "symmetry", "what": what,
                     "value": float(value)})


def scaling(rows):
    """Largest difference, over the largest value, where viscosities and
    forces are c times as large: U, omega, p/c, sigma/c."""
    one = blob("c1")
    for c in (1e-9, 1e9):
        other = blob(f"c{c:g}", materials={
            "blob": {"eta": 1000*c, "etaC": 200*c, "R": 0.4, "rho": 10*c},
            "rest": {"eta": 3*c, "etaC": 5*c, "R": 0.2}})
        for name, factor in (("U", 1), ("omega", 1), ("p", c), ("sigma", c)):
            a, b = one.field(name, 1), other.field(name, 1)/factor
            rows.append({"invariant": "scaling", "c": c, "what": name,
                         "value": float(np.abs(b - a).max()/np.abs(a).max())})


def draw(rows):
    """One panel an invariant."""
    def values(invariant):
        return [row for row in rows if row["invariant"] == invariant]

    def bars(axis, own, labels, title):
        axis.barh(labels, [max(row["value"], 1e-18) for row in own],
                  color="#b5651d")
        axis.set_xscale("log")
        axis.set_xlim(1e-18, 1)
        axis.set_title(title, fontsize=9)
        axis.tick_params(labelsize=7)
        axis.grid(alpha=0.3, axis="x")

    figure, axes = plt.subplots(1, 5, figsize=(16, 3.4), dpi=130)
    own = values("rigidMotion")
    bars(axes[0], own, [f"contrast {row['contrast']:g}, shear {row['shear']}"
                        for row in own], "rigid rotation: residual")
    own = values("powerBalance")
    axes[1].loglog([row["tolerance"] for row in own],
                   [row["value"] for row in own], "o-", color="#b5651d")
    axes[1].set_xlabel("tolerance of the solver")
    axes[1].set_title("power: imbalance over supply", fontsize=9)
    axes[1].grid(alpha=0.3)
    own = values("internalLength")
    axes[2].semilogx([row["R"] for row in own], [row["value"] for row in own],
                     "o-", ms=4, color="#b5651d")
    for level in (1, 0.5):
        axes[2].axhline(level, color="grey", ls=":", lw=0.9)
    axes[2].set_xlabel("R/h")
    axes[2].set_title("channel: speed over classical", fontsize=9)
    axes[2].grid(alpha=0.3)
    own = values("symmetry")
    bars(axes[3], own, [row["what"] for row in own],
         "mirror, quarter turn: difference")
    own = values("scaling")
    bars(axes[4], own, [f"{row['what']}, c = {row['c']:g}" for row in own],
         "scaling: difference")
    save(figure, "invariants")
    plt.close(figure)


def study():
    """Rows: invariant (rigidMotion, powerBalance, internalLength, symmetry,
    scaling), its parameters, value."""
    rows = []
    for part in (rigid, power, limits, symmetry, scaling):
        part(rows)
    draw(rows)
    return rows
