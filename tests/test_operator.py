"""The discrete operator itself: positive on meshes of two materials, rigid
where a body is."""

import numpy as np
import pytest

from cosserat.scenes.box import Box
from cosserat.case import residuals

HELD = {side: ("type noSlip;", "type fixedValue; value uniform 0;")
        for side in ("left", "right", "top", "bottom")}

#: Random meshes, among them single stiff cells, in corners and at walls
COUNT = 200

#: Not positive yet: stiff triangles in a corner of held walls
KNOWN = {76}


def least(case):
    """Least real part of the eigenvalues of the block of velocity and
    microrotation, its rows and columns scaled to a diagonal of one."""
    case.run("Test-operator", log=False)
    numbers = np.fromstring((case.path/"operator").read_text(), sep=" ")
    n = int(numbers[0])
    matrix = numbers[1:].reshape(n, n)
    cells = case.n_cells()
    block = np.r_[:2*cells, 3*cells:n]
    matrix = matrix[np.ix_(block, block)]
    scale = 1/np.sqrt(np.abs(np.diag(matrix)))
    return np.linalg.eigvals(matrix*np.outer(scale, scale)).real.min()


def mesh(rng, kind, n):
    """Entries of Box for a mesh of a kind."""
    if kind == "sheared":
        return {"shear": float(rng.uniform(0, 1))}
    if kind == "triangles":
        return {"triangles": True}
    if kind == "wavy":
        amplitude, a, b = rng.uniform(0, 0.3)/n, *rng.uniform(0, 6, 2)

        def warp(x, y):
            inside = (np.abs(x) < 0.499) & (np.abs(y) < 0.499)
            return (x + amplitude*inside*np.sin(17*x + 23*y + a),
                    y + amplitude*inside*np.sin(31*x - 19*y + b))
        return {"warp": warp}
    return {}


def scene(path, seed):
    """Two materials in random cells, whole or by random fractions; free or
    held walls; classical on any mesh, or etaC up to 10 eta on squares and
    0.8 eta on cells that lean."""
    rng = np.random.default_rng(seed)
    n = int(rng.integers(3, 5))
    rotates = rng.random() < 0.5
    kind = str(rng.choice(["squares", "sheared", "wavy", "triangles"]
                          if not rotates else
                          ["squares", "squares", "sheared", "wavy"]))
    most = 1 if kind == "squares" else -0.1
    coupling = float(10**rng.uniform(-1, most)) if rotates else 0
    contrast = float(10**rng.uniform(0, 6))
    R = float(10**rng.uniform(-1, 0))
    part = rng.random(4*n*n)
    if rng.random() < 0.5:
        part = np.round(part)
    materials = {name: {"eta": eta, "etaC": coupling*eta, "R": R}
                 for name, eta in (("stiff", contrast), ("soft", 1.0))}
    return Box(path, n=n, materials=materials,
               walls=HELD if rng.random() < 0.5 else {},
               fractions=lambda x, y: part[:len(x)], average="layered",
               **mesh(rng, kind, n)).write()


@pytest.mark.slow
@pytest.mark.parametrize("first", range(0, COUNT, 20))
def test_operator_is_positive(tmp_path, first):
    """No eigenvalue has a negative real part, but for rounding: the diagonals
    of the stiff cells hold the contrast."""
    for seed in range(first, first + 20):
        positive = least(scene(tmp_path/f"{seed}", seed)) > -1e-9
        assert positive == (seed not in KNOWN), seed


@pytest.mark.parametrize("coupling, measured",
                         [(3, 0.120), (10, 0.0711), (100, 0.0133)])
def test_free_corners(tmp_path, coupling, measured):
    """A uniform medium of etaC > eta between walls without traction and
    couple: cells in corners have two of them, which by etaC in the place of
    the compact part turned each cell against itself (-0.72 to -0.89)."""
    material = {"eta": 1.0, "etaC": float(coupling), "R": 0.03}
    case = Box(tmp_path/"case", n=4, materials={"a": material, "b": material},
               fractions=lambda x, y: 0*x).write()
    assert least(case) == pytest.approx(measured, rel=0.01)


@pytest.mark.parametrize("contrast", [1e3, 1e6, 1e8])
@pytest.mark.parametrize("kind", ["squares", "triangles", "wavy"])
def test_body_is_rigid(tmp_path, kind, contrast):
    """A square body moves as one, by 1e-4 at 1e6 (measured 4e-6 and less), and
    in proportion to its softness."""
    options = {"squares": {}, "triangles": {"triangles": True}, "wavy": {
        "warp": lambda x, y: (
            x + 0.012*np.sin(8*np.pi*x)*np.sin(8*np.pi*y),
            y + 0.012*np.sin(8*np.pi*x)*np.sin(8*np.pi*y))}}[kind]

    def inside(x, y):
        return (np.abs(x) < 0.125) & (np.abs(y) < 0.125)
    case = Box(tmp_path/"case", n=16, g=(0, -1, 0), tolerance=1e-7,
               materials={"body": {"eta": contrast, "etaC": 0, "R": 0,
                                   "rho": 1},
                          "fluid": {"eta": 1, "etaC": 0, "R": 0}},
               fractions=inside, **options).write()
    case.substitute("system/controlDict", {"endTime": 1e-9, "deltaT": 1e-9})
    case.run("cosseratPicFoam")
    x, y = case.centres()[:, :2].T
    body = inside(x, y)
    U = case.field("U")[body, :2]
    one, none = np.ones(body.sum()), np.zeros(body.sum())
    motions = np.block([[one, none], [none, one], [-y[body], x[body]]]).T
    u = U.T.ravel()
    rest = u - motions @ np.linalg.lstsq(motions, u, rcond=None)[0]
    assert np.abs(rest).max() < 1e2/contrast*np.abs(u).max()
    assert residuals(case.log())[0][3] < 100
