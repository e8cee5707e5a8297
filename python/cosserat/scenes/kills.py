"""Runs killed at random moments, as by kill -9 or a power cut, and started
again until they come to their end: does that end equal the one of the run that
was left alone, and is every time that a kill has left half written told?"""

import os
import random
import re
import shutil
import signal
import subprocess
import time
from contextlib import suppress

from cosserat.case import Case, RunError, fresh_case
from cosserat.scenes.silo import mesh_entries

SEED = 3

#: Time after the start of a write in which to kill [s], some two steps
WINDOW = 0.2


def parts(case, ranks):
    """Directories that times are written to."""
    return [case.path/(f"processor{rank}" if ranks > 1 else ".")
            for rank in range(ranks)]


def files(case, ranks):
    """Content of the files of the latest time, by name."""
    contents = {}
    for rank, path in enumerate(parts(case, ranks)):
        last = path/Case(path).times()[-1]
        for file in last.rglob("*"):
            if file.is_file():
                contents[rank, str(file.relative_to(last))] = file.read_bytes()
    return contents


def delete_last(case, ranks, log):
    """Delete the time that a log says is not whole, of all processors."""
    # OpenFOAM's own words where a rank has not even begun it
    match = (re.search(r"Time (\S+) of .* is not wholly written", log)
             or re.search(r"is not the same for all processors", log))
    if not match:
        return False
    last = max((time for path in parts(case, ranks)
                for time in Case(path).times()), key=float)
    assert match.lastindex is None or match[1] == last, log
    for path in parts(case, ranks):
        shutil.rmtree(path/last, ignore_errors=True)
    return True


def command(ranks):
    """Words that run the solver; each of several ranks says in pid.RANK what
    process it is, for mpirun gives them groups of their own."""
    if ranks == 1:
        return ["cosseratPicFoam"]
    return ["mpirun", "-np", str(ranks), "sh", "-c",
            'echo $$ > "pid.$OMPI_COMM_WORLD_RANK";'
            " exec cosseratPicFoam -parallel"]


def kill(case, process):
    """kill -9 for a program and, of mpirun, its ranks."""
    pids = [int(file.read_text()) for file in case.path.glob("pid.*")]
    for pid in [process.pid, *pids]:
        with suppress(ProcessLookupError):      # ended by itself
            os.kill(pid, signal.SIGKILL)


def run_and_kill(case, ranks, moment):
    """Run a case, and kill it that time [s] after it has written two more
    times (None: never); exit code and log."""
    first = Case(parts(case, ranks)[0])
    wanted = len(first.times()) + 2
    latest = time.monotonic() + (case.timeout or float("inf"))
    log = case.path/"log.cosseratPicFoam"
    with log.open("w") as file, subprocess.Popen(
            command(ranks), cwd=case.path, stdout=file,
            stderr=subprocess.STDOUT) as process:
        try:
            if moment is not None:
                # Some steps on, then at any moment of a step
                while len(first.times()) < wanted and process.poll() is None:
                    time.sleep(0.002)
                    if time.monotonic() > latest:
                        raise RunError(f"{case.path} does not get on")
                time.sleep(moment)
                if process.poll() is None:
                    kill(case, process)
            process.wait(case.timeout)
        except (subprocess.TimeoutExpired, RunError):
            kill(case, process)
            raise
    return process.returncode, log.read_text(errors="replace")


def go_on(case, ranks, kills, chance):
    """Run a case to its end, killing it so often; times that were half
    written and deleted by hand, and the last log."""
    deleted = 0
    while True:
        code, log = run_and_kill(
            case, ranks, chance.uniform(0, WINDOW) if kills else None)
        kills -= kills > 0 and code == -signal.SIGKILL
        if delete_last(case, ranks, log):
            deleted += 1
        elif code == 0:
            return deleted, log
        else:
            assert code == -signal.SIGKILL, log[-2000:]


def silo(path, steps):
    """A coarse silo that writes every step and keeps the last few."""
    case = fresh_case(path, "silo")
    case.substitute("system/blockMeshDict", mesh_entries(4))
    case.substitute("system/controlDict", {
        "endTime": 1e-5*steps, "deltaT": 1e-5, "adjustTimeStep": "no",
        "writeInterval": 1e-5, "writePrecision": 17})
    case.run("blockMesh")
    return case


def compare(folder, ranks, kills, seed=SEED):
    """A run left alone, and the same one killed so often; a row."""
    whole = silo(folder/f"whole{ranks}", 5*kills)
    if ranks > 1:
        whole.decompose(ranks, "scotch")
    killed = folder/f"killed{ranks}"
    shutil.rmtree(killed, ignore_errors=True)
    case = Case(shutil.copytree(whole.path, killed))
    whole.run("cosseratPicFoam", ranks=ranks)
    deleted, _ = go_on(case, ranks, kills, random.Random(seed))
    expected, found = files(whole, ranks), files(case, ranks)
    return {"ranks": ranks, "kills": kills, "halfWritten": deleted,
            "files": len(expected),
            "different": sum(expected[name] != found.get(name)
                             for name in expected)}
