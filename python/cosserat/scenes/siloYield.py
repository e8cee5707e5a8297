"""The silo whose fill yields: a law for the tutorial's case, and limits of its
yield stress by hand."""

import re

import numpy as np

from cosserat.case import FILES
from cosserat.references import Silo
from cosserat.scenes.yielding import entries

#: Rate far below those of the flow [1/s]
EPS = 10.0

#: Yield stresses [Pa] over the weight of an aperture's height, classical: below
#: the first the fill flows, since a column above the aperture is heavier than
#: what its two sides bear; above the second it rests, since stresses balance the
#: weight that do not yield (tutorials/silo/README.md)
FLOWS = 0.5
RESTS = float(np.hypot(0.5, 6.25/4))


def give_yield(case, tauY, eps=EPS):
    """Make the fill of a copy of the tutorial yield at tauY [Pa], with the
    viscosities of the tutorial as those beyond it."""
    path = case.path/FILES["materials"]
    law = {"etaP": Silo.ETA, "tauY": tauY, "eps": eps,
           "regularisation": "BercovierEngelman", "etaCRatio": 1,
           "R": "$alpha", "B": "infinite"}
    head, tail = path.read_text().split("    granular\n")
    tail = re.sub(r"viscosityLaw    constant;\s+constantCoeffs\s+\{.*?\}",
                  f"viscosityLaw    bingham;\n        binghamCoeffs"
                  f" {{ {entries(law)} }}", tail, count=1, flags=re.S)
    path.write_text(f"{head}    granular\n{tail}")
    return case
