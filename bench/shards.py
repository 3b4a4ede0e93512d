#!/usr/bin/env python3
"""How long a census and an evaluation take as shards: one task on one core, and two at once on two
cores, measured; 8 and 64 computed from these. Prints a table.

A task takes s + w / n seconds, with s what the start takes and w the work of all, where n cores do
n tasks; and then what was made is merged. s is measured as a shard that has nothing to do, or one
press; w is what one task took more."""

import os
import subprocess
import sys
import tempfile
import time

PROGRAM = os.path.abspath("bin/pra-tactile")
WORK = {
    "census --q 4 --degree 6": ("csv", ["census", "--q", "4", "--degree", "6"], "1000000"),
    "evaluate --presses 400 --seed 1": ("json", ["evaluate", "--presses", "400", "--seed", "1"], "400"),
}


def on(core, arguments):
    return subprocess.Popen(
        [PROGRAM, *arguments],
        stdout=subprocess.DEVNULL,
        preexec_fn=lambda: os.sched_setaffinity(0, {core}),
    )


def seconds(commands):
    """Of these commands at once, each on a core of its own."""
    begin = time.monotonic()
    for running in [on(core, command) for core, command in enumerate(commands)]:
        if running.wait() != 0:
            sys.exit("a command failed")
    return time.monotonic() - begin


def main():
    print("| | start | 1 task | 2 tasks | 8 tasks (computed) | 64 tasks (computed) | 2 files merged in |")
    print("|---|--:|--:|--:|--:|--:|--:|")
    for name, (ending, command, many) in WORK.items():
        with tempfile.TemporaryDirectory() as folder:
            def shard(i, n):
                return [*command, "--shard", f"{i}/{n}", "--output", f"{folder}/{i}-{n}.{ending}"]

            start = seconds([shard(many, many)])
            one = seconds([shard(1, 1)])
            two = seconds([shard(1, 2), shard(2, 2)])
            parts = [f"{folder}/{i}-2.{ending}" for i in (1, 2)]
            merging = seconds([["merge", *parts, "--output", f"{folder}/merged"]])
            more = [start + (one - start) / n for n in (8, 64)]
            print(f"| `{name}` |", " | ".join(f"{t:.1f} s" for t in [start, one, two, *more, merging]), "|")


if __name__ == "__main__":
    main()
