"""Meshes of prisms on the unit square [-1/2, 1/2]^2, written as
constant/polyMesh of a case: triangles by Delaunay's triangulation of shaken
points, and honeycombs."""

import numpy as np
from scipy.spatial import Delaunay

HEADER = """FoamFile
{{ version 2.0; format ascii; class {cls}; {note}location "constant/polyMesh";
object {name}; }}
// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //
"""


def shaken_points(n, shake=0.2, seed=1):
    """Rows of points about 1/n apart, those inside shaken."""
    points = []
    random = np.random.default_rng(seed)
    for j in range(n + 1):
        shift = 0.5 if j % 2 else 0.0
        x = (np.arange(n + 1) + shift)/n - 0.5
        if shift:
            x = np.concatenate([[-0.5], x[:-1], [0.5]])
        for xi in x:
            point = np.array([xi, j/n - 0.5])
            if abs(abs(point) - 0.5).min() > 1e-9:
                point += shake/n*random.uniform(-0.5, 0.5, 2)
            points.append(point)
    return np.array(points)


def nearest_side(a, b):
    """Patch of the edge between two points of the boundary."""
    x, y = (a + b)/2
    distance = {"left": x + 0.5, "right": 0.5 - x, "bottom": y + 0.5,
                "top": 0.5 - y}
    return min(distance, key=distance.get)


def write_prisms(case, n, depth=0.1):
    """Write the mesh with patches left, right, bottom, top, frontAndBack."""
    flat = shaken_points(n)
    triangles = Delaunay(flat).simplices
    a, b, c = (flat[triangles[:, i]] for i in range(3))
    area = ((b - a)[:, 0]*(c - a)[:, 1] - (b - a)[:, 1]*(c - a)[:, 0])/2
    triangles = triangles[np.abs(area) > 1e-9]
    area = area[np.abs(area) > 1e-9]
    triangles[area < 0] = triangles[area < 0][:, ::-1]
    # Neighbouring cells get neighbouring numbers
    triangles = triangles[np.lexsort(flat[triangles].mean(axis=1).T)]

    write_polygons(case, flat, triangles, nearest_side, depth)


def write_honeycomb(case, n):
    """Write a mesh of n rows of hexagons, cells of four and five edges beside
    the walls; patches as those of write_prisms."""
    flat, numbers = [], {}

    def corner(i, j):
        """Number of the point i half cells from the left, on line j."""
        if (i, j) not in numbers:
            numbers[i, j] = len(flat)
            inside = 0 < i < 2*n and 0 < j < n
            bend = (-0.15 if (i + j) % 2 else 0.15)*inside
            flat.append((i/(2*n) - 0.5, (j + bend)/n - 0.5))
        return numbers[i, j]

    cells = []
    for j in range(n):
        ends = list(range(0, 2*n + 1, 2))
        if j % 2:
            ends = [0, *range(1, 2*n, 2), 2*n]
        for a, b in zip(ends, ends[1:]):
            # On the lines of the walls nothing ends in the middle
            below = range(a, b + 1) if j > 0 else (a, b)
            above = range(a, b + 1) if j < n - 1 else (a, b)
            cells.append(np.array([corner(i, j) for i in below]
                                  + [corner(i, j + 1) for i in above][::-1]))
    write_polygons(case, np.array(flat), cells, nearest_side)


def write_polygons(case, flat, cells, side, depth=0.1):
    """Write the mesh of prisms on cells, polygons of the points flat given
    counter-clockwise; side(a, b) names the patch of an edge of the boundary."""
    edges = {}
    for cell, corners in enumerate(cells):
        for p, q in zip(corners, np.roll(corners, -1)):
            edges.setdefault(frozenset((p, q)), []).append((cell, p, q))

    n_flat = len(flat)

    def quad(p, q):
        """Face between two points, its normal out of a cell to their left."""
        return (p, q, q + n_flat, p + n_flat)

    inner, outer = [], {}
    for uses in edges.values():
        (cell, p, q), *other = uses
        if other:
            inner.append((cell, other[0][0], quad(p, q)))
        else:
            outer.setdefault(side(flat[p], flat[q]), []).append(
                (cell, quad(p, q)))

    def ordered(cell, neighbour, face):
        return ((cell, neighbour, face) if cell < neighbour
                else (neighbour, cell, face[::-1]))

    inner = sorted(ordered(*row) for row in inner)
    caps = ([(i, tuple(t[::-1])) for i, t in enumerate(cells)]
            + [(i, tuple(np.array(t) + n_flat)) for i, t in enumerate(cells)])

    points = np.vstack([np.c_[flat, np.zeros(n_flat)],
                        np.c_[flat, np.full(n_flat, depth)]])
    write_mesh(case, points, inner,
               [*((name, "wall", rows) for name, rows in outer.items()),
                ("frontAndBack", "empty", caps)])


def write_mesh(case, points, inner, patches):
    """Write constant/polyMesh: points (n, 3); inner faces (owner, neighbour,
    points of it) in OpenFOAM's order; patches (name, type and what belongs to
    it, [(owner, points of it)])."""
    faces = [face for _, _, face in inner]
    owner = [cell for cell, _, _ in inner]
    boundary = []
    for name, kind, rows in patches:
        boundary.append(f"{name} {{ type {kind}; nFaces {len(rows)}; "
                        f"startFace {len(faces)}; }}")
        owner += [cell for cell, _ in rows]
        faces += [face for _, face in rows]
    note = (f'note "nPoints:{len(points)}  nCells:{max(owner) + 1}  '
            f'nFaces:{len(faces)}  nInternalFaces:{len(inner)}"; ')

    def file(name, cls, rows):
        path = case.path/"constant/polyMesh"/name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(HEADER.format(cls=cls, name=name, note=note)
                        + f"{len(rows)}\n(\n" + "\n".join(rows) + "\n)\n")

    def text(values):
        return "(" + " ".join(map(str, values)) + ")"

    file("points", "vectorField", [text(map(repr, map(float, p)))
                                   for p in points])
    file("faces", "faceList", [f"{len(f)}{text(f)}" for f in faces])
    file("owner", "labelList", list(map(str, owner)))
    file("neighbour", "labelList", [str(row[1]) for row in inner])
    file("boundary", "polyBoundaryMesh", boundary)
