"""Relatives of the silo's corner (cosserat.scenes.relatives) by the flow solver,
against the finite elements; the silo itself is siloRate."""

import shutil

import numpy as np

from cosserat.case import residuals
from cosserat.references import RELATIVES
from cosserat.scenes.relatives import SCENES, RelativeCase, measure
from studies.common import HERE

#: Cells a unit length
MESHES = [8, 16, 32]


def run(path, name, scene, meshes, references):
    """Rows of a scene; references by quantity."""
    rows, errors = [], {}
    for cells in meshes:
        if not RelativeCase.fits(scene, cells):
            continue
        shutil.rmtree(path, ignore_errors=True)
        case = RelativeCase(path, scene, cells).write()
        case.run("cosseratPicFoam")
        for quantity, value in measure(case, scene, cells).items():
            reference = references[quantity].value
            error = value/reference - 1
            before = errors.get((quantity, cells//2))
            errors[quantity, cells] = error
            rows.append({
                "scene": name, "cells": cells, "quantity": quantity,
                "value": value, "reference": reference, "error": error,
                "order": float(np.log2(abs(before/error)))
                if before else None,
                "iterations": residuals(case.log())[0][3]})
            print(rows[-1], flush=True)
    return rows


def study():
    """Rows: scene, cells (a unit), quantity, value, reference, error
    (relative), order (from the row of half the cells), iterations."""
    path, rows = HERE/"runs/cornerRelatives", []
    for name, scene in SCENES.items():
        rows += run(path, name, scene, MESHES,
                    {q: RELATIVES[name, q] for q in scene.quantities})
    return rows
