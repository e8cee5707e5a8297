"""The study 'peers': the price of an error by the runs on a few meshes, times
read from logs, and interFoam's silo on coarse cells."""

import shutil

import pytest

from cosserat.scenes import peers, silo


def test_price_by_powers_of_the_cells():
    """Error 1.6/n and cost n^3/1000: 5 % is at 32 cells, for 32.8 s."""
    def price(cells):
        return peers.price(cells, [1.6/n for n in cells],
                           [n**3/1000 for n in cells])

    for cells, extrapolated in (([4, 8, 16], True), ([8, 24, 48], False)):
        found = price(cells)
        assert found["orderError"] == pytest.approx(1)
        assert found["orderCost"] == pytest.approx(3)
        assert found["cells"] == pytest.approx(32)
        assert found["cpu"] == pytest.approx(32.768)
        assert found["extrapolated"] is extrapolated


@pytest.mark.parametrize("errors, cells", [
    ([0.03, 0.02, 0.01], 4),        # from the coarsest on
    ([0.2, -0.04, -0.02], 8),       # an error that changes its sign
    ([0.01, 0.2, 0.05], 16),        # by chance, and then for good
    ([0.1, 0.2, 0.3], None),        # no mesh helps
])
def test_price_where_a_power_says_nothing(errors, cells):
    """A mesh that was run counts; what is reached by chance does not."""
    found = peers.price([4, 8, 16], errors, [1, 10, 100])
    assert found["cells"] == (cells and pytest.approx(cells))
    assert (found["cpu"] is None) == (cells is None)


LOG = """Time = 1
ExecutionTime = 0.5 s  ClockTime = 1 s
Time = 2

PIMPLE: iteration 1
ExecutionTime = 1.5 s  ClockTime = 2 s
Time = 4
"""


def test_time_to_half():
    """Half of 25 is out between the steps; a step that did not end has no
    processor time."""
    cpu = peers.cpu_by_time(LOG)
    assert cpu == {1: 0.5, 2: 1.5}
    half = peers.to_half([0, 1, 2], [0, 10, 20], cpu)
    assert half == {"timeToHalf": 1.25, "cpuToHalf": 1.5, "steps": 2}
    assert peers.to_half([0, 1], [0, 10], cpu)["timeToHalf"] is None


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which(peers.PEER), reason="no interFoam")
def test_inertia_of_the_peer_is_scaled_away(tmp_path):
    """interFoam on 4 cells a unit: too fast by 39 %, whatever is left of
    inertia."""
    rates = []
    for inertia in (1.0, 0.5):
        case = peers.peer_case(tmp_path/str(inertia), 4, 1e-4, inertia)
        peers.stop_at_rest(case, peers.PEER_REST)
        row = peers.solve_at_rest(case, peers.PEER)
        assert 20 < row["iterations"] < 200
        rates.append(row["Q"])
    assert rates[0] == pytest.approx(1.39*9952, rel=0.01)
    assert rates[1] == pytest.approx(rates[0], rel=1e-5)


@pytest.mark.slow
def test_own_rate_is_that_of_the_fluxes(tmp_path):
    """cosseratPicFoam's case is the classical fluid, without microrotation."""
    case = peers.own_case(tmp_path/"case", 4)
    peers.stop_at_rest(case, silo.REST)
    row = peers.solve_at_rest(case, peers.OWN)
    assert "microrotation     no" in case.log()
    assert abs(row["error"]) < 0.3
