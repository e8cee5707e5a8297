"""The laws and schemes that can be chosen by name: what the solver knows, and
a run with each of them, in the case tutorials/schemes."""

import re

from .case import Case

#: The file that chooses, of entries that the dictionaries of the case read
CHOICES = "system/schemes"

#: A name that nothing has
UNKNOWN = "unheardOf"

#: Entries that take a switch or a number, and what to try of it
VALUES = {
    "compressible": ["no", "yes"],
    "volumeCorrection": ["yes", "no"],
    "freeSurfaceStabilisation": ["0", "0.5", "1"],
}

#: Entries that take a list of names
LISTS = ("forced",)

#: Files that hold the entries of one type, by the entry that chooses it
PARTS = {"region": "constant/regions", "dye": "constant/dye"}

#: What an entry needs beside it to be of effect
TOGETHER = {
    "compressible": {"viscosityLaw": "granularContact"},
}


def chosen(case):
    """What the case has chosen, by entry."""
    return {key: value.strip()
            for key, value in case.entries(CHOICES).items()}


def choose(case, entry, name):
    """Choose a name for an entry."""
    if entry in LISTS:
        name = f"({name})"
    case.substitute(CHOICES, {**TOGETHER.get(entry, {}), entry: name})


def told(log):
    """Names that a message of the solver tells as allowed, instead of the
    unknown one."""
    # Versions print lists with or without their size, and where an error is
    # from with or without 'function'
    message = re.split(r"\n\s*(?:From |file: )",
                       log.rpartition(UNKNOWN)[2])[0]
    lists = re.findall(r"\(([^()]*)\)", message)
    if lists:
        return " ".join(lists).split()
    allowed = re.search(r"Allowed: (.*)", message)
    if not allowed:
        raise ValueError(f"no names in\n{log[-3000:]}")
    return allowed[1].split(", ")


def names(case, entry):
    """Names that the solver allows for an entry, as it tells them when it is
    given one that nothing has."""
    if entry in VALUES:
        return VALUES[entry]

    before = (case.path/CHOICES).read_text()
    if entry in PARTS:
        part = case.path/PARTS[entry]
        now = chosen(case)[entry]
        text = part.with_name(f"{part.name}.{now}").read_text()
        unknown = part.with_name(f"{part.name}.{UNKNOWN}")
        unknown.write_text(re.sub(rf"(type\s+){now};", rf"\1{UNKNOWN};", text))
    try:
        choose(case, entry, UNKNOWN)
        log = case.run("cosseratPicFoam", log=False, check=False).stdout
    finally:
        (case.path/CHOICES).write_text(before)
        if entry in PARTS:
            unknown.unlink()
    return told(log)


def run_with(source, target, entry, name):
    """Run a meshed case with another choice, as a case of its own."""
    case = Case.copy(source.path, target)
    mesh = source.path/"constant/polyMesh"
    (case.path/"constant/polyMesh").symlink_to(mesh, target_is_directory=True)
    choose(case, entry, name)
    case.run("cosseratPicFoam")
    return case
