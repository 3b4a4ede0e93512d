"""How likely an image is of another shape than GF(4)'s (Note [Unlikeness] of Classification/Unlike.hs): the regression, fitted.

usage: bench/peers/unlikeness.py TRUE FOREIGN [TRUE FOREIGN ..]
  folders that `pra-tactile images --set press` wrote, each of the alphabet's symbols and, with --foreign, of others
needs: numpy
"""

import pathlib
import re
import sys

import numpy

HERE = pathlib.Path(__file__).resolve().parent.parent.parent
DRAWN = re.findall(r"^[#.]{8}$", (HERE / "data/shapes.txt").read_text(), re.M)
SHAPES = [numpy.array([[c == "#" for c in row] for row in DRAWN[i : i + 12]], float) for i in range(0, len(DRAWN), 12)]
ROWS, COLUMNS = numpy.mgrid[0:12, 0:8].astype(float)


def standardised(image):
    return (image - image.mean()).ravel() / max(numpy.linalg.norm(image - image.mean()), 1e-12)


def moved(shape, right, down):
    padded = numpy.pad(shape, 2)
    x, y = COLUMNS - right + 2, ROWS - down + 2
    i, j = numpy.floor(y).astype(int), numpy.floor(x).astype(int)
    v, u = y - i, x - j
    above = (1 - u) * padded[i, j] + u * padded[i, numpy.minimum(j + 1, 11)]
    below = numpy.minimum(i + 1, 15)
    return (1 - v) * above + v * ((1 - u) * padded[below, j] + u * padded[below, numpy.minimum(j + 1, 11)])


STEPS = (-0.5, 0, 0.5)
OURS = numpy.array([standardised(moved(s, r, d)) for b in SHAPES for s in (b, b[::-1, ::-1]) for r in STEPS for d in STEPS])


def features(path):
    data = path.read_bytes()
    values = numpy.frombuffer(data[re.match(rb"P5\s+8\s+12\s+65535\s", data).end() :], ">u2").reshape(12, 8).astype(float)
    like = (OURS @ standardised(values)).max()
    blocks = numpy.sort((values - values.mean()).reshape(6, 2, 4, 2).mean((1, 3)).ravel())[::-1].cumsum()
    spread = ((values - values.mean()) ** 2).sum() / 4
    free = max(blocks[k - 1] / numpy.sqrt(spread * k * (24 - k) / 24) for k in range(8, 17))
    left = [max(0.01, 1 - r * r) for r in (like, free)]
    return [1, numpy.log(left[0] / left[1]), -like]


folders = [numpy.array([features(p) for p in sorted(pathlib.Path(f).glob("*.pgm"))]) for f in sys.argv[1:]]
rows = numpy.vstack(folders)
other = numpy.concatenate([numpy.full(len(f), i % 2) for i, f in enumerate(folders)])
fitted = numpy.zeros(3)
for _ in range(50):
    chance = 1 / (1 + numpy.exp(-numpy.clip(rows @ fitted, -30, 30)))
    curvature = (rows.T * (chance * (1 - chance) + 1e-9)) @ rows + 1e-6 * numpy.eye(3)
    fitted += numpy.linalg.solve(curvature, rows.T @ (other - chance))
print("intercept %.2f, per ratio %.2f, per likeness %.2f" % tuple(fitted))
for name, ours, theirs in zip(sys.argv[1::2], folders[::2], folders[1::2]):
    for share in (0.97, 0.99):
        limit = numpy.quantile(ours @ fitted, share)
        print(f"{name}: where {share:.0%} of the alphabet's pass, {(theirs @ fitted <= limit).mean():.1%} of the others do")
