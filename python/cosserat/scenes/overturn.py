"""A heavy layer overturns: points and flow together, with the flow of the
start of the step, extrapolated, or solved at mid-step."""

import numpy as np

from cosserat.scenes.box import Box, add_points

COUPLINGS = ["frozen", "extrapolated", "midpoint"]

AVERAGES = ["linearLeastSquares", "cellMean"]

#: Cells a side and end [s], by which points have moved by up to a fifth
N, END = 32, 30.0


def run(path, coupling, steps, n=N, average=AVERAGES[0]):
    """Positions by id, and the log."""
    fluid = {"eta": 1, "etaC": 0, "R": 0}
    case = Box(path, n=n, g=(0, -1, 0), tolerance=1e-9,
               materials={"heavy": {**fluid, "rho": 1}, "light": fluid},
               fractions=lambda x, y: 0*x).write()
    add_points(case, "{ type all; material heavy; }"
               " { type belowInterface; material light; along (1 0 0);"
               " up (0 1 0); height polynomial ((0.1 0) (0.3 1)); }",
               coupling=coupling, average=average, minPointsPerCell=0)
    case.substitute("system/controlDict", {
        "endTime": END, "deltaT": END/steps, "writeInterval": steps})
    case.run("cosseratPicFoam")
    xy = case.cloud("positions")[np.argsort(case.cloud("origId")), :2]
    return xy, case.log()
