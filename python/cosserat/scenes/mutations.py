"""Dictionaries with one mistake each, and what a run does with them.

Small cases of one to three steps; an entry is deleted, misspelt, given twice,
exchanged with another one, or its value is no number, no finite one, none that
makes sense; brackets are lost, files cut short. The seed is fixed. A run must
end by itself, without a signal, and either refuse the entry by name, or tell
that nothing reads it, or have finite results."""

import os
import random
import re
import resource
import shutil
import signal
import subprocess
from dataclasses import dataclass
from time import sleep, time

from cosserat.case import fresh_case
from cosserat.scenes.silo import mesh_entries

#: Of the chance that chooses them
SEED = 20260

#: Scene: cells, and entries of controlDict
SCENES = {
    "silo": (mesh_entries(4) | {
        "nWall": 1, "nAperture": 2, "nCorridor": 2, "nAbove": 2, "nFloor": 4,
        "nBelow": 6, "nFill": 10},
        {"endTime": 2e-5, "deltaT": 1e-5, "writeInterval": 1e-5}),
    "shearLayer": ({"n": 8},
                   {"endTime": 4e4, "deltaT": 2e4, "writeInterval": 4e4}),
    "hopper": ({"nx": 8, "nSpout": 2, "nCone": 6, "nBin": 4},
               {"endTime": 0.04, "deltaT": 0.02, "writeInterval": 0.04}),
    "gravityChannel": ({"n": 8}, {}),
}

#: Files, by how often they are chosen
FILES = {
    "constant/materialProperties": 5, "constant/materialPointsProperties": 5,
    "constant/g": 1, "system/controlDict": 3, "system/fvSolution": 1,
    "system/walls": 1, "0/U": 2, "0/omega": 1, "0/p_rgh": 1,
}

#: Files whose entries are all known, so that none is passed over in silence
KNOWN = ("constant/materialProperties", "constant/materialPointsProperties",
         "system/fvSolution", "system/controlDict")

#: What a number is replaced by, and what it is multiplied by
NUMBERS = ("0", "-1", "1e300", "-1e300", "1e-300", "1e400", "nan", "inf")

FACTORS = (-1, 1e-8, 1e-3, 0.5, 7, 1e3, 1e8)

#: Mistakes of a value that is no number, or of a whole entry or file
OTHERS = ("value word", "value", "value (1 2 3)", "delete", "misspell",
          "exchange", "duplicate", "dimensions", "cut", "bracket less",
          "bracket more", "semicolon less")

KINDS = ([f"value {number}" for number in NUMBERS]
         + [f"times {factor}" for factor in FACTORS] + list(OTHERS))

#: A number that stands for itself
NUMBER = re.compile(r"(?<![\w.$])-?\d[\d.]*(e-?\d+)?(?![\w.])")

#: Steps after which a run that goes on is stopped, and seconds for these
STEPS, LIMIT = 8, 20


@dataclass
class Entry:
    """An entry of a dictionary: its keyword with those it is in, and where
    keyword, value and the whole are in the text; value None: a dictionary."""
    name: str
    key: tuple
    value: tuple
    whole: tuple


def entries(text):
    """All entries of a text, those of dictionaries in lists as well."""
    def blank(match):
        return re.sub(r"\S", " ", match[0])

    plain = re.sub(r"//[^\n]*|/\*.*?\*/", blank, text, flags=re.S)
    tokens = list(re.finditer(r'#[^\n]*|[{}();]|"[^"]*"|[^\s{}();"]+', plain))
    found = []

    def read(i, path):
        while i < len(tokens) and tokens[i][0] != "}":
            key = tokens[i]
            i += 1
            if key[0][0] == "#" or key[0] == ";":
                continue
            name = f"{path}{key[0]}"
            if i < len(tokens) and tokens[i][0] == "{":
                i = read(i + 1, f"{name}/")
                found.append(Entry(name, key.span(), None,
                                   (key.start(), tokens[i].end())))
                i += 1
                continue
            start, item = i, 0
            while tokens[i][0] != ";":
                if tokens[i][0] == "{":
                    i = read(i + 1, f"{name}/{item}/")
                    item += 1
                i += 1
            if i > start:
                found.append(Entry(
                    name, key.span(),
                    (tokens[start].start(), tokens[i - 1].end()),
                    (key.start(), tokens[i].end())))
            i += 1
        return i

    read(0, "")
    return [entry for entry in found if not entry.name.startswith("FoamFile")]


def mutate(text, kind, chance):
    """The text with one mistake, and the entry that has it; None where the
    text has no place for it."""
    def replaced(span, new):
        return text[:span[0]] + new + text[span[1]:]

    if kind == "cut":
        body = text.index("*/") + 2 if "*/" in text else 0
        left = text[:chance.randrange(body, len(text) - 100)]
        # Between entries it is no mistake
        last = re.sub(r"//[^\n]*", "", left).rstrip()[-1:]
        return (left, "") if last not in ("}", ";", "/", "") else None
    if kind in ("bracket less", "semicolon less"):
        end = text.index("// * *")
        places = [i for i, c in enumerate(text) if i > end
                  and c in ("(){}" if kind[0] == "b" else ";")]
        place = chance.choice(places)
        return replaced((place, place + 1), " "), ""

    all_entries = entries(text)
    valued = [entry for entry in all_entries if entry.value]
    numbers = [entry for entry in valued
               if NUMBER.search(text[slice(*entry.value)])]
    number = kind.startswith("times") or kind[len("value "):] in NUMBERS
    if number and not numbers:
        return None
    entry = chance.choice(
        numbers if number
        else all_entries if kind in ("delete", "misspell", "duplicate")
        else valued)
    start, end = entry.key
    word = text[start:end]

    if kind == "delete":
        new = replaced(entry.whole, "")
    elif kind == "misspell":
        i = chance.randrange(1, len(word)) if len(word) > 1 else 1
        new = replaced(entry.key, word[:i] + "x" + word[i:])
    elif kind == "exchange":
        other = chance.choice(valued)
        if text[slice(*other.value)] == text[slice(*entry.value)]:
            return None
        new = replaced(entry.value, text[slice(*other.value)])
    elif kind == "duplicate":
        new = replaced(entry.whole, "\n".join([text[slice(*entry.whole)]]*2))
    elif kind == "dimensions":
        new = replaced(entry.value, "[0 3 -2 0 0 0 0] "
                       + text[slice(*entry.value)].split("]")[-1])
    elif kind == "bracket more":
        new = replaced((entry.whole[1], entry.whole[1]), chance.choice("(){}"))
    elif number:
        chosen = chance.choice(list(NUMBER.finditer(text, *entry.value)))
        action, value = kind.split()
        new = replaced(chosen.span(), value if action == "value" else
                       f"{float(chosen[0])*float(value):.10g}")
    else:
        new = replaced(entry.value, kind[len("value "):])
    return (new, entry.name) if new != text else None


def cases(folder):
    """The scenes as they are, meshed."""
    found = {}
    for name, (cells, control) in SCENES.items():
        case = found[name] = fresh_case(folder/name, name)
        case.substitute("system/blockMeshDict", cells)
        case.substitute("system/controlDict", control)
        if (case.path/"constant/materialPointsProperties").exists():
            case.substitute("constant/materialPointsProperties",
                            {"pointsPerCell": 9})
        case.run("blockMesh")
    return found


def run(case):
    """Run the solver; exit code (None: it went on and was stopped, "hang": it
    did not even get on) and log."""
    def limits():
        # Against a wish for all the memory there is
        resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
        resource.setrlimit(resource.RLIMIT_FSIZE, (64 << 20, 64 << 20))

    path = case.path/"log.cosseratPicFoam"
    start = time()
    with open(path, "w", encoding="utf-8") as log, subprocess.Popen(
            ["cosseratPicFoam"], cwd=case.path, stdout=log,
            env={**os.environ, "PWD": str(case.path)},
            stderr=subprocess.STDOUT, preexec_fn=limits) as process:
        looked = start
        while process.poll() is None:
            sleep(0.005)
            if time() - looked > 0.25:
                looked = time()
                if f"\nStep {STEPS}:" in path.read_text(errors="replace"):
                    process.kill()
                    process.wait()
                    return None, path.read_text(errors="replace")
            if time() - start > LIMIT:
                process.kill()
                process.wait()
                return "hang", path.read_text(errors="replace")
    return process.returncode, path.read_text(errors="replace")


def tidy(case):
    """Take away what a run has written."""
    for path in case.path.iterdir():
        if (re.fullmatch(r"[-\d.e+]+|postProcessing|dynamicCode", path.name)
                and path.name != "0"):
            shutil.rmtree(path)
    for name in ("uniform", "lagrangian", "p", "phi"):
        path = case.path/"0"/name
        if path.is_dir():
            shutil.rmtree(path)
        elif path.exists():
            path.unlink()


def infinite(case):
    """A file of the results that has a number that is none, or ''."""
    for folder in case.path.iterdir():
        if not re.fullmatch(r"[-\d.e+]+", folder.name) or folder.name == "0":
            continue
        for path in folder.rglob("*"):
            if path.is_file() and re.search(
                    r"(?<![\w/.])-?(nan|inf)\b(?!in)", path.read_text(
                        errors="replace").split("boundaryField")[0]):
                return str(path.relative_to(case.path))
    return ""


def told(log):
    """Lines that tell what nothing reads, and warnings."""
    return [line for line in log.splitlines()
            if re.search(
                "nothing reads|No dictionary|given twice|[wW]arning", line)]


def message(log):
    """What the run has been refused with, on one line."""
    match = re.search(r"--> FOAM FATAL.*?\n(.*?)(\n\s*From |\Z)", log, re.S)
    return " ".join(match[1].split()) if match else ""


def unnamed(row, case, log):
    """What the end of the log does not name: file, entry, or '' if all."""
    # A legal value may lead to what is refused elsewhere, which is named there
    if row["mutation"].startswith("times") and re.search(
            r"Allowed: |Cures", log):
        return ""

    # OpenFOAM's own messages may leave it to the line before which file it is
    end = log[max(log.find("FOAM FATAL"), 0):]
    reading = re.findall(r"^Reading (\S+)", log, re.M)[-1:]
    file = row["file"].split("/")[-1]

    # Walls are included in the fields
    names = [file] + (["0/U", "0/omega"] if file == "walls" else [])
    if row["entry"].startswith("functions/"):
        # By its name
        names.append(row["entry"].split("/")[1])
    if (not any(name in end for name in names) and reading != [row["file"]]
            and not (reading and file == "walls")):
        return "names not the file"

    # What OpenFOAM reads it names by line; of a variable, the entry with it
    words = re.findall(r"[\w.]+", row["entry"])
    own = row["file"] in KNOWN and file != "controlDict"
    whole = row["mutation"] in ("delete", "misspell", "duplicate")
    if (own and words and not row["mutation"].startswith("bracket")
            and f"${words[-1]}" not in (case.path/row["file"]).read_text()
            and not any(word in end for word in words[0 if whole else -2:])):
        return "names not the entry"
    return ""


def judge(row, case, code, log, usual):
    """Add to a row its outcome and its fault, '' if none; usual: what is told
    without a mistake."""
    fault = ""
    reason = message(log)
    if code == "hang":
        outcome = "hangs"
        fault = "neither ends nor gets on"
    elif code == -signal.SIGABRT and reason:
        # OpenFOAM's abort() where others exit()
        outcome = "refused"
    elif code is not None and code not in (0, 1):
        outcome = "crashes"
        fault = f"exit code {code}"
    elif code == 1:
        outcome = "refused"
        fault = unnamed(row, case, log)
    else:
        warned = set(told(log)) - usual
        outcome = "warned" if warned else "ran"
        found = infinite(case)
        if found:
            fault = f"not a finite number in {found}"
        elif (row["file"] in KNOWN and not warned
              # Names that the user gives
              and not re.search(r"materials/\w+$|functions/", row["entry"])
              and row["mutation"] in ("misspell", "duplicate", "bracket more",
                                      "bracket less", "cut")):
            fault = "passed over in silence"
    row.update(outcome=outcome, code=code, fault=fault, message=reason[:300])


def mutations(scenes, count, seed):
    """Number, scene, file, entry, mutation and text of so many mutations."""
    chance = random.Random(seed)
    number = 0
    while number < count:
        scene = chance.choice(list(scenes))
        files = [file for file in FILES if (scenes[scene].path/file).exists()]
        file = chance.choices(files, [FILES[file] for file in files])[0]
        kind = chance.choice(KINDS)
        text = (scenes[scene].path/file).read_text()
        changed = mutate(text, kind, chance)
        if changed:
            number += 1
            yield {"number": number, "scene": scene, "file": file,
                   "entry": changed[1], "mutation": kind}, changed[0]


def sweep(folder, count, seed=SEED):
    """Run so many mutations in a folder; their rows."""
    scenes = cases(folder)
    usual = {}
    for name, case in scenes.items():
        code, log = run(case)
        assert code == 0, log
        usual[name] = set(told(log))
        tidy(case)
    rows = []
    for row, text in mutations(scenes, count, seed):
        case = scenes[row["scene"]]
        path = case.path/row["file"]
        original = path.read_text()
        path.write_text(text)
        start = time()
        try:
            code, log = run(case)
        finally:
            path.write_text(original)
        row["seconds"] = round(time() - start, 2)
        judge(row, case, code, log, usual[row["scene"]])
        tidy(case)
        rows.append(row)
    return rows
