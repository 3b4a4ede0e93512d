#!/usr/bin/env python3
"""Check drawings of shapes, without any of the program's code: python3 check_shapes.py FILE [REPORT.json ...]
Prints the least distance and every fault; exit status 0: none, 1: faults, or a REPORT of 'pra-tactile shapes --examine FILE --json'
that is wrong, 2: FILE is no drawings. The rules: shapes of 12 rows of 8 taxels, embossed (#) or flat (.), made of blocks of 2 x 2
taxels, no two of which meet at a corner only; 48 to 56 taxels embossed, at least 4 along each side; all embossed ones in one
piece, no flat one enclosed. The distance of two shapes is the least number of taxels in which one differs from the other turned
by any quarter turns or mirrored, middle on middle, and then shifted by up to a taxel each way; of a shape from itself, without
the identity. It is a fault below 32."""
import json, sys

WIDE, HIGH, LEAST = 8, 12, 32
KINDS = ("side", "stroke", "pieces", "hole", "area", "own-image", "too-near")

def read(text):
    """The shapes as (name, set of taxels (x, y))."""
    found = []
    for line in text.splitlines():
        line = line.rstrip()
        if not line or line.startswith(";"):
            continue
        if line.startswith("symbol "):
            found.append((line[7:].strip(), []))
        elif set(line) <= set("#.") and found:
            found[-1][1].append(line)
        else:
            raise ValueError("this is no line of a drawing: %r" % line)
    if not found or len({name for name, _ in found}) < len(found):
        raise ValueError("there are no shapes, or two of one name")
    for name, rows in found:
        if len(rows) != HIGH or any(len(row) != WIDE for row in rows):
            raise ValueError("%s is not 12 rows of 8" % name)
    return [(name, {(x, y) for y, row in enumerate(rows) for x, c in enumerate(row) if c == "#"}) for name, rows in found]

def pieces(taxels):
    left, count = set(taxels), 0
    while left:
        count, edge = count + 1, [left.pop()]
        while edge:
            x, y = edge.pop()
            beside = {(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)} & left
            left -= beside
            edge += beside
    return count

def by_itself(s):
    """The faults that a shape has whatever the others are."""
    flat = {(x, y) for x in range(-1, WIDE + 1) for y in range(-1, HIGH + 1)} - s
    blocks = {(x // 2, y // 2) for x, y in s}
    fills = all((2 * u + i, 2 * v + j) in s for u, v in blocks for i in (0, 1) for j in (0, 1))
    corner = any(((x, y) in s) == ((x + 1, y + 1) in s) != ((x + 1, y) in s) == ((x, y + 1) in s)
                 for x in range(WIDE - 1) for y in range(HIGH - 1))
    sides = [sum(x == 0 for x, _ in s), sum(x == WIDE - 1 for x, _ in s), sum(y == 0 for _, y in s), sum(y == HIGH - 1 for _, y in s)]
    wrong = {"side": min(sides) < 4, "stroke": not fills or corner, "pieces": pieces(s) > 1, "hole": pieces(flat) > 1,
             "area": not 48 <= len(s) <= 56}
    return [kind for kind in KINDS if wrong.get(kind)]

def transformed(s, mirrored, turns):
    """About the middle, in half taxels, so that all is exact: mirrored left and right, then turned clockwise."""
    points = [(2 * x - WIDE + 1, 2 * y - HIGH + 1) for x, y in s]
    if mirrored:
        points = [(-x, y) for x, y in points]
    for _ in range(turns):
        points = [(-y, x) for x, y in points]
    return set(points)

NAMES = {"identity": (False, 0), "mirror": (True, 0)}
NAMES.update({"turn-%d" % (90 * t): (False, t) for t in (1, 2, 3)})
NAMES.update({"mirror-turn-%d" % (90 * t): (True, t) for t in (1, 2, 3)})

def difference(a, b, how, shift):
    """In how many taxels a differs from b, transformed and then shifted."""
    there = {(x + 2 * shift[0], y + 2 * shift[1]) for x, y in transformed(b, *NAMES[how])}
    return len(transformed(a, False, 0) ^ there)

def distances(shapes):
    steps = [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1)]
    return {(n, m): min(difference(a, b, how, step) for how in NAMES if i < j or how != "identity" for step in steps)
            for i, (n, a) in enumerate(shapes) for j, (m, b) in enumerate(shapes) if i <= j}

def check(shapes):
    """The least distance and all faults, shape by shape."""
    apart, faults = distances(shapes), []
    for i, (name, s) in enumerate(shapes):
        faults += [(name, kind) for kind in by_itself(s)]
        faults += [(name, "own-image")] * (apart[name, name] < LEAST)
        faults += [(name, "too-near")] * any(apart[other, name] < LEAST for other, _ in shapes[:i])
    return apart, faults

def disagreement(shapes, apart, faults, report):
    """What a report says otherwise, or nothing."""
    named = dict(shapes)
    if report["least_distance"] != min(apart.values()):
        return "its least distance"
    if [(f["shape"], f["kind"]) for f in report["faults"]] != faults:
        return "its faults"
    if sorted((p["a"], p["b"]) for p in report["pairs"]) != sorted(apart):
        return "which pairs there are"
    for p in report["pairs"]:
        met = difference(named[p["a"]], named[p["b"]], p["transformation"], p["shift"])
        if not p["distance"] == met == apart[p["a"], p["b"]] or max(map(abs, p["shift"])) > 1:
            return "the pair %s, %s" % (p["a"], p["b"])
        if p["a"] == p["b"] and p["transformation"] == "identity":
            return "the image of %s" % p["a"]
    return None

def main(file, *reports):
    try:
        with open(file, encoding="utf-8") as text:
            shapes = read(text.read())
    except (OSError, ValueError) as why:
        print("%s: %s" % (file, why), file=sys.stderr)
        return 2
    apart, faults = check(shapes)
    print("%d shapes, least distance %d" % (len(shapes), min(apart.values())))
    for name, kind in faults:
        print("fault: %s: %s" % (name, kind))
    status = 1 if faults else 0
    for name in reports:
        with open(name, encoding="utf-8") as text:
            wrong = disagreement(shapes, apart, faults, json.load(text))
        if wrong:
            print("%s: wrong is %s" % (name, wrong))
            status = 1
    return status

if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) > 1 else __doc__)
