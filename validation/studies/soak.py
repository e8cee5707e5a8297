"""Twenty thousand steps: what grows, in memory, in the books of the points, in
the time of a step.

A hopper with inflow and outflow, whose grains are replaced some two hundred
times, and a driven cavity of two materials; in both the population is kept in
narrow limits, so that points are added and deleted."""

import re
import shutil
import subprocess
import time
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from cosserat.box import Box, add_points
from cosserat.case import RunError
from studies.common import HERE, fresh_case, save

STEPS = 20000

#: Steps after which memory and time of a step are taken for settled
SETTLED = 1000

LIMITS = {"minPointsPerCell": 8, "maxPointsPerCell": 20}

#: inside, volume, in, volume, added, deleted, out, volume
ACCOUNT = re.compile(
    r"Material points: (\S+) inside \((\S+) m3\); since the start "
    r"(\S+) in \((\S+) m3\), (\S+) added, (\S+) deleted, "
    r"(\S+) out \((\S+) m3\)")


def hopper(path, steps):
    """The tutorial's hopper on 8 x 12 cells, at a Courant number of 1/2."""
    case = fresh_case(path, "hopper")
    case.substitute("system/blockMeshDict", {
        "nx": 8, "nSpout": 2, "nCone": 6, "nBin": 4})
    points = case.path/"constant/materialPointsProperties"
    text = re.sub(r"minPointsPerCell.*;", "", points.read_text())
    points.write_text(text + "".join(
        f"{key} {value};\n" for key, value in LIMITS.items()))
    control(case, steps, 0.1)
    case.run("blockMesh")
    return case


def cavity(path, steps):
    """A driven cavity on 10 x 10 cells, a second material below, with
    velocities that gather points."""
    shutil.rmtree(path, ignore_errors=True)
    still = ("type noSlip;", "type zeroGradient;")
    case = Box(path, n=10, tolerance=1e-6, materials={
        "a": {"eta": 1, "etaC": 0, "R": 0}, "b": {"eta": 3, "etaC": 1, "R": 0.1},
        }, fractions=lambda x, y: 0*x, walls={
            "left": still, "right": still, "bottom": still,
            "top": ("type fixedValue; value uniform (1 0 0);",
                    "type zeroGradient;")}).write()
    add_points(case, "{ type all; material a; }"
               " { type box; material b; min (-1 -1 -1); max (1 0.1 1); }",
               velocity="cellPoint", **LIMITS)
    control(case, steps, 0.05)
    return case


SCENES = {"hopper": hopper, "cavity": cavity}


def control(case, steps, deltaT):
    """Steps of one length; all digits in the log."""
    path = case.path/"system/controlDict"
    path.write_text(re.sub(r"^(write|adjust)\w+\s.*\n", "", path.read_text(),
                           flags=re.M) + f"""
adjustTimeStep no; writeControl timeStep; writeInterval {steps};
writePrecision 17;
""")
    case.substitute("system/controlDict", {
        "deltaT": deltaT, "endTime": repr(steps*deltaT)})


def run(case, every=0.5):
    """Run a case; rows of length of the log [bytes] and memory [kB]."""
    path = case.path/"log.cosseratPicFoam"
    memory = []
    with path.open("w") as log, subprocess.Popen(
            ["cosseratPicFoam"], cwd=case.path, stdout=log,
            stderr=subprocess.STDOUT) as process:
        while process.poll() is None:
            status = Path(f"/proc/{process.pid}/status").read_text()
            resident = re.search(r"VmRSS:\s+(\d+)", status)
            if resident:
                memory.append((path.stat().st_size, int(resident[1])))
            time.sleep(every)
    if process.returncode:
        raise RunError(f"{case.path} ended with {process.returncode}")
    return memory


def accounts(case):
    """The books of every step against those of the seeding: the last ones,
    largest error of the number of points, and of the volume over that of the
    mesh, which is full."""
    inside, volume, n_in, v_in, added, deleted, n_out, v_out = np.array(
        ACCOUNT.findall(case.log()), float).T
    start = int(re.search(r"Material points: (\d+) seeded", case.log())[1])
    full = case.volumes().sum()
    return {
        "steps": len(inside), "points": int(inside[-1]), "in": int(n_in[-1]),
        "added": int(added[-1]), "deleted": int(deleted[-1]),
        "out": int(n_out[-1]),
        "errPoints": int(np.abs(
            start + n_in + added - deleted - n_out - inside).max()),
        "errVolume": float(np.abs(full + v_in - v_out - volume).max()/full),
    }


def soak(scene, path, steps=STEPS):
    """A row for a scene; its memory [kB] against steps, and the time at the
    end of each step [s]."""
    case = SCENES[scene](path, steps)
    memory = np.array(run(case))
    log = case.path.joinpath("log.cosseratPicFoam").read_bytes()
    ends = [match.start() for match in re.finditer(rb"^Step ", log, re.M)]
    memory[:, 0] = np.searchsorted(ends, memory[:, 0])
    seconds = np.array(re.findall(rb"^ExecutionTime = (\S+) s", log, re.M),
                       float)
    settled = int(np.interp(SETTLED, *memory.T))
    first, last = ((part[-1] - part[0])/(len(part) - 1) for part in
                   (seconds[:SETTLED], seconds[-SETTLED:]))
    return {"scene": scene, **accounts(case), "rss": settled,
            "rssEnd": int(memory[-1, 1]),
            "growth": int(memory[-1, 1]) - settled,
            "secondsFirst": first, "secondsLast": last,
            "ratio": last/first}, memory, seconds


def study():
    """Rows: scene, steps, points (at the end), in, added, deleted, out,
    errPoints and errVolume (largest error of the books of all steps, the
    latter over the volume of the mesh), rss and rssEnd (memory [kB] after a
    thousand steps and at the end), growth [kB] between them, secondsFirst and
    secondsLast (processor time of a step, mean of the first and of the last
    thousand), ratio (of these)."""
    rows = []
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4), dpi=130)
    for scene in SCENES:
        row, memory, seconds = soak(scene, HERE/"runs/soak"/scene)
        rows.append(row)
        print(row, flush=True)
        axes[0].plot(memory[:, 0], memory[:, 1]/1024, label=scene)
        blocks = seconds[:len(seconds)//SETTLED*SETTLED:SETTLED]
        axes[1].plot(SETTLED*np.arange(1, len(blocks)),
                     np.diff(blocks)/SETTLED*1e3, ".-", label=scene)
    for axis, label in zip(axes, ("resident memory [MB]",
                                  "time of a step [ms]")):
        axis.set_xlabel("step")
        axis.set_ylabel(label)
        axis.set_xticks(range(0, STEPS + 1, 5000))
        axis.set_ylim(0, 1.15*axis.get_ylim()[1])
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    save(figure, "soak")
    plt.close(figure)
    return rows
