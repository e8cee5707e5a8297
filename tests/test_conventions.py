"""What users of OpenFOAM expect: options, and that its programs work on cases
of this solver."""

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from cosserat.case import Case, ROOT, TUTORIALS, worst_residual

#: The block of grains of the template, in cells of a 20 x 20 mesh
BLOCK = "(0.2 0.4 -1) (0.6 0.8 1)"


@pytest.fixture(name="template")
def template_fixture(tmp_path):
    """Function that copies and meshes the template, small."""

    def copy(target="case", n=20, **control):
        case = Case.copy(TUTORIALS/"template", tmp_path/target)
        case.substitute("system/blockMeshDict", {"nx": n, "ny": n})
        case.substitute("system/controlDict", {
            "endTime": 0.02, "deltaT": 0.01, "writeInterval": 0.02,
            "adjustTimeStep": "no", **control})
        case.run("blockMesh")
        return case

    return copy


def dictionary(case, name, text):
    """Write a dictionary of a tool into system."""
    (case.path/"system"/name).write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object x; }\n"
        + text)


def test_options_of_the_solver(template):
    """-help names what the solver is for, and the usual ones."""
    case = template()
    text = case.run("cosseratPicFoam", "-help", log=False).stdout
    for word in ("material points", "-case", "-parallel", "-doc",
                 "-dry-run", "-postProcess"):
        assert word in text, word


@pytest.mark.slow
def test_completion_of_options():
    """In an interactive shell, by OpenFOAM's own completion."""
    text = subprocess.run(
        ["bash", "--norc", "-ic", """
source "$WM_PROJECT_DIR/etc/bashrc"
source etc/bashrc
complete -p cosseratPicFoam
_of_complete_ cosseratPicFoam - cosseratPicFoam
echo "${COMPREPLY[@]}" """], cwd=ROOT, stdout=subprocess.PIPE, text=True,
        check=False).stdout
    assert "_of_complete_ cosseratPicFoam" in text
    assert "-postProcess" in text and "-dry-run" in text


def test_doc_names_files_that_are_there(template):
    """-doc, and not a page of openfoam.com that there is none of."""
    text = template().run("cosseratPicFoam", "-doc", log=False).stdout
    files = [Path(word) for word in text.split() if word.startswith("/")]
    assert len(files) == 4 and all(file.exists() for file in files)


@pytest.mark.slow
@pytest.mark.parametrize("option", ["-dry-run", "-dry-run-write"])
def test_dry_run_is_the_first_step(template, option):
    """On the mesh of the case; it writes a time only where asked to."""
    case, run = template(), template("run", endTime=0.01)
    text = case.run("cosseratPicFoam", option, log=False).stdout
    run.run("cosseratPicFoam")
    steps = [[line for line in each.splitlines() if "Solving for" in line]
             for each in (text, run.log())]
    assert len(steps[0]) == 6 and steps[0] == steps[1]
    assert case.times() == (["0.01"] if option.endswith("write") else [])
    assert not (case.path/"postProcessing").exists()


@pytest.mark.slow
def test_postProcess_gives_what_the_run_gave(template):
    """Function objects on times written, and what OpenFOAM's own program says
    instead."""
    case = template(writeInterval=0.01)
    case.measure("stress", "cosseratStress", "writeControl writeTime;")
    case.measure("followed", "pointTracers", "places ((0.4 0.6 0));")
    case.run("cosseratPicFoam")
    tables = [("power", "powerBalance.dat"),
              ("below", "materialOutflow.dat"),
              ("followed", "tracer0.dat")]
    before = [case.table(*each) for each in tables]
    stress = case.field("sigma", "0.01")
    shutil.rmtree(case.path/"postProcessing")
    (case.path/"0.01/sigma").unlink()

    case.run("cosseratPicFoam", "-postProcess")
    assert case.log().rstrip().endswith("End")
    for (name, file), rows in zip(tables, before):
        after = case.table(name, file)
        assert np.array_equal(after[-2:, 0], [0.01, 0.02]), name
        # The imbalance is the solver's, and no step means no flux
        kept = [i for i in range(rows.shape[1])
                if (name, i) not in (("power", 6), ("power", 3))]
        assert np.allclose(after[-2:, kept], rows[-2:, kept], rtol=1e-4,
                           atol=1e-9), name
    assert np.allclose(case.field("sigma", "0.01"), stress,
                       atol=1e-5*np.abs(stress).max())

    said = case.run("postProcess", check=False, log=False).stdout
    assert "cosseratPicFoam -postProcess" in said


@pytest.mark.slow
def test_foamLog(template):
    """Residuals, iterations, Courant numbers and times of each step."""
    case = template()
    case.run("cosseratPicFoam")
    case.run("foamLog", "log.cosseratPicFoam")
    times = [0.01, 0.02]
    for name in ("U_0", "p_rghFinalRes_0", "omegaIters_0", "CourantMax_0",
                 "executionTime_0"):
        lines = (case.path/"logs"/name).read_text().splitlines()
        # What comes before the first step has no time
        rows = np.array([line.split() for line in lines
                         if len(line.split()) == 2], float)
        # The Courant number of a step is told before its time
        assert np.array_equal(rows[:, 0], times[:len(rows)]), name
        assert len(rows) >= (1 if name == "CourantMax_0" else 2), name
        assert np.isfinite(rows[:, 1]).all(), name


@pytest.mark.slow
def test_changeDictionary_and_foamDictionary(template):
    """A floor made smooth by the one is seen by the other, and lets slide."""
    rough, case = template("rough"), template()
    dictionary(case, "changeDictionaryDict", """
U { boundaryField { floor { type slip; } } }
omega { boundaryField { floor { type zeroGradient; } } }
""")
    case.run("changeDictionary")
    kind = case.run("foamDictionary", "0/U", "-entry",
                    "boundaryField.floor.type", "-value", log=False).stdout
    assert kind.split()[-1] == "slip"
    slide = []
    for each in (rough, case):
        each.run("cosseratPicFoam")
        lowest = each.centres()[:, 1] < 0.05
        slide.append(np.abs(each.field("U")[lowest, 0]).max())
    assert slide[1] > 1.5*slide[0]


@pytest.mark.slow
def test_setFields_gives_the_fractions(template):
    """A scene whose fractions are set by setFields flows as the one whose
    points fill the same cells."""
    points = template("points")
    points.run("cosseratPicFoam")
    case = template("fractions")
    (case.path/"constant/materialPointsProperties").unlink()
    for name, value in (("air", 1), ("grains", 0)):
        (case.path/f"0/alpha.{name}").write_text(f"""
FoamFile {{ version 2.0; format ascii; class volScalarField; object x; }}
dimensions [0 0 0 0 0 0 0];
internalField uniform {value};
boundaryField
{{
    "(walls|floor)" {{ type zeroGradient; }}
    #includeEtc "caseDicts/setConstraintTypes"
}}
""")
    dictionary(case, "setFieldsDict", f"""
defaultFieldValues ();
regions
(
    boxToCell
    {{
        box {BLOCK};
        fieldValues
        (
            volScalarFieldValue alpha.air 0
            volScalarFieldValue alpha.grains 1
        );
    }}
);
""")
    case.run("setFields")
    case.run("cosseratPicFoam")
    log = [c.log().split("Time = ")[0] for c in (points, case)]
    first = [[line for line in text.splitlines() if "Solving for" in line]
             for text in log]
    assert first[0] == first[1] and first[0]


@pytest.mark.slow
def test_topoSet_and_refineMesh(template):
    """Cells of a box halved both ways: cells with five edges beside them."""
    case = template()
    dictionary(case, "topoSetDict", f"""
actions ( {{ name block; type cellSet; action new; source boxToCell;
    box {BLOCK}; }} );
""")
    dictionary(case, "refineMeshDict", """
set block; coordinateSystem global;
globalCoeffs { tan1 (1 0 0); tan2 (0 1 0); }
directions (tan1 tan2);
useHexTopology no; geometricCut yes; writeMesh no;
""")
    case.run("topoSet")
    case.run("refineMesh", "-overwrite", "-dict", "system/refineMeshDict")
    assert case.n_cells() == 400 + 3*64
    case.run("cosseratPicFoam")
    assert worst_residual(case.log()) <= 1e-6


@pytest.mark.slow
def test_mapFields(template):
    """A flow mapped to a finer mesh, with its points, is where the run goes
    on."""
    coarse = template("coarse")
    coarse.run("cosseratPicFoam")
    fine = template("fine", n=40, endTime=0.01, writeInterval=0.01)
    fine.run("mapFields", "../coarse", "-consistent", "-sourceTime",
             "latestTime")
    assert np.abs(fine.field("U", "0")).max() == pytest.approx(
        np.abs(coarse.field("U")).max(), rel=0.05)
    volume = coarse.cloud("volume")[coarse.cloud("material") == 1].sum()
    fine.run("cosseratPicFoam")
    assert worst_residual(fine.log()) <= 1e-6
    grains = fine.cloud("volume")[fine.cloud("material") == 1].sum()
    assert grains == pytest.approx(volume, rel=1e-6)
