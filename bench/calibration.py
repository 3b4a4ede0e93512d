"""Whether the doubts of symbols and parts mean what they say: how many were told to be wrong, and how many were.

Each press is simulated, written to disk and decoded by the program, which is told how exact the robot is. Where it is located
with a doubt of at most 1e-4, the array says what every symbol and part is, and so which of them were taken for something else.

usage: bench/calibration.py [--program bin/pra-tactile] [--presses 150] [--seed 1] [--json FILE]
needs: Python's own library
"""

import argparse
import concurrent.futures
import json
import math
import pathlib
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
# How it is pressed, and the robot's position error in taxels, which `decode` is told.
CONDITIONS = {
    "": 1,
    "--noise 0.3": 1,
    "--noise 0.5": 1,
    "--position-error 2": 2,
    "--position-error 3": 3,
    "--size 34x44": 1,
    "--sensor ideal": 1,
    "--sensor real": 1,
    "--sensor hard": 2,
    "--turn any": 1,
    "--sensor real --turn any": 1,
    "--sensor hard --turn any": 2,
}


def decoded(program, condition, error, number):
    """What is told of a press, by its number; a turn of any degrees is drawn from it."""
    options = [str(number * 37.77 % 360) if o == "any" else o for o in condition.split()]
    with tempfile.TemporaryDirectory() as folder:
        frames = folder + "/frames"
        thing = ["cube", "parallelepiped"][number % 2]
        asked = [program, "probe", "--object", thing, "--seed", str(number), "--output", frames] + options
        subprocess.run(asked, check=True, capture_output=True)
        told = [program, "decode", "--json", "--position-error", str(error), frames]
        return json.loads(subprocess.run(told, capture_output=True, text=True).stdout)


def judged(answers):
    """Of each symbol and part whose place is known: its kind, the doubt that was told, and whether it is wrong."""
    for answer in answers:
        if answer["outcome"] == "located" and answer["doubt"] <= 1e-4:
            for kind in ("symbols", "parts"):
                for one in answer[kind]:
                    if one["expected"] is not None:
                        yield kind, one["likeliest"]["doubt"], one["likeliest"]["code"] != one["expected"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(HERE.parent / "bin" / "pra-tactile"))
    parser.add_argument("--presses", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=pathlib.Path)
    args = parser.parse_args()
    numbers = range(args.seed, args.seed + args.presses)
    rows = []
    print("| presses | located | kind | number | told wrong | counted wrong | standard errors |")
    print("|---|--:|---|--:|--:|--:|--:|")
    for condition, error in CONDITIONS.items():
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            answers = list(pool.map(lambda n: decoded(args.program, condition, error, n), numbers))
        located = sum(a["outcome"] == "located" for a in answers)
        found = list(judged(answers))
        for kind in ("symbols", "parts"):
            told = [(doubt, wrong) for k, doubt, wrong in found if k == kind]
            expected, counted = sum(d for d, _ in told), sum(w for _, w in told)
            deviation = math.sqrt(sum(d * (1 - d) for d, _ in told))
            off = (counted - expected) / max(deviation, 1e-9)
            rows.append({"condition": condition, "located": located, "kind": kind, "number": len(told),
                         "told": expected, "counted": counted, "standard_errors": off})
            print(f"| `{condition or 'as usual'}` | {located} | {kind} | {len(told)} | {expected:.2f} | {counted} | {off:+.1f} |", flush=True)
    if args.json:
        args.json.write_text(json.dumps(rows, indent=2) + "\n")


if __name__ == "__main__":
    main()
