"""Runs on several processors, compared with that on one."""

import re

import numpy as np
from scipy.spatial import cKDTree

from cosserat.case import residuals

FIELDS = ("U", "p", "omega")


def compare(case, serial):
    """Differences of a case from another one: of the fields relative to the
    largest value, of the places of the points [m]."""
    row = {}
    for name in FIELDS:
        a, b = case.field(name), serial.field(name)
        row[f"diff{name}"] = float(np.abs(a - b).max()/np.abs(b).max())
    places, others = case.cloud("positions"), serial.cloud("positions")
    row["points"] = len(places)
    row["diffPoints"] = float(cKDTree(others).query(places)[0].max())
    row["volume"] = float(case.cloud("volume").sum())
    return row


def costs(case):
    """Iterations of all steps, seconds of a step."""
    log = case.log()
    return {
        "iterations": sum(row[3] for row in residuals(log) if row[0] == "U"),
        "step": float(re.findall(r"done, (\S+) s per step", log)[-1])}
