#!/usr/bin/env python3
"""Profiles of the channel, and its speed over the load beside the load at which
it starts to flow."""

import re
from pathlib import Path

import matplotlib
matplotlib.use("Agg")

# pylint: disable=wrong-import-position
import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import Case
from cosserat.yielding import channel_load

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"

law = (case.path/"constant/materialProperties").read_text()
exact = channel_load(1/float(re.search(r"\bR\s+(\S+);", law)[1]))
loads, soft, stiff = np.loadtxt(results/"loads.csv", delimiter=",").T

# Speeds that fall with the viscosity at rest are a creep
flows = stiff > np.sqrt(0.1)*soft
below, above = loads[~flows].max(), loads[flows].min()

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
y = case.centres()[:, 1]
order = np.argsort(y)
left.plot(case.field("U")[order, 0], y[order], label="u [m/s]")
left.plot(case.field("omega")[order], y[order], label=r"$\omega$ [1/s]")
left.set_ylabel("y [m]")
left.legend()
right.semilogy(loads, soft, "o-", label="eps 1e-5")
right.semilogy(loads, stiff, "s-", label="eps 1e-6")
right.axvline(exact, color="k", ls="--", label="exact load")
right.set_xlabel("load G H/(2 tauY)")
right.set_ylabel("speed [m/s]")
right.legend()
figure.tight_layout()
figure.savefig(results/"channel.png", dpi=120)

print(f"flows from a load between {below:.2f} and {above:.2f}, exact"
      f" {exact:.5f}")
print(results/"channel.png")
