"""Runs one engine that is called from Python: `worker.py ENGINE drop|impact|hollow SETTING FILE` prints one line of JSON.

`worker.py ENGINE version` prints the engine's version.
"""

import importlib
import json
import sys
import time

from drop import read_designs, read_strikes
from hollow import Record

AT_LEAST = 0.3  # s: a list that takes less is run several times


def main(engine, what, setting=None, file=None):
    model = importlib.import_module(f"{engine}_model")
    if what == "version":
        print(json.dumps({"version": model.VERSION}))
    elif what == "drop":
        print(json.dumps(drops(model, model.SETTINGS[setting], read_designs(file))))
    elif what == "hollow":
        print(json.dumps({"drops": [hollow(model, model.SETTINGS[setting], design) for design in read_designs(file)]}))
    else:
        chosen = model.SETTINGS[setting]
        print(json.dumps({"spins": [model.strike(strike, chosen) for strike in read_strikes(file)]}))


def drops(model, setting, designs):
    """Verdicts of a list, and the seconds that one pass through it takes."""
    passes, started = 0, time.perf_counter()
    while passes == 0 or time.perf_counter() - started < AT_LEAST:
        verdicts = [model.run(design, setting) for design in designs]
        passes += 1
    return {"seconds": (time.perf_counter() - started) / passes, "verdicts": verdicts}


def hollow(model, setting, design):
    """What became of one part with a hollow; without a face where it came to lie on none in time."""
    record = Record(design)
    result = model.run(design, setting, record)
    return record.result() if result == "none" else result


if __name__ == "__main__":
    main(*sys.argv[1:])
