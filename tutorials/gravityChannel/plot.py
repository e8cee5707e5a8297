#!/usr/bin/env python3
"""Profiles of the gravity channel beside the analytic ones."""

from pathlib import Path

from cosserat.analytic import GravityChannel, Material, granular_contact
from cosserat.case import Case
from cosserat.picture import profiles

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

eta, etaC, _ = granular_contact(n=0, k=4, eta_n=1e11, eta_m=1e11)
channel = GravityChannel(Material(eta, etaC, R=0.3), h=1, G=2000*10)

errors = profiles(case, channel, results/"profiles.png")
print(f"Err [30]: u {errors[0]:.3g}, omega {errors[1]:.3g}")
print(results/"profiles.png")
