"""Function objects of OpenFOAM on what this solver has: clouds, residuals,
stresses; and what it says where there is nothing for them."""

import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from cosserat.scenes.box import add_points

LIQUIDS = {"a": {"eta": 1, "etaC": 0.5, "R": 0.2, "rho": 2},
           "b": {"eta": 3, "etaC": 1, "R": 0.1, "rho": 1}}

REGIONS = ("{ type all; material b; } { type disc; material a;"
           " centre (0.1 0.1 0); radius 0.2; }")

DYE = "{ type bands; across (1 0 0); start -0.4; width 0.1; period 0.2; }"


@pytest.fixture(name="run")
def run_fixture(box):
    """Function that runs a scene with function objects, on so many ranks."""

    def make(functions, ranks=1, points=True, check=True, deltaT=0.1):
        case = box(f"ranks{ranks}", n=8, materials=LIQUIDS, g=(0, -1, 0),
                   fractions=lambda x, y: x < 0)
        if points:
            add_points(case, REGIONS, DYE, pointsPerCell=4)
        case.override("control", functions=f"{{ {functions} }}")
        case.substitute("system/controlDict", {
            "endTime": 0.2, "deltaT": deltaT,
            "writeInterval": round(0.2/deltaT)})
        case.decompose(ranks)
        done = case.run("cosseratPicFoam", ranks=ranks, check=check)
        case.reconstruct()
        return case, done

    return make


@pytest.mark.slow
@pytest.mark.parametrize("ranks", [1, 2])
def test_vtkCloud(run, ranks):
    """Places, material, dye and volume are those of the cloud written."""
    case, _ = run("vtk { type vtkCloud; libs (lagrangianFunctionObjects);"
                  " cloud materialPoints; writeControl writeTime;"
                  " format ascii; }", ranks)
    (file,) = case.path.glob("postProcessing/vtk/**/*.vtp")
    found = {}
    for array in ElementTree.parse(file).iter("DataArray"):
        values = np.array(array.text.split(), float)
        n = int(array.get("NumberOfComponents", 1))
        found[array.get("Name")] = values.reshape(-1, n) if n > 1 else values
    order = np.lexsort(found["Points"].T.round(5))
    places = case.cloud("positions")
    ours = np.lexsort(places.T.round(5))
    assert np.allclose(found["Points"][order], places[ours], atol=1e-5)
    for name in ("material", "dye", "volume"):
        assert np.allclose(found[name][order], case.cloud(name)[ours],
                           rtol=1e-5), name
    assert set(found["dye"]) > {0, 1, 2}


@pytest.mark.slow
def test_vtkCloud_of_a_choice(run):
    """Points of one material, chosen as of any other cloud."""
    case, _ = run("vtk { type vtkCloud; libs (lagrangianFunctionObjects);"
                  " cloud materialPoints; writeControl writeTime; format ascii;"
                  " fields (volume); selection { ours { action use;"
                  " source field; field material; accept (less 0.5); } } }")
    (file,) = case.path.glob("postProcessing/vtk/**/*.vtp")
    n = int(re.search(r"NumberOfPoints='(\d+)'", file.read_text())[1])
    assert n == (case.cloud("material") == 0).sum() > 0


@pytest.mark.slow
@pytest.mark.parametrize("field", ["volume", "material"])
def test_dataCloud(run, field):
    """A column of the points beside their places."""
    case, _ = run("data { type dataCloud; libs (lagrangianFunctionObjects);"
                  f" cloud materialPoints; field {field};"
                  " writeControl writeTime; }")
    (file,) = [f for f in case.path.glob("postProcessing/data/**/*")
               if f.is_file()]
    rows = np.loadtxt(file)
    assert np.allclose(sorted(rows[:, 3]), sorted(case.cloud(field)),
                       rtol=1e-4)


@pytest.mark.slow
def test_particleDistribution(run):
    """Number and volume of the points by material."""
    case, _ = run("""spread
{
    type particleDistribution; libs (fieldFunctionObjects);
    cloud materialPoints; writeControl writeTime; setFormat raw;
    nameVsBinWidth ((volume 1e-5));
}""")
    assert list(case.path.glob("postProcessing/spread/**/*"))


@pytest.mark.slow
def test_cloudInfo(run):
    """It is of parcels that have a diameter: an error, or not a row."""
    case, done = run("info { type cloudInfo; libs (lagrangianFunctionObjects);"
                     " clouds (materialPoints); writeControl writeTime; }",
                     check=False)
    if done.returncode:
        assert "materialPoints" in done.stdout[done.stdout.index("FOAM FATAL"):]
    else:
        (file,) = case.path.glob("postProcessing/info/**/*.dat")
        assert all(line.startswith("#")
                   for line in file.read_text().splitlines())


@pytest.mark.slow
@pytest.mark.parametrize("ranks", [1, 2])
def test_solverInfo(run, ranks):
    """Residuals and iterations are those of the log; omega's too."""
    case, done = run("info { type solverInfo; libs (utilityFunctionObjects);"
                     " fields (U p_rgh omega); }", ranks)
    (file,) = case.path.glob("postProcessing/info/*/solverInfo.dat")
    lines = file.read_text().splitlines()
    names = lines[1].split()[1:]
    rows = [dict(zip(names, line.split())) for line in lines[2:]]
    assert [float(row["Time"]) for row in rows] == [0.1, 0.2]
    told = re.findall(r"Solving for (\w+), Initial residual = (\S+), Final"
                      r" residual = (\S+), No Iterations (\d+)", done.stdout)
    for i, row in enumerate(rows):
        # After the solve of the start
        U, p, omega = told[3*(i + 1):3*(i + 2)]
        for name, (_, initial, final, n) in (("Ux", U), ("Uy", U),
                                             ("p_rgh", p), ("omega", omega)):
            assert float(row[f"{name}_initial"]) == pytest.approx(
                float(initial), rel=1e-5)
            assert float(row[f"{name}_final"]) == pytest.approx(
                float(final), rel=1e-5)
            assert row[f"{name}_iters"] == n
        for name in "U", "p_rgh", "omega":
            assert row[f"{name}_solver"] == "FGMRES"
        assert row["U_converged"] == "true"


def test_runTimeControl_by_residual(run):
    """What others compute from them: here the run ends by the first."""
    case, done = run("""
info { type solverInfo; libs (utilityFunctionObjects); fields (p_rgh); }
stop
{
    type runTimeControl; libs (utilityFunctionObjects);
    conditions
    {
        one { type equationInitialResidual; fields (p_rgh); value 0.9;
              mode minimum; }
    }
}
""", deltaT=0.04)
    assert "satisfied using threshold value: 0.9" in done.stdout
    # Which looks from the third step on
    assert case.times() == ["0.12"]


@pytest.mark.slow
@pytest.mark.parametrize("ranks", [1, 2])
def test_stress_is_there_for_others(run, ranks):
    """Sampled as it is written: by a probe, as a mean over the volume, and
    along a line."""
    case, _ = run("""
probe { type probes; libs (sampling); fields (sigma coupleStress);
    probeLocations ((0.0625 0.0625 0.05)); writeControl timeStep; }
mean { type volFieldValue; libs (fieldFunctionObjects); regionType all;
    operation volAverage; fields (sigma dissipation); writeFields no; }
line { type sets; libs (sampling); writeControl writeTime; fields (sigma);
    interpolationScheme cell; setFormat raw; sets ( l { type midPoint; axis y;
    start (0.06 -0.5 0.05); end (0.06 0.5 0.05); } ); }
""", ranks)
    sigma = case.field("sigma")
    at = np.argmin(np.linalg.norm(
        case.centres()[:, :2] - 0.0625, axis=1))
    probe = next(case.path.glob("postProcessing/probe/*/sigma"))
    rows = [line for line in probe.read_text().splitlines()
            if not line.startswith("#")]
    assert len(rows) == 2
    numbers = np.array(re.findall(r"-?[\d.]+(?:e[-+]\d+)?", rows[-1]), float)
    assert np.allclose(numbers[1:], sigma[at], atol=1e-5*np.abs(sigma).max())
    mean = next(case.path.glob("postProcessing/mean/*/volFieldValue.dat"))
    last = np.array(re.findall(r"-?[\d.]+(?:e[-+]\d+)?",
                               mean.read_text().splitlines()[-1]), float)
    assert np.allclose(last[1:10], sigma.mean(axis=0),
                       atol=1e-5*np.abs(sigma).max())
    assert last[10] == pytest.approx(case.field("dissipation").mean(),
                                     rel=1e-5)
    assert list(case.path.glob("postProcessing/line/0.2/*sigma*"))


@pytest.mark.parametrize("functions, words", [
    ("t { type pointTracers; libs (cosseratFunctionObjects);"
     " places ((0 0 0)); }", ["no material points"]),
    ("s { type pointStatistics; libs (cosseratFunctionObjects); }",
     ["no material points"])])
def test_without_points(run, functions, words):
    """What needs them says so."""
    _, done = run(functions, points=False, check=False)
    assert done.returncode
    for word in words:
        assert word in done.stdout


def test_vtkCloud_without_points(run):
    """OpenFOAM's own writes nothing, and the run goes on."""
    case, _ = run("vtk { type vtkCloud; libs (lagrangianFunctionObjects);"
                  " cloud materialPoints; writeControl writeTime; }",
                  points=False)
    assert case.times() == ["0.2"] or case.times()
    assert not list(case.path.glob("postProcessing/vtk/**/*.vtp"))
