"""The function object errorIndicator against the true errors of the strains,
where these are known or by finite elements."""

import matplotlib.pyplot as plt
import numpy as np

from cosserat.scenes.indicator import around, at_rest, compare, run, worst
from studies.common import HERE, save

FOLDER = HERE/"runs/errorIndicator"

CELLS = [12, 24, 48]

#: Scene: label of the figure, numbers of cells across, a side or a unit
SCENES = {
    "layer0.3": ("layer, R/h 0.3", CELLS),
    "layer0.05": ("layer, R/h 0.05", CELLS),
    "channel": ("channel", CELLS),
    "annularCouette": ("annular Couette", [8, 16, 32]),
    "uniform": ("manufactured, uniform", CELLS),
    "wavy": ("manufactured, wavy", CELLS),
    "triangles": ("manufactured, triangles", CELLS),
    "halved": ("manufactured, hanging nodes", CELLS),
    "jump": ("jump along faces, 1000:1", [16, 32, 64]),
    "inclusion": ("inclusion, 500:1", [16, 32, 64]),
    "silo": ("silo, 1000:1", [2, 4, 8]),
    "rayleighTaylor": ("Rayleigh-Taylor", [16, 32, 64]),
}


def draw(rows, cells):
    """Indicator against true error of each cell of the middle meshes, and
    effectivity against cells."""
    figure, axes = plt.subplots(3, 4, figsize=(11, 8), dpi=130)
    for axis, (scene, (true, indicator)) in zip(axes.ravel(), cells.items()):
        whole = true.sum()
        axis.loglog(true/whole, indicator/whole, ".", ms=1.5, alpha=0.5)
        span = np.array([true.max()/whole*1e-6, true.max()/whole])
        axis.loglog(span, span, "k:", lw=0.8)
        axis.set_xlim(span[0], 3*span[1])
        axis.set_ylim(span[0], 3*span[1])
        row = next(r for r in rows if r["scene"] == scene
                   and r["n"] == SCENES[scene][1][1])
        axis.set_title(f"{SCENES[scene][0]}\neffectivity"
                       f" {row['effectivity']:.2f}, rank correlation"
                       f" {row['correlation']:.2f}", fontsize=7)
        axis.tick_params(labelsize=6)
    for axis in axes[-1]:
        axis.set_xlabel("true error of the cell", fontsize=7)
    for axis in axes[:, 0]:
        axis.set_ylabel("indicator", fontsize=7)
    save(figure, "errorIndicator")
    plt.close(figure)


def study():
    """Rows: scene, n (cells across or a side; a unit of the silo), cells,
    error (true, of the strains over those of the flow, in its energy),
    indicator, effectivity, correlation (of the ranks of cells), found (of the
    error in the worst tenth, in that by the indicator), worstShare and
    trueWorstShare (of all in it); the last ones of meshes whose worst tenth
    of cells by the indicator has been halved, and those around it too."""
    rows, cells = [], {}
    for scene, (_, numbers) in SCENES.items():
        for n in numbers:
            row, *fields = compare(scene, n, *run(FOLDER, scene, n))
            rows.append(row)
            print(*(f"{value:.3g}" if isinstance(value, float) else value
                    for value in row.values()), flush=True)
            if n == numbers[1]:
                cells[scene] = fields
    for scene, n in (("silo", 4), ("inclusion", 16)):
        case, _ = at_rest(FOLDER, scene, n)
        picked = worst(case.field("errorIndicator"))
        for name, halve in (("worst tenth halved", picked),
                            ("and those around", around(case, picked))):
            row, *_ = compare(f"{scene}, {name}", n, *at_rest(FOLDER, scene, n, halve))
            rows.append(row)
            print(row, flush=True)
    draw(rows, cells)
    return rows
