"""Twenty thousand steps: what grows, in memory, in the books of the points, in
the time of a step.

A hopper with inflow and outflow, whose grains are replaced some two hundred
times, and a driven cavity of two materials; in both the population is kept in
narrow limits, so that points are added and deleted."""

import re
import subprocess
import time
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from cosserat.case import RunError
from cosserat.scenes.soak import SCENES, accounts
from studies.common import HERE, save

STEPS = 20000

#: Steps after which memory and time of a step are taken for settled
SETTLED = 1000


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
