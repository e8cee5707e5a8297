"""Pages, sections and equations that headers and pages name are there."""

import re
from functools import lru_cache

import pytest

from cosserat.case import ROOT

DOCS = ROOT/"docs"

FILES = sorted(
    file for folder in ("src", "applications", "python", "bin", "docs",
                        "validation", "tests", "tutorials")
    for ending in ("*.C", "*.H", "*.py", "*.md")
    for file in (ROOT/folder).rglob(ending)
    if not {"lnInclude", "runs", "results"} & set(file.parts)
    and not file.is_symlink()) + sorted(ROOT.glob("*.md"))

#: A page by its path or in a link of another page, "theory (7)" of docs, a
#: section or an equation; several in words, "2, 3 and 5" or "2 to 5"
SEVERAL = r"\d+(?:(?:, | and | to )\d+)*"
NAMED = re.compile(
    r"\bdocs/(?P<path>\w+)\.md|\]\((?:docs/|\.\./docs/)?(?P<link>\w+)\.md\)"
    rf"|\b(?P<kind>sections?|equations?) \(?(?P<numbers>{SEVERAL})\b")
THEORY = re.compile(r"\btheory \((\d+)\)|\btheory, section (\d+)")


@lru_cache(maxsize=None)
def contents(page):
    """Numbers of the sections and equations of a page."""
    text = (DOCS/f"{page}.md").read_text()
    return {
        "section": {int(n) for n in re.findall(r"^## (\d+)\.", text, re.M)},
        "equation": {int(n) for n in re.findall(r"\\tag\{(\d+)\}", text)}}


def spelt_out(numbers):
    """[2, 3, 4, 7] of "2 to 4 and 7"."""
    found = []
    for part in re.split(r", | and ", numbers):
        ends = [int(n) for n in part.split(" to ")]
        found += range(ends[0], ends[-1] + 1)
    return found


def missing(text, own=None):
    """What a text names that is not there. A section or an equation is of the
    page named last in the same paragraph of a source, and in a page (own) of
    the link right before it, else of itself."""
    lost = []
    text = re.sub(r"\n[ ]*(?://-?|#:?)?[ ]*(?=\S)", " ", text)
    for paragraph in re.split(r"\n\s*\n?", text):
        page, end = own, 0
        for m in NAMED.finditer(paragraph):
            if m["kind"] is None:
                page = m["path"] or m["link"]
                if not (DOCS/f"{page}.md").exists():
                    # A link may be to a page of another folder
                    if m["path"]:
                        lost.append(f"{page}.md")
                    page = own
                end = m.end()
                continue
            if own and m.start() > end + 2:
                page = own
            if page and contents(page)["section"]:
                kind = m["kind"].rstrip("s")
                lost += [f"{page}.md, {kind} {n}"
                         for n in spelt_out(m["numbers"])
                         if n not in contents(page)[kind]]
            end = m.end()
        if own:
            lost += [f"theory.md {m[0]}" for m in THEORY.finditer(paragraph)
                     if int(m[1] or m[2]) not in contents("theory")[
                         "equation" if m[1] else "section"]]
    return lost


@pytest.mark.parametrize("kind", ["sources", "pages"])
def test_what_is_named_is_there(kind):
    """In headers, sources and scripts; and in pages."""
    lost = {}
    for file in FILES:
        if (file.suffix == ".md") != (kind == "pages"):
            continue
        own = file.stem if file.parent == DOCS else None
        found = [] if file.name == "test_pages.py" else missing(
            file.read_text(), own)
        if found:
            lost[str(file.relative_to(ROOT))] = found
    assert not lost


def test_what_is_not_there_is_seen():
    """A page, a section and an equation that there is none of, over a line's
    end too; what is there is not told."""
    assert missing("as in docs/theories.md") == ["theories.md"]
    assert missing("(docs/theory.md,\n    sections 2 to 99)")[-1] == \
        "theory.md, section 99"
    assert missing("docs/theory.md, equation (99)") == [
        "theory.md, equation 99"]
    assert missing("docs/theory.md, section 3; docs/corners.md, section 77"
                   ) == ["corners.md, section 77"]
    assert missing("theory (99)", "discretisation") == [
        "theory.md theory (99)"]
    assert not missing("docs/theory.md, sections 2 and 3, equation (9)")


@pytest.mark.parametrize("page", ["theory", "discretisation", "corners"])
def test_numbers_of_a_page_go_up(page):
    """Sections and equations are numbered without gaps."""
    text = (DOCS/f"{page}.md").read_text()
    for found in (re.findall(r"^## (\d+)\.", text, re.M),
                  re.findall(r"\\tag\{(\d+)\}", text)):
        assert [int(n) for n in found] == list(range(1, len(found) + 1))


def test_readme_names_all_pages():
    """Every page of docs, in the README or in one that it names."""
    text = (ROOT/"README.md").read_text()
    assert not [page.name for page in DOCS.glob("*.md")
                if page.name not in text]
