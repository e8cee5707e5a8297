"""What OpenFOAM reads is read: units by name, directives, code, paths; files
that nothing reads are told; scripts take no file for one of OpenFOAM's."""

import os
import re
import shutil
import subprocess

import numpy as np
import pytest

from cosserat.scenes.box import Box, add_points
from cosserat.case import Case, ROOT

LIQUIDS = {"a": {"eta": 2, "etaC": 1, "R": 0.1, "rho": 1},
           "b": {"eta": 4, "etaC": 0, "R": 0, "rho": 0}}

LID = {"top": ("type fixedValue; value uniform (1 0 0);",
               "type zeroGradient;")}


@pytest.fixture(name="plain", scope="module")
def plain_fixture(tmp_path_factory):
    """A box stirred by its lid, with the power of that."""
    case = Box(tmp_path_factory.mktemp("lid")/"case", n=6,
               materials={"a": LIQUIDS["a"]}, walls=LID).write()
    shutil.copytree(case.path/"0", case.path/"0.orig")
    return case, power(case)


@pytest.fixture(name="expected")
def expected_fixture(plain):
    """The power of the box as it is."""
    return plain[1]


@pytest.fixture(name="lid")
def lid_fixture(plain, tmp_path):
    """Function that makes a copy of the box, meshed."""

    def make(target="case"):
        case = Case(shutil.copytree(plain[0].path, tmp_path/target))
        shutil.rmtree(case.path/"postProcessing")
        case.restore()
        shutil.rmtree(case.path/"0.orig")
        return case

    return make


def change(case, file, pattern, replacement):
    """Change a file of a case, which has the pattern."""
    path = case.path/file
    text = path.read_text()
    assert re.search(pattern, text), text
    path.write_text(re.sub(pattern, replacement, text))


def power(case, *options, **how):
    """Of the walls, after a run."""
    case.run("cosseratPicFoam", "-solveOnce", *options, **how)
    return case.table("power", "powerBalance.dat")[-1][2]


@pytest.mark.parametrize("file, pattern, replacement", [
    ("0/U", r"\[0 1 -1 0 0 0 0\]", "[m s^-1]"),
    ("0/U", r"\[0 1 -1 0 0 0 0\]", "[m/s]"),
    ("0/p_rgh", r"\[1 -1 -2 0 0 0 0\]", "[Pa]"),
    ("0/p_rgh", r"\[1 -1 -2 0 0 0 0\]", "[kg m^-1 s^-2]"),
    ("0/omega", r"\[0 0 -1 0 0 0 0\]", "[s^-1]"),
    ("constant/materialProperties", "eta 2;", "eta [Pa s] 2;"),
    ("constant/materialProperties", "eta 2;", "eta eta [kg m^-1 s^-1] 2;"),
    ("constant/materialProperties", "eta 2;", "eta [kg/(m s)] 2;"),
    ("constant/materialProperties", "R 0.1;", "R [m] 0.1;"),
    ("constant/materialProperties", "rho 1;", "rho [kg m^-3] 1;"),
    ("constant/materialProperties", "rho 1;", "rho [1 -3 0 0 0] 1;"),
    ("constant/g", r"\[0 1 -2 0 0 0 0\]", "[m s^-2]"),
    # Directives and what is on their lines
    ("0/U", '#includeEtc "caseDicts/setConstraintTypes"\n}',
     '#includeEtc "caseDicts/setConstraintTypes" }'),
    ("constant/materialProperties", r"materials\n\{([^$]*)eta 2;",
     r"two 2;\nmaterials\n{\1eta $two;"),
    ("constant/materialProperties", "eta 2;", 'eta 9; #remove eta\n eta 2;'),
    ("constant/materialProperties", "eta 2;",
     "#inputMode merge\n eta 7; eta 2;"),
    ("constant/materialProperties", "eta 2;",
     "#ifeq 1 1\n eta 2;\n#else\n eta 8;\n#endif\n"),
    ("constant/materialProperties", "eta 2;", '#sinclude "none" eta 2;'),
    ("constant/materialProperties", "eta 2;", 'eta #eval "1 + 1";'),
    ("constant/materialProperties", "eta 2;", "eta #eval{ 2*(3 - 2) };"),
    ("constant/materialProperties", "rho 1;",
     "loc (1 0 0);\nrho #eval{ mag($[(vector) loc]) };\n#remove loc\n"),
    ("system/fvSolution", "creepingFlow\n{",
     'solvers { "(p|U).*" { solver PCG; } div(phi,U) { } }\ncreepingFlow\n{'),
])
def test_what_openfoam_reads(lid, expected, file, pattern, replacement):
    """The power is that of the case as it was."""
    case = lid()
    change(case, file, pattern, replacement)
    assert power(case) == pytest.approx(expected, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("velocity, viscosity", [
    ("[m s^-1]", "[Pa s]"), ("[m/s]", "[kg m^-1 s^-1]")])
def test_flux_in_units_by_name(box, velocity, viscosity):
    """What a velocity of 1 m/s over a face of 1 m by 0.1 m brings in leaves,
    and the pressure at the end of the plug is that of numbers alone."""
    found = []
    for units in (velocity, viscosity), (None, None):
        case = box(f"named{units[0] is not None}", n=6,
                   materials={"a": LIQUIDS["a"]}, walls={
                       "left": ("type fixedValue; value uniform (1 0 0);",
                                "type zeroGradient;"),
                       "right": ("type zeroGradient;", "type zeroGradient;",
                                 "type fixedValue; value uniform 0;"),
                       "bottom": ("type noSlip;", "type zeroGradient;"),
                       "top": ("type noSlip;", "type zeroGradient;")})
        if units[0]:
            change(case, "0/U", r"\[0 1 -1 0 0 0 0\]", units[0])
            change(case, "constant/materialProperties", "eta 2;",
                   f"eta {units[1]} 2;")
        case.run("cosseratPicFoam", "-solveOnce")
        assert case.patch_field("phi", "right", 0).sum() == pytest.approx(
            0.1, rel=1e-9)
        found.append(case.field("p_rgh", 0).max())
    assert found[0] == pytest.approx(found[1], rel=1e-9) and found[0] > 1


@pytest.mark.parametrize("file, pattern, replacement, words", [
    ("0/U", r"\[0 1 -1 0 0 0 0\];", "[m s^-2];", ["imension"]),
    ("0/U", r"\[0 1 -1 0 0 0 0\];", "[m s^-1;", ["'[' of line", "not closed"]),
    ("constant/materialProperties", "eta 2;", "eta [m] 2;",
     ["'eta'", "dimensions"]),
    ("constant/materialProperties", "eta 2;", "eta [Pa s];", ["'eta'"]),
    ("constant/materialProperties", "eta 2;", "eta [Pa s 2;",
     ["'[' of line", "not closed"])])
def test_what_it_does_not_read(lid, file, pattern, replacement, words):
    """Other units, and brackets that are open."""
    case = lid()
    change(case, file, pattern, replacement)
    done = case.run("cosseratPicFoam", check=False)
    message = done.stdout[done.stdout.index("FOAM FATAL"):]
    assert done.returncode
    for word in words:
        assert word in message, message


CODE = {
    "#calc": ("constant/materialProperties", "eta 2;",
              'eta #calc "3.0 - 1.0";'),
    "#codeStream": ("constant/materialProperties", "eta 2;", """
        eta #codeStream
        {
            code
            #{
                os << (1 > 0 ? 2 : 3);   // braces } of code are its own
            #};
        };"""),
    "codedFixedValue": ("0/U", r"top \{ [^}]*\}", """
        top
        {
            type codedFixedValue;
            value uniform (0 0 0);
            name lid;
            code
            #{
                operator==(vector(1, 0, 0));
            #};
        }"""),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", CODE)
def test_code(lid, expected, name):
    """Compiled where the user is not root, which OpenFOAM asks for; where root
    cannot be another one, it is OpenFOAM that refuses."""
    case = lid()
    change(case, *CODE[name][:2], lambda _: CODE[name][2])
    command = ["cosseratPicFoam", "-solveOnce"]
    other = ["unshare", "--user", "--map-user=1000", "--map-group=1000"]
    if os.geteuid() == 0 and subprocess.run(
            [*other, "true"], stderr=subprocess.DEVNULL,
            check=False).returncode == 0:
        command = [*other, *command]
    done = case.run(*command, check=False)
    if os.geteuid() == 0 and command[0] != other[0]:
        assert "administrator rights" in done.stdout, done.stdout[-2000:]
        return
    assert done.returncode == 0, done.stdout[-3000:]
    assert case.table("power", "powerBalance.dat")[-1][2] == pytest.approx(
        expected, rel=1e-9)


SURFACE = """solid heap
{}
endsolid heap
"""


def prism(x, y):
    """A closed box in STL, from the origin to (x, y), across the mesh."""
    corners = np.array([[i & 1, i >> 1 & 1, i >> 2] for i in range(8)])
    corners = corners*(x, y, 2.0) - (0, 0, 1.0)
    facets = ""
    for quad in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3),
                 (0, 4, 6, 2), (1, 3, 7, 5)):
        for which in ((0, 1, 2), (0, 2, 3)):
            rows = "\n".join("vertex {:g} {:g} {:g}".format(
                *corners[quad[i]]) for i in which)
            facets += (f"facet normal 0 0 0\nouter loop\n{rows}\n"
                       "endloop\nendfacet\n")
    return SURFACE.format(facets)


REGIONS = {
    "surface": ('type surface; file "constant/triSurface/box.stl";', 0.12),
    "tableFile": ("type belowInterface; along (1 0 0); up (0 1 0);"
                  " height tableFile; heightCoeffs { file"
                  ' "constant/height.dat"; }', 0.6),
    "surface of the case": ("type surface; file"
                            ' "$FOAM_CASE/constant/triSurface/box.stl";', 0.12),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", REGIONS)
@pytest.mark.parametrize("ranks", [1, 2])
def test_case_from_anywhere(box, tmp_path, name, ranks):
    """Files of a region are those of the case, wherever it is run from."""
    region, share = REGIONS[name]
    case = box(n=10, materials=LIQUIDS, g=(0, -1, 0),
               fractions=lambda x, y: x < 0)
    add_points(case, "{ type all; material b; } { material a; %s }" % region,
               pointsPerCell=4)
    (case.path/"constant/triSurface").mkdir()
    (case.path/"constant/triSurface/box.stl").write_text(prism(0.3, 0.4))
    (case.path/"constant/height.dat").write_text("((-1 0.1) (1 0.1))")
    command = ["cosseratPicFoam", "-case", str(case.path), "-solveOnce"]
    case.decompose(ranks)
    if ranks > 1:
        command = ["mpirun", "-np", "2", *command, "-parallel"]
    done = subprocess.run(command, cwd=tmp_path, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False,
                          timeout=case.timeout)
    assert done.returncode == 0, done.stdout[-2000:]
    found = re.search(r"by points and on the mesh: a (\S+)", done.stdout)[1]
    assert float(found) == pytest.approx(share*0.1, rel=1e-9)


FILES = [
    ("constant/fvOptions", "bodyForce"), ("system/fvOptions", "bodyForce"),
    ("constant/dynamicMeshDict", "does not move"),
    ("constant/turbulenceProperties", "creeping"),
    ("constant/transportProperties", "materialProperties"),
    ("constant/MRFProperties", "rotatingWallVelocity"),
    ("constant/materialPropertys", ""), ("0/p", "p_rgh"),
    ("0/alpha.water", "fractions"), ("0/bodyforce", ""), ("0/T", ""),
]


@pytest.mark.parametrize("file, hint", FILES)
def test_file_that_nothing_reads(lid, file, hint):
    """Is told at the start, with what there is in its place."""
    case = lid()
    if file.startswith("0/"):
        shutil.copy(case.path/"0/p_rgh", case.path/file)
    else:
        shutil.copy(case.path/"constant/g", case.path/file)
    log = case.run("cosseratPicFoam").stdout.split("Time = ")[0]
    told = log[log.index("Files that nothing reads"):]
    (line,) = [line for line in told.splitlines()
               if re.match(rf"\s+{file}\b", line)]
    assert hint in line


@pytest.mark.slow
def test_files_are_told_once_by_two_ranks(lid):
    """Those of the case and of the start time."""
    case = lid()
    shutil.copy(case.path/"constant/g", case.path/"constant/fvOptions")
    shutil.copy(case.path/"0/p_rgh", case.path/"0/T")
    case.decompose(2)
    log = case.run("cosseratPicFoam", ranks=2).stdout
    for file in ("constant/fvOptions:", "    0/T\n"):
        assert log.count(file) == 1, file


def test_fractions_beside_points_are_told(box):
    """Points prevail."""
    case = box(n=4, materials=LIQUIDS, fractions=lambda x, y: x < 0)
    shutil.copy(case.path/"0/alpha.a", case.path/"keep")
    add_points(case, "{ type all; material a; }")
    shutil.move(case.path/"keep", case.path/"0/alpha.a")
    log = case.run("cosseratPicFoam").stdout
    assert "0/alpha.a: fractions are those of the points" in log


@pytest.mark.slow
def test_what_is_read_is_not_told(box):
    """Of a case with nothing too many, at the start and when it goes on; a
    file that another one includes is read."""
    case = box(n=4, materials=LIQUIDS, fractions=lambda x, y: x < 0,
               force=lambda x, y: (0*x, 0*y))
    shutil.copy(case.path/"constant/g", case.path/"constant/parts")
    change(case, "constant/materialProperties", "materials\n",
           '#includeIfPresent "parts"\nmaterials\n')
    change(case, "constant/parts", "value.*", "")
    change(case, "system/controlDict", "startFrom .*;",
           "startFrom latestTime;")
    for end in (1, 2):
        case.substitute("system/controlDict", {"endTime": end})
        log = case.run("cosseratPicFoam").stdout
        assert "Files that nothing reads" not in log, log


@pytest.mark.slow
@pytest.mark.parametrize("name, text, found", [
    ("test_x.py", "echo ran >&2; COSSERAT_RAN=yes\n", "no"),
    ("prefs.sh", "export COSSERAT_RAN=yes\n", "no"),
    ("COSSERAT_RAN=yes", None, "no"), ("-k", None, "no")])
def test_environment_takes_no_argument(tmp_path, name, text, found):
    """Of a script that sources it: OpenFOAM would run files, and set names."""
    if text:
        (tmp_path/name).write_text(text)
    clean = {key: value for key, value in os.environ.items()
             if not key.startswith(("WM_", "FOAM_", "COSSERATPIC_D"))}
    done = subprocess.run(
        ["bash", "-c", f'. "{ROOT}/etc/bashrc" || exit 1;'
         ' echo "${COSSERAT_RAN:-no} $WM_PROJECT_VERSION"', "x", name],
        cwd=tmp_path, env=clean, stdout=subprocess.PIPE, text=True,
        stderr=subprocess.STDOUT, check=False)
    assert done.returncode == 0, done.stdout
    assert done.stdout.split()[0] == found and len(done.stdout.split()) == 2


def test_no_script_hands_its_arguments_on():
    """Where OpenFOAM's own environment is sourced, with '-'."""
    scripts = [ROOT/"etc/bashrc", *(ROOT/"bin").iterdir(),
               *ROOT.glob("All*"), ROOT/"validation/Allrun", ROOT/".ci/run"]
    seen = 0
    for script in scripts:
        for line in script.read_text().splitlines():
            if re.match(r"\s*(\.|source) .*/etc/bashrc", line) and (
                    "COSSERATPIC_FOAM" in line or '"$1' in line):
                assert line.rstrip().endswith(" -"), (script, line)
                seen += 1
    assert seen == 2
