"""Whether the doubts of symbols and parts mean what they say: by decade of doubt how many were told to be wrong, and how many were.

Each press is simulated, written to disk and decoded by the program, which is told how exact the robot is. Where it is located
with a doubt of at most 1e-4, the array says what every symbol and part is, and so which of them were taken for something else.
Presses are on the two objects over GF(4), and on the sheet over other fields. (What is told of single images, and of other
shapes: make calibration.)

usage: bench/calibration.py [--program bin/pra-tactile] [--q 4] [--presses 150] [--seed 1] [--json FILE] [CONDITION ...]
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
    "--sensor paper": 1,
    "--sensor paper --turn any": 1,
    "--sensor real": 1,
    "--sensor real --turn any": 1,
    "--sensor hard": 2,
    "--sensor hard --turn any": 2,
    "--noise 0.5": 1,
    "--position-error 3": 3,
    "--size 34x44": 1,
}


# From what doubt on a column counts.
DECADES = {0: "below 1e-4", 1e-4: "1e-4 to 1e-3", 1e-3: "to 1e-2", 1e-2: "to 0.1", 0.1: "above"}


def decoded(program, q, condition, error, number):
    """What is told of a press, by its number; a turn of any degrees is drawn from it."""
    options = [str(number * 37.77 % 360) if o == "any" else o for o in condition.split()]
    with tempfile.TemporaryDirectory() as folder:
        frames = folder + "/frames"
        thing = ["cube", "parallelepiped"][number % 2] if q == 4 else "sheet"
        array = [] if q == 4 else ["--profile", str(HERE.parent / "data" / "profiles" / f"gf{q}.json")]
        if q == 2 and "--size" not in options:
            options += ["--size", "40x92"]
        asked = [program, "probe", *array, "--object", thing, "--seed", str(number), "--output", frames, *options]
        subprocess.run(asked, check=True, capture_output=True)
        told = [program, "decode", *array, "--json", "--position-error", str(error), frames]
        return json.loads(subprocess.run(told, capture_output=True, text=True).stdout)


def judged(answers):
    """Of each symbol and part whose place is known: its kind, the doubt that was told, and whether it is wrong."""
    for answer in answers:
        if answer["outcome"] == "located" and answer["doubt"] <= 1e-4:
            for kind in ("symbols", "parts"):
                for one in answer[kind]:
                    if one["expected"] is not None:
                        yield kind, one["likeliest"]["doubt"], one["likeliest"]["code"] != one["expected"]


def by_decade(told):
    edges = [*DECADES, 2]
    return [[(doubt, wrong) for doubt, wrong in told if edges[i] <= doubt < edges[i + 1]] for i in range(len(DECADES))]


def counts(told):
    """How many, told wrong, counted wrong; and by how many standard errors of a sum of independent events that is off."""
    expected, wrong = sum(doubt for doubt, _ in told), sum(wrong for _, wrong in told)
    deviation = math.sqrt(sum(doubt * (1 - doubt) for doubt, _ in told))
    return {"number": len(told), "told": expected, "counted": wrong, "standard_errors": (wrong - expected) / max(deviation, 1e-9)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(HERE.parent / "bin" / "pra-tactile"))
    parser.add_argument("--q", type=int, default=4)
    parser.add_argument("--presses", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("conditions", nargs="*", metavar="CONDITION", default=list(CONDITIONS), help="such as '--sensor hard --turn any'")
    args = parser.parse_args()
    numbers = range(args.seed, args.seed + args.presses)
    rows = []
    print("| q | presses | located | kind | " + " | ".join(DECADES.values()) + " | all | standard errors |")
    print("|--:|---|--:|---|" + "--:|" * (len(DECADES) + 2))
    for condition in args.conditions:
        error = CONDITIONS.get(condition, 1)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            answers = list(pool.map(lambda n: decoded(args.program, args.q, condition, error, n), numbers))
        located = sum(a["outcome"] == "located" for a in answers)
        found = list(judged(answers))
        for kind in ("symbols", "parts"):
            told = [(doubt, wrong) for k, doubt, wrong in found if k == kind]
            cells = [counts(these) for these in [*by_decade(told), told]]
            rows.append({"q": args.q, "condition": condition, "located": located, "kind": kind, "decades": cells[:-1], **cells[-1]})
            shown = " | ".join(f"{c['number']}: {c['told']:.2f}, {c['counted']}" for c in cells)
            name = f"`{condition}`"
            print(f"| {args.q} | {name} | {located} | {kind} | {shown} | {cells[-1]['standard_errors']:+.1f} |", flush=True)
    if args.json:
        args.json.write_text(json.dumps(rows, indent=2) + "\n")


if __name__ == "__main__":
    main()
