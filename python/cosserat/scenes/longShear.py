"""The shear layer over many steps: errors, dye bands, points per cell."""

import numpy as np

from cosserat.analytic import Material, ShearLayer, err, granular_contact
from cosserat.case import fresh_case
from cosserat.scenes.box import account, count

STEPS = 1000

END = 2.6e7

V = 1e-6

N, PER_CELL = 24, 36

ROWS = N*round(PER_CELL**0.5)


def bands(case, time, exact):
    """What the dye looks like, by rows of points of the same y.

    bands: how often the band of the sample crosses x = 1/2, its offset from
    row to row followed through the periodic ends; asymmetry: offset of a row
    against that of its image by a half turn [m]; bandError: largest distance
    of a row's band from where the exact flow has it [m]."""
    xyz = case.cloud("positions", time)
    dye = case.cloud("dye", time) > 0
    row = np.clip(np.floor((xyz[:, 1] + 0.5)*ROWS).astype(int), 0, ROWS - 1)

    # Middle of the dyed points of a row, on the circle of the periodic cell
    angle = np.exp(2j*np.pi*(xyz[:, 0] - 0.5))
    offset = np.angle([angle[dye & (row == i)].mean() for i in range(ROWS)])
    offset = np.unwrap(offset)/(2*np.pi)
    half = ROWS//2
    offset -= np.round((offset[half - 1] + offset[half])/2)

    y = np.array([xyz[row == i, 1].mean() for i in range(ROWS)])
    return {
        "bands": int(1 + np.floor(offset[-1]) + np.floor(-offset[0])),
        "asymmetry": float(np.abs(offset + offset[::-1]).max()),
        "bandError": float(np.abs(offset - exact.u(y)*float(time)).max()),
    }


def run(path, wanted):
    """Run the tutorial on to each of the wanted steps; a row for each."""
    case = fresh_case(path, "shearLayer")
    case.substitute("system/controlDict", {
        "adjustTimeStep": "no", "deltaT": END/STEPS})
    # Not that of the function objects, which are further in
    case.override("control", writeControl="timeStep")
    case.substitute("system/fvSolution", {"tolerance": 1e-10})
    case.substitute("constant/materialPointsProperties",
                    {"pointsPerCell": PER_CELL})
    eta, etaC, _ = granular_contact(0, 4, 1e11, 1e11)
    exact = ShearLayer(Material(eta, etaC, 0.3), 1, V=V, Omega=0)
    count(case)
    case.run("blockMesh")
    y = case.centres()[:, 1]

    rows = []
    for step in wanted:
        # On from the last one: a restart is the uninterrupted run
        case.substitute("system/controlDict", {
            "endTime": END*step/STEPS, "writeInterval": step})
        case.run("cosseratPicFoam")
        time = case.times()[-1]
        xyz = case.cloud("positions", time)
        cells = (np.floor(np.clip(xyz[:, 0], 0, 1 - 1e-12)*N)*N
                 + np.floor(np.clip(xyz[:, 1] + 0.5, 0, 1 - 1e-12)*N))
        points = np.bincount(cells.astype(int), minlength=N*N)
        rows.append({
            "step": step, "time": float(time),
            "shear": 2*V*float(time),
            "errU": err(exact.u(y), case.field("U", time)[:, 0]),
            "errOmega": err(exact.omega(y), case.field("omega", time)),
            **bands(case, time, exact),
            "minPoints": int(points.min()), "maxPoints": int(points.max()),
            "points": len(xyz),
            "added": int(account(case)[4]),
        })
    return rows
