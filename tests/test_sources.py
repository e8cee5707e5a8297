"""What of OpenFOAM's style clang-format does not know."""

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


@pytest.mark.parametrize("file", SOURCES, ids=lambda f: f.name)
def test_source_is_as_openfoam_writes_it(file):
    """Banner, 80 columns but for tables, no tabs; a header has its guard and
    says what it is."""
    text = file.read_text()
    lines = text.splitlines()
    assert "cosseratPicFoam: creeping flow" in lines[1]
    for number, line in enumerate(lines, 1):
        assert "\t" not in line and line == line.rstrip(), number
        assert len(line) <= 80 or "|" in line, (number, len(line))

    if not FRAGMENT.match(file.name):
        assert lines[-1].startswith("// ****")
        if file.suffix == ".H":
            assert f"{file.stem}_H" in re.search(r"#ifndef (\w+)", text)[1]
            assert "\nDescription\n" in text
