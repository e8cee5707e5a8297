"""The silo on several processors, decomposed by all methods there are, and
with the sparse factorisation: twenty steps at half the resolution of the
tutorial, compared with one processor. More ranks than cores share them. And
the speed-up of two ranks on 256 x 256 cells with 16 points each."""

import re

import matplotlib.pyplot as plt
import numpy as np
from scipy.spatial import cKDTree

from cosserat.case import residuals
from studies.common import new_case, save
from cosserat.silo import mesh_entries

METHODS = ("simple", "hierarchical", "scotch", "metis", "ptscotch")

#: Ranks, and by how many in x and y simple and hierarchical cut
PARTS = {1: (1, 1), 2: (2, 1), 3: (1, 3), 4: (2, 2), 8: (2, 4)}

#: Where v1912 with PT-Scotch 7.0.3 of Debian 12 hangs or ends by a signal as it
#: decomposes, before any program of this project
NOT_HERE = {("ptscotch", 4), ("ptscotch", 8)}

FIELDS = ("U", "p", "omega")


def decompose(case, method, ranks):
    """Decompose the latest time; ptscotch does it in parallel."""
    if method == "ptscotch":
        case.run("redistributePar", "-decompose", ranks=ranks)
    else:
        case.run("decomposePar", "-latestTime", "-force")


def run(method, ranks, block="automatic", cells=4):
    """The case of one run, reconstructed."""
    case = new_case("parallel", f"{method}-{ranks}-{block}", "silo")
    case.substitute("system/blockMeshDict", mesh_entries(cells))
    case.substitute("system/controlDict", {
        "endTime": 2e-4, "deltaT": 1e-5, "adjustTimeStep": "no",
        "writeInterval": 2e-4, "writePrecision": 17})
    path = case.path/"system/fvSolution"
    path.write_text(re.sub(
        r"tolerance .*", f"tolerance 1e-10; preconditioner {{ block {block}; }}",
        path.read_text()))
    case.run("blockMesh")
    if ranks > 1:
        nx, ny = PARTS[ranks]
        case.substitute("system/decomposeParDict", {
            "numberOfSubdomains": ranks, "method": method,
            "n": f"({nx} {ny} 1)"})
        decompose(case, method, ranks)
        case.run("cosseratPicFoam", ranks=ranks)
        case.run("reconstructPar", "-latestTime")
    else:
        case.run("cosseratPicFoam")
    return case


def large(method, ranks, cells=256, steps=8):
    """The case of a run of the sinking inclusion, not reconstructed."""
    case = new_case("parallel", f"large-{method}-{ranks}", "sinkingInclusion")
    case.substitute("system/blockMeshDict", {"n": cells})
    dt = 48/cells
    case.substitute("system/controlDict", {
        "endTime": steps*dt, "deltaT": dt, "adjustTimeStep": "no",
        "writeInterval": 1000})
    case.run("blockMesh")
    if ranks > 1:
        case.substitute("system/decomposeParDict", {
            "numberOfSubdomains": ranks, "method": method})
        case.run("decomposePar")
    case.run("cosseratPicFoam", ranks=ranks)
    return case


def speed_up():
    """Rows of two ranks beside one, with the ratio of the times of a step."""
    rows = []
    for method, ranks in [("none", 1), ("scotch", 2), ("simple", 2)]:
        case = large(method, ranks)
        points = re.findall(r"Material points: (\d+) inside", case.log())[-1]
        rows.append({"scene": "sinkingInclusion", "method": method,
                     "ranks": ranks, "block": "automatic",
                     "points": int(points), **costs(case)})
        rows[-1]["speedUp"] = rows[0]["step"]/rows[-1]["step"]
        print(rows[-1], flush=True)
    return rows


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


def study():
    """Rows: scene, method, ranks, block (of the preconditioner), iterations
    (of all steps), points, step [s, on two cores]; of the silo diffU, diffp,
    diffomega (from one rank, over the largest value), diffPoints [m], volume
    [m3]; of the sinking inclusion speedUp (over one rank)."""
    rows = []
    for block, wanted in (
            ("automatic", [(m, n) for m in METHODS for n in PARTS
                           if n > 1 and (m, n) not in NOT_HERE]),
            ("direct", [("scotch", 2)])):
        serial = run("none", 1, block)
        for method, ranks in [("none", 1)] + wanted:
            case = serial if ranks == 1 else run(method, ranks, block)
            rows.append({"scene": "silo", "method": method, "ranks": ranks,
                         "block": block,
                         **costs(case), **compare(case, serial)})
            print(rows[-1], flush=True)
    draw(rows)
    return rows + speed_up()


def draw(rows):
    """Iterations and differences against ranks."""
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), dpi=130)
    one = rows[0]["iterations"]
    for i, method in enumerate(METHODS):
        chosen = [row for row in rows
                  if row["method"] == method and row["block"] == "automatic"]
        ranks = [row["ranks"] for row in chosen]
        axes[0].plot([1] + ranks,
                     [1] + [row["iterations"]/one for row in chosen],
                     "o-", ms=3, lw=1.2, label=method)
        for name, style in zip(FIELDS, ("-", "--", ":")):
            axes[1].semilogy(
                ranks, [row[f"diff{name}"] for row in chosen], style,
                color=f"C{i}", lw=1.2, label=name if i == 0 else None)
    axes[0].axhline(1.1, color="grey", lw=0.8, ls="--")
    axes[0].set_ylabel("iterations over those of one rank")
    axes[1].axhline(1e-8, color="grey", lw=0.8, ls="--")
    axes[1].set_ylabel("difference from one rank")
    for axis in axes:
        axis.set_xlabel("ranks")
        axis.set_xticks([1, 2, 3, 4, 8])
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    save(figure, "parallel")
    plt.close(figure)
