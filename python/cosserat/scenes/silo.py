"""The silo at rest: cases of the scenes of references.py, and their rate."""

import re

import numpy as np

from cosserat.case import FILES

#: Depth of the mesh [m]
DEPTH = 0.1

#: Internal lengths in apertures
ALPHAS = {"0": 0.0, "1/3": 1/3, "2/3": 2/3, "5/3": 5/3, "10/3": 10/3}

#: The fill [m2]
VOLUME = 25.0

#: Time in which nothing moves [s]
REST = 1e-9

#: Lengths of the blocks of the tutorial's blockMeshDict
BLOCKS = {"nWall": 0.25, "nAperture": 1, "nCorridor": 1, "nAbove": 1,
          "nFloor": 2, "nBelow": 3.75, "nFill": 5}


def mesh_entries(cells):
    """Entries of blockMeshDict for a number of cells a unit length."""
    return {key: max(round(length*cells), 1) for key, length in BLOCKS.items()}


#: Those of half the resolution of the tutorial
COARSE = mesh_entries(4)


def reshape(case, silo, cells):
    """Give a copy of the tutorial the slot of a scene, cells a unit length."""
    case.substitute(FILES["mesh"], mesh_entries(cells) | {
        "nAperture": round(silo.aperture*cells),
        "nFloor": round((2.5 - silo.aperture/2)*cells),
        "nBelow": round((4 - silo.floor)*cells)})
    half = silo.aperture/2
    path = case.path/FILES["mesh"]
    # Coordinates of the slot, and cells across its floor
    text = re.sub(r"\((-?)0\.5 ", rf"(\g<1>{half} ", path.read_text())
    text = text.replace(" -0.25 $", f" {-silo.floor} $")
    path.write_text(re.sub(r"(\(\$n\w+ )\$nWall 1\)",
                           rf"\g<1>{round(silo.floor*cells)} 1)", text))


def solve_once(case, alpha, corners=True, tolerance=1e-8):
    """Make a copy of the tutorial, or of the round one, one solve of its start
    with the internal length alpha; 0: classical."""
    case.substitute(FILES["control"], {
        "endTime": REST, "deltaT": REST, "adjustTimeStep": "no",
        "writeControl": "timeStep", "writeInterval": 1, "writePrecision": 12})
    case.substitute(FILES["solution"], {"tolerance": tolerance})
    if not corners:
        case.override("solution", creepingFlow="{ corners off; }")

    path = case.path/FILES["materials"]
    if alpha == 0:
        path.write_text(re.sub(r"etaC(\s+)1000;", r"etaC\g<1>0;",
                               path.read_text()))
    case.substitute(FILES["materials"], {"alpha": repr(float(alpha))})
    case.substitute(FILES["points"], {"pointsPerCell": 4})


def prepare(case, silo, cells, corners=True, tolerance=1e-8):
    """Make a copy of the tutorial one solve of a scene, without dye; meshed."""
    reshape(case, silo, cells)
    solve_once(case, silo.alpha, corners, tolerance)

    path = case.path/FILES["materials"]
    path.write_text(re.sub(r"eta(\s+)1;", rf"eta\g<1>{silo.background};",
                           path.read_text()))

    path = case.path/FILES["points"]
    text = re.sub(r"    dye\n    \(.*?\n    \);\n", "", path.read_text(),
                  flags=re.S)
    if silo.filled:
        text = text.replace("        }\n    );", """        }
        {
            type        box;
            material    granular;
            min         (%s %s -1);
            max         (%s 5 1);
        }
    );""" % (-silo.aperture/2, -silo.floor, silo.aperture/2), 1)
    path.write_text(text)

    if silo.rough:
        # A name prevails over the pattern
        for name, entry in (("U", "type noSlip;"),
                            ("omega", "type fixedValue; value uniform 0;")):
            path = case.path/"0"/name
            path.write_text(path.read_text().replace(
                "boundaryField\n{",
                f"boundaryField\n{{\n    siloWalls {{ {entry} }}", 1))
    case.run("blockMesh")
    return case


def halve(case):
    """Leave a copy of the tutorial the half x > 0 of its mesh behind a mirror.
    Of the whole the jet folds to one side when it stands on the floor, sooner
    or later as chance has it."""
    path = case.path/FILES["mesh"]
    # Vertices are numbered row by row, eight in each, on back and front
    text = re.sub(r"    hex \((\d+) .*\n",
                  lambda m: m[0] if int(m[1]) % 8 > 2 else "",
                  path.read_text())

    def kept(match):
        columns = {int(vertex) % 8 for vertex in match[1].split()}
        return match[0] if min(columns) > 2 and columns != {3} else ""

    text = re.sub(r" {12}\(([\d ]+)\)\n", kept, text)
    middle = " ".join(f"({i} {i + 40} {i + 48} {i + 8})"
                      for i in (3, 11, 19, 27))
    path.write_text(text.replace("(-0.5 ", "(0 ").replace(
        "boundary\n(", f"""boundary
(
    middle
    {{
        type symmetryPlane;
        faces ({middle});
    }}"""))
    across = int(case.entries(FILES["mesh"])["nAperture"])
    case.substitute(FILES["mesh"], {"nAperture": across//2})


def rate(case, aperture=1):
    """Volume that leaves through the aperture, y = 0, in a time [m2/s], by the
    fluxes of the last time."""
    phi = case.field("phi")
    corners = case.internal_faces()
    middle, size = corners.mean(axis=1), np.ptp(corners, axis=1)
    through = ((np.abs(middle[:, 1]) < 1e-9) & (size[:, 1] < 1e-9)
               & (np.abs(middle[:, 0]) < aperture/2))
    # In refined meshes normals of faces are up and down
    normal = np.cross(corners[:, 2] - corners[:, 0],
                      corners[:, 3] - corners[:, 1])[:, 1]
    return float(-(phi*np.sign(normal))[through].sum()/DEPTH)


#: Cells and growth towards the corners (largest over smallest of a half, or of
#: a block with a corner at one end) of columns and rows of blocks of the
#: tutorial's mesh, for smallest cells of 1/32
REFINED = {
    "columns": [("end", 12, 6), ("both", 8, 1), ("both", 24, 6),
                ("both", 16, 4), ("both", 24, 6), ("both", 8, 1),
                ("start", 12, 6)],
    "rows": [("end", 36, 8), ("both", 8, 1), ("both", 48, 8),
             ("start", 12, 6)],
}


def refine(case, half=False):
    """Refine the mesh of a copy of the tutorial, or of its half, into the
    corners."""
    columns = list(REFINED["columns"])
    if half:
        _, cells, growth = columns[3]
        columns[3] = "end", cells//2, growth

    def grading(towards, _, growth):
        if towards == "both":
            return f"((0.5 0.5 {growth}) (0.5 0.5 {1/growth!r}))"
        return repr(float(growth) if towards == "start" else 1/growth)

    def block(match):
        # Vertices are numbered row by row, eight in each
        first = int(match[1].split()[0])
        column = columns[first % 8]
        row = REFINED["rows"][first // 8]
        return (f"hex ({match[1]}) ({column[1]} {row[1]} 1) simpleGrading "
                f"({grading(*column)} {grading(*row)} 1)")

    path = case.path/FILES["mesh"]
    path.write_text(re.sub(
        r"hex \(([\d ]+)\) \([^)]*\) simpleGrading \(1 1 1\)", block,
        path.read_text()))
