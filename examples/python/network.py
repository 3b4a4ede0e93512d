"""The network: its outputs for an image, and its training. It needs no array."""

import math

from reading import demand, many, natural, take


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


def slopes(hidden, output, images):
    """The sum of squared errors, and minus its derivative by every weight and bias."""
    error, total = 0.0, [0.0] * (97 * len(hidden) + (len(hidden) + 1) * len(output))
    for x, label in images:
        h = layer(hidden, x)
        z = layer(output, h)
        off = [v - (k == label) for k, v in enumerate(z)]
        above = [2 * d * v * (1 - v) for d, v in zip(off, z)]
        below = [y * (1 - y) * dot(above, [unit[j] for unit in output]) for j, y in enumerate(h)]
        error += dot(off, off)
        products = [d * v for d in below for v in x + [1.0]]
        products += [d * v for d in above for v in h + [1.0]]
        total = [t - p for t, p in zip(total, products)]
    return error, total


def descend(given):
    hidden, output = weights(given)
    images = many(
        take(given, "images"), lambda one: (image(take(one, "rows")), natural(take(one, "class")))
    )
    epochs = natural(take(given, "epochs"))
    keys = "rate", "momentum", "goal", "least_gradient"
    rate, momentum, goal, least = (real(take(given, key)) for key in keys)
    demand(images and all(label < len(output) for _, label in images) and epochs <= 50)
    demand(rate > 0 and 0 <= momentum <= 1 and goal >= 0 and least >= 0)
    inner, width = 97 * len(hidden), len(hidden) + 1

    def at(point):
        rows = [point[i : i + 97] for i in range(0, inner, 97)]
        return slopes(rows, [point[i : i + width] for i in range(inner, len(point), width)], images)

    point, step = sum(hidden + output, []), "begun"
    error, slope = at(point)
    change = [rate * g for g in slope]
    while error > goal and epochs > 0 and math.sqrt(dot(slope, slope)) >= least:
        epochs -= 1
        change = [momentum * c + (1 - momentum) * rate * g for c, g in zip(change, slope)]
        there = [p + c for p, c in zip(point, change)]
        error_there, slope_there = at(there)
        if error_there > 1.04 * error:
            step, rate = "undone", 0.7 * rate
            change = [rate * g for g in slope]
            continue
        step = "lower" if error_there < error else "tolerated"
        rate *= 1.05 if step == "lower" else 1
        point, error, slope = there, error_there, slope_there
    return {"error": error, "rate": rate, "step": step}


OPERATIONS = {"outputs": outputs, "descend": descend}
