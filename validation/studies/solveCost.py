"""Cost of a flow solve in Poisson solves of the same mesh: the sinking block
of 'extremes' on four meshes."""

import re

import matplotlib.pyplot as plt

from cosserat.scenes.block import DEFAULT, block
from studies.common import HERE, cell_ticks, save

CELLS = [64, 128, 256, 512]


def run(n, contrast, model, repeat=3):
    """One row: alternating flow and Poisson solves, the best of each."""
    given = {**DEFAULT, "n": n, "contrast": contrast}
    if model == "classical":
        given.update(coupling=0.0, R=0.0)
    case = block(HERE/"runs/solveCost/case", **given, tolerance=1e-6)
    case.override("solution", creepingFlow="{ preconditioner"
                  " { block multigrid; } }")
    done = case.run("Test-solveCost", "-repeat", repeat).stdout
    value = dict(re.findall(
        r"(flowSeconds|iterations|poissonIterations|poissonUnits|peakMemory)"
        r" (\S+)", done))
    return {"n": n, "contrast": contrast, "model": model,
            "iterations": int(value["iterations"]),
            "poissonIterations": int(value["poissonIterations"]),
            "poissonUnits": float(value["poissonUnits"]),
            "cpu": float(value["flowSeconds"]),
            "peakMemory": 1024*int(value["peakMemory"]),
            "bytesPerCell": 1024*int(value["peakMemory"])/n**2}


def draw(rows):
    """Figure: the ratio against the mesh."""
    figure, axes = plt.subplots(figsize=(6, 4), dpi=130)
    for model, style in (("classical", "--"), ("cosserat", "-")):
        for i, contrast in enumerate((1, 1e3, 1e6)):
            own = [row for row in rows if row["model"] == model
                   and row["contrast"] == contrast]
            axes.semilogx([row["n"] for row in own],
                          [row["poissonUnits"] for row in own], style + "o",
                          ms=4, color=f"C{i}", base=2,
                          label=f"{model}, contrast {contrast:g}")
    cell_ticks(axes, CELLS, [f"{n}$^2$" for n in CELLS])
    axes.set_xlabel("cells")
    axes.set_ylabel("flow solve over Poisson solve")
    axes.set_ylim(0, 40)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, ncol=2, loc="upper left")
    save(figure, "solveCost")
    plt.close(figure)


def study():
    """Rows: n, contrast, model, iterations, poissonIterations, poissonUnits,
    cpu [s] of one solve, peakMemory [bytes] of the process, bytesPerCell."""
    rows = [run(n, contrast, model) for n in CELLS
            for contrast in (1, 1e3, 1e6)
            for model in ("classical", "cosserat")]
    draw(rows)
    return rows
