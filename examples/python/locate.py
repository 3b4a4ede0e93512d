"""From what was felt of some cells back to their place in the array.

A patch is a dictionary from offsets to what was felt there; a position is that of the patch's upper
left cell, felt or not. Raises Refused with the reason where there is no answer.
"""

from math import exp, fsum, inf, log

from folding import FOLDINGS, differences


class Refused(Exception):
    """There is no answer, for this reason."""


def locate(array, patch):
    """The positions at which every cell agrees, by way of the patch's complete windows."""
    if not patch:
        raise Refused("too-few-cells")
    windows = complete_windows(array, patch)
    if not windows:
        raise Refused("no-complete-window")
    # Where every cell agrees every complete window occurs, so that these are the common places of
    # the windows that occur, as far as all other cells agree there too.
    found = within(array, patch, 0)
    if not found:
        raise Refused(why_nowhere(array, patch, windows))
    return found


def nearest(array, patch, radius):
    """The positions that differ in the fewest cells, if these are at most so many; None stands for
    as many as are corrected for certain."""
    if not patch:
        raise Refused("too-few-cells")
    if radius is None:
        promised = array.surface in ("sheet", FOLDINGS[array.folding])
        radius = max(0, array.distance(list(patch)) - 1) // 2 if promised else 0
    found = within(array, patch, radius)
    if found:
        return found
    nonzero = sum(code != 0 for code in patch.values())
    windows = complete_windows(array, patch)
    if radius == 0 and windows:
        raise Refused(why_nowhere(array, patch, windows))
    if nonzero <= radius:
        raise Refused("zero-window")
    raise Refused("contradiction" if radius == 0 else "beyond-radius")


def within(array, patch, radius):
    """The nearest positions, ascending, if they differ in no more cells than the radius."""
    width, planes = array.planes(array.surface, list(patch))
    counts = differences(planes, list(patch.values()))
    least = min(counts, default=inf)
    if least > radius:
        return []
    return [divmod(k, width) for k in indices(counts, least)]


def indices(counts, wanted):
    """Where a number stands in bytes or in a list."""
    found, start = [], 0
    try:
        while True:
            start = counts.index(wanted, start) + 1
            found.append(start - 1)
    except ValueError:
        return found


def complete_windows(array, patch):
    """The offsets at which all cells of a window were felt, with their contents."""
    rectangle = array.rectangle()
    windows = []
    for i, j in patch:
        codes = [patch.get((i + a, j + b)) for a, b in rectangle]
        if None not in codes:
            windows.append(((i, j), codes))
    return windows


def why_nowhere(array, patch, windows):
    """The reason for which a patch with complete windows is nowhere."""
    width, planes = array.planes(array.surface, array.rectangle())
    occurring = []
    for (i, j), codes in windows:
        found = indices(differences(planes, codes), 0)
        if found:
            occurring.append({place(array, k // width - i, k % width - j) for k in found})
    if not occurring:
        zeros = not any(any(codes) for _, codes in windows)
        return "zero-window" if zeros else "not-in-array"
    if array.surface == "sheet":
        for row, column in set.intersection(*occurring):
            # What lies on the sheet agrees; the patch is nowhere because something does not.
            if agrees_on_sheet(array, patch, row, column):
                return "off-sheet"
    return "contradiction"


def place(array, row, column):
    """Where the patch is; on the sheet perhaps beyond its upper or left edge."""
    if array.surface == "sheet":
        return row, column
    return array.canonical(array.surface, row, column)


def agrees_on_sheet(array, patch, row, column):
    for (i, j), code in patch.items():
        cell = array.canonical("sheet", row + i, column + j)
        if cell is not None and array.cells[cell[0] * array.n2 + cell[1]] != code:
            return False
    return True


def posterior(array, patch):
    """Bayes' theorem: all positions are equally likely beforehand, cells are independent; a cell is
    known by the probability of each code. The positions that are possible, with their
    probabilities."""
    height, width = array.admissible(array.surface, list(patch))
    if not patch:
        return [(r, c, 1 / array.size) for r in range(height) for c in range(width)]
    logs = [[log(p) if p > 0 else -inf for p in chances] for chances in patch.values()]
    _, planes = array.planes(array.surface, list(patch))
    likely = []
    for k, codes in enumerate(zip(*planes)):
        likelihood = sum(map(list.__getitem__, logs, codes))
        if likelihood > -inf:
            likely.append((k, likelihood))
    if not likely:
        raise Refused("contradiction")
    best = max(likelihood for _, likelihood in likely)
    weights = [exp(likelihood - best) for _, likelihood in likely]
    total = fsum(weights)
    return [(*divmod(k, width), w / total) for (k, _), w in zip(likely, weights)]
