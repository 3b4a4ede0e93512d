"""Products of two vectors of 10^7 elements, by galois. usage: products.py Q"""

import sys

import galois
import numpy as np

from measure import serve, timed

COUNT = 10**7


def scrambled(multiplier, q):
    """Codes without a pattern that a cache could profit from; the benchmarks in Haskell make the same."""
    i = np.arange(COUNT, dtype=np.uint64)
    return ((i * np.uint64(multiplier) >> np.uint64(16)) % np.uint64(q)).astype(np.uint8)


def main():
    q = int(sys.argv[1])
    field = galois.GF(q)
    x, y = field(scrambled(2654435761, q)), field(scrambled(2246822519, q))

    def measurement():
        seconds, product = timed(lambda: x * y)
        return COUNT / seconds, int(np.asarray(product).astype(np.int64).sum())

    serve(f"products, GF({q})", "products/s", measurement)


main()
