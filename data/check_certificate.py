#!/usr/bin/env python3
"""Check a certificate that 'pra-tactile certificate' wrote, without any of its code: python3 check_certificate.py FILE.
Exit status 0: good, the windows told are all distinct; 1: bad, with the reason. Every step follows from the definitions: the
field GF(q); the order of x modulo h, by which the sequence s(i+n) = -(c0 s(i) + ... + c(n-1) s(i+n-1)) has period q^n - 1;
the fold; then the rank of the alpha^e(i,j), or all windows. Primes below 3317044064679887385961981 are recognised by the
strong test to 13 bases, which decides there (Sorenson and Webster, 2017); larger ones by Pocklington's theorem."""
import hashlib, json, struct, sys
from functools import reduce
from math import gcd

DOMAIN, BASES = 3317044064679887385961981, (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41)

class Bad(Exception): pass

def need(condition, why):
    if not condition:
        raise Bad(why)

def number(x):  # lists of natural numbers, too; those above 2^53 - 1 are decimal strings
    if isinstance(x, list):
        return [number(y) for y in x]
    if isinstance(x, str) and x.isascii() and x.isdigit():
        x = int(x)
    need(type(x) is int and x >= 0, "%r is not a number 0, 1, 2, ..." % (x,))
    return x

def is_prime(n, shown):
    if n >= DOMAIN or n in BASES or n < 2:
        return n in BASES or n in shown
    s = (n - 1 & 1 - n).bit_length() - 1  # n - 1 = 2^s d, d odd
    d = n - 1 >> s
    return all(pow(a, d, n) == 1 or any(pow(a, d << r, n) == n - 1 for r in range(s)) for a in BASES)

def product(powers, bound):
    need(all(a[0] < b[0] for a, b in zip(powers, powers[1:])), "prime factors do not ascend")
    result = 1
    for l, e in powers:
        need(l > 1 and 0 < e < 10000, "a prime factor or its exponent is out of range")
        result *= l**e
        need(result <= bound, "prime factors exceed what they should multiply to")
    return result

def pocklington(shown, proof):
    p, factors = number(proof["prime"]), number(proof["factors"])
    f = product([(l, e) for l, e, a in factors], p)
    need(p > 3 and (p - 1) % f == 0 and f * f > p, "%d: its factors told are not those of %d" % (p, p - 1))
    for l, e, a in factors:
        need(is_prime(l, shown) and pow(a, p - 1, p) == 1 == gcd(pow(a, (p - 1) // l, p) - 1, p), "%d is not shown to be prime" % p)
    return shown | {p}

class Field:  # GF(p)[A] / modulus, an element coded by its base-p digits, lowest degree first
    def __init__(self, q, modulus):
        m, p = len(modulus) - 1, next((d for d in range(2, 257) if q % d == 0), 0)
        need(1 < q <= 256 and m > 0 and p**min(m, 9) == q and modulus[m] == 1 and max(modulus) < p, "there is no such field")
        digits = [[a // p**i % p for i in range(m)] for a in range(q)]
        code = lambda ds: sum(d % p * p**i for i, d in enumerate(ds))
        self.add = [[code(x + y for x, y in zip(a, b)) for b in digits] for a in digits]
        self.neg = [code(-x for x in a) for a in digits]
        def times(a, b):
            acc = [0] * m
            for y in reversed(digits[b]):
                acc = [u - acc[-1] * r + y * v for u, r, v in zip([0] + acc[:-1], modulus, digits[a])]
            return code(acc)
        def powers(g):
            cycle = [1]
            while len(cycle) < q and times(cycle[-1], g) not in (0, 1):
                cycle.append(times(cycle[-1], g))
            return cycle if times(cycle[-1], g) == 1 else []
        cycle = max(map(powers, range(1, q)), key=len)  # a ring of q elements is a field iff one of them has order q - 1
        need(len(cycle) == q - 1, "the modulus factors, so there is no such field")
        log = {a: i for i, a in enumerate(cycle)}
        self.mul = [[cycle[(log[a] + log[b]) % (q - 1)] if a and b else 0 for b in range(q)] for a in range(q)]

    def dot(self, a, b):
        return reduce(lambda total, xy: self.add[total][self.mul[xy[0]][xy[1]]], zip(a, b), 0)

class Residues:  # GF(q)[x] / h, h = x^n + lower, and x^e for e of so many bits
    def __init__(self, f, lower, bits):
        self.f, self.n, self.reduced = f, len(lower), [f.neg[c] for c in lower]
        self.squares = [[0, 1] + [0] * (self.n - 2) if self.n > 1 else self.reduced]
        while len(self.squares) < bits:
            self.squares.append(self.times(self.squares[-1], self.squares[-1]))

    def times(self, a, b):
        add, mul, acc = self.f.add, self.f.mul, [0] * self.n
        for y in reversed(b):  # Horner's rule: acc x + y a, and x^n replaced
            top, scale = mul[acc[-1]], mul[y]
            acc = [add[add[u][top[r]]][scale[v]] for u, r, v in zip([0] + acc[:-1], self.reduced, a)]
        return acc

    def power(self, e):
        return reduce(self.times, (a for i, a in enumerate(self.squares) if e >> i & 1), [1] + [0] * (self.n - 1))

def check(c):
    seal = hashlib.sha256(json.dumps({k: c[k] for k in c if k != "seal"}, sort_keys=True, separators=(",", ":")).encode())
    need(c["seal"] == seal.hexdigest(), "the seal is broken")
    P, E = c["profile"], c["evidence"]
    choices = {"reading": "characteristic reciprocal", "folding": "diagonal row-major", "surface": "torus twisted-torus sheet",
               "packing": "most-significant-first least-significant-first", "schema": "pra-tactile/profile/1"}
    need(c["schema"] == "pra-tactile/certificate/1" and all(P[k] in v.split() for k, v in choices.items()), "a name is unknown")
    q, h, state, (n1, n2), diagonal = *map(number, (P["q"], P["polynomial"], P["state"], P["shape"])), P["folding"] == "diagonal"
    f, n, sheet, twisted = Field(q, number(P["modulus"])), len(h) - 1, P["surface"] == "sheet", P["surface"] == "twisted-torus"
    need(n > 0 and max(h + state) < q and h[n] == 1 and h[0], "the polynomial is not monic with a constant term")
    if P["reading"] == "reciprocal":
        h = [f.mul[x][f.mul[h[0]].index(1)] for x in reversed(h)]
    N, shown = q**n - 1, reduce(pocklington, c["primes"], set())
    ring = Residues(f, h[:n], N.bit_length())
    factors = [(number(x["prime"]), number(x["exponent"])) for x in c["factors"]]
    need(number(c["period"]) == N == product(factors, N), "the period is not q^n - 1, or not the product of the factors")
    need(all(is_prime(l, shown) for l, e in factors), "a factor of q^n - 1 is not shown to be prime")
    need(ring.power(N) == ring.power(0), "x^(q^n - 1) is not 1")
    for (l, e), x in zip(factors, c["factors"]):
        need(ring.power(0) != ring.power(N // l) == number(x["residue"]), "x^((q^n - 1)/%d) is 1, or not the one told" % l)
    need(len(state) == n and any(state), "the initial state does not start the sequence")
    need(n1 * n2 == N and (not diagonal or gcd(n1, n2) == 1), "the sequence does not fill the shape")
    mask = number(c["mask"])
    extent = [1 + max(i for i, j in mask), 1 + max(j for i, j in mask)]
    need(all(mask.count(cell) == 1 for cell in mask) and extent == number(P["window"]), "the window is not the extent of the mask")
    rows, columns = (n1 - extent[0] + 1, n2 - extent[1] + 1) if sheet else (n1, n2)
    need(rows > 0 < columns and number(c["windows"]) == rows * columns, "the surface does not have so many windows")
    if E["road"] == "rank":
        need(sheet or twisted != diagonal, "the rank decides nothing on this surface")
        exponent = lambda i, j: j + n2 * ((i - j) * pow(n2, -1, n1) % n1) if diagonal else i * n2 + j
        vectors, cells, inverse = number(E["vectors"]), number(E["cells"]), number(E["inverse"])
        need(vectors == [ring.power(exponent(i, j) % N) for i, j in mask], "a vector is not the power of alpha that belongs to its cell")
        need(len(cells) == n and cells == sorted(set(cells)) and cells[-1] < len(mask), "the cells are not n of the mask's")
        need([len(x) for x in inverse] == [n] * n and max(map(max, inverse)) < q, "the inverse is not an n x n matrix")
        chosen = list(zip(*(vectors[i] for i in cells)))
        unit = all(f.dot(x, y) == (i == j) for i, x in enumerate(inverse) for j, y in enumerate(chosen))
        return need(unit, "the inverse is wrong, so that rank n is not shown")
    need(E["road"] == "enumeration", "the road is unknown")
    s, at, taps = list(state), bytearray(N), [f.neg[x] for x in h[:n]]
    for i in range(N):
        s.append(f.dot(taps, s[i:]))
        at[i % n1 * n2 + i % n2 if diagonal else i] = s[i]
    digits = list(enumerate(mask if P["packing"] == "least-significant-first" else mask[::-1]))
    index = lambda r, k: (r * n2 + k) % N if twisted else r % n1 * n2 + k % n2
    content = lambda r, k: sum(at[index(r + i, k + j)] * q**e for e, (i, j) in digits)
    seen = sorted((content(r, k), r * n2 + k) for r in range(rows) for k in range(columns))
    need(all(a[0] < b[0] for a, b in zip(seen, seen[1:])), "two windows are the same")
    need(E["sha256"] == hashlib.sha256(b"".join(struct.pack(">Q", p) for w, p in seen)).hexdigest(), "the digest is another")

if __name__ == "__main__":
    try:
        check(json.load(open(sys.argv[-1], encoding="utf-8")))
        print("good")
    except (Bad, OSError, ValueError, TypeError, KeyError, AttributeError, IndexError) as why:
        sys.exit("bad: %s" % (why if isinstance(why, Bad) else "this is no certificate: %r" % why))
