"""What the Python peers share: the protocol. For each line on standard input one measurement is made and one line
of JSON is printed. The first measurement of a process includes what is compiled on first use."""

import json
import resource
import sys
import time


def serve(what, unit, measurement):
    """`measurement` returns (value, check): the value in `unit`, and a text that tells whether the work done is
    the same as another program's."""
    for _ in sys.stdin:
        value, check = measurement()
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        print(json.dumps({"what": what, "value": value, "unit": unit, "check": str(check), "peak_mib": peak}), flush=True)


def timed(action):
    start = time.perf_counter()
    result = action()
    return time.perf_counter() - start, result
