"""Points that are mixed are put in the order of their cells again."""

import re

import numpy as np
import pytest

from cosserat.scenes.box import STILL, add_points

LID = ("type fixedValue; value uniform (1 0 0);", "type zeroGradient;")

CELLS = 48


def mix(folder, order):
    """Put the points in the files of a folder in an order."""
    for path in folder.iterdir():
        text = path.read_text()
        # A field of one value is not written as a list
        match = re.search(r"\n\d+\n\(\n(.*?)\n\)\n", text, re.S)
        if match:
            rows = match[1].split("\n")
            assert len(rows) == len(order)
            path.write_text(text[:match.start(1)]
                            + "\n".join(rows[i] for i in order)
                            + text[match.end(1):])


@pytest.mark.parametrize("share, sorts", [(0.002, False), (0.05, True)])
def test_mixed_points_are_sorted(box, share, sorts):
    """A share of the points changes places in the list. Where more than one in
    two hundred is then far from the one before, all are sorted in the next
    step, which leaves every point where it would have been."""
    case = box("case", n=CELLS, tolerance=1e-6,
               materials={"a": {"eta": 1, "etaC": 0, "R": 0}},
               walls={**{side: STILL for side in ("left", "right", "bottom")},
                      "top": LID})
    add_points(case, "{ type all; material a; }")
    case.override("control", startFrom="latestTime", adjustTimeStep="no",
                  writeControl="timeStep", writeInterval=1, writePrecision=17,
                  deltaT=0.01, endTime=0.02)
    case.run("cosseratPicFoam")
    expected = case.cloud("positions")[np.argsort(case.cloud("origId"))]

    random = np.random.default_rng(1)
    order = np.arange(len(expected))
    chosen = random.choice(len(order), int(share*len(order)), replace=False)
    order[np.sort(chosen)] = chosen
    mix(case.path/"0.01/lagrangian/materialPoints", order)
    for file in sorted((case.path/"0.02").rglob("*"), reverse=True):
        file.rmdir() if file.is_dir() else file.unlink()
    (case.path/"0.02").rmdir()
    case.run("cosseratPicFoam")

    number = case.cloud("origId")
    places = case.cloud("positions")
    assert np.abs(places[np.argsort(number)] - expected).max() < 1e-12
    rows = np.floor((places[:, 1] - case.mesh_points()[:, 1].min())*CELLS)
    assert ((np.diff(rows) < 0).sum() < CELLS) == sorts
