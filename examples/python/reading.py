"""What requests bring, checked: each function returns what it was given, or refuses it."""

from field import Impossible
from folding import FOLDINGS, Array
from locate import Refused


def demand(condition):
    if not condition:
        raise Refused("invalid")


def integer(value):
    """A whole number, plainly or as a decimal string. 2.0 is a float, and true is a bool."""
    if type(value) is str:
        digits = value.removeprefix("-")
        demand(digits.isascii() and digits.isdigit() and len(digits) <= 4096)
        return int(value)
    demand(type(value) is int)
    return value


def natural(value):
    number = integer(value)
    demand(number >= 0 and value != "-0")
    return number


def many(value, item):
    demand(type(value) is list)
    return [item(x) for x in value]


def code(array):
    def read(value):
        element = natural(value)
        demand(element < array.field.q)
        return element

    return read


def cells_of(value, item):
    """The observed cells of a patch by their offsets; null is a cell that was not observed."""
    rows = many(value, lambda row: many(row, lambda x: None if x is None else item(x)))
    demand(rows and rows[0] and all(len(row) == len(rows[0]) for row in rows))
    return {(i, j): x for i, row in enumerate(rows) for j, x in enumerate(row) if x is not None}


def chances(array):
    """The probability of each code: a code is certain, a list is divided by its sum."""
    q = array.field.q

    def read(value):
        if type(value) is not list:
            certain = code(array)(value)
            return [float(k == certain) for k in range(q)]
        demand(len(value) == q)
        demand(all(type(x) in (int, float) and 0 <= x <= 2 for x in value))
        total = sum(value)
        demand(abs(total - 1) <= 0.001 + 1e-12)
        return [x / total for x in value]

    return read


def mask_of(value):
    """The offsets that a drawing such as ##./.## marks; rows and columns that are blank at its end
    do not show in them."""
    demand(type(value) is str and set(value) <= set("#./"))
    rows = value.split("/")
    demand(all(len(row) == len(rows[0]) for row in rows))
    offsets = [(i, j) for i, row in enumerate(rows) for j, c in enumerate(row) if c == "#"]
    demand(1 <= len(offsets) <= 4096)
    return offsets


def pair(value):
    numbers = many(value, natural)
    demand(len(numbers) == 2)
    return numbers


def among(*names):
    def read(value):
        demand(type(value) is str and value in names)
        return value

    return read


PROFILE = {
    "schema": among("pra-tactile/profile/1"),
    "q": natural,
    "modulus": lambda value: many(value, natural),
    "polynomial": lambda value: many(value, natural),
    "reading": among("characteristic", "reciprocal"),
    "state": lambda value: many(value, natural),
    "folding": among(*FOLDINGS),
    "shape": pair,
    "window": pair,
    "surface": among("torus", "twisted-torus", "sheet"),
    "packing": among("most-significant-first", "least-significant-first"),
}


def array_of(profile):
    demand(type(profile) is dict)
    try:
        return Array({key: read(take(profile, key)) for key, read in PROFILE.items()})
    except Impossible:
        raise Refused("impossible-profile") from None


def take(given, key):
    demand(type(given) is dict and key in given)
    return given[key]
