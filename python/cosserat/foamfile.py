"""OpenFOAM's files as arrays: ascii or binary, plain or compressed."""

import gzip
import re

import numpy as np

#: Numbers of a value by its type
COMPONENTS = {"scalar": 1, "label": 1, "bool": 1, "sphericalTensor": 1,
              "vector": 3, "symmTensor": 6, "tensor": 9}


HEADER = "FoamFile\n{{ version 2.0; format ascii; class {}; object {}; }}\n"


def write_file(path, text, cls="dictionary"):
    """Write a file with OpenFOAM's header, and the folders that it is in."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(HEADER.format(cls, path.name) + text)


def listed(values):
    """Entry of a list of scalars, (n,), or of vectors, (n, 3) or (n, 2) in the
    plane."""
    values = np.asarray(values)
    if values.ndim == 1:
        kind, rows = "scalar", [repr(v) for v in values.tolist()]
    else:
        space = np.zeros((len(values), 3), values.dtype)
        space[:, :values.shape[1]] = values
        kind = "vector"
        rows = [f"({' '.join(map(repr, row))})" for row in space.tolist()]
    return (f"nonuniform List<{kind}> {len(rows)}\n(\n" + "\n".join(rows)
            + "\n)")


def find(path):
    """The file, or the compressed one beside its name; None: neither."""
    for each in (path, path.with_name(path.name + ".gz")):
        if each.is_file():
            return each
    return None


class FoamFile:
    """A file with OpenFOAM's header."""

    def __init__(self, path):
        file = find(path)
        if file is None:
            raise FileNotFoundError(f"no {path}, and no {path}.gz")
        data = file.read_bytes()
        self.data = gzip.decompress(data) if file.suffix == ".gz" else data
        end = self.data.find(b"}", self.data.find(b"FoamFile"))
        self.header = self.data[:end].decode(errors="replace")
        # Behind the line that ends the header, where there is one
        line = re.compile(rb"// \* \* \*.*\n").search(self.data, end)
        self.start = line.end() if line else end + 1
        self.binary = bool(re.search(r"format\s+binary", self.header))

    def type(self, kind):
        """Type of the numbers of a value in binary."""
        bits = re.search(r"(MSB|LSB);label=(\d+);scalar=(\d+)", self.header)
        order, label, scalar = bits.groups() if bits else ("LSB", "32", "64")
        return np.dtype(("<" if order == "LSB" else ">") + (
            f"i{int(label)//8}" if kind == "label" else
            "i1" if kind == "bool" else f"f{int(scalar)//8}"))

    def text(self):
        """What is behind the header, as text."""
        return self.data[self.start:].decode(errors="replace")

    def after(self, key, at=None):
        """Place behind a word that begins an entry, on a line of its own but
        for blanks and brackets."""
        found = re.compile(rb"^[\s{]*" + re.escape(key).encode()
                           if isinstance(key, str) else key,
                           re.M).search(self.data, at or self.start)
        if not found:
            raise KeyError(key)
        return found.end()

    def entry(self, at, n_uniform=None):
        """Values of 'uniform v;' or 'nonuniform List<kind> n(...)' behind a
        place; (n,) or (n, components)."""
        head = self.data[at:at + 200].lstrip()
        if head.startswith(b"uniform"):
            start = self.data.index(b"uniform", at) + len(b"uniform")
            text = self.data[start:self.data.index(b";", start)].decode()
            row = numbers(text)
            n = n_uniform or 1
            return np.full(n, row[0]) if len(row) == 1 else np.tile(row, (n, 1))
        kind = re.match(rb"nonuniform\s+(?:List<(\w+)>)?", head)
        at = self.data.index(b"nonuniform", at) + len(kind[0])
        return self.list(at, (kind[1] or b"scalar").decode())[0]

    def list(self, at, kind):
        """Values of a list behind a place, and the place behind it."""
        n_components = COMPONENTS[kind]
        size = re.compile(rb"\s*(\d+)\s*([({])?").match(self.data, at)
        n, start = int(size[1]), size.end()
        if n == 0 or size[2] is None:
            return np.zeros((0, n_components)[:1 + (n_components > 1)]), start
        if size[2] == b"{":
            end = self.data.index(b"}", start)
            row = numbers(self.data[start:end].decode())
            values = np.tile(row, (n, 1))
        elif self.binary:
            dtype = self.type(kind)
            count = n*n_components
            values = np.frombuffer(self.data, dtype, count, start)
            end = start + count*dtype.itemsize
        else:
            end = _closing(self.data, start)
            values = numbers(self.data[start:end].decode())
        values = np.array(values, int if kind == "label" else float)
        if n_components > 1:
            return values.reshape(n, n_components), end + 1
        return values.reshape(n), end + 1

    def faces(self):
        """Labels of the corners of each face of a mesh."""
        if not self.binary:
            return [np.array(face.split(), int) for face in re.findall(
                r"\d+\(([\d ]+)\)", self.text())]
        starts, at = self.list(self.start, "label")
        flat, _ = self.list(at, "label")
        return np.split(flat, starts[1:-1])

    def positions(self):
        """Places of the points of a cloud."""
        if not self.binary:
            rows = re.findall(r"\(([-\d.e+]+) ([-\d.e+]+) ([-\d.e+]+)\)",
                              self.text())
            return np.array(rows, float).reshape(-1, 3)
        n = int(re.compile(rb"\s*(\d+)\s*\(?").match(
            self.data, self.start)[1])
        place, cell = self.type("scalar"), self.type("label")
        length = 3*place.itemsize + cell.itemsize
        places = np.zeros((n, 3))
        at = self.data.index(b"(", self.start) + 1
        for i in range(n):
            at = self.data.index(b"(", at) + 1
            places[i] = np.frombuffer(self.data, place, 3, at)
            at += length
        return places

    def dimensions(self):
        """Exponents of kg, m, s, K, mol, A, cd, or names, as text."""
        return re.search(rb"dimensions\s*\[([^\]]*)\]",
                         self.data)[1].decode()


def numbers(text):
    """All numbers of a text."""
    return np.array(text.replace("(", " ").replace(")", " ").split(), float)


def _closing(data, start):
    """Place of the bracket that closes the one before a place."""
    depth = 1
    for bracket in re.compile(rb"[()]").finditer(data, start):
        depth += 1 if bracket[0] == b"(" else -1
        if depth == 0:
            return bracket.start()
    raise ValueError("a list without an end")
