#!/usr/bin/env python3
"""Pictures of the shear layer: profiles beside the analytic ones, and the
dye bands."""

from pathlib import Path

from cosserat.analytic import Material, ShearLayer, granular_contact
from cosserat.case import Case
from cosserat.picture import profiles, snapshots

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"
results.mkdir(exist_ok=True)

eta, etaC, _ = granular_contact(n=0, k=4, eta_n=1e11, eta_m=1e11)
walls = case.entries("system/walls")
given = {walls["velocity"]: float(walls[walls["velocity"]]),
         walls["rotation"]: float(walls[walls["rotation"]])}
layer = ShearLayer(Material(eta, etaC, R=0.3), h=1, **given)

errors = profiles(case, layer, results/"profiles.png")
snapshots(case, case.times()[::2], [0], results/"bands.png", velocity=False)

print(f"Err [30]: u {errors[0]:.3g}, omega {errors[1]:.3g}")
print(f"{results/'profiles.png'}\n{results/'bands.png'}")
