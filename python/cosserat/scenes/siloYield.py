"""The silo whose fill yields: a law for the tutorials' cases."""

import re

from cosserat.case import FILES
from cosserat.references import Silo
from cosserat.scenes.yielding import entries

#: Rate far below those of the flow [1/s]
EPS = 10.0


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
    # Cells that the fill's surface cuts have no exact derivative
    case.override("solution", creepingFlow="{ nonlinear { tolerance 1e-4; } }")
    return case
