"""The house keeps its measures: files, functions and classes of src stay short
enough to be read at once."""

import re
from pathlib import Path

import pytest

from cosserat.case import ROOT

MOST = {"file": 500, "function": 80, "members": 30}

FILES = sorted(f for f in (ROOT/"src").rglob("*.[CH]")
               if "lnInclude" not in f.parts)


def functions(lines):
    """Length of the body of each function at the left margin."""
    start = None
    for i, line in enumerate(lines):
        if line == "{":
            start = i
        elif line == "}" and start is not None:
            # Back to the name; not a class or a namespace
            first = start
            while first and lines[first - 1].strip():
                first -= 1
            head = " ".join(lines[first:start])
            if not re.match(r"\s*(class|struct|namespace|template\b.*\bclass "
                            r"\w+$)", head) and "(" in head:
                yield lines[first], i - start + 1
            start = None


def members(lines):
    """Data members of each class: names that end with an underscore, declared
    at the depth of its body."""
    depth, inside, count = 0, None, 0
    for line in lines:
        code = line.split("//")[0]
        if depth == 0 and re.match(r"(class|struct) \w+$", code.strip()):
            inside, count = code.split()[1], 0
        if inside and depth == 1 and re.search(r"\b\w+_(\[\w+\])?(, \w+_)*;",
                                               code) and "return" not in code:
            count += code.count("_,") + 1
        depth += code.count("{") - code.count("}")
        if inside and depth == 0 and code.startswith("};"):
            yield inside, count
            inside = None


def measured():
    """What is too large, and the largest of each kind."""
    found = []
    for path in FILES:
        lines = path.read_text().splitlines()
        name = str(path.relative_to(ROOT))
        found.append(("file", len(lines), name))
        if path.suffix == ".C":
            found += [("function", n, f"{name}: {head}")
                      for head, n in functions(lines)]
        else:
            # namespace Foam { is at the margin
            body = [line for line in lines if not line.startswith("namespace")]
            found += [("members", n, f"{name}: {head}")
                      for head, n in members_of(body)]
    return found


def members_of(lines):
    """Members with the braces of namespaces, at the margin and alone, gone."""
    kept, previous = [], ""
    for line in lines:
        alone = line in ("{", "}")
        opens_class = re.match(r"(class|struct) ", previous) or \
            previous.startswith((":", "    public", "    private"))
        if not alone or (line == "{" and opens_class):
            kept.append(line)
        if line.strip():
            previous = line
    return members(kept)


@pytest.mark.parametrize("kind", ["file", "function", "members"])
def test_measures(kind):
    """No file, function or class is larger than may be read at once."""
    large = [(n, name) for k, n, name in measured()
             if k == kind and n > MOST[kind]]
    assert not large, large


def test_measures_see():
    """A body of 81 lines and a class of 31 members are found."""
    lines = ["void f()", "{", *["    x;"]*79, "}"]
    assert [n for _, n in functions(lines)] == [81]
    lines = ["namespace Foam", "{", "class a", "{",
             *[f"    int x{i}_;" for i in range(31)], "};", "}"]
    assert list(members_of(lines)) == [("a", 31)]
