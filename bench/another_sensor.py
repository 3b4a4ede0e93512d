"""Faces read by a sensor that is not the project's: its elements, cover, contact and response are written here anew.

What `probe` simulates is what the decoder was built with. This presses the same faces by another model: square elements
under a soft cover with a long tail, a rigid press with force and tilts, a response that saturates, with gains, crosstalk,
hysteresis, offsets, dead elements and 8 bits. Each answer is judged by where its window is on the face that was pressed.

usage: bench/another_sensor.py [--program bin/pra-tactile] [--presses 100] [--any-angle] [CONDITION ...]
needs: numpy and scipy (bench/peers/setup.sh)
"""

import argparse
import json
import math
import pathlib
import subprocess
import tempfile

import numpy
from scipy import ndimage

HERE = pathlib.Path(__file__).resolve().parent.parent
TAXEL = 1.5875  # mm, between the elements; the relief is as high, and a symbol's taxel as wide
COLUMN, ROW = 25.4, 31.75  # mm, the pitch of the symbols
GRID = 0.2  # mm, how finely the relief is drawn
SIDE = 16  # elements
PARTS = 6  # of an element, along each axis
REGION = (40 * TAXEL, 52 * TAXEL)
CUBE = {
    "C2 C6 C7 C3": (0, 0),
    "C3 C7 C8 C4": (0, 5),
    "C4 C8 C5 C1": (4, 0),
    "C1 C2 C3 C4": (4, 5),
    "C1 C5 C6 C2": (8, 0),
    "C6 C5 C8 C7": (8, 5),
}
PARALLELEPIPED = {"P1 P2 P3 P4": (0, 10), "P6 P5 P8 P7": (3, 10), "P2 P6 P7 P3": (6, 10), "P4 P8 P5 P1": (9, 10)}
# What is other than usual, and what `decode` is told.
USUAL = {
    "gain": 0.06,  # standard deviation from element to element, natural logarithm
    "dead": 0,  # elements, at most
    "rotation": 0.0,  # degrees, standard deviation
    "position": 1.0,  # taxels, standard deviation
    "force": 0.1,  # standard deviation, share
    "tilt": 0.1,  # standard deviation, height of the relief over half the sensor
    "cover": 1.0,  # mm, the cover's spread; a quarter of the force spreads three times as far
    "saturation": 1.2,
    "crosstalk": 0.01,
    "hysteresis": 0.05,
    "offset": 0.0,
    "noise": 0.02,
    "full": 1.0,  # of full scale: what reads 255
}
CONDITIONS = {
    "usual": ({}, []),
    "gain-10": ({"gain": 0.1}, []),
    "gain-30": ({"gain": 0.3}, []),
    "dead-16": ({"dead": 16}, []),
    "rotation-1.5": ({"rotation": 1.5}, []),
    "rotation-3": ({"rotation": 3}, []),
    "position-2": ({"position": 2}, ["--position-error", "2"]),
    "position-2-untold": ({"position": 2}, []),
    "position-3": ({"position": 3}, ["--position-error", "3"]),
    "cover-1.6": ({"cover": 1.6}, []),
    "crosstalk-5": ({"crosstalk": 0.05}, []),
    "hysteresis-20": ({"hysteresis": 0.2}, []),
    "noise-10": ({"noise": 0.1}, []),
    "offset-10": ({"offset": 0.1}, []),
    "tilted": ({"force": 0.3, "tilt": 0.3}, []),
    "tilted-3": ({"tilt": 0.419}, []),
    "tilted-5": ({"tilt": 0.7}, []),
    "saturated": ({"saturation": 0.5, "full": 0.8}, []),
    "dim": ({"full": 8.0}, []),
    "all": (
        {
            "gain": 0.2,
            "dead": 8,
            "rotation": 2,
            "position": 1.5,
            "force": 0.3,
            "tilt": 0.2,
            "hysteresis": 0.1,
            "crosstalk": 0.02,
            "noise": 0.05,
        },
        ["--position-error", "1.5"],
    ),
}


def shapes():
    """The bitmaps of the shipped alphabet, 12 rows of 8."""
    found, rows = [], []
    for line in (HERE / "data" / "shapes.txt").read_text().splitlines() + [""]:
        if line and set(line) <= set("#."):
            rows.append([c == "#" for c in line])
        elif rows:
            found.append(numpy.array(rows))
            rows = []
    return found


def size_of(face):
    """Rows and columns of symbols, and millimetres across and down."""
    if face in CUBE:
        return 4, 5, 127.0, 127.0
    return 3, 7, 177.8, 101.6 if face in ("P1 P2 P3 P4", "P6 P5 P8 P7") else 95.25


def relief_of(face, array, alphabet):
    """Heights in mm, with rounded edges, and far below beyond the face's own edge; and how wide that margin is."""
    rows, columns, width, height = size_of(face)
    row, column = {**CUBE, **PARALLELEPIPED}[face]
    heights = numpy.zeros((int(height / GRID), int(width / GRID)))
    for i in range(rows):
        for j in range(columns):
            left = (width - columns * COLUMN) / 2 + j * COLUMN + (COLUMN - 8 * TAXEL) / 2
            top = (height - rows * ROW) / 2 + i * ROW + (ROW - 12 * TAXEL) / 2
            for y, x in zip(*numpy.nonzero(alphabet[array[row + i, column + j]]), strict=True):
                down = [round((top + (y + k) * TAXEL) / GRID) for k in (0, 1)]
                across = [round((left + (x + k) * TAXEL) / GRID) for k in (0, 1)]
                heights[slice(*down), slice(*across)] = TAXEL
    margin = int(60 / GRID)
    return numpy.pad(ndimage.gaussian_filter(heights, 0.25 / GRID), margin, constant_values=-4.0), margin


class Sensor:
    """One sensor of a condition, with its own gains, offsets and dead elements; it remembers the press before."""

    def __init__(self, random, condition):
        self.is_ = {**USUAL, **condition}
        self.random = random
        self.gain = numpy.exp(random.normal(0, self.is_["gain"], (SIDE, SIDE)))
        self.offset = random.uniform(0, self.is_["offset"], (SIDE, SIDE))
        self.dead = numpy.zeros(SIDE * SIDE, bool)
        self.dead[random.choice(SIDE * SIDE, random.integers(0, self.is_["dead"] + 1), replace=False)] = True
        self.before = numpy.zeros((SIDE, SIDE))

    def press(self, height_at):
        """A frame of bytes, of heights in mm at places in mm around the sensor's centre."""
        is_, random = self.is_, self.random
        along = ((numpy.arange(SIDE * PARTS) + 0.5) / PARTS - SIDE / 2) * TAXEL
        x, y = numpy.meshgrid(along, along)
        tilts = random.normal(0, is_["tilt"], 2) * TAXEL / (SIDE / 2 * TAXEL)
        plane = height_at(x, y) - TAXEL + tilts[0] * x + tilts[1] * y
        force = 0.22 * max(0.3, 1 + random.normal(0, is_["force"]))
        low, high = -4.0, 8.0
        for _ in range(30):  # until the pressure balances the force
            middle = (low + high) / 2
            low, high = (middle, high) if (numpy.maximum(0, middle + plane) ** 1.3).mean() < force else (low, middle)
        pressure = numpy.maximum(0, low + plane) ** 1.3
        spread = is_["cover"] / TAXEL * PARTS
        near, far = (ndimage.gaussian_filter(pressure, k * spread, mode="nearest") for k in (1, 3))
        felt = (0.75 * near + 0.25 * far).reshape(SIDE, PARTS, SIDE, PARTS)[:, 1:-1, :, 1:-1].mean((1, 3))
        read = (1 - numpy.exp(-felt / is_["saturation"])) * self.gain
        read = read + is_["crosstalk"] * (read.mean(0, keepdims=True) + read.mean(1, keepdims=True))
        read = read + is_["hysteresis"] * self.before
        self.before = read
        read = read * (1 + random.normal(0, 0.02, read.shape)) + random.normal(0, is_["noise"], read.shape) + self.offset
        read[self.dead.reshape(SIDE, SIDE)] = 0
        return numpy.clip(numpy.round(255 * read / is_["full"]), 0, 255).astype(numpy.uint8)


def turned(degrees, x, y):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return c * x - s * y, s * x + c * y


def judged(program, reliefs, condition, told, seed, any_angle):
    """What came of a press: right, wrong or refused, and the doubt that was told."""
    random = numpy.random.default_rng(seed)
    face = sorted(reliefs)[random.integers(len(reliefs))]
    heights, margin = reliefs[face]
    _, _, width, height = size_of(face)
    angle = random.uniform(0, 360) if any_angle else random.choice([0, 180])
    centre = [random.uniform(r / 2, max(r / 2, side - r / 2)) for r, side in zip(REGION, (width, height), strict=True)]

    def on_face(x, y):
        across, down = turned(-angle, x - REGION[0] / 2, y - REGION[1] / 2)
        return centre[0] + across, centre[1] + down

    sensor = Sensor(random, condition)
    with tempfile.TemporaryDirectory() as folder:
        rows = ["file,x_mm,y_mm,rotation_deg,force_n"]
        half = SIDE / 2 * TAXEL
        for y in [min(half * (k + 1), REGION[1] - half) for k in range(6)]:
            for x in [half * (k + 1) for k in range(4)]:
                error = random.normal(0, sensor.is_["position"], 2) * TAXEL
                turn = random.normal(0, sensor.is_["rotation"])

                def height_at(u, v, x=x + error[0], y=y + error[1], turn=turn):
                    across, down = turned(turn, u, v)
                    across, down = on_face(x + across, y + down)
                    places = [t / GRID - 0.5 + margin for t in (down, across)]
                    return ndimage.map_coordinates(heights, places, order=1, cval=-4)

                name = f"{len(rows):03d}.pgm"
                head = b"P5\n%d %d\n255\n" % (SIDE, SIDE)
                pathlib.Path(folder, name).write_bytes(head + sensor.press(height_at).tobytes())
                rows.append(f"{name},{x},{y},0,10")
        pathlib.Path(folder, "manifest.csv").write_text("\n".join(rows) + "\n")
        asked = [program, "decode", "--json", *told, folder]
        answer = json.loads(subprocess.run(asked, capture_output=True, text=True).stdout)
    if answer["outcome"] != "located":
        return "refused", 0
    x, y = on_face(*answer["robot_mm"])
    apart = math.hypot(x - answer["place_mm"][0], y - answer["place_mm"][1])
    askew = abs((answer["angle_deg"] - angle + 180) % 360 - 180)
    right = answer["face"] == face.split() and apart < 8 and askew < 5
    return ("right" if right else "wrong"), answer["doubt"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(HERE / "bin" / "pra-tactile"))
    parser.add_argument("--presses", type=int, default=100)
    parser.add_argument("--any-angle", action="store_true")
    parser.add_argument("conditions", nargs="*", metavar="CONDITION", help=", ".join(CONDITIONS))
    asked = parser.parse_args()
    printed = subprocess.run([asked.program, "array", "--format", "csv"], capture_output=True, text=True, check=True)
    array = numpy.array([row.split(",") for row in printed.stdout.split()], int)
    reliefs = {face: relief_of(face, array, shapes()) for face in {**CUBE, **PARALLELEPIPED}}
    for name in asked.conditions or CONDITIONS:
        condition, told = CONDITIONS[name]
        outcomes = [
            judged(asked.program, reliefs, condition, told, seed, asked.any_angle) for seed in range(asked.presses)
        ]
        counts = [sum(o == outcome for o, _ in outcomes) for outcome in ("right", "wrong", "refused")]
        expected = sum(doubt for _, doubt in outcomes)
        print("%-18s right %d  wrong %d (expected: %.2g)  refused %d" % (name, *counts[:2], expected, counts[2]), flush=True)


if __name__ == "__main__":
    main()
