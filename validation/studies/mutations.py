"""Thousand dictionaries with one mistake each: what does a run do with them?

Small cases of one to three steps; an entry is deleted, misspelt, given twice,
exchanged with another one, or its value is no number, no finite one, none that
makes sense; brackets are lost, files cut short. The seed is fixed. A run must
end by itself, without a signal, and either refuse the entry by name, or tell
that nothing reads it, or have finite results."""

from collections import Counter

from cosserat.scenes.mutations import sweep
from studies.common import HERE

COUNT, SEED = 1000, 20260


def study():
    """Rows: number, scene, file, entry, mutation, outcome (ran, refused,
    warned), code (exit code, None where a run that got on was stopped),
    seconds, fault (none is allowed), message."""
    rows = sweep(HERE/"runs/mutations", COUNT)
    print(Counter(row["outcome"] for row in rows))
    print(f"at most {max(row['seconds'] for row in rows)} s a run")
    for row in rows:
        if row["fault"]:
            print(row)
    return rows
