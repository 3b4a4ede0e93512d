"""A pseudorandom array: one period of an m-sequence, folded into n1 x n2 cells."""

from functools import cached_property, lru_cache
from itertools import product
from math import gcd

from field import Field, Impossible

FOLDINGS = {"diagonal": "torus", "row-major": "twisted-torus"}
"""The foldings, each with its own surface: on it the neighbours of all cells are alike."""


class Array:
    """All that a profile states, checked. Raises Impossible if there is no such array."""

    def __init__(self, profile):
        self.field = Field(profile["q"], profile["modulus"])
        q = self.field.q
        self.state = profile["state"]
        self.n1, self.n2 = profile["shape"]
        self.k1, self.k2 = profile["window"]
        self.folding, self.surface = profile["folding"], profile["surface"]
        self.most_significant_first = profile["packing"] == "most-significant-first"
        self.size = self.n1 * self.n2
        polynomial = profile["polynomial"]
        while polynomial and polynomial[-1] == 0:
            polynomial = polynomial[:-1]
        self.n = n = len(polynomial) - 1
        if any(c >= q for c in polynomial + self.state):
            raise Impossible("a coefficient or a term of the state is no element")
        if self.size != q**n - 1:
            raise Impossible("the cells are not as many as the terms of a period")
        if n < 1 or polynomial[-1] != 1 or not self.field.is_primitive(polynomial):
            raise Impossible("the polynomial is not primitive")
        if len(self.state) != n or not any(self.state):
            raise Impossible("the state is not n terms, or all zeros")
        if self.folding == "diagonal" and gcd(self.n1, self.n2) != 1:
            raise Impossible("the sides have a common divisor")
        if not 1 <= self.k1 * self.k2 <= 4096:
            raise Impossible("the window is empty or too large")
        if profile["reading"] == "reciprocal":
            # x^n h(1/x), made monic.
            inverse = self.field.power(polynomial[0], -1)
            polynomial = [self.field.multiply(inverse, c) for c in reversed(polynomial)]
        self.h = polynomial
        self.plane = lru_cache(maxsize=1024)(self._plane)

    @cached_property
    def terms(self):
        """One period: s(i + n) = - (c0 s(i) + ... + c(n-1) s(i+n-1)). Mind the minus."""
        field = self.field
        taps = [(k, field.negate(c)) for k, c in enumerate(self.h[:-1]) if c]
        s = list(self.state)
        for i in range(self.size - self.n):
            term = 0
            for k, c in taps:
                term = field.add(term, field.multiply(c, s[i + k]))
            s.append(term)
        return bytes(s[: self.size])

    def index(self, row, column):
        """Which term a cell holds; beyond the edges on the folding's own surface."""
        if self.folding == "row-major":
            return (self.n2 * row + column) % self.size
        # i = row modulo n1 and i = column modulo n2, by the Chinese remainder theorem.
        steps = (column - row) * pow(self.n1, -1, self.n2) % self.n2
        return (row + self.n1 * steps) % self.size

    @cached_property
    def cells(self):
        """All cells, row by row."""
        s = self.terms
        return bytes(s[self.index(r, c)] for r, c in product(range(self.n1), range(self.n2)))

    def rectangle(self):
        """The offsets of a window's cells, in reading order."""
        return list(product(range(self.k1), range(self.k2)))

    # Surfaces

    def canonical(self, surface, row, column):
        """The cell that a row and a column, perhaps negative, are on a surface; None beyond the
        edges of the sheet."""
        if surface == "torus":
            return row % self.n1, column % self.n2
        if surface == "twisted-torus":
            return divmod((self.n2 * row + column) % self.size, self.n2)
        return (row, column) if 0 <= row < self.n1 and 0 <= column < self.n2 else None

    def admissible(self, surface, offsets):
        """How many rows and columns of positions there are from which cells with these offsets lie
        on the surface, the position itself as well."""
        if surface != "sheet":
            return self.n1, self.n2
        height = self.n1 - max((i for i, _ in offsets), default=0)
        width = self.n2 - max((j for _, j in offsets), default=0)
        return (height, width) if height > 0 and width > 0 else (0, 0)

    def planes(self, surface, offsets):
        """The width of the rectangle of admissible positions, and for each offset what all these
        positions, row by row, have there: one string of bytes an offset."""
        height, width = self.admissible(surface, offsets)
        return width, [self.plane(surface, i, j, height, width) for i, j in offsets]

    def _plane(self, surface, i, j, height, width):
        if surface == "twisted-torus":
            start = (self.n2 * i + j) % self.size
            return self.cells[start:] + self.cells[:start]
        rows, j = [], j % self.n2
        for r in range(i, i + height):
            start = r % self.n1 * self.n2
            row = self.cells[start : start + self.n2]
            rows.append((row + row)[j : j + width])
        return b"".join(rows)

    # Masks, which are lists of offsets

    def prove(self, mask):
        """Whether all windows on the profile's surface differ, the rank, and how many differ. None
        if no window lies on the sheet."""
        own = FOLDINGS[self.folding]
        height, width = self.admissible(self.surface, mask)
        if height == 0:
            return None
        contents = len(set(zip(*self.planes(self.surface, mask)[1])))
        rank = self.rank(mask) if self.surface in (own, "sheet") else None
        return {"proved": contents == height * width, "rank": rank, "windows": contents}

    def rank(self, mask):
        """The windows at the first n terms are a basis of all, on the folding's own surface."""
        s, places = self.terms, [self.index(i, j) for i, j in mask]
        return self.field.rank(
            [[s[(t + e) % self.size] for e in places] for t in range(self.n)]
        )

    def distance(self, mask):
        """In how many cells two windows differ at least, on the folding's own surface. The
        difference of two shifts of an m-sequence is a third one, or zeros if they are the same; so
        this is the least number of cells of a window that are not 0."""
        _, planes = self.planes(FOLDINGS[self.folding], mask)
        return min(differences(planes, [0] * len(mask)))


DIFFERS = [bytes(int(a != b) for b in range(256)) for a in range(256)]


def differences(planes, codes):
    """At each position, in how many cells the planes differ from these codes. The bytes of a whole
    plane are added at once, as one large integer, which carries nothing in fewer than 256 steps."""
    if not planes or not planes[0]:
        return b""
    size, groups = len(planes[0]), []
    for start in range(0, len(planes), 255):
        total = 0
        for plane, code in zip(planes[start : start + 255], codes[start : start + 255]):
            total += int.from_bytes(plane.translate(DIFFERS[code]), "little")
        groups.append(total.to_bytes(size, "little"))
    return groups[0] if len(groups) == 1 else [sum(counts) for counts in zip(*groups)]
