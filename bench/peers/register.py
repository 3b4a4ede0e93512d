"""A period of the m-sequence of x^12 + x^4 + x^3 + x^2 + A over GF(4), by galois's Fibonacci register.

galois takes the feedback polynomial, the reciprocal of the characteristic one, and the state with the oldest
symbol last; so [1, 0, ..., 0] begins 0, ..., 0, 1."""

import galois
import numpy as np

from measure import serve, timed

PERIOD = 4**12 - 1


def main():
    field = galois.GF(4)
    h = galois.Poly([1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 2], field=field)
    weights = np.arange(PERIOD, dtype=np.int64) % 257

    def measurement():
        register = galois.FLFSR(h.reverse(), state=[1] + [0] * 11)
        seconds, terms = timed(lambda: register.step(PERIOD))
        return PERIOD / seconds, int((np.asarray(terms) * weights).sum())

    serve("m-sequence, GF(4), n = 12", "symbols/s", measurement)


main()
