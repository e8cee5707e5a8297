"""A box with one or two materials, written from scratch: the scene of
tests and studies that no tutorial covers."""

import re
import shutil
from pathlib import Path

import numpy as np

from cosserat.case import Case, ROOT, parse_list
from cosserat.foamfile import listed, write_file
from cosserat.refined import middles, refine_cells, refine_scene
from cosserat.triangles import write_honeycomb, write_prisms

#: A classical fluid, and a second one
ONE = {"a": {"eta": 1, "etaC": 0, "R": 0}}
TWO = {**ONE, "b": {"eta": 3, "etaC": 0, "R": 0}}

VECTOR, SCALAR = "volVectorField", "volScalarField"

SIDES = {"left": "(0 4 7 3)", "right": "(1 2 6 5)",
         "bottom": "(0 1 5 4)", "top": "(3 7 6 2)"}


#: Walls of U and omega: at rest; those of the exact solution; a flow from left
#: to right at 1 m/s
STILL = ("type noSlip;", "type zeroGradient;")
TURN = {side: ("exact", "exact") for side in SIDES}
FORWARD = {side: ("type fixedValue; value uniform (1 0 0);",
                  "type zeroGradient;") for side in ("left", "right")}


def add_points(case, regions, dye="", pointsPerCell=16, **entries):
    """Give a case material points, and take away its fractions; entries are
    those of materialPointsProperties."""
    (case.path/"constant/materialPointsProperties").write_text(f"""
FoamFile {{ version 2.0; format ascii; class dictionary; object x; }}
seeding {{ pointsPerCell {pointsPerCell}; regions ({regions}); dye ({dye}); }}
""")
    case.override("points", **entries)
    for alpha in (case.path/"0").glob("alpha.*"):
        alpha.unlink()
    count(case)


def material(name, constants):
    """Entry of a material: of constant viscosity by eta, etaC, R, B (infinite),
    or of a law with its coeffs (text); and of rho (0)."""
    law = constants.get("law", "constant")
    coeffs = constants.get("coeffs") or " ".join(
        f"{key} {constants.get(key, 'infinite')};"
        for key in ("eta", "etaC", "R", "B"))
    return (f"    {name}\n    {{\n        rho {constants.get('rho', 0)};"
            f" viscosityLaw {law};\n        {law}Coeffs {{ {coeffs} }}\n    }}")


def count(case):
    """Let a case with points count them in each step."""
    case.measure("points", "pointStatistics", "writeControl none;")


def account(case):
    """The books at the end of a run that counts its points: inside, volume,
    in, volume, added, deleted, out, volume; the volumes in m3."""
    row = case.table("points", "pointStatistics.dat")[-1]
    return [row[1], *row[7:14]]


def retype(case, kind, *sides):
    """Give sides of a meshed box another type of mesh patch."""
    path = case.path/"constant/polyMesh/boundary"
    text = path.read_text()
    for side in sides:
        text = re.sub(rf"(\b{side}\s*{{\s*type\s+)\w+;", rf"\1{kind};", text)
        text = re.sub(rf"(\b{side}\s*{{[^}}]*?)inGroups\s+[^;]*;", r"\1", text)
    path.write_text(text)
    return case


class Box:
    """Unit square [-1/2, 1/2]^2, n x n cells; xmin moves its left side, and
    leaves cells away.

    materials: dict of name: dict of eta, etaC, R, B, rho; walls: dict of side:
    (U entry, omega entry[, p_rgh entry]) as text; g: vector; cyclic: True for
    cyclic left and right; fractions: function (x, y) -> fraction of the first
    material, where there are two; U, omega: functions (x, y) for the initial
    fields; force, couple: functions (x, y) for a body force and a body couple;
    warp: function (x, y) -> (x, y) that moves the points of the mesh;
    triangles: True for triangular prisms; honeycomb: True for hexagons;
    halved: function (x, y) -> is the cell there halved both ways; refined:
    selections of refine_scene, by name; average: of the viscosities (None:
    left out).
    """

    def __init__(self, path, n=16, materials=None, walls=None, g=(0, 0, 0),
                 cyclic=False, fractions=None, U=None, omega=None,
                 tolerance=1e-10, shear=0.0, notConverged="error",
                 symmetry=(), xmin=-0.5, force=None, couple=None,
                 average="arithmetic", warp=None, triangles=False,
                 halved=None, refined=None, honeycomb=False):
        self.case = Case(Path(path))
        self.n, self.materials, self.g = n, materials, g
        self.cyclic, self.fractions, self.shear = cyclic, fractions, shear
        self.U, self.omega, self.tolerance = U, omega, tolerance
        self.notConverged, self.symmetry = notConverged, symmetry
        self.xmin, self.average = xmin, average
        self.force, self.couple = force, couple
        self.warp, self.triangles, self.halved = warp, triangles, halved
        self.refined, self.honeycomb = refined or {}, honeycomb
        self.walls = {side: ("type slip;", "type zeroGradient;")
                      for side in SIDES}
        self.walls.update(walls or {})

    def file(self, name, text, cls="dictionary"):
        """Write a file of the case."""
        write_file(self.case.path/name, text, cls)

    def write(self):
        """Write and mesh the case, in place of one that is there."""
        # Fields of its start would be of another mesh
        shutil.rmtree(self.case.path/"0", ignore_errors=True)
        self.file("system/controlDict", """
application         cosseratPicFoam;
startFrom           startTime;
startTime           0;
endTime             1;
deltaT              1;
writeControl        timeStep;
writeInterval       1;
writeFormat         ascii;
writePrecision      16;
timeFormat          general;
timePrecision       8;
runTimeModifiable   false;
functions
{
    power { type powerBalance; libs (cosseratFunctionObjects); }
    stress { type cosseratStress; libs (cosseratFunctionObjects);
        writeControl writeTime; }
}
""")
        schemes = (ROOT/"tutorials/silo/system/fvSchemes").read_text()
        (self.case.path/"system/fvSchemes").write_text(schemes)
        self.file("system/fvSolution", f"""
creepingFlow
{{
    tolerance       {self.tolerance};
    notConverged    {self.notConverged};
}}
""")
        self.file("constant/g", f"""
dimensions [0 1 -2 0 0 0 0]; value ({self.g[0]} {self.g[1]} {self.g[2]});
""", "uniformDimensionedVectorField")
        laws = "\n".join(material(name, m)
                         for name, m in self.materials.items())
        mean = f"viscosityAverage {self.average};\n" if self.average else ""
        self.file("constant/materialProperties",
                  f"materials\n{{\n{laws}\n}}\n{mean}")
        if self.triangles:
            self.prisms()
        elif self.honeycomb:
            write_honeycomb(self.case, self.n)
        else:
            self.mesh()
            self.case.run("blockMesh", "-noFunctionObjects")
        if self.halved:
            refine_cells(self.case, np.flatnonzero(
                self.halved(*middles(self.case).T)))
        if self.refined:
            refine_scene(self.case, **self.refined)
        if self.warp:
            self.move_points()
        (self.case.path/"0").mkdir(exist_ok=True)
        self.fields()
        return self.case

    def prisms(self):
        """Write a mesh of triangles."""
        write_prisms(self.case, self.n)

    def mesh(self):
        """Write blockMeshDict."""
        k = self.shear
        points = [(self.xmin - k/2, -.5), (.5 - k/2, -.5), (.5 + k/2, .5),
                  (self.xmin + k/2, .5)]
        nx = round(self.n*(0.5 - self.xmin))
        vertices = " ".join(f"({x} {y} {z})" for z in (0, 0.1)
                            for x, y in points)
        patches = ""
        for side, face in SIDES.items():
            kind = "type wall;"
            if self.cyclic and side in ("left", "right"):
                other = "right" if side == "left" else "left"
                kind = f"type cyclic; neighbourPatch {other};"
            elif side in self.symmetry:
                kind = "type symmetryPlane;"
            patches += f"{side} {{ {kind} faces ({face}); }}\n"
        self.file("system/blockMeshDict", f"""
scale 1; vertices ({vertices});
blocks (hex (0 1 2 3 4 5 6 7) ({nx} {self.n} 1) simpleGrading (1 1 1));
edges (); boundary ( {patches} );
defaultPatch {{ name frontAndBack; type empty; }}
""")

    def move_points(self):
        """Apply warp to the points of the mesh."""
        path = self.case.path/"constant/polyMesh/points"
        text = path.read_text()
        start = text.index("(", text.index("// * *"))
        points = parse_list("nonuniform List<vector> " + text[
            text.index("// * *"):].split("//\n", 1)[1], None)
        points[:, 0], points[:, 1] = self.warp(points[:, 0], points[:, 1])
        rows = "\n".join(f"({x!r} {y!r} {z!r})" for x, y, z in points.tolist())
        path.write_text(f"{text[:start]}(\n{rows}\n)\n")

    def fields(self):
        """Write the fields of time 0."""
        centres = self.case.centres()
        x, y = centres[:, 0], centres[:, 1]
        walls = {side: entries for side, entries in self.walls.items()
                 if side not in self.symmetry
                 and not (self.cyclic and side in ("left", "right"))}

        def field(name, cls, dims, internal, which):
            patches = "\n".join(f"{side} {{ {which(side)} }}" for side in walls)
            self.file(f"0/{name}", f"""
dimensions {dims};
internalField {listed(np.asarray(internal, float))};
boundaryField
{{
{patches}
#includeEtc "caseDicts/setConstraintTypes"
}}
""", cls)

        def boundary_values(function, side, vector):
            xy = self.case.patch_centres(side)[:, :2]
            values = np.array(function(xy[:, 0], xy[:, 1]))
            return listed(values.T if vector
                          else np.broadcast_to(values, len(xy)))

        def patch(side, i, function, vector):
            entry = self.walls[side][i]
            return (f"type fixedValue; value {boundary_values(function, side, vector)};"
                    if entry == "exact" else entry)

        U = np.zeros((len(x), 3))
        if self.U:
            U[:, :2] = np.array(self.U(x, y)).T
        omega = np.zeros(len(x))
        if self.omega:
            omega[:] = self.omega(x, y)

        field("U", VECTOR, "[0 1 -1 0 0 0 0]", U,
              lambda side: patch(side, 0, self.U, True))
        field("omega", SCALAR, "[0 0 -1 0 0 0 0]", omega,
              lambda side: patch(side, 1, self.omega, False))
        field("p_rgh", SCALAR, "[1 -1 -2 0 0 0 0]", np.zeros(len(x)),
              lambda side: (*self.walls[side], "type zeroGradient;")[2])

        if self.force:
            b = np.zeros((len(x), 3))
            b[:, :2] = np.array(self.force(x, y)).T
            field("bodyForce", VECTOR, "[1 -2 -2 0 0 0 0]", b,
                  lambda side: "type zeroGradient;")
        if self.couple:
            field("bodyCouple", SCALAR, "[1 -1 -2 0 0 0 0]",
                  np.broadcast_to(self.couple(x, y), len(x)),
                  lambda side: "type zeroGradient;")

        names = list(self.materials)
        if len(names) == 2:
            first = np.array(self.fractions(x, y), float)
            for name, alpha in zip(names, (first, 1 - first)):
                field(f"alpha.{name}", SCALAR, "[0 0 0 0 0 0 0]", alpha,
                      lambda side: "type zeroGradient;")


class Annulus(Box):
    """Quarter of an annulus 1 < r < 2, n cells across, its ends cyclic by
    rotation; left is the inner wall, right the outer one."""

    def mesh(self):
        arc = 2**0.5
        vertices = " ".join(f"({x} {y} {z})" for z in (0, 0.1)
                            for x, y in ((1, 0), (2, 0), (0, 2), (0, 1)))
        arcs = " ".join(
            f"arc {a + 4*i} {b + 4*i} ({r*arc/2!r} {r*arc/2!r} {0.1*i})"
            for i in (0, 1) for a, b, r in ((1, 2, 2), (0, 3, 1)))
        ends = " ".join(
            f"{side} {{ type cyclic; neighbourPatch {other};"
            " transform rotational; rotationAxis (0 0 1);"
            f" rotationCentre (0 0 0); faces ({SIDES[side]}); }}"
            for side, other in (("bottom", "top"), ("top", "bottom")))
        walls = " ".join(f"{side} {{ type wall; faces ({SIDES[side]}); }}"
                         for side in ("left", "right"))
        self.file("system/blockMeshDict", f"""
scale 1; vertices ({vertices});
blocks (hex (0 1 2 3 4 5 6 7) ({self.n} {2*self.n} 1) simpleGrading (1 1 1));
edges ({arcs}); boundary ({ends} {walls});
defaultPatch {{ name frontAndBack; type empty; }}
""")

    def fields(self):
        self.walls = {side: self.walls[side] for side in ("left", "right")}
        super().fields()
