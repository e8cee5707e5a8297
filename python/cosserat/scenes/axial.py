"""Wedges for flows around an axis: one block of cells in the mid-plane, bent
to any shape, with values of exact flows on its sides."""

import re

import numpy as np

from cosserat.case import Case
from cosserat.foamfile import listed, write_file
from cosserat.scenes.box import material
from cosserat.triangles import write_mesh

#: Sides of the block
SIDES = ("left", "right", "bottom", "top")


class AxialCase(Case):
    """A wedge with its axis along x, its mid-plane that of x and y.

    shape: function (s, t) -> (x, y) of the unit square, s from left to right
    and t from bottom to top; n: cells along s and t; walls: dict of side:
    (U, p_rgh, omega), each text or a function (x, y) of values; cyclic: are
    left and right one; materials: dict of name: dict of eta, etaC, R, B, rho,
    or law, coeffs (text), rho;
    fractions: function (x, y) of the first one's; g: along the axis; angle
    between the planes [degrees]; triangles: halve the cells; average: of the
    viscosities."""

    def __init__(self, path, shape, n, walls, materials, cyclic=False,
                 fractions=None, g=None, force=None, couple=None, angle=5.0,
                 tolerance=1e-10, functions="", triangles=False,
                 average="arithmetic"):
        super().__init__(path)
        self.n, self.cyclic, self.triangles = n, cyclic, triangles
        s, t = np.meshgrid(*(np.linspace(0, 1, k + 1) for k in n))
        self.nodes = np.array(shape(s, t))
        self.slope = np.tan(np.radians(angle)/2)
        #: Whole circle over the wedge
        self.to_circle = np.pi/self.slope
        self._mesh()
        self._dictionaries(materials, g, tolerance, functions, average)
        self._fields(walls, materials, fractions, force, couple)

    def write(self, name, text, cls="dictionary"):
        """Write a file of the case."""
        write_file(self.path/name, text, cls)

    def middles(self):
        """Centres of the cells in the mid-plane, shape (2, cells): those that
        the solver takes."""
        return self._sums()[1]

    def volumes(self):
        """Volumes of the cells of the wedge, by the rule of Pappus."""
        area, (_, y) = self._sums()
        return area*y*2*self.slope

    def _sums(self):
        """Areas and centroids of the polygons."""
        nodes = self.nodes.reshape(2, -1)
        corners = nodes[:, np.array(self._polygons())]
        first, area, moment = corners[:, :, 0], 0, 0
        for k in range(1, corners.shape[2] - 1):
            b, c = corners[:, :, k], corners[:, :, k + 1]
            part = ((b - first)[0]*(c - first)[1]
                    - (b - first)[1]*(c - first)[0])/2
            area = area + part
            moment = moment + part*(first + b + c)/3
        return area, moment/area

    def side(self, name):
        """Middles of the edges of a side, shape (2, edges)."""
        line = {"left": self.nodes[:, :, 0], "right": self.nodes[:, :, -1],
                "bottom": self.nodes[:, 0, :], "top": self.nodes[:, -1, :]}[name]
        middles = (line[:, 1:] + line[:, :-1])/2
        return middles[:, middles[1] > 1e-12]

    def _polygons(self):
        """Numbers of the nodes around each cell, row by row."""
        nx, ny = self.n
        quads = [[k, k + 1, k + nx + 2, k + nx + 1]
                 for j in range(ny)
                 for k in range(j*(nx + 1), j*(nx + 1) + nx)]
        if not self.triangles:
            return quads
        # Diagonals in turn, as nothing of a uniform mesh would be skewed less
        return [half for i, (a, b, c, d) in enumerate(quads)
                for half in (([a, b, c], [a, c, d]) if (i//nx + i) % 2
                             else ([a, b, d], [b, c, d]))]

    def _mesh(self):
        nx = self.n[0]
        x, y = (q.ravel() for q in self.nodes)
        on_axis = y < 1e-12
        front = np.arange(x.size)
        # Points behind, but for those on the axis
        behind = np.where(on_axis, front,
                          x.size + np.cumsum(~on_axis) - 1)
        points = [*zip(x, np.where(on_axis, 0, y), self.slope*y*~on_axis),
                  *zip(x[~on_axis], y[~on_axis], -self.slope*y[~on_axis])]

        def upright(a, b):
            """The face over an edge, its normal to the right from a to b."""
            return list(dict.fromkeys(
                [front[a], behind[a], behind[b], front[b]]))

        # Edges by their ends, as their first cell runs through them
        edges, inner = {}, []
        for label, nodes in enumerate(self._polygons()):
            for a, b in zip(nodes, nodes[1:] + nodes[:1]):
                if (b, a) in edges:
                    inner.append((edges.pop((b, a)), label, upright(b, a)))
                else:
                    edges[a, b] = label
        inner.sort(key=lambda face: face[:2])

        sides = {name: [] for name in SIDES}
        row, column = np.divmod(front, nx + 1)
        for (a, b), label in edges.items():
            name = ("left" if column[a] == column[b] == 0 else
                    "right" if column[a] == column[b] == nx else
                    "bottom" if row[a] == row[b] == 0 else "top")
            # On the axis there is no face
            if len(upright(a, b)) > 2:
                sides[name].append((label, upright(a, b)))
        for name in sides:
            along = column if name in ("top", "bottom") else row
            sides[name].sort(key=lambda face, q=along: q[
                [k for k in face[1] if k < x.size]].sum())
        sides["front"] = [(label, [front[k] for k in nodes])
                          for label, nodes in enumerate(self._polygons())]
        sides["back"] = [(label, [behind[k] for k in nodes[::-1]])
                         for label, nodes in enumerate(self._polygons())]

        def kind(name):
            if name in ("front", "back"):
                return "wedge"
            if self.cyclic and name in ("left", "right"):
                other = "right" if name == "left" else "left"
                return f"cyclic; neighbourPatch {other}"
            return "patch"

        sides = {name: those for name, those in sides.items() if those}
        self.patch_names = list(sides)
        write_mesh(self, np.array(points), inner,
                   [(name, kind(name), those) for name, those in sides.items()])

    def _dictionaries(self, materials, g, tolerance, functions, average):
        self.write("system/controlDict", f"""
application cosseratPicFoam; startFrom startTime; startTime 0;
stopAt endTime; endTime 1; deltaT 1; writeControl timeStep; writeInterval 1;
writeFormat ascii; writePrecision 16; timeFormat general; timePrecision 6;
runTimeModifiable false;
functions {{
power {{ type powerBalance; libs (cosseratFunctionObjects); }}
load {{ type wallLoad; libs (cosseratFunctionObjects); }}
{functions} }}
""")
        self.write("system/fvSchemes", """
ddtSchemes { default none; } gradSchemes { default Gauss linear; }
divSchemes { default none; } laplacianSchemes { default none; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; }
""")
        self.write("system/fvSolution",
                   f"creepingFlow {{ tolerance {tolerance}; }}\n")
        laws = "\n".join(material(name, m) for name, m in materials.items())
        self.write("constant/materialProperties",
                   f"materials {{ {laws} }}\n"
                   + (f"viscosityAverage {average};\n"
                      if len(materials) > 1 else ""))
        if g is not None:
            self.write("constant/g", "dimensions [0 1 -2 0 0 0 0];"
                       f" value ({' '.join(map(str, g))});\n",
                       "uniformDimensionedVectorField")

    def _fields(self, walls, materials, fractions, force, couple):
        types = {"U": ("volVectorField", "[0 1 -1 0 0 0 0]", "(0 0 0)"),
                 "p_rgh": ("volScalarField", "[1 -1 -2 0 0 0 0]", "0"),
                 "omega": ("volScalarField", "[0 0 -1 0 0 0 0]", "0")}
        for i, (name, (cls, dims, zero)) in enumerate(types.items()):
            entries = {side: row[i] for side, row in walls.items()}
            self._field(name, cls, dims, f"uniform {zero}", entries)
        x, y = self.middles()
        if fractions:
            alpha = fractions(x, y)*np.ones_like(x)
            for name, values in zip(materials, (alpha, 1 - alpha)):
                self._field(f"alpha.{name}", "volScalarField",
                            "[0 0 0 0 0 0 0]", listed(values), {})
        if force:
            self._field("bodyForce", "volVectorField", "[1 -2 -2 0 0 0 0]",
                        listed(np.transpose(force(x, y))), {})
        if couple:
            self._field("bodyCouple", "volScalarField", "[1 -1 -2 0 0 0 0]",
                        listed(couple(x, y)), {})

    def _field(self, name, cls, dims, inside, entries):
        text = ""
        for patch in self.patch_names:
            if patch in ("front", "back"):
                entry = "type wedge;"
            elif self.cyclic and patch in ("left", "right"):
                entry = "type cyclic;"
            else:
                entry = entries.get(patch, "type zeroGradient;")
                if callable(entry):
                    values = np.transpose(entry(*self.side(patch)))
                    entry = f"type fixedValue; value {listed(values)};"
            text += f"{patch} {{ {entry} }}\n"
        self.write(f"0/{name}", f"dimensions {dims};\ninternalField {inside};\n"
                   f"boundaryField\n{{\n{text}}}\n", cls)

    def step(self, dt, steps):
        """Do steps of a time [s], and write the last."""
        self.override("control", endTime=f"{steps*dt:.8g}",
                      deltaT=f"{dt:.12g}", writeInterval=steps)

    def fill(self, name, values):
        """Give a field values in the cells: numbers (cells), or components in
        the plane (2, cells)."""
        path = self.path/"0"/name
        path.write_text(re.sub(r"internalField [^;]*;", lambda _:
                               f"internalField {listed(np.transpose(values))};",
                               path.read_text()))

    def solve_and_compare(self, u, omega=None, p=None):
        """Relative L2 errors of a solved case against functions (x, y), by
        volume; of the pressure without its mean, in its own units."""
        self.run("cosseratPicFoam")
        x, y = self.middles()
        V = self.volumes()

        def rms(values):
            return np.sqrt((V*np.sum(np.atleast_2d(values)**2, axis=0)).sum()
                           / V.sum())

        row = {"cells": len(V)}
        exact = np.asarray(u(x, y))
        row["errU"] = rms(self.field("U")[:, :2].T - exact)/rms(exact)
        if omega:
            row["errOmega"] = rms(self.field("omega") - omega(x, y))/rms(
                omega(x, y))
        if p:
            off = self.field("p") - p(x, y)
            row["errP"] = rms(off - (V*off).sum()/V.sum())
        return row
