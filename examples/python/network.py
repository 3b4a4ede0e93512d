"""The network: its outputs for an image. It needs no array."""

import math

from reading import demand, many, take


def real(value):
    demand(type(value) in (int, float) and abs(value) <= 1e15)
    return float(value)


def reals(value):
    return many(value, lambda row: many(row, real))


def image(value):
    rows = reals(value)
    demand([len(row) for row in rows] == [8] * 12)
    return sum(rows, [])


def weights(given):
    hidden, output = reals(take(given, "hidden")), reals(take(given, "output"))
    demand(hidden and output and all(len(unit) == 97 for unit in hidden))
    demand(all(len(unit) == len(hidden) + 1 for unit in output))
    return hidden, output


def logistic(a):
    return 1 / (1 + math.exp(-a)) if a > -700 else 0.0


def dot(a, b):
    return sum(map(float.__mul__, a, b))


def layer(units, inputs):
    return [logistic(dot(unit, inputs + [1.0])) for unit in units]


def outputs(given):
    hidden, output = weights(given)
    return layer(output, layer(hidden, image(take(given, "rows"))))


OPERATIONS = {"outputs": outputs}
