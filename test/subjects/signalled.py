"""Runs a command once for each delay, sends it a signal after that, and prints how all runs ended, each way once: the signal's
name, or their status.  usage: signalled.py SIGNAL MILLISECONDS... -- COMMAND..."""

import signal
import subprocess
import sys
import time

number = signal.Signals[sys.argv[1]]
middle = sys.argv.index("--")
delays, command = sys.argv[2:middle], sys.argv[middle + 1 :]
# Whoever runs the tests may have it ignored, as nohup does.
signal.signal(number, signal.SIG_DFL)
endings = set()
for delay in delays:
    run = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(float(delay) / 1000)
    run.send_signal(number)
    status = run.wait(30)
    endings.add(number.name if status == -number else str(status))
print(*sorted(endings))
