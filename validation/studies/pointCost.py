"""Cost of the material points beside the flow solve of the same step: the
scene of 'rayleighTaylor' on 128 x 128 cells, 16 points each."""

import re

import matplotlib.pyplot as plt

from cosserat.scenes.rayleighTaylor import scene
from studies.common import HERE, save

RATIOS = (1, 0.01)

KEYS = ("seeding", "moving", "averaging", "flow")


def run(path, n, ratio, ranks, steps=10):
    """One row, from Test-pointCost."""
    case = scene(path, ratio, n, 100, 1)
    case.decompose(ranks, "scotch")
    done = case.run("Test-pointCost", "-steps", steps, ranks=ranks).stdout
    value = dict(re.findall(
        r"(points|seeding|moving|averaging|flow|bytes|size) ([-\d.e+]+)",
        re.search(r"pointCost: .*", done)[0]))
    row = {"n": n, "ratio": ratio, "ranks": ranks,
           "points": int(value["points"])}
    row.update({key: float(value[key]) for key in KEYS})
    row.update({
        "share": (row["moving"] + row["averaging"])/row["flow"],
        "bytesPerPoint": float(value["bytes"]),
        "objectSize": int(value["size"]),
        "pointsPerSecond": row["points"]/row["moving"]})
    return row


def study():
    """Rows: n, ratio (of the viscosities), ranks, points, seeding, moving,
    averaging, flow [s], share (moving and averaging over flow),
    bytesPerPoint (growth of the processes by seeding), objectSize [bytes],
    pointsPerSecond (moved)."""
    rows = []
    for ratio in RATIOS:
        for ranks in (1, 2):
            rows.append(run(HERE/f"runs/pointCost/{ratio}-{ranks}", 128, ratio,
                            ranks))
            print(rows[-1], flush=True)

    figure, axes = plt.subplots(figsize=(6, 3.6), dpi=130)
    labels = [f"ratio {row['ratio']:g},\n{row['ranks']} rank"
              + "s"*(row["ranks"] > 1) for row in rows]
    left = [0.0]*len(rows)
    for key in KEYS:
        width = [row[key] for row in rows]
        axes.barh(labels, width, left=left, label=key)
        left = [a + b for a, b in zip(left, width)]
    axes.set_xlabel("seconds per step (seeding: once)")
    axes.legend(fontsize=8, ncol=len(KEYS), loc="lower center",
                bbox_to_anchor=(0.5, 1))
    axes.grid(axis="x", alpha=0.3)
    save(figure, "pointCost")
    plt.close(figure)
    return rows
