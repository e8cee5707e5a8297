"""What the studies share: where they run, and what they write."""

import json
from pathlib import Path

import matplotlib
matplotlib.use("Agg")

# pylint: disable=wrong-import-position
from cosserat.case import Case, environment, fresh_case

NAMES = ["convergence", "significance", "internalLength", "longShear",
         "siloRate", "siloDischarge", "granularContact", "invariants", "manufactured",
         "extremes", "solveCost", "sceneCost", "pointIntegration",
         "rigidShear", "pointDistribution", "pointCoupling", "rayleighTaylor",
         "siloVolume", "pointCost", "freeSurface", "parallel", "speedAccuracy",
         "soak", "mutations", "kills", "errorIndicator", "finiteElements",
         "cornerRelatives", "jumps", "peers", "refinement", "yield",
         "axisymmetric"]

HERE = Path(__file__).resolve().parents[1]
RESULTS = HERE/"results"

LABELS = {"OmegaV": r"($\Omega$, V)", "OmegaSigma": r"($\Omega$, $\sigma$)",
          "muV": r"($\mu$, V)", "muSigma": r"($\mu$, $\sigma$)",
          "gravity": "gravity channel"}

environment()

# A study may take hours
Case.timeout = None


def write(name, rows):
    """Write results/NAME.json."""
    RESULTS.mkdir(exist_ok=True)
    path = RESULTS/f"{name}.json"
    path.write_text(json.dumps({"rows": rows}, indent=1))
    return path


def save(figure, name):
    """Write a figure to results/."""
    RESULTS.mkdir(exist_ok=True)
    figure.tight_layout()
    figure.savefig(RESULTS/f"{name}.png")


def new_case(study, name, tutorial):
    """A fresh copy of a tutorial in runs/STUDY/NAME."""
    return fresh_case(HERE/"runs"/study/name, tutorial)


def cell_ticks(axis, cells, labels=None):
    """Ticks at the numbers of cells of a logarithmic axis, no others."""
    axis.set_xticks(cells, labels or [str(n) for n in cells])
    axis.minorticks_off()
