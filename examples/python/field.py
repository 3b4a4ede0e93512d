"""The field GF(q), q = p^m, of at most 256 elements, and polynomials over it.

An element is its code: the number whose base-p digits are the coefficients of a polynomial over the
integers modulo p, lowest degree first. Products are reduced by the modulus. In GF(4) with the
modulus 1,1,1 the codes 0, 1, 2, 3 are 0, 1, A and A + 1. Polynomials over the field are lists of
codes, the constant term first.
"""

from functools import lru_cache
from itertools import count
from math import gcd


class Impossible(Exception):
    """There is no such field, polynomial or array."""


class Field:
    """Tables of powers and logarithms to the base of the smallest primitive element."""

    def __init__(self, q, modulus):
        self.q = q
        self.p, self.m = prime_power(q)
        if len(modulus) != self.m + 1 or modulus[-1] != 1 or max(modulus) >= self.p:
            raise Impossible("the modulus is not monic of degree m over the integers modulo p")
        self.modulus = modulus
        # An element of order q - 1 exists exactly if all others but 0 are its powers, and so have
        # inverses: exactly if the modulus is irreducible.
        cycles = (self._powers(g) for g in range(1, q))
        self.exp = next((c for c in cycles if len(c) == q - 1 and 0 not in c), None)
        if self.exp is None:
            raise Impossible("the modulus is reducible")
        self.log = {a: i for i, a in enumerate(self.exp)}
        self.negatives = [self.code([-x for x in self.digits(a)]) for a in range(q)]
        self.sums = lru_cache(maxsize=None)(self._sums)

    def digits(self, a):
        return [a // self.p**k % self.p for k in range(self.m)]

    def code(self, digits):
        return sum(d % self.p * self.p**k for k, d in enumerate(digits))

    def _product(self, a, b):
        """By the definition: multiply the polynomials, then take away multiples of the modulus."""
        product = [0] * (2 * self.m - 1)
        for i, x in enumerate(self.digits(a)):
            for j, y in enumerate(self.digits(b)):
                product[i + j] += x * y
        for top in range(2 * self.m - 2, self.m - 1, -1):
            for k, c in enumerate(self.modulus):
                if k < self.m:
                    product[top - self.m + k] -= product[top] * c
        return self.code(product[: self.m])

    def _powers(self, g):
        """1, g, g^2, ... until one of them comes again."""
        powers = [1]
        while (power := self._product(powers[-1], g)) not in powers:
            powers.append(power)
        return powers

    def _sums(self, a):
        """a + b for every b: a row of the table, made when it is first used."""
        rows = [self.digits(b) for b in range(self.q)]
        return [self.code([x + y for x, y in zip(self.digits(a), b)]) for b in rows]

    def add(self, a, b):
        return a ^ b if self.p == 2 else self.sums(a)[b]

    def negate(self, a):
        return self.negatives[a]

    def multiply(self, a, b):
        if a == 0 or b == 0:
            return 0
        return self.exp[(self.log[a] + self.log[b]) % (self.q - 1)]

    def power(self, a, exponent):
        """a^exponent for any integer; 0^0 = 1. ZeroDivisionError for 0 to a negative one."""
        if a == 0:
            if exponent < 0:
                raise ZeroDivisionError
            return int(exponent == 0)
        return self.exp[self.log[a] * exponent % (self.q - 1)]

    def trace(self, a):
        """a + a^p + ... + a^(p^(m-1)), an element of the prime field."""
        total = 0
        for k in range(self.m):
            total = self.add(total, self.power(a, self.p**k))
        return total

    def rank(self, rows):
        """The rank of a matrix, by elimination."""
        rows, rank = [list(row) for row in rows], 0
        for column in range(len(rows[0])):
            pivot = next((r for r in range(rank, len(rows)) if rows[r][column]), None)
            if pivot is None:
                continue
            rows[rank], rows[pivot] = rows[pivot], rows[rank]
            inverse = self.power(rows[rank][column], -1)
            for row in rows[rank + 1 :]:
                if row[column]:
                    factor = self.negate(self.multiply(row[column], inverse))
                    row[:] = [
                        self.add(x, self.multiply(factor, y)) for x, y in zip(row, rows[rank])
                    ]
            rank += 1
            if rank == len(rows):
                break
        return rank

    # Polynomials over the field

    def times(self, f, g, h):
        """f g modulo h, which is monic; f and g have as many coefficients as h below its top."""
        n = len(h) - 1
        product = [0] * (2 * n - 1)
        for i, a in enumerate(f):
            if a:
                for j, b in enumerate(g):
                    product[i + j] = self.add(product[i + j], self.multiply(a, b))
        for top in range(2 * n - 2, n - 1, -1):
            self._reduce(product, top, h)
        return product[:n]

    def _reduce(self, coefficients, top, h):
        n = len(h) - 1
        factor = self.negate(coefficients[top])
        if factor:
            for k in range(n):
                coefficients[top - n + k] = self.add(
                    coefficients[top - n + k], self.multiply(factor, h[k])
                )

    def x_to(self, exponent, h):
        """x^exponent modulo h."""
        n = len(h) - 1
        power = [1] + [0] * (n - 1)
        for bit in bin(exponent)[2:]:
            power = self.times(power, power, h)
            if bit == "1":
                shifted = [0] + power
                self._reduce(shifted, n, h)
                power = shifted[:n]
        return power

    def is_primitive(self, h):
        """Whether x has the order q^n - 1 modulo h, n its degree. Then h is irreducible as well."""
        h = h[: max((i + 1 for i, c in enumerate(h) if c), default=0)]
        n = len(h) - 1
        if n < 1 or h[-1] != 1 or h[0] == 0:
            return False
        # The product of the roots, (-1)^n h(0), is the norm of each, which is then primitive.
        norm = h[0] if n % 2 == 0 else self.negate(h[0])
        if gcd(self.log[norm], self.q - 1) > 1:
            return False
        one = [1] + [0] * (n - 1)
        order = self.q**n - 1
        return self.x_to(order, h) == one and all(
            self.x_to(order // r, h) != one for r in prime_factors(order)
        )

    def first_primitive(self, degree):
        """The first one of the degree, the coefficients compared from the highest degree down."""
        for number in count(1):
            h = [number // self.q**k % self.q for k in range(degree)] + [1]
            if self.is_primitive(h):
                return h


def prime_power(q):
    """p and m with q = p^m <= 256."""
    if 2 <= q <= 256:
        p = next(d for d in range(2, q + 1) if q % d == 0)
        m = next(m for m in count(1) if p**m >= q)
        if p**m == q:
            return p, m
    raise Impossible("q is no prime power up to 256")


def is_prime(n):
    """Miller and Rabin's test; with these bases no composite number below 2^64 passes."""
    bases = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)
    if n < 2 or any(n % b == 0 for b in bases):
        return n in bases
    s = ((n - 1) & (1 - n)).bit_length() - 1
    for b in bases:
        x = pow(b, n >> s, n)
        if x != 1 and all(pow(x, 1 << k, n) != n - 1 for k in range(s)):
            return False
    return True


def prime_factors(n):
    """The set of primes that divide n: small ones by trial, others by Pollard's rho."""
    if n == 1:
        return set()
    for d in range(2, 1000):
        if n % d == 0:
            return {d} | prime_factors(without(n, d))
    if is_prime(n):
        return {n}
    d = next(d for d in (rho(n, c) for c in count(1)) if d != n)
    return prime_factors(d) | prime_factors(n // d)


def without(n, d):
    while n % d == 0:
        n //= d
    return n


def rho(n, c):
    """A divisor of n above 1, perhaps n itself: where x -> x^2 + c runs into a cycle."""
    slow = fast = 2
    d = 1
    while d == 1:
        slow = (slow * slow + c) % n
        fast = (fast * fast + c) % n
        fast = (fast * fast + c) % n
        d = gcd(slow - fast, n)
    return d
