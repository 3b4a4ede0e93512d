"""Faces that carry other shapes than the alphabet's: how many presses on them are located, and how many of their symbols are recognised.

The array is the shipped one, but each element has a shape that is none of ours: letters, and shapes drawn by chance by the rules of the
alphabets (`images --foreign-shapes`), four others for every press. All are at least so many taxels from each of ours, turned or mirrored and shifted
by up to a taxel. Faces lie at any angle. Every answer with a place is wrong. A symbol is certain if it is recognised, and another shape with a
probability below a tenth.

usage: bench/foreign_faces.py [--program bin/pra-tactile] [--presses 100] [--seed 1] [--distance 24] [SENSOR ...]
needs: Python's own library
"""

import argparse
import itertools
import json
import pathlib
import random
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent.parent
# Capitals on 4 x 6 blocks of 2 x 2 taxels, a hexadecimal digit a row.
LETTERS = """699F99 E9E99E 788887 E9999E F8E88F F8E888 788B97 99F999 722227 111196 9ACA99 88888F 9FF999
    9DB999 699996 E99E88 6999B7 E99EA9 78611E F66666 999996 999966 999FF9 996699 99F666 F1248F""".split()


def drawing(letter):
    return ["".join("##" if int(row, 16) >> bit & 1 else ".." for bit in (3, 2, 1, 0)) for row in letter for _ in (0, 1)]


def drawings(path):
    rows = [line for line in path.read_text().splitlines() if line and set(line) <= set("#.")]
    return [rows[i : i + 12] for i in range(0, len(rows), 12)]


def image(path):
    """A drawing of a 16-bit PGM file."""
    samples = path.read_bytes()[-192:]
    return ["".join("#" if samples[2 * (8 * y + x)] > 127 else "." for x in range(8)) for y in range(12)]


def distance(one, other):
    """The least number of taxels in which they differ, the one turned by 180 degrees or mirrored, and shifted by up to a taxel."""
    embossed = {(x, y) for y in range(12) for x in range(8) if one[y][x] == "#"}
    images = [{(7 - x if h else x, 11 - y if v else y) for x, y in embossed} for h, v in itertools.product((0, 1), repeat=2)]
    fixed = {(x, y) for y in range(12) for x in range(8) if other[y][x] == "#"}
    shifts = list(itertools.product((-1, 0, 1), repeat=2))
    return min(len(fixed ^ {(x + i, y + j) for x, y in moved}) for moved in images for i, j in shifts)


def pressed(options, sensor, shapes, number):
    """The answer of a press on a face with these shapes."""
    draw = random.Random(number)
    with tempfile.TemporaryDirectory() as folder:
        chosen = pathlib.Path(folder, "shapes.txt")
        chosen.write_text("\n".join(f"symbol {k}\n" + "\n".join(shape) + "\n" for k, shape in enumerate(draw.sample(shapes, 4))))
        asked = ["--object", draw.choice(["cube", "parallelepiped"]), "--turn", str(draw.uniform(0, 360)), "--seed", str(number)]
        command = [options.program, "probe", *asked, "--sensor", sensor, "--shapes", str(chosen), "--output", folder + "/frames"]
        subprocess.run(command, check=True, capture_output=True)
        return json.loads(subprocess.run([options.program, "decode", "--json", folder + "/frames"], capture_output=True, text=True).stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(HERE / "bin" / "pra-tactile"))
    parser.add_argument("--presses", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--distance", type=int, default=24)
    parser.add_argument("sensors", nargs="*", metavar="SENSOR", default=["real", "hard"])
    options = parser.parse_args()
    ours = drawings(HERE / "data" / "shapes.txt")
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(options.seed, options.seed + 10):  # a seed has few shapes
            asked = ["images", "--set", "bitmap", "--foreign", str(options.distance), "--count", "40", "--seed", str(seed)]
            subprocess.run([options.program, *asked, "--output", f"{folder}/{seed}"], check=True, capture_output=True)
        drawn = [list(shape) for shape in sorted({tuple(image(path)) for path in pathlib.Path(folder).glob("*/*.pgm")})]
    far = {
        name: [shape for shape in shapes if all(distance(shape, known) >= options.distance for known in ours)]
        for name, shapes in (("letters", [drawing(letter) for letter in LETTERS]), ("drawn", drawn))
    }
    print("| sensor | shapes | of them | presses | located | told wrong | symbols | recognised | certain |")
    print("|---|---|--:|--:|--:|--:|--:|--:|--:|")
    for sensor, (name, shapes) in itertools.product(options.sensors, far.items()):
        answers = [pressed(options, sensor, shapes, options.seed * 1000 + k) for k in range(options.presses)]
        located = [answer["doubt"] for answer in answers if answer["outcome"] == "located"]
        symbols = [symbol for answer in answers for symbol in answer["symbols"]]
        known = [symbol["none"] for symbol in symbols if symbol["code"] is not None]
        certain = [none for none in known if none < 0.1]
        counts = [len(shapes), len(answers), len(located), f"{sum(located):.2g}", len(symbols), len(known), len(certain)]
        print(f"| `{sensor}` | {name} | " + " | ".join(map(str, counts)) + " |", flush=True)


if __name__ == "__main__":
    main()
