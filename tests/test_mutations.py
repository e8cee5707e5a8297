"""Dictionaries with one mistake each: the first of the study
mutations."""

from collections import Counter

import pytest

from cosserat.scenes.mutations import sweep


@pytest.mark.slow
def test_mutations(tmp_path):
    """No crash, no hang, nothing passed over in silence, no message that names
    neither file nor entry, no result that is not finite."""
    rows = sweep(tmp_path, 60)
    assert [row for row in rows if row["fault"]] == []
    outcomes = Counter(row["outcome"] for row in rows)
    assert outcomes["refused"] > 30 and outcomes["ran"] > 5, outcomes
