"""What all tests share: the environment, and cases in temporary folders."""

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT/"python"))
sys.path.insert(0, str(ROOT/"validation"))

# pylint: disable=wrong-import-position
from cosserat import case as cases
from cosserat.box import Box

cases.environment()


@pytest.fixture(name="tutorial")
def tutorial_fixture(tmp_path):
    """Function that copies a tutorial and meshes it."""

    def copy(name, target="case", **dictionaries):
        """Entries to set by file: control, mesh, solution, materials,
        points, walls; each a dict of regular expression: replacement."""
        case = cases.Case.copy(cases.TUTORIALS/name, tmp_path/target)
        for file, entries in dictionaries.items():
            case.substitute(cases.FILES[file], entries)
        case.run("blockMesh")
        return case

    return copy


@pytest.fixture(name="box")
def box_fixture(tmp_path):
    """Function that makes a box case of the given parameters."""

    def make(target="case", **parameters):
        return Box(tmp_path/target, **parameters).write()

    return make
