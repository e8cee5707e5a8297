"""Rayleigh-Taylor instability of van Keken et al. (1997), J. Geophys. Res. 102,
22477: a light layer below a heavy one in a box of 0.9142 x 1, their interface
at 0.2 + 0.02 cos(pi x/0.9142), no slip below and above, free slip at the
sides. Viscosity 1 above, `ratio` below; a density difference and gravity of 1.

The viscosity of cut cells is the harmonic mean: the interface is sheared along
itself. On 32 x 32 cells at ratio 0.01 it has the peak at 1.44e-2 at 50, the
geometric mean 1.23e-2 at 54, the arithmetic one 1.10e-2 at 58."""

import matplotlib.pyplot as plt

from cosserat.picture import snapshot
from cosserat.scenes.rayleighTaylor import SCENES, run, speeds
from studies.common import HERE, save

CELLS = [64, 96]


def draw(cases):
    """Speed against time, and the materials at the finest mesh."""
    finest = {ratio: cases[ratio, max(n for r, n in cases if r == ratio)]
              for ratio in SCENES}
    figure, axes = plt.subplots(1, 4, figsize=(13, 3.6), dpi=130)
    for i, (ratio, (end, _, highest, when)) in enumerate(SCENES.items()):
        for (own, n), case in cases.items():
            if own == ratio:
                axes[0].plot(*speeds(case).T, color=f"C{i}",
                             lw=1.6 if case is finest[ratio] else 0.7,
                             label=f"ratio {ratio}"
                             if case is finest[ratio] else None)
        axes[0].plot(when, highest, "k+", ms=9,
                     label="published peak" if i == 0 else None)
        case = finest[ratio]
        snapshot(case, case.times()[-1], [0, 1], axes=axes[i + 1],
                 velocity=False, size=0.3)
        axes[i + 1].set_title(f"ratio {ratio}, t = {end}", fontsize=9)
    axes[0].set_xlabel("time")
    axes[0].set_ylabel("$v_{rms}$")
    axes[0].set_ylim(bottom=0)
    axes[0].grid(alpha=0.3)
    axes[0].legend(fontsize=7)
    save(figure, "rayleighTaylor")
    plt.close(figure)


def study():
    """Rows: ratio, n (cells a side), growth, linearGrowth (of linear theory),
    vrmsMax, tMax, steps, cpu [s]."""
    cases, rows = {}, []
    for n in CELLS:
        for ratio in SCENES:
            cases[ratio, n], row = run(
                HERE/f"runs/rayleighTaylor/{ratio}-{n}", ratio, n)
            rows.append(row)
            print(row, flush=True)
    draw(cases)
    return rows
