"""What of OpenFOAM's style clang-format does not know, what Python imports, and
that each rule finds what breaks it."""

import ast
import re

import pytest

from cosserat.case import ROOT

SOURCES = sorted(
    file for folder in ("src", "applications")
    for ending in ("*.C", "*.H")
    for file in (ROOT/folder).rglob(ending)
    if not {"lnInclude"} & set(file.parts) and not file.is_symlink())

#: What an include file of the solver's main function is named like
FRAGMENT = re.compile(r"create|check|manual|solved")


def banner(name, lines):
    """The project's name in the second line."""
    return "cosseratPicFoam: creeping flow" not in lines[1]


def tabs(name, lines):
    """Neither tabs nor space at the end of a line."""
    return [i for i, line in enumerate(lines, 1)
            if "\t" in line or line != line.rstrip()]


def width(name, lines):
    """80 columns but for tables."""
    return [i for i, line in enumerate(lines, 1)
            if len(line) > 80 and "|" not in line]


def end(name, lines):
    """The line of stars."""
    return not FRAGMENT.match(name) and not lines[-1].startswith("// ****")


def guard(name, lines):
    """A header is guarded by a name with its own in it."""
    if not name.endswith(".H") or FRAGMENT.match(name):
        return False
    found = re.search(r"#ifndef (\w+)", "\n".join(lines))
    return not found or f"{name[:-2]}_H" not in found[1]


def description(name, lines):
    """A header says what it is."""
    return (name.endswith(".H") and not FRAGMENT.match(name)
            and "Description" not in lines)


RULES = [banner, tabs, width, end, guard, description]


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.__name__)
def test_sources_are_as_openfoam_writes_them(rule):
    """No file breaks a rule."""
    assert len(SOURCES) > 150
    found = {str(file.relative_to(ROOT)): rule(
        file.name, file.read_text().splitlines()) for file in SOURCES}
    assert {name: places for name, places in found.items() if places} == {}


GOOD = ["/*---*\\", "    cosseratPicFoam: creeping flow of", "Description",
        "#ifndef a_H", "// ****//"]


@pytest.mark.parametrize("rule, line, text", [
    (banner, 1, "    OpenFOAM"), (tabs, 2, "Description "),
    (tabs, 3, "#ifndef\ta_H"), (width, 0, 81*"x"), (end, 4, "}"),
    (guard, 3, "#ifndef b_H"), (description, 2, "Class")])
def test_rule_can_fail(rule, line, text):
    """A line that breaks it is found, and a table may be wide."""
    assert not rule("a.H", GOOD)
    assert rule("a.H", GOOD[:line] + [text] + GOOD[line + 1:])
    assert not width("a.H", [81*"|"])


#: What the modules of a folder may import of the project
IMPORTS = {
    "python/cosserat": {"cosserat"},
    "tests": {"cosserat"},
    "tutorials": {"cosserat"},
    "validation": {"cosserat", "studies.common"},
}

#: Besides: a study whose figures are in a module of their own
ALLOWED = {("validation/studies/speedAccuracy.py",
            "studies.speedAccuracyFigures")}

#: Modules of the project, by which names that it imports are known as its own
OWN = {"cosserat", "studies", "conftest"} | {
    file.stem for file in (ROOT/"tests").glob("*.py")}


def imported(text):
    """Modules that a text imports, and of the project's packages what is
    imported from them."""
    found = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found |= ({f"studies.{alias.name}" for alias in node.names}
                      if node.module == "studies"
                      else {"." + (node.module or "")} if node.level
                      else {node.module})
    return {name for name in found
            if name[0] != "." and name.split(".")[0] in OWN}


@pytest.mark.parametrize("folder", IMPORTS)
def test_imports_run_one_way(folder):
    """Tests and studies take what they share from the package, which knows
    neither; they do not import each other."""
    files = list((ROOT/folder).rglob("*.py"))
    assert files
    wrong = [(str(file.relative_to(ROOT)), name) for file in files
             for name in imported(file.read_text())
             if name.split(".")[0] not in IMPORTS[folder]
             and name not in IMPORTS[folder]]
    assert set(wrong) <= ALLOWED


def test_imports_are_found():
    """Of all forms."""
    assert imported("import test_silo\nfrom studies import soak\n"
                    "def f():\n    from studies.common import save\n"
                    "import numpy as np\nfrom cosserat.case import Case\n") == {
        "test_silo", "studies.soak", "studies.common", "cosserat.case"}
