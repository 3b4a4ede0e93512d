"""The operations of the protocol: each takes an array and an input to a result, or refuses."""

from locate import Refused, locate, nearest, posterior
from reading import cells_of, chances, code, demand, integer, many, mask_of, natural, take

LARGEST_PLAIN = 2**53 - 1
LONGEST_RUN = 200_000


class Errored(Exception):
    """There is no saying, for this reason."""


def number(n):
    return n if n <= LARGEST_PLAIN else str(n)


def placed(positions):
    cells = [{"row": r, "column": c} for r, c in positions]
    return {"position": cells[0]} if len(cells) == 1 else {"positions": cells}


def inverse(array, given):
    a = code(array)(take(given, "a"))
    return to_power(array, a, -1)


def power(array, given):
    a = code(array)(take(given, "a"))
    return to_power(array, a, integer(take(given, "exponent")))


def to_power(array, a, exponent):
    try:
        return array.field.power(a, exponent)
    except ZeroDivisionError:
        raise Refused("division-by-zero") from None


def logarithm(array, given):
    a = code(array)(take(given, "a"))
    if a == 0:
        raise Refused("out-of-range")
    return array.field.log[a]


def first_primitive(array, given):
    degree = natural(take(given, "degree"))
    demand(degree > 0)
    return array.field.first_primitive(degree)


def terms(array, given):
    start, length = natural(take(given, "from")), natural(take(given, "length"))
    if length > LONGEST_RUN:
        raise Errored("so many terms do not fit into a line")
    start %= array.size
    return list((array.terms * ((start + length) // array.size + 1))[start : start + length])


def cell(array, given):
    row, column = natural(take(given, "row")), natural(take(given, "column"))
    return array.terms[array.index(row, column)]


def pack(array, given):
    codes = many(take(given, "cells"), code(array))
    demand(len(codes) == array.k1 * array.k2)
    packed = 0
    for c in codes if array.most_significant_first else reversed(codes):
        packed = packed * array.field.q + c
    return number(packed)


def unpack(array, given):
    packed, q, size = natural(take(given, "packed")), array.field.q, array.k1 * array.k2
    if packed >= q**size:
        raise Refused("out-of-range")
    codes = []
    for _ in range(size):
        packed, c = divmod(packed, q)
        codes.append(c)
    return codes[::-1] if array.most_significant_first else codes


def nearest_of(array, given):
    patch = cells_of(take(given, "patch"), code(array))
    radius = take(given, "radius")
    return placed(nearest(array, patch, None if radius is None else natural(radius)))


def prove(array, given):
    proof = array.prove(mask_of(take(given, "mask")))
    if proof is None:
        raise Refused("off-sheet")
    return proof


def of_codes(function, *keys):
    """An operation that takes codes to a code."""

    def operation(array, given):
        return function(array.field, *[code(array)(take(given, key)) for key in keys])

    return operation


OPERATIONS = {
    "add": of_codes(lambda field, a, b: field.add(a, b), "a", "b"),
    "multiply": of_codes(lambda field, a, b: field.multiply(a, b), "a", "b"),
    "negate": of_codes(lambda field, a: field.negate(a), "a"),
    "inverse": inverse,
    "power": power,
    "logarithm": logarithm,
    "trace": of_codes(lambda field, a: field.trace(a), "a"),
    "primitive": lambda array, given: array.field.is_primitive(
        many(take(given, "polynomial"), code(array))
    ),
    "first-primitive": first_primitive,
    "term": lambda array, given: array.terms[natural(take(given, "index")) % array.size],
    "terms": terms,
    "cell": cell,
    "pack": pack,
    "unpack": unpack,
    "locate": lambda array, given: placed(
        locate(array, cells_of(take(given, "patch"), code(array)))
    ),
    "nearest": nearest_of,
    "posterior": lambda array, given: posterior(
        array, cells_of(take(given, "patch"), chances(array))
    ),
    "prove": prove,
    "distance": lambda array, given: array.distance(mask_of(take(given, "mask"))),
}
