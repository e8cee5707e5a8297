"""Scenes that do not need a part of the program, against the same with that
part forced on."""

import re

import numpy as np

from cosserat.case import fresh_case, residuals
from cosserat.scenes.block import DEFAULT, block

CELLS = 128

STEPS = 20


def control(case, **entries):
    """Entries of controlDict."""
    case.substitute("system/controlDict", entries)


def sinking(path, n=CELLS, **given):
    """The block of 'extremes', one solve."""
    return block(path, **{**DEFAULT, "n": n, **given}, tolerance=1e-8)


def weightless(path, n=CELLS):
    """The same without density, driven by a lid."""
    case = sinking(path, n=n)
    text = (case.path/"constant/materialProperties").read_text()
    (case.path/"constant/materialProperties").write_text(
        re.sub(r"rho \S+;", "rho 0;", text))
    text = (case.path/"0/U").read_text()
    (case.path/"0/U").write_text(text.replace(
        "top { type slip; }",
        "top { type fixedValue; value uniform (1 0 0); }"))
    return case


def layer(path, n=CELLS):
    """The sheared layer with dye: one material, points, a steady flow."""
    case = fresh_case(path, "shearLayer")
    case.substitute("system/blockMeshDict", {"n": n})
    path = case.path/"system/blockMeshDict"
    path.write_text(path.read_text().replace("($n $n 1)", f"({n} $n 1)"))
    control(case, endTime=STEPS*1e3, deltaT=1e3, adjustTimeStep="no",
            writeInterval=STEPS*1e3)
    case.run("blockMesh")
    return case


def still(path, n=CELLS):
    """Two materials that stay where they are, for many steps."""
    case = sinking(path, n=n)
    control(case, endTime=STEPS, writeInterval=STEPS)
    return case


#: scene: (how it is made, what is switched off, what forces it on)
SCENES = {
    "no etaC anywhere": (
        lambda p, n: sinking(p, n, coupling=0.0, R=0.0),
        "microrotation"),
    "no density anywhere": (weightless, "gravity"),
    "one material, with dye": (layer, "averages"),
    "one material, with dye; steady": (layer, "averages matrices"),
    "two materials at rest; steady": (still, "matrices"),
}


def step_seconds(log):
    """Processor time of a step: of the first solve where there is one step,
    and else without it."""
    times = [float(t) for t in re.findall(r"ExecutionTime = (\S+) s", log)]
    if len(times) < 3:
        return times[-1]
    return (times[-1] - times[0])/(len(times) - 1)


def run(path, scene, n=CELLS, repeat=3):
    """A row: the scene as it is and with the part forced on, alternating."""
    make, off = SCENES[scene]
    seconds, fields, iterations = {}, {}, {}
    for _ in range(repeat):
        for forced in (False, True):
            case = make(path, n)
            if forced:
                case.override("solution",
                              creepingFlow=f"{{ forced ({off}); }}")
            log = case.run("cosseratPicFoam").stdout
            seconds[forced] = min(step_seconds(log),
                                  seconds.get(forced, np.inf))
            fields[forced] = np.hstack([
                case.field("U").ravel()/np.abs(case.field("U")).max(),
                case.field("omega")/max(np.abs(case.field("omega")).max(),
                                        1e-300)])
            iterations[forced] = sum(
                solve[3] for solve in residuals(log) if solve[0] == "U")
    return {"scene": scene, "off": off, "seconds": seconds[False],
            "secondsForced": seconds[True],
            "ratio": (seconds[False]/seconds[True]
                      if seconds[True] else None),
            "iterations": iterations[False],
            "iterationsForced": iterations[True],
            "difference": float(np.abs(fields[True] - fields[False]).max())}
