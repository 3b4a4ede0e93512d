"""Runs a command, sends it a signal once its subject runs, and prints its status, the subject's processes that are left, and the
files in TMPDIR.  usage: interrupted.py SIGNAL MARK COMMAND...  (the subject is known by MARK, its last argument)"""

import os
import pathlib
import signal
import subprocess
import sys
import time


def subjects(mark):
    """The processes whose last argument is the mark, zombies not among them."""
    found = []
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            arguments = (process / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if arguments[-2:-1] == [mark.encode()] and b"faulty.py" in b" ".join(arguments[:2]):
            found.append(process.name)
    return found


def wait_until(holds, seconds):
    end = time.monotonic() + seconds
    while not holds() and time.monotonic() < end:
        time.sleep(0.05)


number, mark, command = signal.Signals[sys.argv[1]], sys.argv[2], sys.argv[3:]
# Whoever runs the tests may have it ignored, as nohup does.
signal.signal(number, signal.SIG_DFL)
run = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
wait_until(lambda: subjects(mark), 15)
time.sleep(0.5)
run.send_signal(number)
status = run.wait(15)
wait_until(lambda: not subjects(mark), 2)
print(status == -number, len(subjects(mark)), len(os.listdir(os.environ["TMPDIR"])))
