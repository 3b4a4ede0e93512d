"""What mistakes that no test noticed do to what is decoded: the counts of the same presses and pairs, with each of them and without.

After tools/mutate.sh, from the folder where it ran. A line each: the mistake, and what became of the presses under each condition
(right, wrong, and how many wrong ones were told to be expected), of the pairs (right, given, wrong of these) and of the mosaics (right);
`as without` where all numbers are.

usage: tools/mutate/shifts.py [--presses 200] [--pairs 200] [--jobs 2] [--json FILE] [PART ...]     PART: touch recognition (default), or a module
needs: numpy and scipy for the pairs
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent.parent.parent
WORK = pathlib.Path("dist-newstyle/mutate")
PROGRAM = WORK.resolve() / "bin" / "pra-tactile"
CONDITIONS = {
    "usual": [],
    "real, any angle": ["--sensor", "real", "--any-angle"],
    "position error 3, noise 0.3": ["--position-error", "3", "--noise", "0.3"],
    "hard, any angle": ["--sensor", "hard", "--any-angle"],
    "28 x 36": ["--size", "28x36"],
}


def unnoticed(parts):
    """The mistakes of these parts that were tried and not noticed, by name, the latest result of each."""
    equivalent = {line.rstrip() for line in open(HERE / "tools" / "mutate" / "equivalent.txt") if line[:1].strip()}
    latest = {}
    for line in open(WORK / "results.jsonl"):
        result = json.loads(line)
        latest[result["site"], result["variant"]] = result
    for (site, variant), result in sorted(latest.items(), key=lambda item: (item[1]["file"], item[1]["line"])):
        name = f"{result['module']} {result['name']}: {result['variants'][variant - 1]}"
        wanted = any(f"src/{part}/" in result["file"] or result["module"].endswith(part) for part in parts)
        if wanted and result["outcome"] in ("survived", "unfelt", "unreached") and name not in equivalent:
            yield name, f"{site}.{variant}"


def counted(mutant, presses, pairs):
    """The numbers with that mistake, or with none; what does not end within ten minutes is told."""
    environment = {**os.environ, **({"PRA_TACTILE_MUTANT": mutant} if mutant else {})}
    numbers = {}

    def ran(command):
        return subprocess.run(command, env=environment, check=True, capture_output=True, text=True, timeout=600).stdout

    try:
        for condition, options in CONDITIONS.items():
            said = json.loads(ran([PROGRAM, "evaluate", "--presses", str(presses), "--json", *options]))["stitching"]
            numbers[condition] = [said["right"], said["wrong"], round(said["wrong_expected"], 3)]
        if pairs:
            with tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder) / "pairs.json"
                ran([sys.executable, HERE / "bench" / "peers" / "stitching.py", "--program", PROGRAM, "--no-peers", "--pairs", str(pairs),
                     "--levels", "0.2", "--mosaics", "20", "--json", file])  # fmt: skip
                for row in (row for table in json.loads(file.read_text()) for row in table["rows"]):
                    numbers[row["name"]] = [row[key] for key in ("right", "given", "wrong_of_given") if key in row]
    except (subprocess.SubprocessError, ValueError, KeyError) as fault:
        numbers["ended by"] = str(fault)[-200:]
    return numbers


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--presses", type=int, default=200)
    parser.add_argument("--pairs", type=int, default=200)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("parts", nargs="*", default=["touch", "recognition"], metavar="PART")
    arguments = parser.parse_args()
    sure = counted(None, arguments.presses, arguments.pairs)
    print("without", json.dumps(sure), flush=True)
    mutants = list(unnoticed(arguments.parts))
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        found = pool.map(lambda mutant: counted(mutant[1], arguments.presses, arguments.pairs), mutants)
        for (name, _), numbers in zip(mutants, found):
            other = {key: value for key, value in numbers.items() if value != sure.get(key)}
            print(name, json.dumps(other) if other else "as without", flush=True)
            if arguments.json:
                with open(arguments.json, "a") as file:
                    print(json.dumps({"mutant": name, "with": numbers, "without": sure}), file=file)


if __name__ == "__main__":
    main()
