"""Primitive polynomials by galois. usage: primitive.py first Q N | primitive.py all Q N

"first" is the first in lexicographic order, "all" is all of the degree. galois remembers what it has found, so its
memory is cleared before each measurement."""

import functools
import gc
import sys

import galois

from measure import serve, timed


def forget():
    for thing in gc.get_objects():
        if type(thing) is functools._lru_cache_wrapper and thing.__module__.startswith("galois"):
            thing.cache_clear()


def codes(polynomial):
    """Coefficient codes, constant term first."""
    return ",".join(str(int(c)) for c in reversed(polynomial.coeffs))


def main():
    which, q, n = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    galois.GF(q)

    def measurement():
        forget()
        if which == "first":
            seconds, h = timed(lambda: galois.primitive_poly(q, n, method="min"))
            return seconds, codes(h)
        seconds, found = timed(lambda: list(galois.primitive_polys(q, n)))
        return seconds, " ".join(map(codes, found))

    serve(f"{which} primitive, GF({q}), n = {n}", "s", measurement)


main()
