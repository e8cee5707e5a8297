"""Cases: copy, change, run, read back.

Fields, clouds and meshes may be ascii or binary, plain or compressed, in any
of the three planes; of a run in parallel the times are to be reconstructed.
"""

import os
import re
import shutil
import signal
import subprocess
import tempfile
from contextlib import suppress
from pathlib import Path

import numpy as np

from cosserat.foamfile import FoamFile, find

ROOT = Path(__file__).resolve().parents[2]
TUTORIALS = ROOT/"tutorials"

#: Short names of the files of a case
FILES = {
    "control": "system/controlDict",
    "mesh": "system/blockMeshDict",
    "solution": "system/fvSolution",
    "materials": "constant/materialProperties",
    "points": "constant/materialPointsProperties",
    "walls": "system/walls",
    "decomposition": "system/decomposeParDict",
}


#: Types of the patches in front of a mesh and behind it
SIDES = ("empty", "wedge")


class RunError(RuntimeError):
    """A program of the case failed or took too long; the message ends with
    its log."""


class Case:
    """A case directory."""

    #: Longest time that a program may take [s]; None: any
    timeout = 600

    def __init__(self, path):
        self.path = Path(path)
        self._plane = None

    @classmethod
    def copy(cls, source, target):
        """A clean copy of a case, with its 0.orig as 0."""
        source, target = Path(source), Path(target)
        shutil.copytree(
            source, target, dirs_exist_ok=True,
            ignore=shutil.ignore_patterns(
                "[1-9]*", "0", "0.*[0-9]", "processor*", "log.*",
                "postProcessing", "polyMesh", "results", "*.png"))
        case = cls(target)
        case.restore()
        return case

    def restore(self):
        """Copy 0.orig to 0."""
        shutil.rmtree(self.path/"0", ignore_errors=True)
        shutil.copytree(self.path/"0.orig", self.path/"0")

    def substitute(self, file, entries):
        """Replace the values of entries (keyword value;) of a dictionary, by
        keyword: value; each must be there."""
        path = self.path/file
        text = path.read_text()
        for key, value in entries.items():
            text, n = re.subn(rf"^(\s*{key}\s+)[^;]*;", rf"\g<1>{value};",
                              text, flags=re.M)
            if n == 0:
                raise KeyError(f"no entry {key} in {path}")
        path.write_text(text)
        return self

    def run(self, *command, log=True, check=True, ranks=1):
        """Run a program in the case; its output goes to log.<program> as it
        comes, to be followed. What takes longer than the timeout is killed."""
        command = [str(c) for c in command]
        path = self.path/f"log.{command[0]}"
        if ranks > 1:
            command = ["mpirun", "-np", str(ranks), *command, "-parallel"]
        with (path.open("w+", errors="replace") if log else
              tempfile.TemporaryFile("w+", errors="replace")) as file:
            code = self._wait(command, file)
            file.seek(0)
            text = file.read()
        said = f"{' '.join(command)} in {self.path}"
        if code is None:
            raise RunError(f"{said} was killed after {self.timeout} s, the"
                           f" longest time allowed:\n{text[-3000:]}")
        if check and code:
            raise RunError(f"{said} ended with {code}:\n{text[-3000:]}")
        return subprocess.CompletedProcess(command, code, text)

    def _wait(self, command, file):
        """Exit code of a program that writes to a file; None where it took
        too long."""
        with subprocess.Popen(
                command, cwd=self.path, stdout=file, stderr=subprocess.STDOUT,
                start_new_session=True) as process:
            try:
                return process.wait(self.timeout)
            except subprocess.TimeoutExpired:
                # mpirun ends its ranks, which are in groups of their own
                process.terminate()
                with suppress(subprocess.TimeoutExpired):
                    process.wait(5)
                return None
            finally:
                with suppress(ProcessLookupError):
                    os.killpg(process.pid, signal.SIGKILL)

    def decompose(self, ranks, method="simple", n=None, field=None):
        """Write system/decomposeParDict and decompose the latest time; n: parts
        along each axis of simple and hierarchical (by default along x);
        field: of weights. Of one rank nothing is to do."""
        if ranks == 1:
            return self
        n = n or f"({ranks} 1 1)"
        weights = f"weightField {field};\n" if field else ""
        (self.path/FILES["decomposition"]).write_text(
            "FoamFile { version 2.0; format ascii; class dictionary;"
            f" object decomposeParDict; }}\nnumberOfSubdomains {ranks};\n"
            f"method {method};\n{weights}coeffs {{ n {n}; }}\n")
        if method == "ptscotch":
            self.run("redistributePar", "-decompose", ranks=ranks)
        else:
            self.run("decomposePar", "-latestTime", "-force")
        return self

    def reconstruct(self, *options):
        """Reconstruct what has been decomposed, if it has."""
        if any(self.path.glob("processor*")):
            self.run("reconstructPar", *options)
        return self

    def solve(self, ranks=1, **parts):
        """Run the solver, on several ranks decomposed and reconstructed;
        parts: of decompose()."""
        self.decompose(ranks, **parts)
        self.run("cosseratPicFoam", ranks=ranks)
        return self.reconstruct()

    def override(self, file, **entries):
        """Add entries at the end of a dictionary, where they prevail; text
        that begins with a brace is a dictionary, and merges."""
        with (self.path/FILES.get(file, file)).open("a") as text:
            for key, value in entries.items():
                end = "" if str(value).lstrip().startswith("{") else ";"
                text.write(f"\n{key} {value}{end}\n")
        return self

    def measure(self, name, kind, entries="", library="cosseratFunctionObjects"):
        """Give the case a function object: its name, type and further
        entries."""
        return self.override(
            "control", functions=f"{{ {name} {{ type {kind};"
            f" libs ({library}); {entries} }} }}")

    def entries(self, file):
        """Simple entries (keyword value;) at the top of a dictionary."""
        text = re.sub(r"//[^\n]*", "", (self.path/file).read_text())
        return dict(re.findall(r"^(\w+)\s+([^;{}#]+);", text, re.M))

    def log(self, program="cosseratPicFoam"):
        """Log of a program that was run."""
        return (self.path/f"log.{program}").read_text()

    def times(self):
        """Time directories as names, in the order of time, without 0."""
        names = [d.name for d in self.path.iterdir()
                 if d.is_dir() and re.fullmatch(r"\d+(\.\d*)?(e-?\d+)?", d.name)
                 and float(d.name) > 0]
        return sorted(names, key=float)

    def file(self, name, time=None):
        """A file of a time, by default the last one."""
        time = self.times()[-1] if time is None else time
        return FoamFile(self.path/str(time)/name)

    def field(self, name, time=None):
        """Internal field, shape (nCells,) or (nCells, components)."""
        file = self.file(name, time)
        return file.entry(file.after("internalField"), self.n_cells())

    def patch_field(self, name, patch, time=None):
        """Values of a field on a patch."""
        file = self.file(name, time)
        at = file.after("boundaryField")
        at = file.after(rb"^\s*" + patch.encode() + rb"\s*\{", at)
        return file.entry(file.after(rb"^\s*value\s", at))

    def n_cells(self):
        """Number of cells of the mesh."""
        return int(re.search(r"nCells:\s*(\d+)",
                             self.mesh_file("owner").header)[1])

    def mesh_file(self, name):
        """A file of the mesh."""
        return FoamFile(self.path/"constant/polyMesh"/name)

    def mesh_points(self):
        """Points of the mesh, shape (nPoints, 3)."""
        file = self.mesh_file("points")
        return file.list(file.start, "vector")[0]

    def patches(self):
        """Patches of the mesh: dict of name: (type, faces)."""
        return {name: (kind, range(int(start), int(start) + int(n)))
                for name, kind, n, start in re.findall(
                    r"(\w+)\s*\{\s*type\s+(\w+);[^}]*?nFaces\s+(\d+);"
                    r"\s*startFace\s+(\d+);",
                    self.mesh_file("boundary").text())}

    def plane(self):
        """Axes of the plane of the mesh, that of pictures across first."""
        if self._plane is None:
            corners = next(
                corners[0] for kind, corners in self.patch_faces().values()
                if kind in SIDES and corners)
            ways = corners[1:] - corners[0]
            normal = np.cross(ways[:-1], ways[1:]).sum(axis=0)
            across = np.argmax(np.abs(normal))
            self._plane = [i for i in range(3) if i != across]
        return self._plane

    def wedge(self):
        """Is the mesh a wedge around an axis."""
        return any(kind == "wedge" for kind, _ in self.patches().values())

    def centres(self):
        """Cell centres, shape (nCells, 3); of wedges those in the mid-plane,
        which the solver takes."""
        if self.wedge():
            return np.array([_middle(p, self.plane()) for p in self.polygons()])
        if find(self.path/"0/C") is None:
            self.run("postProcess", "-func", "writeCellCentres", "-time", "0",
                     log=None)
        return self.field("C", 0)

    def volumes(self):
        """Cell volumes."""
        if find(self.path/"0/V") is None:
            self.run("postProcess", "-func", "writeCellVolumes", "-time", "0",
                     log=None)
        return self.field("V", 0)

    def patch_faces(self):
        """Corners of the faces of each patch, and its type: dict of name:
        (type, list of arrays of points)."""
        points, faces = self.mesh_points(), self.mesh_file("faces").faces()
        return {name: (kind, [points[faces[i]] for i in which])
                for name, (kind, which) in self.patches().items()}

    def internal_faces(self):
        """Corners of the internal faces, all rectangles: (faces, 4, 3)."""
        n = int(re.search(r"nInternalFaces:\s*(\d+)",
                          self.mesh_file("owner").header)[1])
        return self.mesh_points()[np.array(
            self.mesh_file("faces").faces()[:n])]

    def patch_centres(self, name):
        """Face centres of a patch with rectangular faces, shape (n, 3)."""
        return np.array([face.mean(axis=0)
                         for face in self.patch_faces()[name][1]])

    def patch_normals(self, name):
        """Unit normals of the faces of a patch, out of the mesh: (n, 3)."""
        normals = np.array([np.cross(face[2] - face[0], face[3] - face[1])
                            for face in self.patch_faces()[name][1]])
        return normals/np.linalg.norm(normals, axis=1)[:, None]

    def polygons(self):
        """Corners of each cell in the plane of the mesh: list of arrays."""
        points, faces = self.mesh_points(), self.mesh_file("faces").faces()
        file = self.mesh_file("owner")
        owner = file.list(file.start, "label")[0]
        cells = [None]*self.n_cells()
        for kind, which in self.patches().values():
            if kind in SIDES:
                for i in which:
                    cells[owner[i]] = points[faces[i]]
        return cells

    def boundary_edges(self):
        """Edges in the plane of the faces of walls and openings, as pairs of
        points."""
        edges = []
        plane = self.plane()
        for kind, faces in self.patch_faces().values():
            if kind in (*SIDES, "cyclic", "processor"):
                continue
            for corners in faces:
                a = corners[0]
                b = corners[np.argmax(np.hypot(*(corners - a)[:, plane].T))]
                edges.append((a, b))
        return edges

    def cloud(self, name, time=None, cloud="materialPoints"):
        """Field of a cloud, one row or number per point."""
        file = self.file(f"lagrangian/{cloud}/{name}", time)
        if name == "positions":
            return file.positions()
        kind = re.search(r"class\s+(\w+)Field;", file.header)[1]
        return file.list(file.start, kind)[0].astype(float)

    def centroid(self, material, time=None):
        """Mean position of the points of a material (its index)."""
        chosen = self.cloud("material", time) == material
        return np.average(self.cloud("positions", time)[chosen], axis=0,
                          weights=self.cloud("volume", time)[chosen])

    def table(self, function, file):
        """Rows that a function object has written, by time; of parts written
        after a restart the later ones prevail."""
        rows = {}
        base = self.path/"postProcessing"/function
        for part in sorted(base.iterdir(), key=lambda d: float(d.name)):
            for row in np.loadtxt(part/file, ndmin=2):
                rows[row[0]] = row
        return np.array([rows[t] for t in sorted(rows)])


def _middle(corners, plane):
    """Centroid of a polygon in a plane; zero across it."""
    first, others = corners[0, plane], corners[1:, plane] - corners[0, plane]
    areas = np.cross(others[:-1], others[1:])
    middle = np.zeros(3)
    middle[plane] = first + (areas[:, None]*(others[:-1] + others[1:])/3).sum(
        axis=0)/areas.sum()
    return middle


def parse_list(text, n_uniform):
    """Values of 'uniform v;' or 'nonuniform List<type> n (...)'."""
    head = text.lstrip()
    if head.startswith("uniform"):
        value = head[len("uniform"):head.index(";")]
        row = np.array(re.findall(r"[-\d.e+]+", value), float)
        n = n_uniform or 1
        return np.full(n, row[0]) if len(row) == 1 else np.tile(row, (n, 1))

    match = re.search(r"(\d+)\s*\(|(\d+)\s*\{([^}]*)\}", head)
    if match.group(2):
        return np.full(int(match.group(2)), float(match.group(3)))
    n, start = int(match.group(1)), match.end()
    # Up to the end of the entry, or of the list where it is all of the file
    end = head.find(";", start)
    flat = head[start:end if end >= 0 else head.rindex(")")]
    values = np.array(flat.replace("(", " ").replace(")", " ").split(), float)
    return values if len(values) == n else values.reshape(n, -1)


def residuals(log):
    """Rows (iterations, final residuals...) of the solves in a log."""
    pattern = (r"FGMRES:  Solving for (\S+), Initial residual = (\S+), "
               r"Final residual = (\S+), No Iterations (\d+)")
    return [(field, float(initial), float(final), int(n))
            for field, initial, final, n in re.findall(pattern, log)]


def worst_residual(log):
    """Largest final residual of all solves in a log."""
    return max(row[2] for row in residuals(log))


def cpu_seconds(log):
    """Processor time of a run [s]."""
    return float(re.findall(r"ExecutionTime = (\S+) s", log)[-1])


def fresh_case(path, tutorial):
    """A copy of a tutorial, by its name, in place of what was there."""
    shutil.rmtree(path, ignore_errors=True)
    return Case.copy(TUTORIALS/tutorial, path)


def environment():
    """Stop with a plain word where the project's environment is not set."""
    if "COSSERATPIC_APPBIN" not in os.environ:
        raise SystemExit("source etc/bashrc first")
