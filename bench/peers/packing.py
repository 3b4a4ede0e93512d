"""The 1200 faces of 200 boxes, as they are walked, packed by rectpack on 255 x 257 cells; the argument is its
algorithm. With `--figures`, instead, every algorithm once: its time, the rows up to the
last used one, and which share of them is taken."""

import sys

import rectpack

from measure import serve, timed

ROWS, COLUMNS, BOXES = 255, 257, 200
ALGORITHMS = ["MaxRectsBl", "MaxRectsBssf", "MaxRectsBaf", "MaxRectsBlsf", "SkylineBl", "SkylineBlWm", "SkylineMwf",
              "SkylineMwfWm", "GuillotineBssfSas", "GuillotineBafMaxas"]
MASK = 2**64 - 1


def mixed(i):
    """As in bench/Bench/Input.hs: SplitMix64."""
    z = i * 0x9E3779B97F4A7C15 & MASK
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 & MASK
    z = (z ^ z >> 27) * 0x94D049BB133111EB & MASK
    return (z ^ z >> 31) >> 32


def faces():
    """Rows and columns of cells, from sides in eighths of a millimetre."""
    for box in range(BOXES):
        a, b, c = (800 + mixed(3 * box + k) % 1201 for k in range(3))
        for wide, high in ((a, b), (a, b), (a, c), (a, c), (b, c), (b, c)):
            yield high // 254, wide * 5 // 1016


def pack(algorithm, pieces):
    # A sheet of more rows than are needed: how many are used is told.
    packer = rectpack.newPacker(mode=rectpack.PackingMode.Offline, pack_algo=getattr(rectpack, algorithm),
                                sort_algo=rectpack.SORT_AREA, rotation=False)
    for rows, columns in pieces:
        packer.add_rect(columns, rows)
    packer.add_bin(COLUMNS, ROWS)
    packer.pack()
    return packer.rect_list()


def main():
    pieces = list(faces())
    if "--figures" in sys.argv:
        for algorithm in ALGORITHMS:
            seconds, laid = timed(lambda: pack(algorithm, pieces))
            rows = max(y + height for _, _, y, _, height, _ in laid)
            share = sum(width * height for _, _, _, width, height, _ in laid) / (rows * COLUMNS)
            print(f"{algorithm}: {len(laid)} laid, {rows} rows, {100 * share:.1f} %, {seconds:.2f} s", flush=True)
        return

    def measurement():
        seconds, laid = timed(lambda: pack(sys.argv[1], pieces))
        return seconds, f"{len(laid)} laid"

    serve("1200 faces on 255 x 257", "s", measurement)


main()
