#!/usr/bin/env pvpython
# SPDX-License-Identifier: GPL-3.0-or-later
"""A case in ParaView: cells coloured by a field, points by material and dye.

    pvpython showCase.py CASE [FIELD [FILE.png]]

or in ParaView's Python shell, with the case's folder as the current one:

    exec(open("showCase.py").read())

Without a file to write, pvpython opens a window. Reads the case itself
(ParaView's reader of OpenFOAM cases), serial or decomposed.
"""

import sys
from pathlib import Path

from paraview import simple as pv

CLOUD = "lagrangian/materialPoints"


def show(case, field="omega"):
    """Set the view up; returns it."""
    marker = Path(case)/f"{Path(case).resolve().name}.foam"
    marker.touch()
    reader = pv.OpenFOAMReader(FileName=str(marker))
    serial = any(p.name[0] in "123456789" for p in Path(case).iterdir())
    reader.CaseType = "Reconstructed Case" if serial else "Decomposed Case"
    reader.UpdatePipelineInformation()
    reader.MeshRegions = [r for r in ("internalMesh", CLOUD)
                          if r in reader.MeshRegions.Available]
    view = pv.GetActiveViewOrCreate("RenderView")
    view.InteractionMode = "2D"
    pv.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    pv.GetAnimationScene().GoToLast()

    mesh = pv.ExtractBlock(Input=reader)
    mesh.Selectors = ["/Root/internalMesh"]
    cells = pv.Show(mesh, view)
    pv.ColorBy(cells, ("CELLS", field))
    cells.RescaleTransferFunctionToDataRange(True)
    cells.SetScalarBarVisibility(view, True)

    points = pv.ExtractBlock(Input=reader)
    points.Selectors = ["/Root/lagrangian"]
    dyed = pv.Threshold(Input=points, Scalars=["POINTS", "dye"])
    dyed.LowerThreshold, dyed.UpperThreshold = 1, 1e9
    dots = pv.Show(dyed, view)
    dots.PointSize = 3
    dots.AmbientColor = dots.DiffuseColor = [0.35, 0.2, 0.07]

    view.ResetCamera()
    return view


if __name__ in ("__main__", "__vtkconsole__"):
    arguments = sys.argv[1:] or ["."]
    window = show(*arguments[:2])
    if len(arguments) > 2:
        pv.SaveScreenshot(arguments[2], window, ImageResolution=[1200, 900])
    elif __name__ == "__main__":
        pv.Interact(window)
