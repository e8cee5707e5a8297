"""Mistakes of a dictionary are told before the first step: file, entry, what
was found and what is allowed; nothing of the case is changed."""

import re

import pytest

from cosserat.scenes.box import add_points
from cosserat.case import TUTORIALS

MATERIALS = "constant/materialProperties"
POINTS = "constant/materialPointsProperties"
SOLUTION = "system/fvSolution"
CONTROL = "system/controlDict"
GRAVITY = "constant/g"

#: name: (file, pattern, replacement, words of the message)
MISTAKES = {
    "missing viscosity": (MATERIALS, "eta         1000;", "",
                          ["eta", "materialProperties"]),
    "negative viscosity": (MATERIALS, "eta         1000;", "eta -3;",
                           ["eta", "-3", "above zero", "materialProperties"]),
    "zero viscosity": (MATERIALS, "eta         1000;", "eta 0;",
                       ["eta", "0", "above zero"]),
    "not a number": (MATERIALS, "eta         1000;", "eta much;",
                     ["eta", "much", "materialProperties"]),
    "wrong dimensions": (MATERIALS, "eta         1000;",
                         "eta [0 2 -1 0 0 0 0] 1000;",
                         ["dimensions", "eta"]),
    "unknown law": (MATERIALS, "viscosityLaw    constant;",
                    "viscosityLaw plastic;",
                    ["viscosityLaw", "plastic", "constant", "granularContact"]),
    "negative density": (MATERIALS, "rho             1e6;", "rho -1;",
                         ["rho", "-1", "zero"]),
    "R and M": (MATERIALS, "R           $alpha;", "R 1; M 2;",
                ["R", "M", "one of"]),
    "neither R nor M": (MATERIALS, "R           $alpha;", "",
                        ["R", "missing", "one of"]),
    "M without etaC": (MATERIALS, "etaC        0;\n            R           0;",
                       "etaC 0; M 1;", ["etaC", "microrotation"]),
    "B misspelt": (MATERIALS, "B           infinite;", "B infinit;",
                   ["B", "infinit", "infinite"]),
    "B zero": (MATERIALS, "B           infinite;", "B 0;",
               ["B", "above zero"]),
    "unknown average": (MATERIALS, "viscosityAverage    arithmetic;",
                        "viscosityAverage mean;",
                        ["mean", "arithmetic", "geometric", "harmonic"]),
    "unknown material": (POINTS, "material    background;",
                         "material air;", ["air", "background", "granular"]),
    "unknown region": (POINTS, "type        box;", "type cube;",
                       ["cube", "box", "polygon"]),
    "box inside out": (POINTS, "min         (-2.5 0 -1);", "min (9 0 -1);",
                       ["min", "max", "below"]),
    "point in no region": (POINTS, "type        all;",
                           "type box; min (0 0 -1); max (1 1 1);",
                           ["none of the", "type all"]),
    "no points": (POINTS, "pointsPerCell   16;", "pointsPerCell 0;",
                  ["pointsPerCell", "0", "1 or more"]),
    "unknown velocity": (POINTS, "velocity            conservativeLinear;",
                         "velocity nearest;", ["nearest", "cellPoint"]),
    "unknown integration": (POINTS, "integration         RK2;",
                            "integration RK3;", ["RK3", "RK2", "RK4"]),
    "unknown average of points": (POINTS, "integration         RK2;",
                                  "average mean;",
                                  ["average", "mean", "cellMean",
                                   "linearLeastSquares"]),
    "unknown coupling": (POINTS, "integration         RK2;",
                         "coupling implicit;",
                         ["coupling", "implicit", "frozen", "extrapolated",
                          "midpoint"]),
    "too many points wanted": (POINTS, "minPointsPerCell    4;",
                               "minPointsPerCell 40;",
                               ["minPointsPerCell", "40", "16"]),
    "tolerance zero": (SOLUTION, "tolerance       1e-6;", "tolerance 0;",
                       ["tolerance", "between 0 and 1"]),
    "notConverged": (SOLUTION, "tolerance       1e-6;",
                     "notConverged ignore;", ["ignore", "error", "warn"]),
    "no such patch": ("0/U", r"(outerWalls|siloWalls)", "(outer|siloWalls)",
                      ["outerWalls", "U"]),
    "patch type of U": ("0/U", "slip;", "fixedNormalSlip; fixedValue uniform"
                        " (0 0 0);", ["fixedNormalSlip", "noSlip",
                                      "tangentialTraction"]),
    "patch type of omega": ("0/omega", "zeroGradient;",
                            "fixedGradient; gradient uniform 1;",
                            ["fixedGradient", "coupleTraction", "omega"]),
    "dimensions of omega": ("0/omega", "[0 0 -1 0 0 0 0]",
                            "[0 1 -1 0 0 0 0]", ["imension"]),
    # Materials
    "misspelt entry of a law": (MATERIALS, "etaC        1000;",
                                "etaC 1000; etac 10;",
                                ["etac", "read by nothing", "etaC",
                                 "materialProperties"]),
    "misspelt entry of a material": (MATERIALS, "rho             1e6;",
                                     "rho 1e6; Rho 1;",
                                     ["Rho", "read by nothing", "rho",
                                      "constantCoeffs"]),
    "missing density": (MATERIALS, "rho             1e6;", "",
                        ["rho", "materialProperties"]),
    "infinite density": (MATERIALS, "rho             1e6;", "rho inf;",
                         ["rho", "inf", "materialProperties"]),
    "no law": (MATERIALS, "viscosityLaw    constant;", "",
               ["viscosityLaw", "materialProperties"]),
    "no coefficients": (MATERIALS, "constantCoeffs", "coeffs",
                        ["constantCoeffs", "materialProperties"]),
    "no materials": (MATERIALS, "materials\n", "material\n",
                     ["materials", "materialProperties"]),
    "NaN": (MATERIALS, "eta         1000;", "eta nan;",
            ["eta", "nan", "materialProperties"]),
    "infinite": (MATERIALS, "eta         1000;", "eta inf;",
                 ["eta", "inf", "materialProperties"]),
    "negative Cosserat viscosity": (MATERIALS, "etaC        1000;",
                                    "etaC -1;", ["etaC", "-1", "zero"]),
    "missing Cosserat viscosity": (MATERIALS, "etaC        1000;", "",
                                   ["etaC", "materialProperties"]),
    "negative internal length": (MATERIALS, "R           $alpha;", "R -1;",
                                 ["R", "-1", "zero"]),
    "length of wrong dimensions": (MATERIALS, "R           $alpha;",
                                   "R [0 0 1 0 0 0 0] 1;",
                                   ["dimensions", "R"]),
    "missing bulk viscosity": (MATERIALS, "B           infinite;", "",
                               ["B", "materialProperties"]),
    "negative bulk viscosity": (MATERIALS, "B           infinite;", "B -4;",
                                ["B", "-4", "above zero"]),
    "two values": (MATERIALS, "eta         1000;", "eta 1000 2000;",
                   ["eta", "materialProperties"]),
    "unknown variable": (MATERIALS, "$alpha", "$beta", ["beta"]),
    "density average": (MATERIALS, "densityAverage      arithmetic;",
                        "densityAverage median;", ["median", "arithmetic"]),
    # Points
    "no seeding": (POINTS, "seeding\n", "seed\n",
                   ["seeding", "materialPointsProperties"]),
    "no regions": (POINTS, "    regions\n", "    areas\n",
                   ["regions", "materialPointsProperties"]),
    "region without material": (POINTS, "material    background;", "",
                                ["material", "materialPointsProperties"]),
    "region without type": (POINTS, "type        all;", "",
                            ["type", "materialPointsProperties"]),
    "box without a corner": (POINTS, "max         (2.5 5 1);", "",
                             ["max", "materialPointsProperties"]),
    "corner of two numbers": (POINTS, "max         (2.5 5 1);",
                              "max (2.5 5);", ["materialPointsProperties"]),
    "polygon of two corners": (POINTS, "regions\n    (",
                               "regions\n    ( { type polygon; material"
                               " granular; points ((0 0 0) (1 0 0)); }",
                               ["points", "three"]),
    "surface that is not there": (POINTS, "regions\n    (",
                                  "regions\n    ( { type surface; material"
                                  ' granular; file "none.stl"; }',
                                  ["none.stl"]),
    "points as a word": (POINTS, "pointsPerCell   16;",
                         "pointsPerCell many;",
                         ["pointsPerCell", "materialPointsProperties"]),
    "negative minimum": (POINTS, "minPointsPerCell    4;",
                         "minPointsPerCell -4;",
                         ["minPointsPerCell", "-4"]),
    "unknown dye": (POINTS, "type        grid;", "type rings;",
                    ["rings", "grid", "bands", "stripes"]),
    "dye of no material": (POINTS, "material    granular;\n            spacing",
                           "material sand;\n            spacing",
                           ["sand", "granular"]),
    "grid without a direction": (POINTS, "((1 0 0) (0 1 0))",
                                 "((1 0 0) (0 0 0))",
                                 ["directions", "zero"]),
    "too many points": (POINTS, "pointsPerCell   16;",
                        "pointsPerCell 900000000;",
                        ["pointsPerCell", "2147483647"]),
    "dye without spacing": (POINTS, "spacing     0.5;", "",
                            ["spacing", "materialPointsProperties"]),
    "unknown property": (POINTS, "minPointsPerCell    4;",
                         "properties { strain { type tensile; } }",
                         ["tensile", "strain", "accumulatedStrain"]),
    "property of a name that is taken": (
        POINTS, "minPointsPerCell    4;",
        "properties { volume { type carried; } }",
        ["volume", "origId", "materialPointsProperties"]),
    "property as a field of the flow": (
        POINTS, "minPointsPerCell    4;",
        "properties { omega { type carried; onMesh yes; } }",
        ["omega", "on the mesh", "any other name"]),
    "misspelt entry of a property": (
        POINTS, "minPointsPerCell    4;",
        "properties { ore { type carried; begin 1; } }", ["begin", "start"]),
    "region of a property without value": (
        POINTS, "minPointsPerCell    4;",
        "properties { ore { type carried; regions ( { type all; } ); } }",
        ["Region 0", "ore", "value"]),
    "property beyond sense": (
        POINTS, "minPointsPerCell    4;",
        "properties { ore { type carried; start 1e50; } }",
        ["start", "1e+50", "1e+40"]),
    # What OpenFOAM reads without a word
    "entry twice": (MATERIALS, "eta         1000;", "eta 1000; eta 10;",
                    ["'eta' is given twice", "materialProperties"]),
    "material twice": (MATERIALS, "    granular\n    {",
                       "granular { rho 1; }\n granular\n {",
                       ["'granular' is given twice", "materialProperties"]),
    "region with an entry twice": (POINTS, "type        all;",
                                   "type all; type box;",
                                   ["'type' is given twice",
                                    "materialPointsProperties"]),
    "bracket too many": (POINTS, "velocity            conservativeLinear;",
                         "} velocity cellPoint;",
                         ["'}' closes nothing", "directions",
                          "materialPointsProperties"]),
    "bracket not closed": (POINTS, "minPointsPerCell    4;",
                           "inflow { feed { material granular; }",
                           ["'{' of line", "not closed",
                            "materialPointsProperties"]),
    "cut short": (GRAVITY, "value           (0 -10 0);", "value (0 -10",
                  ["'(' of line", "not closed", "constant/g"]),
    "beyond double precision": (MATERIALS, "eta         1000;", "eta 1e400;",
                                ["'eta'", "cannot be read", "1e308"]),
    "beyond sense": (MATERIALS, "eta         1000;", "eta 1e300;",
                     ["eta", "1e+300", "at most 1e+40"]),
    "below sense": (MATERIALS, "eta         1000;", "eta 1e-100;",
                    ["eta", "1e-100", "above zero"]),
    "empty value": (MATERIALS, "eta         1000;", "eta ;",
                    ["eta", "empty", "above zero"]),
    # Gravity, solver, time
    "gravity beyond sense": (GRAVITY, "(0 -10 0)", "(0 -1e300 0)",
                             ["value", "constant/g", "1e+40"]),
    "digits of time": (CONTROL, "timePrecision   8;",
                       "timePrecision 800000000;",
                       ["timePrecision", "1 to 100", "controlDict"]),
    "step lost in the end": (CONTROL, "deltaT          1e-06;",
                             "deltaT 1e-30;",
                             ["deltaT", "1e-30", "endTime", "controlDict"]),
    "write interval zero": (CONTROL, "writeInterval   4.75e-4;",
                            "writeInterval 0;", ["writeInterval", "zero"]),
    "no gravity": (GRAVITY, "value           (0 -10 0);", "",
                   ["value", "constant/g"]),
    "dimensions of gravity": (GRAVITY, "[0 1 -2 0 0 0 0]",
                              "[0 1 -1 0 0 0 0]", ["imension"]),
    "tolerance above one": (SOLUTION, "tolerance       1e-6;",
                            "tolerance 3;", ["tolerance", "3"]),
    "tolerance as a word": (SOLUTION, "tolerance       1e-6;",
                            "tolerance low;", ["tolerance", "fvSolution"]),
    "no iterations": (SOLUTION, "tolerance       1e-6;",
                      "tolerance 1e-6; maxIter 0;", ["maxIter", "0"]),
    "no directions": (SOLUTION, "tolerance       1e-6;",
                      "tolerance 1e-6; nDirections 0;",
                      ["nDirections", "0"]),
    "recycled below none": (SOLUTION, "tolerance       1e-6;",
                            "tolerance 1e-6; nRecycled -1;",
                            ["nRecycled", "-1"]),
    "unknown preconditioner": (SOLUTION, "tolerance       1e-6;",
                               "tolerance 1e-6; preconditioner"
                               " { preconditioner AMG; }", ["AMG", "GAMG"]),
    "misspelt entry of the solver": (SOLUTION, "tolerance       1e-6;",
                                     "tolerence 1e-6;",
                                     ["tolerence", "tolerance"]),
    "misspelt entry of the seeding": (POINTS, "pointsPerCell   16;",
                                      "pointPerCell 16;",
                                      ["pointPerCell", "pointsPerCell"]),
    "time step zero": (CONTROL, "deltaT          1e-06;", "deltaT 0;",
                       ["deltaT"]),
    "Courant number zero": (CONTROL, "adjustTimeStep  no;\n\nmaxCo           0.5;",
                            "adjustTimeStep yes; maxCo 0;", ["maxCo"]),
    # Fields
    "value beyond sense": ("0/U", "uniform (0 0 0)", "uniform (1e300 0 0)",
                           ["internalField", "0/U", "1e+40"]),
    "pressure at a wall": ("0/p_rgh", "zeroGradient;",
                           "fixedValue; value uniform 0;",
                           ["fixedValue", "p_rgh", "slip", "zeroGradient"]),
    "patch twice": ("0/omega", "boundaryField\n{",
                    "boundaryField\n{ outerWalls { type slip; }"
                    " outerWalls { type zeroGradient; }",
                    ["'outerWalls' is given twice", "0/omega"]),
    "dimensions of U": ("0/U", "[0 1 -1 0 0 0 0]", "[0 1 -2 0 0 0 0]",
                        ["imension"]),
    "dimensions of p_rgh": ("0/p_rgh", "[1 -1 -2 0 0 0 0]",
                            "[0 2 -2 0 0 0 0]", ["imension"]),
    "field of wrong size": ("0/omega", "uniform 0;",
                            "nonuniform List<scalar> 2 (0 1);", ["omega"]),
    "NaN in a field": ("0/U", "uniform (0 0 0)", "uniform (nan 0 0)",
                       ["U"]),
    "patch type of p_rgh": ("0/p_rgh", "zeroGradient;", "noSuchType;",
                            ["noSuchType", "zeroGradient", "p_rgh"]),
}


def state(case):
    """Contents of all files of the case but logs."""
    return {p: p.read_bytes() for p in sorted(case.path.rglob("*"))
            if p.is_file() and not p.name.startswith("log.")
            and "postProcessing" not in p.parts}


@pytest.fixture(name="silo", scope="module")
def silo_fixture(tmp_path_factory):
    """A meshed silo, coarse."""
    from cosserat.case import Case
    from cosserat.scenes.silo import COARSE
    case = Case.copy(TUTORIALS/"silo", tmp_path_factory.mktemp("input")/"case")
    case.substitute("system/blockMeshDict", COARSE)
    case.substitute("system/controlDict", {"endTime": 1e-6, "deltaT": 1e-6,
                                           "adjustTimeStep": "no"})
    case.run("blockMesh")
    return case


def test_without_a_mistake(silo):
    """The case as it is runs: what the others change is what stops them."""
    silo.run("cosseratPicFoam", check=True)


@pytest.mark.parametrize("name", MISTAKES)
def test_mistake(silo, name):
    """Non-zero exit, a message with file, entry, value, what is allowed."""
    file, pattern, replacement, words = MISTAKES[name]
    path = silo.path/file
    original = path.read_text()
    assert pattern in original
    path.write_text(original.replace(pattern, replacement))
    before = state(silo)
    try:
        done = silo.run("cosseratPicFoam", check=False)
    finally:
        path.write_text(original)
    assert done.returncode != 0
    message = done.stdout[done.stdout.index("FOAM FATAL"):]
    for word in words:
        assert word in message, message
    assert "Time = " not in done.stdout
    after = state(silo)
    after[path] = before[path]
    assert after == before


def test_variable_at_the_top_is_told(silo):
    """An entry that nothing reads may be a variable; the log names it."""
    done = silo.run("cosseratPicFoam")
    line = next(line for line in done.stdout.splitlines()
                if "nothing reads but other entries" in line)
    assert "alpha" in line and "materialProperties" in line


def test_misspelt_entry_of_the_points_is_told(silo):
    """The same at the top of the points."""
    path = silo.path/POINTS
    original = path.read_text()
    path.write_text(original.replace("minPointsPerCell", "minPointPerCell"))
    try:
        log = silo.run("cosseratPicFoam").stdout
    finally:
        path.write_text(original)
    line = next(line for line in log.splitlines() if "minPointPerCell" in line)
    assert "nothing reads but other entries" in line
    assert "materialPointsProperties" in line


def changed_log(case, file, pattern, replacement):
    """Log of a run with a file changed."""
    path = case.path/file
    original = path.read_text()
    assert pattern in original
    path.write_text(original.replace(pattern, replacement))
    try:
        return case.run("cosseratPicFoam").stdout
    finally:
        path.write_text(original)


def test_misspelt_entry_of_control_is_told(silo):
    """The Courant number misspelt would be that of the default."""
    log = changed_log(silo, CONTROL, "maxCo ", "maxC0 ")
    line = next(line for line in log.splitlines() if "maxC0" in line)
    assert "nothing reads" in line and "controlDict" in line


def test_what_is_appended_is_told(silo):
    """An entry at the top that overrides an earlier one, and a dictionary that
    is not there, so that nothing but defaults is left."""
    log = changed_log(silo, MATERIALS, "viscosityAverage    arithmetic;",
                      "viscosityAverage arithmetic;\n\n"
                      "viscosityAverage harmonic;")
    assert ("Entry 'viscosityAverage' of materialProperties is given twice: the"
            " last one counts" in log)
    assert "viscosityAverage harmonic" in log
    log = changed_log(silo, SOLUTION, "creepingFlow\n", "crepingFlow\n")
    assert re.search(r"nothing reads but other entries, by \$: \d*\(crepingFlow\)",
                     log)
    assert "No dictionary creepingFlow in fvSolution" in log


@pytest.mark.parametrize("box", ["min (9 9 -1); max (10 10 1);",
                                 "min (0 1 -1); max (0.001 1.001 1);"])
def test_region_that_holds_no_point_is_told(silo, box):
    """Outside the mesh, or between points."""
    log = changed_log(silo, POINTS, "regions\n    (", "regions\n    ( "
                      "{ type all; material background; } { type box; "
                      f"material granular; {box} }} ")
    told = [line for line in log.splitlines() if "holds no point" in line]
    # The one of all is hidden by the one of the tutorial
    assert [line.split()[1] for line in told] == ["0", "1"]


def test_later_regions_prevail(box):
    """Where two regions overlap, the points are of the later one."""
    case = box(n=8, materials={"a": {"eta": 1, "etaC": 0, "R": 0},
                               "b": {"eta": 1, "etaC": 0, "R": 0}},
               fractions=lambda x, y: x < 0)
    left = "{ type box; material %s; min (-1 -1 -1); max (%s 1 1); }"
    add_points(case, "{ type all; material a; }" + left % ("b", 0.25)
               + left % ("a", 0), pointsPerCell=4)
    case.run("cosseratPicFoam")
    x = case.cloud("positions")[:, 0]
    assert ((case.cloud("material") == 1) == ((x > 0) & (x < 0.25))).all()


@pytest.mark.slow
def test_mesh_of_three_dimensions(box):
    """Front and back that are not empty."""
    case = box(materials={"a": {"eta": 1, "etaC": 1, "R": .1}})
    case.substitute("constant/polyMesh/boundary", {"type": "wall"})
    for name, entry in (("U", "noSlip"), ("omega", "zeroGradient"),
                        ("p_rgh", "zeroGradient")):
        path = case.path/"0"/name
        path.write_text(path.read_text().replace(
            "#includeEtc", f"frontAndBack {{ type {entry}; }}\n#includeEtc"))
    done = case.run("cosseratPicFoam", check=False)
    message = done.stdout[done.stdout.index("FOAM FATAL"):]
    assert done.returncode and "empty" in message, message


@pytest.mark.slow
def test_missing_field(box):
    """A field that is not there."""
    for name in ("U", "p_rgh", "omega"):
        case = box(name, materials={"a": {"eta": 1, "etaC": 1, "R": .1}})
        (case.path/"0"/name).unlink()
        done = case.run("cosseratPicFoam", check=False)
        message = done.stdout[done.stdout.index("FOAM FATAL"):]
        assert done.returncode and name in message


@pytest.mark.slow
def test_decomposed_for_other_ranks(box):
    """More ranks than parts of the case."""
    case = box(materials={"a": {"eta": 1, "etaC": 1, "R": .1}})
    case.decompose(2)
    done = case.run("cosseratPicFoam", ranks=3, check=False)
    assert done.returncode and "processor" in done.stdout


@pytest.mark.slow
def test_net_force_on_a_floating_body(box):
    """Traction on all walls that nothing balances."""
    case = box(cyclic=True, materials={"a": {"eta": 1, "etaC": 1, "R": .1}},
               walls={"top": ("type tangentialTraction; traction uniform"
                              " (1 0 0);", "type zeroGradient;")})
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode and "No wall holds the body" in done.stdout


def test_couple_where_nothing_bears_it(box):
    """A couple traction on a material without bending viscosity."""
    case = box(materials={"a": {"eta": 1, "etaC": 1, "R": 0}},
               walls={"top": ("type noSlip;", "type coupleTraction;"
                              " coupleTraction uniform 1;")})
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode and "coupleTraction" in done.stdout


def test_inflow_into_a_closed_body(box):
    """Net inflow into an incompressible closed box."""
    case = box(materials={"a": {"eta": 1, "etaC": 1, "R": .1}},
               walls={"top": ("type fixedValue; value uniform (0 -1 0);",
                              "type zeroGradient;")})
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode and "closed and incompressible" in done.stdout


def test_normal_traction(box):
    """A traction with a normal part."""
    case = box(materials={"a": {"eta": 1, "etaC": 1, "R": .1}},
               walls={"top": ("type tangentialTraction; traction uniform"
                              " (0 1 0);", "type zeroGradient;")})
    done = case.run("cosseratPicFoam", check=False)
    assert done.returncode and "normal part" in done.stdout


@pytest.mark.slow
def test_not_converged_is_an_error_or_counted(box):
    """What does not converge says so; going on must be asked for."""
    scene = {"materials": {"a": {"eta": 1, "etaC": 1, "R": .1, "rho": 1},
                           "b": {"eta": 1e3, "etaC": 1, "R": .1}},
             "fractions": lambda x, y: x < y, "g": (0, -1, 0)}
    stop = box("stop", **scene)
    stop.substitute("system/fvSolution", {"tolerance": "1e-10; maxIter 3"})
    done = stop.run("cosseratPicFoam", check=False)
    assert done.returncode and "not converged" in done.stdout

    going = box("going", notConverged="warn", **scene)
    going.substitute("system/fvSolution", {"tolerance": "1e-10; maxIter 3"})
    done = going.run("cosseratPicFoam", check=False)
    assert done.returncode == 0
    assert "2 of 2 solves did not converge" in done.stdout
