"""Stiff against soft: scenes with a jump of the viscosities, on cell faces or
through cells, each one solve at rest.

Units: 1 m (the box |x|, |y| < 1/2), 1 Pa s, 1 N/m3. `contrast` is the ratio of
the viscosities of the body (of the upper layer, the right half) to those of
the rest, which are 1. Fractions of cut cells are exact areas; with `points` a
cell holds a lattice of so many instead.

    python3 -m cosserat.scenes.jumps SCENE CONTRAST CELLS [MEAN]

prints the quantities of a scene.
"""

import shutil
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Optional

from cosserat.scenes import bodies, layered
from cosserat.scenes.box import add_points
from cosserat.case import residuals
from cosserat.results import balance


@dataclass(frozen=True)
class Scene:
    """box: function (path, contrast, cells, **entries of Box) -> Box;
    measure: function (case, contrast, cells) -> dict of quantity: Result;
    region: of the points of the first material, where there may be any;
    points: a cell, where not told otherwise (None: fractions); cells,
    contrasts: what the study runs."""

    box: Callable
    measure: Callable
    region: Optional[str]
    cells: tuple
    contrasts: tuple
    points: Optional[int] = None


#: Cells a side. Of 30, 62, 126 the block has three quarters of the cells that
#: its sides cut, of 34, 66, 130 one quarter
FACES, ODD = (16, 32, 64, 128), (31, 63, 127)
CUT, CUT_LESS = (30, 62, 126), (34, 66, 130)
DISC = ((32, 64, 128), (0.01, 0.1, 10.0, 1e3, 1e6), 16)

SCENES = {
    "disc": Scene(bodies.box(bodies.disc), bodies.measure_disc("disc"),
                  bodies.DISC, *DISC),
    "disc, Cosserat": Scene(
        bodies.box(bodies.disc, True),
        bodies.measure_disc("disc, Cosserat", True), bodies.DISC, *DISC),
    "discFitted": Scene(bodies.fitted_box, bodies.measure_fitted, None,
                        (32, 64, 128), (1e3, 1e5, 3e5, 1e6)),
    "blockOnFaces": Scene(
        bodies.box(bodies.block), bodies.measure_block("block"), bodies.BLOCK,
        FACES, (1e-4, 1e3, 1e6, 1e8)),
    "blockOnFaces, Cosserat": Scene(
        bodies.box(bodies.block, True),
        bodies.measure_block("block, Cosserat"), bodies.BLOCK, FACES,
        (1e3, 1e6, 1e8)),
    "blockOnWavyFaces": Scene(bodies.wavy_box, bodies.measure_motion, None,
                              FACES, (1e-4, 1e3, 1e6)),
    "blockOnTriangles": Scene(bodies.triangles_box, bodies.measure_motion,
                              None, FACES, (1e-4, 1e3, 1e6)),
    "blockThroughCells": Scene(
        bodies.box(bodies.block), bodies.measure_block("block"), bodies.BLOCK,
        CUT, (1e-4, 1e-2, 1e2, 1e6)),
    "blockThroughCells, 1/4": Scene(
        bodies.box(bodies.block), bodies.measure_block("block"), bodies.BLOCK,
        CUT_LESS, (1e-4, 1e-2, 1e2, 1e6)),
    "solCx": Scene(layered.solCx_box, layered.measure_solCx, layered.RIGHT,
                   FACES, (1e3, 1e6)),
    "solCxThrough": Scene(layered.solCx_box, layered.measure_solCx,
                          layered.RIGHT, ODD, (1e3, 1e6)),
    "layers": Scene(layered.layers_box, layered.measure_layers,
                    layered.UPPER, FACES, (10.0,)),
    "layersThrough": Scene(layered.layers_box, layered.measure_layers,
                           layered.UPPER, ODD, (10.0,)),
    "columns": Scene(layered.columns_box, layered.measure_columns,
                     layered.MIDDLE, FACES, (10.0,)),
    "columnsThrough": Scene(layered.columns_box, layered.measure_columns,
                            layered.MIDDLE, CUT, (10.0,)),
    "tilted": Scene(layered.tilted_box, layered.measure_tilted, layered.OVER,
                    FACES, (10.0, 1e3)),
}


def prepare(path, name, contrast, cells, mean=None, points=0, **entries):
    """Case of a scene, meshed. mean: entry viscosityAverage (None: left out);
    points: a cell (0: the scene's own way; None: fractions)."""
    scene = SCENES[name]
    points = scene.points if points == 0 else points
    shutil.rmtree(path, ignore_errors=True)
    # Rounding of the stiff body's stresses keeps the rest from less
    tolerance = max(1e-8, 1e-14*contrast*max(1, (cells/64)**2))
    entries = {"tolerance": tolerance, "average": mean, **entries}
    case = scene.box(path, contrast, cells, **entries).write()
    if points:
        add_points(case, "{ type all; material second; } " + scene.region,
                   pointsPerCell=points)
        case.substitute("system/controlDict", {"endTime": 1e-9,
                                               "deltaT": 1e-9})
    return case


def run(path, name, contrast, cells, mean=None, points=0, **entries):
    """One solve: quantities (dict of Result), iterations, balance."""
    case = prepare(path, name, contrast, cells, mean, points, **entries)
    case.run("cosseratPicFoam")
    return {"quantities": SCENES[name].measure(case, contrast, cells),
            "iterations": residuals(case.log())[0][3],
            "balance": balance(case)}, case


def main(name, contrast, cells, mean=None):
    """The command line; the case is run in a temporary folder."""
    with tempfile.TemporaryDirectory() as folder:
        found, _ = run(Path(folder)/"case", name, float(contrast), int(cells),
                       mean)
    for quantity, result in found.pop("quantities").items():
        print(f"{quantity}: {result}")
    print(found)


if __name__ == "__main__":
    main(*sys.argv[1:])
