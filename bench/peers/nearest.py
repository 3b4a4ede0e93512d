"""Patches of 4 x 4 cells of the paper's array, some of them wrong, compared with all its 255 positions by numpy: the mean
time of a patch. usage: nearest.py hard|soft"""

import sys

import numpy as np

from locating import mixed, sequence
from measure import serve, timed

ROWS, COLUMNS, SIDE, COUNT = 15, 17, 4, 1000


def words():
    """The content of the patch at each position, row by row."""
    index = np.arange(ROWS * COLUMNS)
    cells = np.empty((ROWS, COLUMNS), dtype=np.int64)
    cells[index % ROWS, index % COLUMNS] = sequence([3, 2, 1, 0], ROWS * COLUMNS)
    turned = [np.roll(cells, (-i, -j), axis=(0, 1)).ravel() for i in range(SIDE) for j in range(SIDE)]
    return np.stack(turned, axis=1)


def damaged(contents):
    patches, numbers = [], []
    for i in range(COUNT):
        at = [int(n) for n in mixed(32 * i + np.arange(32))]
        patch = contents[at[0] % 255].copy()
        for j in range(1, i % 5 + 1):
            patch[at[j] % 16] += 1
        patches.append(patch % 4)
        numbers.append(np.array(at[16:]) / 4294967296)
    return patches, numbers


def hard(contents, patches):
    narrow = contents.astype(np.uint8)
    observed = [patch.astype(np.uint8) for patch in patches]

    def locate(patch):
        different = np.count_nonzero(narrow != patch, axis=1)
        place = int(different.argmin())
        return place + 1000 * int(different[place]) if different[place] <= 4 else -1

    return lambda: [locate(patch) for patch in observed]


def soft(contents, patches, numbers):
    cell = np.arange(SIDE * SIDE)
    beliefs = []
    for patch, x in zip(patches, numbers):
        likely = np.repeat(((0.5 - 0.45 * x) / 3)[:, None], 4, axis=1)
        likely[cell, patch] = 0.5 + 0.45 * x
        beliefs.append(likely)

    def locate(belief):
        likelihood = np.log(belief)[cell, contents].sum(axis=1)
        place = int(likelihood.argmax())
        relative = np.exp(likelihood - likelihood[place])
        relative[place] = 0
        others = relative.sum()
        return place + 1000 * int(others / (1 + others) > 0.001)

    return lambda: [locate(belief) for belief in beliefs]


def main():
    contents = words()
    patches, numbers = damaged(contents)
    locate_all = hard(contents, patches) if sys.argv[1] == "hard" else soft(contents, patches, numbers)

    def measurement():
        seconds, found = timed(locate_all)
        return seconds / COUNT, sum((i + 1) * answer for i, answer in enumerate(found))

    serve(f"{sys.argv[1]} decoding, 4 x 4", "s", measurement)


main()
