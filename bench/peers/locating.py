"""What the peers of locating share: numbers without a pattern, and m-sequences over GF(4)."""

import galois
import numpy as np


def mixed(index):
    """The upper 32 bits of SplitMix64's outputs from the seed 0, by their index."""
    z = np.asarray(index, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ z >> np.uint64(30)) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ z >> np.uint64(27)) * np.uint64(0x94D049BB133111EB)
    return (z ^ z >> np.uint64(31)) >> np.uint64(32)


def sequence(coefficients, length):
    """The first terms of the m-sequence with these coefficients of its polynomial, constant term first, from 0 ... 0 1."""
    field = galois.GF(4)
    h = galois.Poly([1] + coefficients[::-1], field=field)
    register = galois.FLFSR(h.reverse(), state=[1] + [0] * (len(coefficients) - 1))
    return np.asarray(register.step(length)).view(np.ndarray)
