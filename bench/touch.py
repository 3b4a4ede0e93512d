#!/usr/bin/env python3
"""How long the commands of touch take and how much memory, each as a whole process with the program's start, beside what is asked.

An array over GF(9) of 32 x 205 is read from 24 frames, by nominal positions and by the lattice, of four presses by `real`; a sheet of
2^20 cells over GF(4) is pressed; 20 000 images are classified; with --training each shipped network is trained and calibrated as
well, in one run each. Of several runs the least is printed, since what else the machine does only adds to it.

usage: bench/touch.py [--program bin/pra-tactile] [--rounds 7] [--training]
needs: Python's own library
"""

import argparse
import os
import pathlib
import subprocess
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent.parent


def measured(command, given=None):
    """Seconds and the peak in MiB of a process that answers, or refuses."""
    with tempfile.TemporaryFile() as source:
        source.write(given or b"")
        source.seek(0)
        start = time.perf_counter()
        process = subprocess.Popen(command, stdin=source, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, cwd=HERE)
        _, status, used = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        if os.waitstatus_to_exitcode(status) not in (0, 1):
            raise SystemExit(process.stderr.read().decode())
        return seconds, used.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(HERE / "bin" / "pra-tactile"))
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--training", action="store_true")
    options = parser.parse_args()
    nine = ["--profile", "data/profiles/gf9.json", "--object", "sheet"]
    large = "--q 4 --polynomial 3,0,2,1,0,0,0,0,0,0,1 --shape 1023x1025 --object sheet --seed 1".split()

    def row(name, asked, commands, rounds=options.rounds, given=None):
        """The least of each command, and of these the least and the greatest."""
        best = [min(measured([options.program, *command], given) for _ in range(rounds)) for command in commands]
        seconds = " to ".join(f"{s:.3g}" for s in sorted({min(best)[0], max(best)[0]}))
        print(f"| {name} | {seconds} | {max(peak for _, peak in best):.0f} | {asked} |", flush=True)

    print("| what | seconds | MiB | asked |\n|---|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as folder:
        presses = [f"{folder}/{seed}" for seed in (91, 92, 93, 94)]
        for press in presses:
            measured([options.program, "probe", *nine, "--seed", pathlib.Path(press).name, "--sensor", "real", "--output", press])
        row("24 frames over GF(9), nominal positions", "0.1 s", [["decode", *nine, "--no-stitching", press] for press in presses])
        row("24 frames over GF(9), by the lattice", "0.4 s", [["decode", *nine, press] for press in presses])
        for size in ("40x52", "100x100"):
            presses = [["probe", *large, "--size", size, "--output", f"{folder}/{size}-{k}"] for k in range(options.rounds)]
            row(f"a press of {size} taxels on 2^20 cells", "1 s, 150 MiB", presses, rounds=1)
        measured([options.program, *"images --set bitmap --count 5000 --image-noise 0.3 --seed 1 --output".split(), folder + "/images"])
        paths = "\n".join(map(str, sorted(pathlib.Path(folder, "images").glob("*.pgm")))) + "\n"
        row("20 000 images, `classify --batch`", "4 s", [["classify", "--batch", "--levels", "0.25,0.75"]], given=paths.encode())
        for q in (4, 2, 3, 5, 7, 8, 9) if options.training else ():
            files = ["--output", folder + "/network.txt", "--calibration", folder + "/calibration.txt"]
            row(f"`train --q {q}` with its calibration", "300 s", [["train", "--q", str(q), *files]], rounds=1)


if __name__ == "__main__":
    main()
