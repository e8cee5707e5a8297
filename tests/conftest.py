"""What all tests share: the environment, and cases in temporary folders."""

import os
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT/"python"))

# pylint: disable=wrong-import-position
from cosserat import case as cases
from cosserat.scenes.box import Box

cases.environment()

# Of one minute and more each
LONGEST = ("test_tutorials", "test_silo", "test_operator", "test_examples")


def pytest_collection_modifyitems(config, items):
    """Side by side the longest files come first, so that no worker waits for
    the last one."""
    if hasattr(config, "workerinput"):
        items.sort(key=lambda item: item.path.stem not in LONGEST)


@pytest.fixture(name="findings", scope="session")
def findings_fixture(tmp_path_factory):
    """Function that returns what sanitizers have found since its last call:
    that of memory in files of its own, that of undefined behaviour and of
    OpenFOAM's check of indices in logs."""
    if not os.environ.get("COSSERATPIC_SANITIZE"):
        return lambda: ""
    folder = tmp_path_factory.mktemp("findings")
    os.environ["ASAN_OPTIONS"] += f":log_path={folder}/memory"
    seen = set()

    def new():
        texts = []
        logs = tmp_path_factory.getbasetemp().glob("*/**/log.*")
        for file in [*folder.iterdir(), *logs]:
            text = file.read_text(errors="replace")
            if file not in seen and (file.parent == folder
                                     or ": runtime error: " in text
                                     or "::checkIndex(" in text):
                seen.add(file)
                texts.append(text[-20000:])
        return "\n".join(texts)

    return new


@pytest.fixture(autouse=True)
def no_findings(findings):
    """A finding fails the test, also one whose program is to fail."""
    yield
    text = findings()
    if text:
        pytest.fail(text, pytrace=False)


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
