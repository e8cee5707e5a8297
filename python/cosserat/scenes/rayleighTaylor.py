"""Rayleigh-Taylor instability of van Keken et al. (1997), J. Geophys. Res. 102,
22477: a light layer below a heavy one in a box of 0.9142 x 1, their interface
at 0.2 + 0.02 cos(pi x/0.9142), no slip below and above, free slip at the
sides. Viscosity 1 above, `ratio` below; a density difference and gravity of
1."""

import shutil

import numpy as np

from cosserat.analytic import rayleigh_taylor_growth
from cosserat.case import cpu_seconds
from cosserat.scenes.box import Box

WIDTH = 0.9142

#: ratio: (time of the end, largest time step, peak of v_rms, its time), the
#: latter two as published
SCENES = {1: (240, 0.5, 3.09e-3, 209),
          0.1: (80, 0.25, 9.46e-3, 72),
          0.01: (56, 0.25, 1.46e-2, 50)}

#: Height of the interface, amplitude of its wave
HEIGHT, AMPLITUDE = 0.2, 0.02


class Tank(Box):
    """The box, n x n cells."""

    def mesh(self):
        super().mesh()
        path = self.case.path/"system/blockMeshDict"
        text = path.read_text()
        for corner in ((0, 0), (1, 0), (1, 1), (0, 1)):
            text = text.replace(f"({corner[0] - .5} {corner[1] - .5} ",
                                f"({WIDTH*corner[0]} {corner[1]} ")
        path.write_text(text)


def scene(path, ratio, n, end, max_step, average="harmonic", **entries):
    """The case with its points; average: of the viscosities (None: left out);
    entries are those of the points."""
    still = ("type noSlip;", "type zeroGradient;")
    light, heavy = ({"eta": eta, "etaC": 0, "R": 0, "rho": rho}
                    for eta, rho in ((ratio, 0), (1, 1)))
    tank = Tank(path, n=n, g=(0, -1, 0), tolerance=1e-6, average=average,
                materials={"light": light, "heavy": heavy},
                fractions=lambda x, y: 0*x,
                walls={"bottom": still, "top": still})
    case = tank.write()
    for name in ("light", "heavy"):
        (case.path/f"0/alpha.{name}").unlink()
    more = "\n".join(f"{key} {value};" for key, value in entries.items())
    tank.file("constant/materialPointsProperties", f"""
seeding
{{
    pointsPerCell 16;
    regions
    (
        {{ type all; material heavy; }}
        {{
            type belowInterface; material light;
            along (1 0 0); up (0 1 0);
            height sine;
            heightCoeffs
            {{
                frequency {0.5/WIDTH!r}; t0 {-WIDTH/2!r};
                amplitude {AMPLITUDE}; scale 1; level {HEIGHT};
            }}
        }}
    );
}}
{more}
""")
    case.substitute("system/controlDict", {
        "endTime": end, "deltaT": max_step, "writeInterval": end/4})
    case.override("control", writeControl="adjustableRunTime",
                  adjustTimeStep="yes", maxCo=0.2, maxDeltaT=max_step)
    case.measure("square", "magSqr", "field U; log no; writeControl writeTime;",
                 "fieldFunctionObjects")
    case.measure("mean", "volFieldValue", "operation volAverage;"
                 " regionType all; fields (magSqr(U)); writeFields no; log no;",
                 "fieldFunctionObjects")
    return case


def speeds(case):
    """Rows of time and root mean square of the velocity."""
    rows = np.loadtxt(
        case.path/"postProcessing/mean/0/volFieldValue.dat", ndmin=2)
    return np.column_stack((rows[:, 0], np.sqrt(rows[:, 1])))


def growth_rate(path, ratio, n, average="harmonic"):
    """Rate at which the wave of the interface grows at the start: the part
    cos(pi x/WIDTH) of the vertical velocity at its height over its amplitude.
    (The slope of v_rms in time is a staircase: the interface takes ten units
    of time from one row of points to the next.)"""
    case = scene(path, ratio, n, 1e-3, 1e-3, average)
    case.run("cosseratPicFoam")
    x, y = case.centres()[:, :2].T
    wave = case.field("U")[:, 1]*np.cos(np.pi*x/WIDTH)
    heights = np.unique(y.round(9))
    parts = [2*wave[np.abs(y - h) < 1e-6].mean() for h in heights]
    return np.interp(HEIGHT, heights, parts)/AMPLITUDE


def peak(rows):
    """Highest speed and its time, by a parabola through what is near."""
    top = int(np.argmax(rows[:, 1]))
    if rows[top, 0] > 0.96*rows[-1, 0]:
        raise ValueError(f"no peak before the end, {rows[-1, 0]}: the speed is"
                         f" highest, {rows[top, 1]}, at {rows[top, 0]}")
    near = rows[np.abs(rows[:, 0] - rows[top, 0]) < 0.04*rows[top, 0]]
    a, b, c = np.polyfit(near[:, 0] - rows[top, 0], near[:, 1], 2)
    return c - b**2/(4*a), rows[top, 0] - b/(2*a)


def run(path, ratio, n, average="harmonic"):
    """The case of one run and its row."""
    end, max_step, _, _ = SCENES[ratio]
    for old in (path, path.with_name(path.name + "-rest")):
        shutil.rmtree(old, ignore_errors=True)
    growth = growth_rate(path.with_name(path.name + "-rest"), ratio, n,
                         average)
    case = scene(path, ratio, n, end, max_step, average)
    case.run("cosseratPicFoam")
    highest, when = peak(speeds(case))
    return case, {"ratio": ratio, "n": n, "growth": float(growth),
                  "linearGrowth": float(rayleigh_taylor_growth(ratio)),
                  "vrmsMax": float(highest), "tMax": float(when),
                  "steps": len(speeds(case)), "cpu": cpu_seconds(case.log())}
