#!/usr/bin/env python3
"""Names that can be chosen in system/schemes.

compare.py              runs the case with each, and writes a table of them
compare.py ENTRY        tells the names that the solver knows
compare.py ENTRY NAME   chooses a name
"""

import re
import sys
from pathlib import Path

import numpy as np

from cosserat import schemes
from cosserat.case import Case

case = Case(Path(__file__).resolve().parent)
results = case.path/"results"


def row(run):
    """Of a run: steps, iterations a solve, time, height that the grains have
    lost, part of the power that is not accounted for."""
    log = run.log()
    solves, iterations = re.search(
        r"Flow: (\d+) solves, (\d+) iterations", log).groups()
    steps, seconds = re.search(
        r"Run: (\d+) steps, (\S+) s of processor time", log).groups()
    balance = float(re.findall(r"relative imbalance (\S+)", log)[-1])
    grains = run.cloud("material") == 1
    height = np.average(run.cloud("positions")[grains, 1],
                        weights=run.cloud("volume")[grains])
    return (int(steps), int(iterations)/int(solves), float(seconds), height,
            abs(balance))


def known(entry):
    """Names of an entry, asked in a copy of the case."""
    asked = Case.copy(case.path, results/"asked")
    asked.run("blockMesh")
    return schemes.names(asked, entry)


def compare():
    """Run all and write the table."""
    lines = ["| entry | name | steps | iterations a solve | time [s] "
             "| height [m] | imbalance |", "|---|---|---|---|---|---|---|"]
    for entry in schemes.chosen(case):
        for name in known(entry):
            run = schemes.run_with(case, results/f"{entry}.{name}", entry, name)
            lines.append("| %s | %s | %d | %.1f | %.1f | %.4f | %.0e |"
                         % (entry, name, *row(run)))
            print(lines[-1], flush=True)
    (results/"schemes.md").write_text("\n".join(lines) + "\n")


def choose(entry, name):
    """Choose a name that the solver knows."""
    if entry not in schemes.VALUES and name not in known(entry):
        raise SystemExit(f"No {entry} {name}: {' '.join(known(entry))}")
    schemes.choose(case, entry, name)


if len(sys.argv) > 1 and sys.argv[1] not in schemes.chosen(case):
    raise SystemExit(f"No entry {sys.argv[1]}: {' '.join(schemes.chosen(case))}")
if len(sys.argv) == 1:
    compare()
elif len(sys.argv) == 2:
    print(*known(sys.argv[1]))
else:
    choose(*sys.argv[1:3])
