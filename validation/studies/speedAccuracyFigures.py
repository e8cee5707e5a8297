"""Figures of the study speedAccuracy."""

import matplotlib.pyplot as plt

from studies.common import save

TITLES = {"shearLayer": "shear layer, R/h = 0.05",
          "inclusionSolve": "sinking inclusion, one solve",
          "inclusionFall": "sinking inclusion, fall of a radius",
          "silo": "silo to 1.9 ms"}


def of(rows, scene, *varied):
    """Runs of a scene that ended, of some kinds."""
    return [row for row in rows if row["scene"] == scene
            and row["error"] is not None
            and (not varied or row["varied"] in varied)]


def single(rows, scene, key):
    """Runs with one setting changed, the default among them, by its value."""
    own = of(rows, scene, "default", key)
    return sorted(own, key=lambda row: row[key])


def draw_front(rows):
    """Error against cost, all runs of each scene, with the front."""
    figure, axes = plt.subplots(2, 2, figsize=(10, 7.5), dpi=130)
    marks = {"cells": "C0s-", "pointsPerCell": "C1o-", "maxCo": "C2^-",
             "tolerance": "C3v-"}
    for axis, (scene, title) in zip(axes.flat, TITLES.items()):
        own = of(rows, scene)
        rest = [row for row in own if row["varied"] not in marks]
        axis.plot([r["cpu"] for r in rest], [r["error"] for r in rest], ".",
                  color="silver", label="other settings, combined", zorder=1)
        for key, mark in marks.items():
            line = single(rows, scene, key)
            axis.plot([r["cpu"] for r in line], [r["error"] for r in line],
                      mark, ms=4, lw=0.8, label=key)
        best = sorted((r for r in own if r["onFront"]), key=lambda r: r["cpu"])
        axis.step([r["cpu"] for r in best], [r["error"] for r in best], "k:",
                  where="post", lw=1.2, label="front")
        start = of(rows, scene, "default")[0]
        axis.plot(start["cpu"], start["error"], "k*", ms=11, label="default")
        if start["errorUncertainty"]:
            axis.axhspan(0, start["errorUncertainty"], color="0.93", zorder=0)
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.set_title(title, fontsize=10)
        axis.set_xlabel("processor time [s]")
        axis.set_ylabel("error")
        axis.grid(alpha=0.3)
    axes[0, 0].legend(fontsize=7)
    save(figure, "speedAccuracy")
    plt.close(figure)


def draw_gain(rows):
    """For each setting and scene the change of error and of cost."""
    scenes = list(TITLES)
    keys = []
    for row in rows:
        if row.get("varied") not in (None, "default", "combined", *keys):
            keys.append(row["varied"])
    labels = []
    for key in keys:
        for value in dict.fromkeys(row[key] for row in rows
                                   if row.get("varied") == key
                                   and (key != "cells"
                                        or row["scene"] == "inclusionFall")):
            labels.append((key, value))
    figure, axes = plt.subplots(1, 4, figsize=(12, 8), dpi=130, sharey=True)
    for axis, scene in zip(axes, scenes):
        start = of(rows, scene, "default")[0]
        cells = iter(single(rows, scene, "cells"))
        for i, (key, value) in enumerate(labels):
            if key == "cells":
                row = next(r for r in cells if r is not start)
            else:
                row = next((r for r in rows if r["scene"] == scene
                            and r["varied"] == key and r[key] == value), start)
            if row is start:
                axis.text(1, i, "default", fontsize=6, va="center")
                continue
            if row["error"] is None:
                axis.text(1, i, row["status"][:24], fontsize=6, va="center",
                          color="C3")
                continue
            for offset, name, colour in ((-0.2, "error", "C3"),
                                         (0.2, "cpu", "C0")):
                ratio = row[name]/start[name]
                axis.barh(i + offset, ratio - 1, 0.38, left=1, color=colour,
                          label=name if i == 0 else None)
        axis.axvline(1, color="k", lw=0.8)
        axis.set_xscale("log")
        axis.set_xlim(0.05, 20)
        axis.set_title(TITLES[scene], fontsize=8)
        axis.grid(axis="x", alpha=0.3)
    axes[0].set_yticks(range(len(labels)), [
        f"{key} {value}" if key != "cells" else f"cells, other level {i + 1}"
        for i, (key, value) in enumerate(labels)], fontsize=7)
    axes[0].invert_yaxis()
    axes[0].legend(fontsize=7)
    figure.supxlabel("over the default's")
    save(figure, "speedAccuracy-settings")
    plt.close(figure)


def draw_lines(rows):
    """Error against tolerance, and of the classical model against R/L."""
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.8), dpi=130)
    for i, (scene, title) in enumerate(TITLES.items()):
        for axis, key in zip(axes, ("tolerance", "pointsPerCell")):
            line = single(rows, scene, key)
            axis.loglog([r[key] for r in line], [r["error"] for r in line],
                        "o-", ms=4, color=f"C{i}", label=title)
            axis.set_xlabel(key)
            axis.set_ylabel("error")
    own = [row for row in rows if row["scene"] == "classical"]
    for key in ("Inclusion", "Channel", "Layer"):
        axes[2].loglog([r["RoverL"] for r in own],
                       [r[f"error{key}"] for r in own], "o-", ms=4,
                       label=key.lower())
    axes[2].axhline(0.01, color="grey", ls=":", lw=0.8)
    axes[2].set_xlabel("R over radius or height")
    axes[2].set_ylabel("error of the classical velocity")
    for axis in axes:
        axis.grid(alpha=0.3)
    for axis in axes[::2]:
        axis.legend(fontsize=7)
    save(figure, "speedAccuracy-limits")
    plt.close(figure)


def draw(rows):
    """All figures."""
    draw_front(rows)
    draw_gain(rows)
    draw_lines(rows)
