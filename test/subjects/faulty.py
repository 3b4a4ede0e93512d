"""A subject that answers rightly until it does one thing wrong, which the first argument names."""

import os
import sys
import time

import honest

FAULT = sys.argv[1]


def write(text):
    sys.stdout.write(text)
    sys.stdout.flush()


def at_fault(profile, request):
    """The third request is where it goes wrong."""
    right = honest.answer(profile, request)
    if request["sequence"] % 7 != 3:
        honest.say(right)
        return
    number = request["sequence"]
    if FAULT == "crash":
        print("the table is not there", file=sys.stderr)
        os._exit(3)
    elif FAULT == "signal":
        os.kill(os.getpid(), 9)
    elif FAULT == "hang":
        time.sleep(1000)
    elif FAULT == "garbage":
        write("Traceback (most recent call last):\n")
    elif FAULT == "half-line":
        write('{"sequence": %d, "res' % number)
        os._exit(0)
    elif FAULT == "no-line-end":
        write('{"sequence": %d, "result": 0}' % number)
        time.sleep(1000)
    elif FAULT == "endless":
        while True:
            honest.say(right)
    elif FAULT == "endless-line":
        while True:
            write("0" * 100000)
    elif FAULT == "long-line":
        write(" " * 8_000_000 + "\n")
        honest.say(right)
    elif FAULT == "order":
        honest.say({**right, "sequence": number + 1})
    elif FAULT == "twice":
        honest.say(right)
        honest.say(right)
    elif FAULT == "nan":
        write('{"sequence": %d, "result": NaN}\n' % number)
    elif FAULT == "deep":
        write('{"sequence": %d, "result": %s}\n' % (number, "[" * 100 + "]" * 100))
    elif FAULT == "digits":
        write('{"sequence": %d, "result": %s}\n' % (number, "1" * 5000))
    elif FAULT == "both":
        honest.say({**right, "refused": "invalid"})
    elif FAULT == "neither":
        honest.say({"sequence": number})
    elif FAULT == "type":
        honest.say({"sequence": number, "result": [0]})
    elif FAULT == "skips":
        honest.say({"sequence": number, "skipped": "not today"})
    elif FAULT == "errs":
        honest.say({"sequence": number, "errored": "out of memory"})
    elif FAULT == "closed-output":
        os.close(1)
        time.sleep(1000)
    elif FAULT == "closed-input":
        honest.say(right)
        os.close(0)
        time.sleep(1000)
    elif FAULT == "flood":
        os.write(2, b"complaint " * 1_000_000 + b"the last word\n")
        honest.say(right)
    elif FAULT == "children":
        import subprocess

        subprocess.Popen(["sleep", "1000"])
        os._exit(1)
    else:
        honest.say(right)


if FAULT == "never-starts":
    time.sleep(1000)
elif FAULT == "starts-badly":
    write("ready\n")
    time.sleep(1000)
elif FAULT == "offers-nothing":
    honest.start = lambda: {"protocol": 1, "name": "idle", "operations": [], "in_flight": 1}
elif FAULT == "refuses-all":
    honest.possible = lambda profile: False
elif FAULT == "skips-all":
    honest.answer = lambda profile, request: {"sequence": request["sequence"], "skipped": "later"}

honest.serve(at_fault)

if FAULT == "stays":
    time.sleep(1000)
elif FAULT == "last-word":
    write("goodbye\n")
elif FAULT == "killed-at-the-end":
    os.kill(os.getpid(), 9)
elif FAULT == "status-3":
    sys.exit(3)
