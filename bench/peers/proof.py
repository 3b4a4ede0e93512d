"""The m-sequence of x^12 + x^4 + x^3 + x^2 + A over GF(4) by galois, folded into 63 x 266305 cells and every 3 x 4
window on the torus packed and marked by numpy: the time of the whole."""

import galois
import numpy as np

from measure import serve, timed

ROWS, COLUMNS, HEIGHT, WIDTH = 63, 266305, 3, 4
PERIOD = ROWS * COLUMNS


def distinct_windows(h):
    terms = np.asarray(galois.FLFSR(h.reverse(), state=[1] + [0] * 11).step(PERIOD)).view(np.ndarray)
    index = np.arange(PERIOD, dtype=np.int32)
    cells = np.empty((ROWS, COLUMNS), dtype=np.uint8)
    cells[index % ROWS, index % COLUMNS] = terms
    # Packed by rows of the window, then the rows joined; wrapping by a margin is the fastest way in numpy.
    wide = np.concatenate([cells, cells[:, : WIDTH - 1]], axis=1)
    strip = np.zeros((ROWS, COLUMNS), dtype=np.uint32)
    for j in range(WIDTH):
        strip = strip << 2 | wide[:, j : j + COLUMNS]
    tall = np.concatenate([strip, strip[: HEIGHT - 1]], axis=0)
    keys = np.zeros((ROWS, COLUMNS), dtype=np.uint32)
    for i in range(HEIGHT):
        keys = keys << (2 * WIDTH) | tall[i : i + ROWS]
    seen = np.zeros(4 ** (HEIGHT * WIDTH), dtype=bool)
    seen[keys.ravel()] = True
    return int(np.count_nonzero(seen))


def main():
    h = galois.Poly([1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 2], field=galois.GF(4))
    serve("sequence, fold and proof, GF(4), 63 x 266305, 3 x 4", "s", lambda: timed(lambda: distinct_windows(h)))


main()
