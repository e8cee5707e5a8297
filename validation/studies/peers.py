"""The silo of a classical fluid by OpenFOAM's interFoam and by
cosseratPicFoam, on the same meshes: what an accurate rate of discharge costs.

interFoam is given what serves it: inertia scaled away, outer iterations with
the largest relaxation factors that converge (studies/interFoamSilo, which
tells why). Measured at rest are the rate of the first Stokes flow, its error
and its processor time; then the discharge until half of the fill is out.

Only the rows of one code again, the others from results/peers.json (or all of
them: figure), in validation/ with etc/bashrc sourced:

    $COSSERATPIC_PYTHON -m studies.peers cosseratPicFoam
    $COSSERATPIC_PYTHON -m studies.peers figure
"""

import json
import re
import sys

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import RunError
from cosserat.picture import outflow
from cosserat.scenes.peers import (OWN, PEER, PEER_REST, TARGET, cpu_by_time,
                                   own_case, peer_case, power, price,
                                   solve_at_rest, stop_at_rest, to_half)
from cosserat.scenes.silo import DEPTH, REST
from studies.common import HERE, RESULTS, save, write

#: Cells a unit length
MESHES = [4, 8, 16]

#: Tolerances of interFoam's outer iterations at rest, by cells. The tightest
#: tells the error that looser ones leave in the rate; 32 cells check the
#: extrapolation
TOLERANCES = {4: [1e-2, 1e-3, 1e-4, 1e-6], 8: [1e-2, 1e-3, 1e-4, 1e-6],
              16: [1e-2, 1e-3, 1e-4, 1e-6], 32: [1e-4, 1e-6]}

#: Meshes and interFoam's tolerances of the discharge until half is out
DISCHARGE_MESHES = [4, 8]
DISCHARGE_TOLERANCES = [1e-2, 1e-3]

#: Entry 'corners' of cosseratPicFoam; "default" leaves it out
CORNERS = ["default", "off"]

#: End of a discharge of cosseratPicFoam [s]: half of the fill is out before,
#: also without the error of coarse meshes that lets it flow too fast
END = 2e-3

#: Relative error that a tolerance may leave in the rate
ITERATION_ERROR = 0.01


def peer_discharge(case):
    """Time, processor time and steps of interFoam's discharge until half."""
    try:
        case.run(PEER)
    except RunError as error:
        print(str(error)[:200], flush=True)
    rows = case.table("discharge", "volFieldValue.dat")
    return to_half(rows[:, 0], rows[:, 1]/DEPTH, cpu_by_time(case.log(PEER)))


def own_discharge(case):
    """The same of cosseratPicFoam's."""
    case.substitute("system/controlDict", {"endTime": END,
                                           "writeInterval": END})
    case.run(OWN)
    rows = outflow(case)
    return to_half(rows[:, 0], rows[:, 1], cpu_by_time(case.log()))


NO_DISCHARGE = {"timeToHalf": None, "cpuToHalf": None, "steps": None}


def peer_row(cells, tolerance, inertia=1.0, discharge=False):
    """interFoam on one mesh at one tolerance."""
    path = HERE/f"runs/peers/{PEER}-{cells}-{tolerance:g}-{inertia:g}"
    case = peer_case(path, cells, tolerance, inertia)
    row = {"kind": "run", "code": PEER, "cells": cells,
           "tolerance": tolerance, "corners": None, "inertia": inertia}
    stop_at_rest(case, PEER_REST)
    row |= solve_at_rest(case, PEER)
    return row | (peer_discharge(peer_case(path, cells, tolerance, inertia))
                  if discharge else NO_DISCHARGE)


def own_row(cells, corners="default", discharge=False):
    """cosseratPicFoam on one mesh, with the tutorial's tolerance."""
    path = HERE/f"runs/peers/{OWN}-{cells}-{corners}"
    case = own_case(path, cells, corners)
    row = {"kind": "run", "code": OWN, "cells": cells,
           "tolerance": float(re.search(
               r"tolerance\s+(\S+);",
               (case.path/"system/fvSolution").read_text())[1]),
           "corners": corners, "inertia": 0.0}
    stop_at_rest(case, REST)
    row |= solve_at_rest(case, OWN)
    return row | (own_discharge(own_case(path, cells, corners))
                  if discharge else NO_DISCHARGE)


def told(row):
    """The row, printed."""
    print(row, flush=True)
    return row


def peer_rows():
    """All of interFoam's rows; the last, with half the inertia, has to be as
    the one with all of it."""
    rows = [told(peer_row(cells, tolerance, discharge=(
        cells in DISCHARGE_MESHES and tolerance in DISCHARGE_TOLERANCES)))
            for cells, tolerances in TOLERANCES.items()
            for tolerance in tolerances]
    return rows + [told(peer_row(8, 1e-6, inertia=0.5))]


def own_rows():
    """All of cosseratPicFoam's rows."""
    return [told(own_row(cells, corners, cells in DISCHARGE_MESHES))
            for corners in CORNERS for cells in MESHES]


def iteration_errors(rows):
    """Give each run of interFoam what its tolerance leaves in the rate,
    against the tightest tolerance on its mesh; cosseratPicFoam's, which is
    tight, is not asked (None)."""
    for row in rows:
        same = [other for other in rows if other["cells"] == row["cells"]
                and other["code"] == row["code"] == PEER
                and other["inertia"] == 1]
        row["iterationError"] = (
            row["Q"]/min(same, key=lambda r: r["tolerance"])["Q"] - 1
            if same else None)


def sequence(rows, code, **entries):
    """Runs of a code with these entries, by cells."""
    return sorted((row for row in rows if row["code"] == code
                   and row["inertia"] != 0.5
                   and all(row[key] == value
                           for key, value in entries.items())),
                  key=lambda row: row["cells"])


def column(rows, key):
    """Values of a key."""
    return [row[key] for row in rows]


def price_of(rows, meshes):
    """Price of the rate at rest by the runs on some meshes, whether their
    tolerance is tight enough for it, and the price of the discharge on that
    mesh, by a power of the cells through the two meshes it was run on."""
    rest = [row for row in rows if row["cells"] in meshes]
    result = price(*(column(rest, key) for key in ("cells", "error", "cpu")))
    result["iterated"] = all(abs(row["iterationError"] or 0) < ITERATION_ERROR
                             for row in rest)
    return result


def discharge_price(rows, cells):
    """Processor time [s] of a discharge until half on a mesh, extrapolated
    from the two finest that it was run on; None where there are not two."""
    done = [row for row in rows if row["cpuToHalf"]]
    if len(done) < 2 or cells is None:
        return None
    n, cpu = column(done, "cells"), column(done, "cpuToHalf")
    return float(cpu[-1]*(cells/n[-1])**power(n, cpu))


def summaries(rows):
    """Rows of what the target costs, with the ratio to cosseratPicFoam's.

    Result is interFoam's price that the study is for: on the meshes that both
    codes have run, at the loosest tolerance that serves. Its discharges are
    taken on the mesh of that price."""
    own = [{"kind": "price", "code": OWN, "tolerance": None,
            "corners": corners, "upTo": MESHES[-1]}
           | price_of(sequence(rows, OWN, corners=corners), MESHES)
           for corners in CORNERS]
    for row in own:
        row["cpuToHalf"] = discharge_price(
            sequence(rows, OWN, corners=row["corners"]), row["cells"])
    peer = []
    for tolerance in TOLERANCES[MESHES[-1]]:
        runs = sequence(rows, PEER, tolerance=tolerance)
        for finest in sorted({MESHES[-1], runs[-1]["cells"]}):
            peer.append({"kind": "price", "code": PEER,
                         "tolerance": tolerance, "corners": None,
                         "upTo": finest}
                        | price_of(runs, [*MESHES, finest]))
    result = next((row for row in peer if row["iterated"] and row["cells"]
                   and row["upTo"] == MESHES[-1]), {"cells": None})
    for row in peer:
        row["cpuToHalf"] = discharge_price(sequence(
            rows, PEER, tolerance=row["tolerance"]), result["cells"])
    for row in own + peer:
        row["result"] = row is result
        for key, ratio in (("cpu", "ratio"), ("cpuToHalf", "ratioToHalf")):
            row[ratio] = row[key]/own[0][key] if row[key] else None
    return own + peer


def label(row):
    """What a line of the figure is called."""
    if row["code"] == PEER:
        return f"{PEER}, tolerance {row['tolerance']:.0e}"
    return OWN + ("" if row["corners"] == "default"
                  else f", corners {row['corners']}")


def draw_line(axis, runs, prices, colour):
    """One sequence of meshes: hollow where outer iterations have left too
    large an error; dotted to what is extrapolated."""
    cpu, error = column(runs, "cpu"), np.abs(column(runs, "error"))*100
    own = runs[0]["code"] == OWN
    axis.loglog(cpu, error, "-" if own else "--", lw=1.2, color=colour)
    for row, x, y in zip(runs, cpu, error):
        loose = abs(row["iterationError"] or 0) >= ITERATION_ERROR
        axis.plot(x, y, "o" if own else "s", ms=5, color=colour,
                  mfc="w" if loose else colour)
        axis.annotate(row["cells"], (x, y), textcoords="offset points",
                      xytext=(4, 5), fontsize=7, color=colour)
    axis.plot([], [], "o-" if own else "s--", ms=5, lw=1.2, color=colour,
              label=label(runs[0]))
    for asked in prices:
        if asked["extrapolated"] and asked["iterated"] and asked["cpu"]:
            last = [row["cells"] for row in runs].index(asked["upTo"])
            axis.plot([cpu[last], asked["cpu"]], [error[last], TARGET*100],
                      ":", color=colour)
            axis.plot(asked["cpu"], TARGET*100, "*", ms=9, color=colour)


def draw(rows, prices):
    """Error of the rate at rest against processor time."""
    figure, axis = plt.subplots(figsize=(6.4, 4.4), dpi=130)
    keys = [(row["code"], row["tolerance"], row["corners"]) for row in prices]
    for i, (code, tolerance, corners) in enumerate(dict.fromkeys(keys)):
        draw_line(axis, sequence(rows, code, corners=corners,
                                 **({"tolerance": tolerance}
                                    if code == PEER else {})),
                  [row for row, key in zip(prices, keys)
                   if key == (code, tolerance, corners)], f"C{i}")
    axis.axhline(TARGET*100, color="grey", lw=0.8, ls=":")
    axis.set_xlabel("processor time of the solve [s]")
    axis.set_ylabel("error of the rate at rest [%]")
    axis.set_yticks([1, 2, 5, 10, 20, 50], ["1", "2", "5", "10", "20", "50"])
    axis.set_ylim(0.4, 200)
    axis.grid(alpha=0.3)
    axis.legend(fontsize=7.5, ncol=2, loc="upper center")
    save(figure, "peers")
    plt.close(figure)


def kept(codes):
    """Runs of the last study of all codes but these."""
    path = RESULTS/"peers.json"
    if set(codes) >= {OWN, PEER} or not path.exists():
        return []
    return [row for row in json.loads(path.read_text())["rows"]
            if row["kind"] == "run" and row["code"] not in codes]


def study(codes=(OWN, PEER)):
    """Rows of runs (kind): code, cells (a unit), tolerance, corners (entry of
    cosseratPicFoam), inertia (factor), Q [m2/s], reference, error, cpu [s] and
    outer iterations at rest, timeToHalf [s], cpuToHalf [s] and steps of the
    discharge, iterationError (of Q, against the tightest tolerance).

    Rows of prices (kind), of an error of 5 % of the rate: code, tolerance,
    corners, upTo (finest mesh used), orderError, orderCost, cells, cpu [s],
    extrapolated, iterated (iterationError below 1 %), cpuToHalf [s] of the
    discharge (extrapolated), ratio and ratioToHalf to cosseratPicFoam, result
    (the ratio that is asked)."""
    rows = kept(codes)
    rows += (own_rows() if OWN in codes else [])
    rows += (peer_rows() if PEER in codes else [])
    iteration_errors(rows)
    prices = summaries(rows)
    draw(rows, prices)
    for row in prices:
        print(row, flush=True)
    return rows + prices


if __name__ == "__main__":
    asked = sys.argv[1:] or [OWN, PEER]
    if set(asked) - {OWN, PEER, "figure"}:
        raise SystemExit(f"{asked}: there are {OWN}, {PEER} and figure")
    print(write("peers", study(asked)))
