"""Points that walk over the edges of polygons beside OpenFOAM's tracking
through tetrahedra, which the entry planarWalk turns on and off."""

import numpy as np
import pytest

from cosserat.scenes.box import STILL, add_points

LID = ("type fixedValue; value uniform (1 0 0);", "type zeroGradient;")


def driven(box, target, walk, deltaT=0.02, steps=20, integration="RK2",
           **mesh):
    """The log, and places of the points of a box driven by its lid after some
    steps, in the order of the cloud."""
    case = box(target, n=8, materials={"a": {"eta": 1, "etaC": 0, "R": 0}},
               walls={**{side: STILL for side in
                         ("left", "right", "bottom")}, "top": LID}, **mesh)
    add_points(case, "{ type all; material a; }", integration=integration,
               minPointsPerCell=0, planarWalk=walk)
    case.substitute("system/controlDict", {
        "endTime": repr(steps*deltaT), "deltaT": repr(deltaT),
        "writeInterval": steps})
    log = case.run("cosseratPicFoam").stdout
    return log, case.cloud("positions")[:, :2]


@pytest.mark.slow
@pytest.mark.parametrize("parameters", [
    {}, {"integration": "RK4"}, {"integration": "Euler"},
    {"deltaT": 0.4, "steps": 2},
    {"shear": 0.7}, {"triangles": True}, {"honeycomb": True},
    {"halved": lambda x, y: np.abs(x) + np.abs(y - 0.1) < 0.3}],
    ids=["squares", "RK4", "Euler", "parts", "sheared", "triangles",
         "honeycomb", "halved"])
def test_walk_is_the_track(box, parameters):
    """Both ways bring all points to the same places but for rounding (measured
    on squares: 6e-15). In longer ways the corners of the lid make more of it."""
    places = {}
    for walk in ("yes", "no"):
        log, places[walk] = driven(box, walk, walk, **parameters)
        assert f"planarWalk {'true' if walk == 'yes' else 'false'}" in log
    assert len(places["yes"]) == len(places["no"])
    assert np.abs(places["yes"] - places["no"]).max() < 1e-12
