"""A wedge around a re-entrant corner, driven at its far side by a singular
solution (wedge.py), which is then the exact flow in all of it."""

import numpy as np

from cosserat import wedge
from cosserat.case import Case
from cosserat.foamfile import listed, write_file
from cosserat.triangles import write_polygons

#: Kinds of meshes: parallelograms, the same halved
QUADS, TRIANGLES = "quads", "triangles"


class WedgeCase(Case):
    """Case of a wedge of radius about 1 with n cells along a wall.

    angles: ends of its sectors, one parallelogram of n x n cells each;
    media: (eta, etaC) of each, etaC with an internal length that keeps all
    from rotating; holds: which walls hold the fluid; mode: which solution."""

    def __init__(self, path, n, angles, media=None, holds=(False, False),
                 mode=0, mesh=QUADS, corners=True, turn=0.0):
        super().__init__(path)
        self.n, self.angles, self.turn = n, angles, turn
        self.media = media or [(1.0, 0.0)]*len(angles)
        self.holds, self.mesh = holds, mesh
        self.sectors = [(end, *medium)
                        for end, medium in zip(angles, self.media)]
        self.solution = wedge.solutions(self.sectors, holds)[mode]
        self.sector_of = []
        self._mesh()
        self._dictionaries(corners)

    def exact(self, x, y):
        """Velocity, pressure and stream function."""
        c, s = np.cos(self.turn), np.sin(self.turn)
        u, v, p, psi = wedge.flow(self.solution, self.sectors,
                                  c*x + s*y, c*y - s*x)
        return c*u - s*v, s*u + c*v, p, psi

    def _mesh(self):
        numbers, cells = {}, []
        rays = np.r_[0, self.angles]

        def point(sector, i, j):
            directions = [np.array([np.cos(a), np.sin(a)])
                          for a in self.turn + rays[sector:sector + 2]]
            place = (i*directions[0] + j*directions[1])/self.n
            # The two faces of a slit are not one
            side = sector if j == 0 else -1
            key = (*place.round(9) + 0.0, i and j == 0 and side == 0)
            if j == 0 and side > 0:
                key = (*place.round(9) + 0.0, False)
            return numbers.setdefault(key, len(numbers))

        for sector in range(len(self.angles)):
            for j in range(self.n):
                for i in range(self.n):
                    quad = [point(sector, i + a, j + b)
                            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                    if self.mesh == QUADS:
                        pieces = [quad]
                    else:
                        pieces = [[quad[0], quad[1], quad[2]],
                                  [quad[0], quad[2], quad[3]]]
                    cells += pieces
                    self.sector_of += [sector]*len(pieces)
        flat = np.array([key[:2] for key in numbers])

        def side(a, b):
            for name, ray in (("first", 0.0), ("second", rays[-1])):
                way = np.array([np.cos(ray + self.turn),
                                np.sin(ray + self.turn)])
                if all(abs(way[0]*p[1] - way[1]*p[0]) < 1e-9 and p @ way > -1e-9
                       for p in (a, b)):
                    # Of a slit both walls are on one ray
                    return name
            return "far"

        (self.path/"system").mkdir(parents=True)
        (self.path/"constant").mkdir()
        write_polygons(self, flat, [np.array(cell) for cell in cells], side)

    def write(self, name, cls, text):
        write_file(self.path/name, text, cls)

    def _dictionaries(self, corners):
        cosserat = any(eta_c for _, eta_c in self.media)
        kinds = sorted(set(self.media))
        self.write("system/controlDict", "dictionary", """
application cosseratPicFoam; startFrom startTime; startTime 0;
stopAt endTime; endTime 1; deltaT 1; writeControl timeStep; writeInterval 1;
writeFormat ascii; writePrecision 14; timeFormat general; timePrecision 6;
runTimeModifiable false;
""")
        self.write("system/fvSchemes", "dictionary", """
ddtSchemes { default none; } gradSchemes { default Gauss linear; }
divSchemes { default none; } laplacianSchemes { default none; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; }
""")
        self.write("system/fvSolution", "dictionary",
                   "creepingFlow { tolerance 1e-9; corners "
                   f"{'automatic' if corners else 'off'}; }}\n")
        materials = "\n".join(
            f"m{i} {{ rho 0; viscosityLaw constant; constantCoeffs {{ eta {a};"
            f" etaC {b}; R {1e3 if b else 0}; B infinite; }} }}"
            for i, (a, b) in enumerate(kinds))
        self.write("constant/materialProperties", "dictionary",
                   f"materials {{ {materials} }}\n"
                   + ("viscosityAverage arithmetic; densityAverage arithmetic;"
                      if len(kinds) > 1 else ""))
        if len(kinds) > 1:
            of_cell = np.array([kinds.index(self.media[s])
                                for s in self.sector_of])
            for i in range(len(kinds)):
                values = listed((of_cell == i).astype(int))
                self.write(f"0/alpha.m{i}", "volScalarField", f"""
dimensions [0 0 0 0 0 0 0];
internalField {values};
boundaryField {{ "(first|second|far)" {{ type zeroGradient; }}
frontAndBack {{ type empty; }} }}
""")

        far = self.patch_faces()["far"][1]
        values = []
        for corners_of_face in far:
            front = corners_of_face[np.abs(corners_of_face[:, 2]) < 1e-9][:, :2]
            a, b = front
            # By the stream function, so that no volume is lost
            _, _, _, psi = self.exact(*np.array([a, b]).T)
            u, v, _, _ = self.exact(*np.array([(a + b)/2]).T)
            along = (b - a)/np.hypot(*(b - a))
            speed = (psi[1] - psi[0])/np.hypot(*(b - a))
            normal = np.array([along[1], -along[0]])
            tangential = along @ np.array([u[0], v[0]])
            values.append(speed*normal + tangential*along)
        walls = "\n".join(
            f"{name} {{ type {'noSlip' if held else 'slip'}; }}"
            for name, held in zip(("first", "second"), self.holds))
        self.write("0/U", "volVectorField", f"""
dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField {{ far {{ type fixedValue;
value {listed(values)}; }}
{walls} frontAndBack {{ type empty; }} }}
""")
        self.write("0/p_rgh", "volScalarField", """
dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0;
boundaryField { "(first|second|far)" { type zeroGradient; }
frontAndBack { type empty; } }
""")
        if cosserat:
            self.write("0/omega", "volScalarField", """
dimensions [0 0 -1 0 0 0 0]; internalField uniform 0;
boundaryField { "(first|second|far)" { type fixedValue; value uniform 0; }
frontAndBack { type empty; } }
""")

    def error(self):
        """Relative error of U in L2 over the cells beyond half the radius."""
        self.run("cosseratPicFoam")
        centres, U = self.centres()[:, :2], self.field("U")[:, :2]
        u, v, _, _ = self.exact(*centres.T)
        away = np.hypot(*centres.T) > 0.5
        miss = np.hypot(U[:, 0] - u, U[:, 1] - v)[away]
        return float(np.sqrt((miss**2).sum()/(u**2 + v**2)[away].sum()))
