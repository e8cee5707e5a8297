#!/usr/bin/env python3
"""Profiles of the pipe beside the analytic ones, and its flow rate. Fails
where the errors are not those expected."""

from pathlib import Path

import numpy as np

from cosserat.analytic import Material, PipeFlow
from cosserat.case import Case
from cosserat.picture import comparison

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

#: Largest errors of u and omega, and of the rate
EXPECTED = 4.6e-4, 6.8e-4, 1.1e-3

free = "zeroGradient" in (case.path/"0/omega").read_text()
pipe = PipeFlow(Material(1, 1, R=0.1), a=1, G=1, free=free)
r, u = case.centres()[:, 0], case.field("U")[:, 2]

errors = comparison(r, np.linspace(0, 1, 200), "r [m]",
                    [("u [m/s]", pipe.u, u),
                     (r"$\omega$ [1/s]", pipe.omega, case.field("omega"))],
                    results/"profiles.png")
print(f"Err [30]: u {errors[0]:.3g}, omega {errors[1]:.3g}")
# Of cells of one width, by rings
rate = (u*r).sum()/r.sum()*8
print(f"Rate over Poiseuille's: {rate:.5f},"
      f" analytic {pipe.over_poiseuille():.5f}")
print(results/"profiles.png")
if any(found > bound for found, bound in zip(
        (*errors, abs(rate/pipe.over_poiseuille() - 1)), EXPECTED)):
    raise SystemExit(f"Not as expected: errors above {EXPECTED}")
