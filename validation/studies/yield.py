"""Layers, channels, a strip and a block of media that yield, against exact values;
steps and iterations of the methods that solve for them."""

import numpy as np

from cosserat import yielding
from cosserat.case import Case, RunError, TUTORIALS
from cosserat.scenes import notch, plug, shearBand
from cosserat.scenes.punch import solve as strip_on_half_space
from cosserat.scenes.yielding import solve, strip, wall_stress
from studies.common import HERE

CLASSICAL = {"etaCRatio": 0, "R": 0, "B": "infinite"}
#: Rates of regularisation that are gone through
ON_THE_WAY = "(1000 100 10 1)"


def run(name, law, coeffs, n, **parameters):
    """A strip in runs/yield, its cells and costs."""
    case = strip(HERE/"runs/yield"/name, law, coeffs, n, **parameters)
    return case, *solve(case)


def row(test, parameters, cells, value, reference, did, order=None):
    """A row of the study."""
    return {"test": test, "parameters": parameters, "cells": cells,
            "value": value, "reference": reference,
            "error": None if value is None else value/reference - 1,
            "order": order,
            "nonlinear": did["nonlinear"], "linear": did["linear"],
            "cpu": did["cpu"]}


def channels():
    """Flow rates of channels of unit yield or power law."""
    scenes = [(f"Papanastasiou, eps {eps}", "bingham",
               {"etaP": 1, "tauY": 0.5, "eps": eps,
                "regularisation": "Papanastasiou"},
               yielding.papanastasiou_rate(0.5, eps))
              for eps in (0.1, 0.01, 0.001)]
    scenes += [(f"Bingham, eps 1e-4, tauY {tauY}", "bingham",
                {"etaP": 1, "tauY": tauY, "eps": 1e-4,
                 "regularisation": "Papanastasiou"},
                yielding.bingham_rate(tauY)) for tauY in (0.25, 0.5, 0.75)]
    scenes += [(f"power law, n {n}", "powerLaw",
                {"K": 1, "n": n, "eps": 1e-6}, yielding.power_rate(n))
               for n in (0.25, 0.5, 2)]
    for name, law, coeffs, rate in scenes:
        exact = yielding.Channel(rate, G=2, h=0.5).flow()
        last = None
        for n in (16, 32, 64, 128):
            _, cells, did = run("channel", law, {**coeffs, **CLASSICAL}, n, G=2,
                                continuation=ON_THE_WAY)
            now = row("channel", name, n,
                      float((cells["U"][:, 0]*cells["h"]).sum()), exact, did)
            if last:
                now["order"] = float(np.log2(abs(last["error"]/now["error"])))
            last = now
            yield now


def layers():
    """Limit stresses of layers."""
    for q in (0.25, 1, 4):
        for depth in (1, 10, 50):
            for n in (48, 96, 192):
                case, _, did = run("layer", "bingham", {
                    "etaP": 1e-5, "tauY": 1, "eps": 1e-4,
                    "regularisation": "BercovierEngelman", "etaCRatio": q,
                    "R": 1/depth, "B": "infinite"}, n, V=1, grading=10,
                    continuation=ON_THE_WAY)
                yield row("layer", f"etaC/eta {q}, H/R {depth}", n,
                          wall_stress(case), yielding.layer_stress(depth, q),
                          did)


def creep(depth, times, rest, n=96):
    """Speed of a channel at a multiple of the load at which it flows."""
    load = times*yielding.channel_load(depth, 4000)
    _, cells, did = run("arrest", "bingham", {
        "etaP": 1, "tauY": 1, "regularisation": "BercovierEngelman",
        "eps": 1/rest, "etaCRatio": 1, "R": 1/depth, "B": "infinite"},
        n, G=2*load, grading=10)
    return float(cells["U"][:, 0].max()), did


def arrest():
    """Speed beside that of finite elements with the same regularisation, times
    the viscosity at rest below the load at which it flows; and the load at
    which the speed goes with its square root."""
    rests = (1e3, 1e4, 1e5, 1e6)
    for depth in (10, 20, 50):
        load = yielding.channel_load(depth, 4000)
        for times in (0.8, 0.9, 1.05, 1.1):
            exact = yielding.RegularisedChannel(2*times*load, 1/depth)
            for rest, speed in zip(rests, exact.speeds(rests)):
                unit = rest if times < 1 else 1
                for n in (96, 192):
                    value, did = creep(depth, times, rest, n)
                    yield row("arrest", f"H/R {depth}, {times} of the load,"
                              f" rest {rest:g}", n, value*unit, speed*unit, did)
        low, high = 0.97, 1.03
        while high - low > 1e-3:
            times = 0.5*(low + high)
            one, _ = creep(depth, times, 1e5)
            two, did = creep(depth, times, 1e6)
            flows = np.log10(one/two) < 0.5
            low, high = (low, times) if flows else (times, high)
        yield row("load", f"H/R {depth}", 96, times*load, load, did)


def ways():
    """Steps of a layer that yields everywhere with larger rates of
    regularisation on the way, by Cosserat viscosity, depth, rate and mesh."""
    for q in (0.25, 1, 4):
        for depth in (1, 10, 50):
            for eps in (1e-2, 1e-3, 1e-4):
                for n in (32, 64, 128, 256):
                    case, _, did = run("way", "bingham", {
                        "etaP": eps/10, "tauY": 1, "eps": eps, "R": 1/depth,
                        "regularisation": "BercovierEngelman", "etaCRatio": q,
                        "B": "infinite"}, n, V=1, grading=10,
                        method="stressVelocity", continuation=ON_THE_WAY)
                    yield row("way", f"etaC/eta {q}, H/R {depth}, eps {eps:g}",
                              n, wall_stress(case),
                              yielding.layer_stress(depth, q), did)


def methods():
    """Steps of a layer that yields everywhere, by method, search, rate of
    regularisation and mesh; none where they do not converge."""
    for method, search in (("Newton", "work"), ("Newton", "residual"),
                           ("Newton", "none"), ("stressVelocity", "work"),
                           ("stressVelocity", "none"), ("Picard", "work")):
        for eps in (1e-2, 1e-3, 1e-4):
            for n in (32, 64, 128, 256):
                value, did = None, dict.fromkeys(("nonlinear", "linear",
                                                    "cpu"))
                try:
                    case, _, did = run("method", "bingham", {
                        "etaP": eps/10, "tauY": 1, "eps": eps, "R": 0.1,
                        "regularisation": "BercovierEngelman", "etaCRatio": 1,
                        "B": "infinite"}, n, V=1, grading=10, method=method,
                        lineSearch=search)
                    value = wall_stress(case)
                except RunError:
                    pass
                yield row("method", f"{method}, {search}, eps {eps:g}", n,
                          value, yielding.layer_stress(10), did)


def notches():
    """Steps to 1e-10 in the cases of Spiegelman et al. (2016), by method; none
    where they do not converge in 200."""
    for number in notch.CASES:
        for method in ("Newton", "stressVelocity", "Picard"):
            for n in (24, 48):
                did = dict.fromkeys(("nonlinear", "linear", "cpu"))
                try:
                    did = notch.solve(notch.prepare(
                        HERE/"runs/yield/notch", number, n, method=method,
                        maxIter=200))
                except RunError:
                    pass
                yield row("notch", f"case {number}, {method}", n, None, None,
                          did)


def plugs():
    """Pressures of a plug between frictional walls, one cell across and
    resolved."""
    for n, down in ((1, 50), (1, 100), (8, 40), (16, 80)):
        case = plug.Plug(HERE/"runs/yield/janssen", n=n, down=down).write()
        did = plug.solve(case)
        centres, p = case.centres()[:, 1], case.field("p")
        y, level = np.unique(np.round(centres, 9), return_inverse=True)
        mean = np.bincount(level, p)/np.bincount(level)
        for z in (1, 2, 5):
            value = np.interp(-z, y, mean)
            if z == 5:
                value = 1.5*mean[0] - 0.5*mean[1]
            yield row("janssen", f"z/W {z}, {n} across", n*down, float(value),
                      float(yielding.janssen(z, 0.3)), did)


#: The medium of the tutorial punch
CLAY = {"etaP": 1e-4, "tauY": 1, "regularisation": "BercovierEngelman",
        "eps": 1e-2, **CLASSICAL}


def punch(name, n, law="bingham", coeffs=None, **nonlinear):
    """Row of a strip on a half space."""
    q, did = strip_on_half_space(
        Case(TUTORIALS/"punch"), HERE/"runs/yield/punch", n, law,
        coeffs or CLAY, **nonlinear)
    return row("punch", name, n, q, yielding.PUNCH, did)


def punches():
    """Limit pressures of a strip: on meshes, by regularisation, and of Cosserat
    media, which the strip does not let turn (the reference is the classical
    one)."""
    last = None
    for n in (8, 16, 32):
        now = punch("eps 0.01", n)
        if last:
            now["order"] = float(np.log2(abs(last["error"]/now["error"])))
        last = now
        yield now
    for eps in (0.1, 0.03, 0.003):
        yield punch(f"eps {eps}", 16, coeffs={**CLAY, "eps": eps})
    for etaV in (1e2, 1e3, 1e4):
        yield punch(f"vonMises, etaV {etaV:g}", 16, "vonMises", {
            "tauY": 1, "etaV": etaV, "etaVP": 0, "branch": "harmonic",
            **CLASSICAL}, method="stressVelocity")
    for R in (0.02, 0.05, 0.1, 0.2, 0.5, 1):
        for n in (8, 16, 32):
            yield punch(f"etaC = eta, R/B {R}", n,
                        coeffs={**CLAY, "etaCRatio": 1, "R": R})


def bands():
    """Width of the band of a block that softens over that on the mesh before,
    with an internal length and without."""
    for name, law in (("R 0.05", {}), ("classical", shearBand.CLASSICAL)):
        last = None
        for n in (12, 24, 48):
            case, did = shearBand.solve(Case(TUTORIALS/"shearBand"),
                                        HERE/"runs/yield/band", n, **law)
            angle, width = shearBand.band(case)
            yield row("band", f"{name}, {angle:.1f} degrees", n, width,
                      last or width, did)
            last = width


def study():
    """Rows: test, parameters, cells, value, reference, error (relative), order,
    nonlinear (steps), linear (iterations), cpu (s)."""
    return [*channels(), *layers(), *arrest(), *ways(),
            *methods(), *notches(), *plugs(), *punches(), *bands()]
