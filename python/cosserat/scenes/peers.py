"""The silo of a classical fluid by OpenFOAM's interFoam and by
cosseratPicFoam: cases of both, what they measure, and the price of an error.

interFoam is given what serves it: inertia scaled away, outer iterations with
the largest relaxation factors that converge (interFoamSilo tells why)."""

import re
import shutil
from pathlib import Path

import numpy as np

from cosserat.case import TUTORIALS, fresh_case, residuals
from cosserat.references import SILO
from cosserat.scenes.silo import VOLUME, mesh_entries, rate as rate_of

OWN, PEER = "cosseratPicFoam", "interFoam"

#: Rate of discharge at rest [m2/s]
REFERENCE = SILO["start, 0"].value

#: Relative error of the rate whose price is asked
TARGET = 0.05

#: First step of interFoam at rest [s]: long beside the 2.5e-12 s in which the
#: viscosity stops the fill (density, width 5 m), and nothing moves 2 mm in it
PEER_REST = 1e-7

#: Runs of which the fastest counts
REPEAT = 3


def peer_case(path, cells, tolerance, inertia=1.0):
    """interFoam's silo, meshed and filled; inertia: factor of the densities,
    and one over that of gravity and of the kinematic viscosities."""
    case = fresh_case(path, Path(__file__).parent/"interFoamSilo")
    (case.path/"system/blockMeshDict").write_text(
        (TUTORIALS/"silo/system/blockMeshDict").read_text())
    case.substitute("system/blockMeshDict", mesh_entries(cells))
    case.substitute("system/fvSolution", {"outerTolerance": tolerance})
    case.substitute("constant/g", {"value": f"(0 {-1e17/inertia} 0)"})
    case.substitute("constant/transportProperties", {
        "rhoGranular": 1e-10*inertia, "nuGranular": 1e13/inertia,
        "rhoBackground": 1e-14*inertia, "nuBackground": 1e14/inertia})
    for program in ("blockMesh", "setFields", "topoSet"):
        case.run(program)
    return case


def own_case(path, cells, corners="default"):
    """The tutorial's silo of the classical fluid, meshed."""
    case = fresh_case(path, "silo")
    case.substitute("system/blockMeshDict", mesh_entries(cells))
    case.substitute("constant/materialProperties", {"alpha": 0, "etaC": 0})
    if corners != "default":
        case.override("solution", creepingFlow=f"{{ corners {corners}; }}")
    case.run("blockMesh")
    return case


def stop_at_rest(case, step):
    """Let a case end after one step, with its face fluxes written."""
    case.substitute("system/controlDict", {
        "endTime": step, "deltaT": step, "adjustTimeStep": "no",
        "writeControl": "timeStep", "writeInterval": 1})
    case.measure("fluxes", "writeObjects", "objects (phi);"
                 " writeControl writeTime;", "utilityFunctionObjects")


def cpu_by_time(log):
    """Processor time [s] at the end of each step, by the time of the step."""
    marks = re.findall(r"^(Time|ExecutionTime) = (\S+)", log, re.M)
    return {float(time[1]): float(cpu[1])
            for time, cpu in zip(marks, marks[1:])
            if time[0] == "Time" and cpu[0] == "ExecutionTime"}


def to_half(times, volumes, cpu):
    """Time [s] at which half of the fill is out, processor time [s] and steps
    up to it; None where it is not reached. cpu: of each step, by its time."""
    past = np.flatnonzero(np.asarray(volumes) >= VOLUME/2)
    if not past.size:
        return {"timeToHalf": None, "cpuToHalf": None, "steps": None}
    i = past[0]
    half = float(np.interp(VOLUME/2, volumes[i - 1:i + 1], times[i - 1:i + 1]))
    ends = sorted(cpu)
    steps = min(int(np.searchsorted(ends, half)) + 1, len(ends))
    return {"timeToHalf": half, "cpuToHalf": cpu[ends[steps - 1]],
            "steps": steps}


def solve_at_rest(case, code):
    """Run the one step of a case; rate, error, cpu and outer iterations."""
    seconds = []
    for _ in range(REPEAT):
        for time in case.times():
            shutil.rmtree(case.path/time)
        log = case.run(code).stdout
        seconds.append(max(cpu_by_time(log).values()))
        if seconds[-1] > 3:
            break
    rate = rate_of(case)
    return {"Q": rate, "reference": REFERENCE, "error": rate/REFERENCE - 1,
            "cpu": min(seconds),
            "iterations": (residuals(log)[0][3] if code == OWN
                           else log.count("PIMPLE: iteration"))}


def power(cells, values):
    """Exponent n of values ~ cells^n by the two finest meshes."""
    return float(np.log(values[-1]/values[-2])/np.log(cells[-1]/cells[-2]))


def price(cells, errors, cpu, target=TARGET):
    """Cells a unit and processor time [s] at which an error is reached and
    kept on finer meshes.

    Between two meshes errors and costs are powers of the cells; beyond the
    finest one, with the exponents measured on the two finest (extrapolated).
    Where the coarsest mesh has reached it, or where the error has changed its
    sign, the mesh itself counts. None where errors do not fall.
    """
    n, e, c = (np.asarray(values, float) for values in (cells, errors, cpu))
    size = np.abs(e)
    orders = {"orderError": -power(n, size), "orderCost": power(n, c)}
    missed = np.flatnonzero(size > target)
    first = missed[-1] + 1 if missed.size else 0
    extrapolated = first == len(n)
    if extrapolated and orders["orderError"] <= 0:
        return orders | {"cells": None, "cpu": None, "extrapolated": True}
    if first == 0 or (not extrapolated and e[first]*e[first - 1] < 0):
        return orders | {"cells": float(n[first]), "cpu": float(c[first]),
                         "extrapolated": False}
    pair = slice(-2, None) if extrapolated else slice(first - 1, first + 1)
    at = n[pair][1]*(size[pair][1]/target)**(-1/power(n[pair], size[pair]))
    return orders | {
        "cells": float(at), "extrapolated": bool(extrapolated),
        "cpu": float(c[pair][1]*(at/n[pair][1])**power(n[pair], c[pair]))}
