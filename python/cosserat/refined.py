"""Meshes some cells of which are halved both ways."""

import numpy as np


def refine_cells(case, cells):
    """Halve cells (labels) of a case in the plane xy. The fields of its start
    time are not taken along."""
    sets = case.path/"constant/polyMesh/sets"
    sets.mkdir(exist_ok=True)
    labels = " ".join(str(int(cell)) for cell in np.sort(cells))
    (sets/"refined").write_text(f"""
FoamFile {{ version 2.0; format ascii; class cellSet; object refined; }}
{len(cells)} ( {labels} )
""")
    (case.path/"system/refineMeshDict").write_text("""
FoamFile { version 2.0; format ascii; class dictionary; object x; }
set refined; coordinateSystem global;
globalCoeffs { tan1 (1 0 0); tan2 (0 1 0); }
directions (tan1 tan2);
useHexTopology no; geometricCut yes; writeMesh no;
""")
    case.run("refineMesh", "-overwrite", "-dict", "system/refineMeshDict",
             "-noFunctionObjects")


def middles(case):
    """Means of the corners of each cell, (cells, 2), without a field."""
    return np.array([np.mean(corners, axis=0)[:2]
                     for corners in case.polygons()])


def refine_scene(case, **selections):
    """Refine a case by refineScene, given a text of entries per selection;
    returns what it says."""
    refine = "\n".join(f"{name} {{ {entries} }}"
                       for name, entries in selections.items())
    (case.path/"system/refineSceneDict").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object x; }\n"
        f"refine\n{{\n{refine}\n}}\n")
    case.run("refineScene", "-overwrite")
    return case.log("refineScene")
