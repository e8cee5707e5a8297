"""How even points stay over 1000 steps in steady flows, by the velocity that
they are given; none is added, but where the population is kept in its default
bounds."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.analytic import RigidShear
from cosserat.scenes.box import Box, add_points
from studies.common import HERE, save

VELOCITIES = ["cell", "cellPoint", "faceFlux", "conservativeLinear"]

#: Velocities that keep volume, with the population kept in bounds
MENDED = {"faceFlux, mended": "faceFlux",
          "conservativeLinear, mended": "conservativeLinear"}

#: Cells a side, points a cell, steps and steps between rows. The largest
#: |u| + |v| is 1, so that the Courant number is 1/2
N, POINTS, STEPS, EVERY = 32, 16, 1000, 50

#: Vortices a side of the cellular flow
VORTICES = 4

STILL = ("type noSlip;", "type zeroGradient;")


def _scaled(x, y):
    """Coordinates of RigidShear, which is one vortex."""
    return VORTICES*(x + 0.5) - 0.5, VORTICES*(y + 0.5) - 0.5


#: flow: what Box is given
FLOWS = {
    "vortices": {"force": lambda x, y: VORTICES**2*RigidShear.force(
        *_scaled(x, y))},
    "cavity": {"walls": {
        "left": STILL, "right": STILL, "bottom": STILL,
        "top": ("type fixedValue; value uniform (1 0 0);",
                "type zeroGradient;")}},
}


def count(flow, velocity, n, step, xy):
    """Row for positions of shape (points, 2)."""
    i, j = np.floor((xy + 0.5)*n).astype(int).clip(0, n - 1).T
    counts = np.bincount(n*j + i, minlength=n*n)
    return {"flow": flow, "velocity": velocity, "step": step,
            "t": step/(2*n), "points": int(counts.sum()),
            "deviation": float(counts.std()), "min": int(counts.min()),
            "max": int(counts.max()), "empty": int((counts == 0).sum())}


def exact(n=N, steps=STEPS, every=EVERY):
    """Rows of points that are given the exact velocity of the vortices."""
    k = round(POINTS**0.5)*n
    line = (np.arange(k) + 0.5)/k - 0.5
    x = np.array(np.meshgrid(line, line)).reshape(2, -1)
    dt, rows = 1/(2*n), []

    def u(x):
        return RigidShear.u(*_scaled(*x))

    for step in range(1, steps + 1):
        k1 = u(x)
        k2 = u(x + dt/2*k1)
        k3 = u(x + dt/2*k2)
        x = x + dt/6*(k1 + 2*k2 + 2*k3 + u(x + dt*k3))
        if step % every == 0:
            rows.append(count("vortices", "exact", n, step, x.T))
    return rows


def run(path, flow, velocity, n=N, steps=STEPS, every=EVERY):
    """Rows of a run."""
    case = Box(path, n=n, materials={"a": {"eta": 1, "etaC": 0, "R": 0}},
               tolerance=1e-8, **FLOWS[flow]).write()
    bounds = {} if velocity in MENDED else {"minPointsPerCell": 0}
    add_points(case, "{ type all; material a; }", pointsPerCell=POINTS,
               velocity=MENDED.get(velocity, velocity), **bounds)
    case.substitute("system/controlDict", {
        "endTime": steps/(2*n), "deltaT": 1/(2*n), "writeInterval": every})
    case.run("cosseratPicFoam")
    return [count(flow, velocity, n, round(float(time)*2*n),
                  case.cloud("positions", time)[:, :2])
            for time in case.times()]


def draw(rows):
    """A row of panels a flow."""
    figure, axes = plt.subplots(2, 3, figsize=(12, 6.5), dpi=130)
    for flow, panels in zip(FLOWS, axes):
        for velocity, colour in zip(["exact", *VELOCITIES, *MENDED],
                                    ["black", *(f"C{i}" for i in range(6))]):
            own = [row for row in rows if row["flow"] == flow
                   and row["velocity"] == velocity]
            step = [row["step"] for row in own]
            for axis, keys in zip(panels, (["deviation"], ["min", "max"],
                                           ["empty"])):
                for key in keys:
                    axis.plot(step, [row[key] for row in own], color=colour,
                              label=velocity if own else None)
        panels[0].set_ylim(0, 16)
        panels[0].axhline(POINTS**0.5, color="grey", ls=":",
                          label="random places")
        panels[0].set_ylabel("standard deviation of points a cell")
        panels[1].set_ylabel("fewest and most points a cell")
        panels[1].set_yscale("symlog", linthresh=10)
        panels[1].set_ylim(0, None)
        panels[2].set_ylabel(f"empty cells of {N*N}")
        for axis in panels:
            axis.set_title(flow, fontsize=9)
            axis.set_xlabel("steps")
            axis.grid(alpha=0.3)
    axes[0, 0].legend(fontsize=8, ncol=2)
    save(figure, "pointDistribution")
    plt.close(figure)


def study():
    """Rows: flow, velocity, step, t [s], points, deviation (standard), min
    and max of points a cell, empty (cells)."""
    rows = exact()
    for flow in FLOWS:
        for velocity in [*VELOCITIES, *MENDED]:
            rows += run(HERE/"runs/pointDistribution"/f"{flow}-{velocity}",
                        flow, velocity)
    draw(rows)
    return rows
