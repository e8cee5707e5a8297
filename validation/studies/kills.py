"""Runs killed at random moments, as by kill -9 or a power cut, and started
again until they come to their end: does that end equal the one of the run that
was left alone, and is every time that a kill has left half written told?"""

from cosserat.scenes.kills import compare
from studies.common import HERE

#: Ranks: kills
KILLS = {1: 20, 2: 5}


def study():
    """Rows: ranks, kills, halfWritten (times that a kill had left so, told and
    deleted), files (of the last time), different (of them, from the run left
    alone)."""
    rows = [compare(HERE/"runs/kills", *item) for item in KILLS.items()]
    for row in rows:
        print(row)
    return rows
