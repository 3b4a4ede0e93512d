#!/usr/bin/env python3
"""Presses whose manifests say something else than was done: right, wrong, refused, what was told wrong, and the least doubt of a wrong one.

Presses of 48 x 60 taxels of the cube, at several spacings, every second of them with its corner at that of a symbol's cell. Of each the frames
are decoded as they are and along other axes (`axes`); with one coordinate told twice as far, as two strips of which the second is told one cell
off, and with the right half from a press on another face (`layouts`); and with each frame 2, 3, 5 and 20 times (`repeats`). Right is what names
a face that was touched and, to less than half a cell, the place that the sensor touched where the answer says that the robot was.

usage: bench/layouts.py [--presses N] [--first SEED] [--spacings 8,12,16] [--program PATH] [axes] [layouts] [repeats]
"""
import argparse
import csv
import json
import shutil
import subprocess
import tempfile
from pathlib import Path

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--presses", type=int, default=20)
parser.add_argument("--first", type=int, default=1)
parser.add_argument("--spacings", default="8,12,16")
parser.add_argument("--program", default="bin/pra-tactile")
parser.add_argument("kinds", nargs="*", metavar="KIND", default=["axes", "layouts", "repeats"])
options = parser.parse_args()
PITCH = (25.4, 31.75)  # mm, of the symbols


def probed(folder, seed, sensor, spacing, face=None):
    """Frames of a press, and its truth."""
    place = ["--at", f"{PITCH[0] * (seed // 2 % 3)},{PITCH[1] * (seed // 6 % 2)}"] if seed % 2 == 0 else []
    asked = ["--object", "cube", "--seed", str(seed), "--size", "48x60", "--upright", "--spacing", str(spacing), "--sensor", sensor]
    face = ["--face", face] if face else []
    subprocess.run(
        [options.program, "probe", *asked, *place, *face, "--truth", f"{folder}.json", "--output", str(folder)], check=True, capture_output=True)
    return json.loads(Path(f"{folder}.json").read_text())


def rows_of(folder):
    with open(folder / "manifest.csv") as manifest:
        return [{**row, "x_mm": float(row["x_mm"]), "y_mm": float(row["y_mm"])} for row in csv.DictReader(manifest)]


def laid(folder, frames):
    """A folder of frames, each a row of a manifest and the folder that its file is in."""
    folder.mkdir()
    lines = ["file,x_mm,y_mm,rotation_deg,force_n"]
    for k, (row, source) in enumerate(frames):
        shutil.copy(source / row["file"], folder / f"{k:04}.pgm")
        lines.append(f"{k:04}.pgm,{row['x_mm']},{row['y_mm']},{row['rotation_deg']},{row['force_n']}")
    (folder / "manifest.csv").write_text("\n".join(lines) + "\n")
    return str(folder)


def decoded(*asked):
    out = subprocess.run([options.program, "decode", "--json", *asked], capture_output=True, text=True)
    return json.loads(out.stdout)


def at(answer, truth, shift=0.0, scale=(1, 1)):
    """Whether that is the place on the face that was touched, for coordinates that are told so far to the right, or so many times as far."""
    if answer["place_mm"] is None:
        return False
    touched = [corner + robot / times for corner, robot, times in zip(truth["region_mm"], answer["robot_mm"], scale)]
    off = [abs(touched[0] - shift - answer["place_mm"][0]), abs(touched[1] - answer["place_mm"][1])]
    return answer["face"] == truth["face"] and all(o < pitch / 2 for o, pitch in zip(off, PITCH))


def cases(place, seed, sensor, spacing):
    """Each layout with its answer, and whether that is right where it is located."""
    frames = place / "frames"
    truth = probed(frames, seed, sensor, spacing)
    rows = rows_of(frames)
    usual = decoded(str(frames))
    yield "as they are", usual, lambda a: at(a, truth)

    def same(answer):
        return (answer["face"], answer["position"]) == (usual["face"], usual["position"])

    if "axes" in options.kinds:
        for axes in ["-x,y", "x,-y", "y,x"]:
            yield axes, decoded(str(frames), "--axes=" + axes), same
    if "layouts" in options.kinds:
        for axis, scale in [("x_mm", (2, 1)), ("y_mm", (1, 2))]:
            doubled = laid(place / axis, [({**row, axis: 2 * row[axis]}, frames) for row in rows])
            yield axis[0] + " doubled", decoded(doubled), lambda a: at(a, truth, scale=scale)
        middle = sorted(row["x_mm"] for row in rows)[len(rows) // 2]
        left, right = [row for row in rows if row["x_mm"] < middle], [row for row in rows if row["x_mm"] >= middle]
        strips = [
            laid(place / "left", [(row, frames) for row in left]),
            laid(place / "right", [({**row, "x_mm": row["x_mm"] + PITCH[0]}, frames) for row in right]),
        ]
        yield "strips, a cell off", decoded("--together", *strips), lambda a: at(a, truth) or at(a, truth, PITCH[0])
        face = "C1 C2 C3 C4" if truth["face"] != ["C1", "C2", "C3", "C4"] else "C1 C5 C6 C2"
        other = probed(place / "other", seed, sensor, spacing, face)
        halves = [(row, frames) for row in left] + [(row, place / "other") for row in rows_of(place / "other") if row["x_mm"] >= middle]
        yield "halves of two faces", decoded(laid(place / "halves", halves)), lambda a: at(a, truth) or at(a, other)
    if "repeats" in options.kinds:
        for times in [2, 3, 5, 20]:
            again = laid(place / f"again{times}", [(row, frames) for row in rows for _ in range(times)])
            yield f"each frame {times} times", decoded(again), lambda a: at(a, truth)


print("| sensor | spacing | layout | right | wrong | told wrong | least doubt of a wrong one | refused |")
print("|---|--:|---|--:|--:|--:|--:|--:|")
for sensor in ["paper", "real"]:
    for spacing in map(int, options.spacings.split(",")):
        told = {}
        for seed in range(options.first, options.first + options.presses):
            with tempfile.TemporaryDirectory() as scratch:
                for name, answer, right in cases(Path(scratch), seed, sensor, spacing):
                    located = answer["outcome"] == "located"
                    told.setdefault(name, []).append((located and right(answer), located, answer["doubt"], seed))
        for name, answers in told.items():
            wrong = [(doubt, seed) for right, located, doubt, seed in answers if located and not right]
            right = sum(right for right, *_ in answers)
            expected = sum(doubt for _, located, doubt, _ in answers if located)
            least = "{:.1e} (seed {})".format(*min(wrong)) if wrong else ""
            print(f"| `{sensor}` | {spacing} | {name} | {right} | {len(wrong)} | {expected:.2g} | {least} | {len(answers) - right - len(wrong)} |",
                  flush=True)
