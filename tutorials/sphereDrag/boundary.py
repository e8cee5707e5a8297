#!/usr/bin/env python3
"""Write the exact flow around the sphere to the outer boundary of 0/U and
0/omega."""

import re
from pathlib import Path

import numpy as np

from cosserat.analytic import Material, SphereFlow
from cosserat.case import Case

case = Case(Path(__file__).resolve().parent)
flow = SphereFlow(Material(1, 1, R=0.1), a=1, U=1)

# Middles of the edges in the mid-plane, of quadrangles or triangles
x, y = np.array([(corners.min(axis=0) + corners.max(axis=0))[:2]/2
                 for corners in case.patch_faces()["outer"][1]]).T
u, v, _, omega = flow.fields(x, y)

for name, kind, rows in (
        ("U", "vector", [f"({a!r} {b!r} 0)" for a, b in zip(
            u.tolist(), v.tolist())]),
        ("omega", "scalar", [repr(a) for a in omega.tolist()])):
    path = case.path/"0"/name
    values = f"nonuniform List<{kind}> {len(rows)} ({' '.join(rows)})"
    text, n = re.subn(r"(outer\s*\{[^}]*value\s+)uniform[^;]*;",
                      rf"\g<1>{values};", path.read_text())
    assert n == 1, path
    path.write_text(text)
