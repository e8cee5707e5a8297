"""Run the studies named on the command line, or all."""

import importlib
import sys
from time import time

from cosserat import exploration
from studies.common import HERE, NAMES, write


def main():
    """The command line."""
    if sys.argv[1:2] == ["tradeOff"]:
        return exploration.main(sys.argv[2:], "validation/Allrun tradeOff",
                                HERE)
    names = sys.argv[1:] or NAMES
    for name in names:
        if name not in NAMES:
            raise SystemExit(f"no study {name}; there are {', '.join(NAMES)}")
    for name in names:
        print(f"== {name} ==", flush=True)
        start = time()
        rows = importlib.import_module(f"studies.{name}").study()
        path = write(name, rows)
        print(f"{path}: {len(rows)} rows, {time() - start:.0f} s", flush=True)
    return None


if __name__ == "__main__":
    main()
