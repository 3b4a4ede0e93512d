"""The memory table of a pseudorandom array over GF(4) as a numpy array, asked for 10^7 windows by indexing.
usage: table.py ROWS COLUMNS WINDOW-ROWS WINDOW-COLUMNS COEFFICIENT..., constant term first, without the leading 1"""

import sys

import numpy as np

from locating import mixed, sequence
from measure import serve, timed

COUNT = 10**7


def table(rows, columns, high, wide, coefficients):
    index = np.arange(rows * columns)
    cells = np.empty((rows, columns), dtype=np.int32)
    cells[index % rows, index % columns] = sequence(coefficients, rows * columns)
    keys = np.zeros((rows, columns), dtype=np.int32)
    for i in range(high):
        for j in range(wide):
            keys = keys << 2 | np.roll(cells, (-i, -j), axis=(0, 1))
    positions = np.full(4 ** (high * wide), -1, dtype=np.int32)
    positions[keys.ravel()] = index
    return positions


def main():
    rows, columns, high, wide, *coefficients = map(int, sys.argv[1:])
    positions = table(rows, columns, high, wide, coefficients)
    # As numpy indexes fastest: with its own kind of integer.
    windows = (mixed(np.arange(COUNT)) % np.uint64(len(positions))).astype(np.intp)

    def measurement():
        seconds, found = timed(lambda: positions[windows])
        return COUNT / seconds, int((np.arange(COUNT) % 257 * found).sum())

    serve(f"table of {rows} x {columns}", "windows/s", measurement)


main()
