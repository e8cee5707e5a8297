"""Independent reference solutions by finite elements (numpy and scipy).

    from cosserat.finiteElements import Flow, Mesh, Wall, between, lines

    mesh = Mesh.tensor(lines([0, 1], 0.1), lines([0, 0.5, 1], 0.1),
                       keep=lambda x, y: (x < 0.5) | (y < 0.5))
    mesh.grade([(0.5, 0.5)], 1e-8)            # rings around a corner
    flow = Flow(mesh, degree=3, eta=1, etaC=1, M=0.1, force=(0, -1),
                walls=[Wall(lambda x, y: x < 1e-9, u=(0, 0), omega=0),
                       Wall(lambda x, y: y < 1e-9, normal=0)])
    flow.flux((0, 0.5), (0.5, 0.5)); flow.at(0.2, 0.3); flow.dissipation()

Elements: Q_k for u and omega, discontinuous P_(k-1) for p, so that mass is
kept cell by cell and p may jump between materials; k = 2, 3, 4. The cells are
quadrilaterals of blocks that a function maps into the plane (mesh.Mesh), with
k + 1 nodes a side on the map (isoparametric). Corners where a flow is not
smooth are graded by rings down to any size: places in a ring are kept
relative to its corner.

Mesh: mesh.tensor, blocks with maps, holes, periodic, grade.
Wall: velocity, free slip on any slope, omega, traction, couple.
Flow: solution; flux, at, wall_load, dissipation, power, u, omega, xy.
"""

from cosserat.finiteElements.flow import Flow, Wall
from cosserat.finiteElements.mesh import Mesh, between, graded_lines, lines

__all__ = ["Flow", "Mesh", "Wall", "between", "graded_lines", "lines"]
