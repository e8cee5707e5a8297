"""Where a case lies and how large it is: heights, hRef, types that give p."""

import numpy as np
import pytest

from cosserat.scenes.box import Box, add_points

BLOCK = {"heavy": {"eta": 10, "etaC": 10, "R": 0.1, "rho": 10},
         "light": {"eta": 1, "etaC": 0, "R": 0, "rho": 1}}

ONE = {"a": {"eta": 1, "etaC": 0, "R": 0, "rho": 3}}

STILL = ("type noSlip;", "type zeroGradient;")

#: Offsets along and across gravity: powers of two and others; 16 cells across
#: are exact at each of them
OFFSETS = [(0, 1e3), (5e5, 4649776), (0, 1e7), (-1e7, 2.0**23), (1e7, 0)]


def moved(dx, dy, scale=1.0):
    """A warp of the box, and the way back."""
    return (lambda x, y: (scale*x + dx, scale*y + dy),
            lambda x, y: ((x - dx)/scale, (y - dy)/scale))


def reference(case, value):
    """Write constant/hRef."""
    (case.path/"constant/hRef").write_text(
        "FoamFile { version 2.0; format ascii;"
        " class uniformDimensionedScalarField; object hRef; }\n"
        f"dimensions [0 1 0 0 0 0 0]; value {value!r};\n")


def heavy_block(box, target, dx=0.0, dy=0.0, scale=1.0, **parameters):
    """A block in a light fluid, its edges between centres, at a default
    tolerance; solved once."""
    warp, back = moved(dx, dy, scale)

    def fraction(x, y):
        x, y = back(x, y)
        return (abs(x + 0.05) < 0.22) & (abs(y - 0.1) < 0.2)

    materials = {name: {**m, "R": m["R"]*scale} for name, m in BLOCK.items()}
    case = box(target, n=16, warp=warp, fractions=fraction, tolerance=1e-6,
               materials=materials, g=(0, -10, 0),
               walls={"bottom": STILL, "left": STILL}, **parameters)
    case.run("cosseratPicFoam")
    return case


@pytest.mark.slow
@pytest.mark.parametrize("dx, dy", OFFSETS)
def test_flow_does_not_depend_on_the_place(box, dx, dy):
    """Velocity, p, microrotation and powers at the default tolerance, to
    1e-9 of their largest value (measured: 1e-13)."""
    here, there = heavy_block(box, "here"), heavy_block(box, "there", dx, dy)
    for name in ("U", "p", "omega"):
        a, b = here.field(name, 1), there.field(name, 1)
        assert np.abs(a - b).max() < 1e-9*np.abs(a).max(), name
    power = [c.table("power", "powerBalance.dat")[0] for c in (here, there)]
    assert power[1][[1, 4, 5]] == pytest.approx(power[0][[1, 4, 5]], rel=1e-9)
    assert ("of its sizes away from the origin" in there.log()) == (
        max(abs(dx), abs(dy)) > 100)


@pytest.mark.slow
@pytest.mark.parametrize("scale", [1e-6, 1e-3, 1e6])
def test_flow_does_not_depend_on_the_size(box, scale):
    """Speeds grow with the square of the size, powers a depth with its fourth
    power; to 1e-9 at the default tolerance."""
    small, large = heavy_block(box, "one"), heavy_block(box, "two", scale=scale)
    a, b = small.field("U", 1), large.field("U", 1)/scale**2
    assert np.abs(a - b).max() < 1e-9*np.abs(a).max()
    power = [c.table("power", "powerBalance.dat")[0] for c in (small, large)]
    assert power[1][[1, 4, 5]]/scale**4 == pytest.approx(
        power[0][[1, 4, 5]], rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("dx, dy, scale", [
    (0, 1e7, 1), (2.0**22, -2.0**22, 1), (0, 0, 1e-6), (0, 0, 1e6)])
def test_points_and_tracers_move_alike(box, dx, dy, scale):
    """Regions, points, tracers and their tables after some steps."""
    places = []
    for target, (ox, oy, s) in (("here", (0, 0, 1)), ("there", (dx, dy, scale))):
        warp, _ = moved(ox, oy, s)
        case = box(target, n=8, warp=warp, fractions=lambda x, y: 0*x,
                   materials={"a": {"eta": 1, "etaC": 0, "R": 0, "rho": 1},
                              "b": {"eta": 10, "etaC": 0, "R": 0, "rho": 9}},
                   g=(0, -1/s, 0), walls={"bottom": STILL})
        low, high = warp(-0.2, -0.1), warp(0.3, 0.4)
        add_points(case, "{ type all; material a; } { type box; material b;"
                   f" min ({low[0]!r} {low[1]!r} -1e9);"
                   f" max ({high[0]!r} {high[1]!r} 1e9); }}")
        case.substitute("system/controlDict", {
            "endTime": 20, "deltaT": 1, "writeInterval": 20})
        tracer = warp(0.11, -0.22)
        case.measure("tracers", "pointTracers",
                     f"places (({tracer[0]!r} {tracer[1]!r} 0));")
        case.run("cosseratPicFoam")
        xy = case.cloud("positions")[np.argsort(case.cloud("origId")), :2]
        rows = case.table("tracers", "tracer0.dat")[:, 1:3]
        places.append([(np.array(each) - (ox, oy))/s for each in (xy, rows)])
    for a, b in zip(*places):
        assert a.shape == b.shape and np.abs(a - a[0]).max() > 0.1
        # A digit of 1e7 is 2e-9, of a cell 1.5e-8, and each of 20 steps rounds
        assert np.abs(a - b).max() < (1.2e-7 if abs(dy) > 0 else 1e-9)
    assert np.abs(places[0][1][-1] - places[0][1][0]).max() > 0.01


@pytest.mark.slow
@pytest.mark.parametrize("g", [(0, -10, 0), (5, -8, 0)])
@pytest.mark.parametrize("height", [None, 0.25, -3.0])
def test_p_rgh_is_openfoams(box, g, height):
    """p - p_rgh = rho (g.x - ghRef), ghRef of hRef as in OpenFOAM's gh.H;
    p itself has the same differences whatever the reference."""
    pressures = []
    for target, value in (("with", height), ("without", None)):
        case = box(target, n=8, materials=BLOCK, g=g, warp=moved(3.0, 40.0)[0],
                   fractions=lambda x, y: y > 40.1, walls={"left": STILL})
        if value is not None:
            reference(case, value)
        case.run("cosseratPicFoam")
        vector = np.array(g, float)
        size = np.linalg.norm(vector)
        gh = case.centres() @ vector - (value or 0)*(
            vector @ (abs(vector)/size))
        p = case.field("p", 1)
        assert p - case.field("p_rgh", 1) == pytest.approx(
            case.field("rho", 1)*gh if (case.path/"1/rho").exists() else
            np.where(case.centres()[:, 1] > 40.1, 10, 1)*gh, rel=1e-12)
        pressures.append(p)
    assert pressures[0] == pytest.approx(pressures[1], abs=1e-9*size*10)


def channel(box, target, y, ends, g=10.0, hRef=None, **parameters):
    """Vertical channel of width 1/4 and length 1, its middle at height y."""
    case = box(target, n=16, warp=lambda a, b: (a/4, b + y), materials={
        "a": {"eta": 1, "etaC": 0, "R": 0, "rho": 1}}, g=(0, -g, 0),
        walls={"left": STILL, "right": STILL,
               **{side: ("type zeroGradient;", "type zeroGradient;", entry)
                  for side, entry in zip(("bottom", "top"), ends)}},
        **parameters)
    if hRef is not None:
        reference(case, hRef)
    case.run("cosseratPicFoam")
    return case


GIVES_P = "type prghPressure; p uniform 0; value uniform 0;"


def flux(case, side="bottom", time=1):
    """Flux through a side [m3/s]."""
    return case.patch_field("phi", side, time).sum()


@pytest.mark.slow
def test_pressure_of_the_air_at_both_ends(box):
    """p = 0 above and below: no pressure gradient, so the flux is that of the
    weight, rho g H^3/(12 eta) a depth, at any height and any hRef."""
    fluxes = [flux(channel(box, f"{y}{h}", y, (GIVES_P, GIVES_P), hRef=h))
              for y, h in ((0.5, None), (100.5, None), (100.5, 7.0),
                           (2.0**20, None), (-1e6, 3.0))]
    exact = 10*0.25**3/12*0.1
    # But for the ends, which bear no shear
    assert fluxes[0] == pytest.approx(exact, rel=0.03)
    assert fluxes == pytest.approx([fluxes[0]]*5, rel=1e-9)


def test_column_between_given_pressures(box):
    """p of the weight of the column below: at rest, and p is linear."""
    case = channel(box, "case", 2.0**16, (
        "type prghPressure; p uniform 10; value uniform 0;", GIVES_P))
    y = case.centres()[:, 1] - 2.0**16
    assert case.field("p", 1) == pytest.approx(10*(0.5 - y), abs=1e-8)
    assert np.abs(case.field("U", 1)).max() < 1e-9
    assert case.patch_field("p", "bottom", 1) == pytest.approx(10, abs=1e-8)


@pytest.mark.parametrize("kind", ["prghTotalPressure", "totalPressure",
                                  "uniformTotalPressure"])
def test_total_pressures_are_those_of_the_flow(box, kind):
    """p_rgh where fluid comes in is less by rho |U|^2/2 of the same solution;
    where it leaves it is not."""
    # Of p and of p_rgh = p + rho g y at the top, the bottom being at 0
    weight = kind == "prghTotalPressure"
    top = 0 if weight else 10
    total = f"type {kind}; p0 uniform {top}; value uniform 0;"
    if kind == "uniformTotalPressure":
        total = f"type {kind}; p0 {top}; value uniform 0;"
    case = channel(box, "case", 0.5, (total.replace("10", "0"), total),
                   hRef=0.0)
    U = case.field("U", 1)[-16:]
    given = case.patch_field("p_rgh", "top", 1)
    assert (U[:, 1] < 0).all() and np.abs(U).max() > 1e-2
    assert given == pytest.approx(10*weight + top - 0.5*(U**2).sum(axis=1),
                                  rel=1e-7)
    assert np.ptp(given) > 1e-4
    assert case.patch_field("p_rgh", "bottom", 1) == pytest.approx(0, abs=1e-9)


def two_densities(box, target, y, p="type fixedValue; value uniform 0;"):
    """Heavy below light, open below and above, the bottom at height y."""
    opening = ("type zeroGradient;", "type zeroGradient;", p)
    return box(target, n=16, warp=moved(0.0, y + 0.5)[0], g=(0, -10, 0),
               tolerance=1e-6,
               materials={"heavy": {"eta": 10, "etaC": 0, "R": 0, "rho": 10},
                          "light": {"eta": 0.1, "etaC": 0, "R": 0, "rho": 1}},
               fractions=lambda x, z: z < y + 0.7,
               walls={"left": STILL, "right": STILL, "bottom": opening,
                      "top": opening})


@pytest.mark.slow
def test_openings_of_two_densities(box):
    """p_rgh where densities differ: the flow is that of the height it is
    counted from, which moves with the case by hRef; without it the run says
    so, unless the lowest opening is at height 0."""
    fluxes = []
    for y in (0, 1, -1, 1e6):
        case = two_densities(box, f"y{y}", y)
        if y:
            done = case.run("cosseratPicFoam", check=False)
            message = done.stdout[done.stdout.index("FOAM FATAL"):]
            for word in ("p_rgh.boundaryField", "1 to 10 kg/m3", "constant/hRef",
                         "prghPressure"):
                assert done.returncode and word in message, message
            assert "Time = " not in done.stdout
            reference(case, float(y))
        case.run("cosseratPicFoam")
        fluxes.append(flux(case))
    assert fluxes == pytest.approx([fluxes[0]]*4, rel=1e-9)
    case = two_densities(box, "other", 0)
    reference(case, 1.0)
    case.run("cosseratPicFoam")
    assert abs(flux(case)/fluxes[0] - 1) > 0.1


@pytest.mark.slow
def test_openings_that_give_p(box):
    """Of two densities, with prghPressure, at any place without hRef."""
    fluxes = []
    for y in (0, 1, -1e6):
        case = two_densities(box, f"y{y}", y, GIVES_P)
        case.run("cosseratPicFoam")
        fluxes.append(flux(case))
    assert fluxes == pytest.approx([fluxes[0]]*3, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("text, words", [
    ("dimensions [0 0 1 0 0 0 0]; value 1;", ["dimensions", "constant/hRef"]),
    ("dimensions [0 1 0 0 0 0 0]; value 1e300;", ["value", "1e+40"]),
    ("dimensions [0 1 0 0 0 0 0]; value 1", ["constant/hRef"])])
def test_reference_is_checked(box, text, words):
    """The file of the height."""
    case = box(n=4, materials=ONE, g=(0, -1, 0))
    reference(case, 0.0)
    path = case.path/"constant/hRef"
    path.write_text(path.read_text().splitlines()[0] + "\n" + text)
    done = case.run("cosseratPicFoam", check=False)
    message = done.stdout[done.stdout.index("FOAM FATAL"):]
    assert done.returncode
    for word in words:
        assert word in message, message


@pytest.mark.slow
def test_restart_far_away_goes_on(tmp_path):
    """A time written there is a start as good as the run's own: no iteration
    at the start, and the same end."""
    ends = []
    for name, ends_at in (("whole", [2]), ("half", [1, 2])):
        case = Box(tmp_path/name, n=8, warp=moved(0.0, 2.0**14)[0],
                   materials=BLOCK, g=(0, -10, 0), tolerance=1e-7,
                   fractions=lambda x, y: (y > 2.0**14) & (x > 0),
                   walls={"bottom": STILL}).write()
        case.substitute("system/controlDict", {"startFrom": "latestTime"})
        for end in ends_at:
            case.substitute("system/controlDict", {"endTime": end})
            case.run("cosseratPicFoam")
        ends.append(case.field("U", 2))
    assert np.abs(ends[0] - ends[1]).max() < 1e-6*np.abs(ends[0]).max()
    first = case.log().index("No Iterations")
    assert case.log()[first:].split()[2] == "0"


@pytest.mark.slow
@pytest.mark.parametrize("y", [2.0**20, -1e7])
def test_given_pressures_of_one_density_far_away(box, y):
    """p_rgh 1 at one end and 0 at the other: no weight in it, so the flux is
    that of the same channel at the origin."""
    fluxes = []
    for place in (0.0, y):
        case = channel(box, f"{place}", place, (
            "type fixedValue; value uniform 1;",
            "type fixedValue; value uniform 0;"))
        fluxes.append(flux(case))
    assert fluxes[1] == pytest.approx(fluxes[0], rel=1e-9)
