#!/usr/bin/env python3
"""Profiles of the pipe beside the analytic ones, and its flow rate."""

from pathlib import Path

import numpy as np

from cosserat.analytic import Material, PipeFlow
from cosserat.case import Case
from cosserat.picture import comparison

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

free = "zeroGradient" in (case.path/"0/omega").read_text()
pipe = PipeFlow(Material(1, 1, R=0.1), a=1, G=1, free=free)
r, u = case.centres()[:, 0], case.field("U")[:, 2]

errors = comparison(r, np.linspace(0, 1, 200), "r [m]",
                    [("u [m/s]", pipe.u, u),
                     (r"$\omega$ [1/s]", pipe.omega, case.field("omega"))],
                    results/"profiles.png")
print(f"Err [30]: u {errors[0]:.3g}, omega {errors[1]:.3g}")
# Of cells of one width, by rings
rate = (u*r).sum()/r.sum()*np.pi
print(f"Rate over Poiseuille's: {rate*8/np.pi:.5f},"
      f" analytic {pipe.over_poiseuille():.5f}")
print(results/"profiles.png")
