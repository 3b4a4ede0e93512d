#!/usr/bin/env python3
"""Presses decoded along the robot's axes and along others: right, wrong, refused, and the least doubt of a wrong one.

usage: bench/layouts.py [--presses N] [--program PATH]
"""
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--presses", type=int, default=20)
parser.add_argument("--program", default="bin/pra-tactile")
options = parser.parse_args()


def decoded(folder, *more):
    out = subprocess.run([options.program, "decode", folder, "--json", *more], capture_output=True, text=True)
    answer = json.loads(out.stdout)
    located = answer["outcome"] == "located"
    return (answer["face"], answer["position"]) if located else None, answer["doubt"]


print("| sensor | spacing | axes | right | wrong | least doubt of a wrong one | refused |")
print("|---|--:|---|--:|--:|--:|--:|")
for sensor in ["paper", "real"]:
    for spacing in [8, 12, 16]:
        told = {"as they are": [], "-x,y": [], "x,-y": [], "y,x": []}
        for seed in range(1, options.presses + 1):
            with tempfile.TemporaryDirectory() as scratch:
                folder = str(Path(scratch) / "frames")
                subprocess.run(
                    [options.program, "probe", "--object", "cube", "--seed", str(seed), "--size", "48x60", "--upright",
                     "--spacing", str(spacing), "--sensor", sensor, "--output", folder], check=True, capture_output=True)
                truth, doubt = decoded(folder)
                told["as they are"].append((truth, truth, doubt))
                for axes in ["-x,y", "x,-y", "y,x"]:
                    told[axes].append((truth, *decoded(folder, "--axes=" + axes)))
        for axes, answers in told.items():
            wrong = [doubt for truth, place, doubt in answers if place is not None and place != truth]
            right = sum(place is not None and place == truth for truth, place, _ in answers)
            least = f"{min(wrong):.1e}" if wrong else ""
            print(f"| `{sensor}` | {spacing} | {axes} | {right} | {len(wrong)} | {least} | {len(answers) - right - len(wrong)} |",
                  flush=True)
