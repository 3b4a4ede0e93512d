"""Facts for the tests, computed by galois and written to test/data, each file with its provenance.

usage, from the repository's root: VENV/bin/python bench/peers/facts.py test/data

All files use the project's conventions (READING.md): an element is coded by the integer whose base-p digits are its
coefficients, lowest degree first; a polynomial is the list of its coefficients' codes, constant term first; s(i + n) =
-(c0 s(i) + ... + c(n-1) s(i + n - 1)). Where galois differs it is converted here, and what was converted is checked."""

import json
import platform
import sys
from pathlib import Path

import galois
import numpy as np

COMMAND = "bench/peers/facts.py test/data"


def ascending(polynomial):
    """galois lists the highest degree first, and the zero polynomial as one zero."""
    return [int(c) for c in reversed(polynomial.coeffs)] if polynomial != 0 else []


def field(q):
    """galois's default moduli are the Conway polynomials, as the project's are."""
    return galois.GF(q)


def modulus(f):
    return ascending(f.irreducible_poly)


def polynomial(f, codes):
    return galois.Poly(list(reversed(codes)), field=f)


def codes(array):
    return [int(c) for c in array]


# -- fields ---------------------------------------------------------------------------------------------------------


def conway():
    """The Conway polynomial of every field of at most 256 elements."""
    records = []
    for q in range(2, 257):
        primes, exponents = galois.factors(q)
        if len(primes) == 1:
            records.append({"q": q, "p": primes[0], "modulus": ascending(galois.conway_poly(primes[0], exponents[0]))})
    return records


def fields():
    """Tables; of the largest field the products of a few rows only, its sums being exclusive ors."""
    records = []
    for q, rows in [(4, None), (9, None), (16, None), (25, None), (27, None), (256, [2, 3, 29, 142, 255])]:
        f = field(q)
        everything = f(np.arange(q))
        chosen = range(q) if rows is None else rows
        record = {"q": q, "modulus": modulus(f), "primitive": int(f.primitive_element)}
        if rows is None:
            record["sums"] = [codes(everything + f(a)) for a in chosen]
            record["products"] = [codes(everything * f(a)) for a in chosen]
        else:
            record["rows"] = {str(a): codes(everything * f(a)) for a in chosen}
        record["negatives"] = codes(-everything)
        record["inverses"] = [None] + codes(everything[1:] ** -1)
        record["powers"] = codes(f.primitive_element ** np.arange(q - 1))
        record["orders"] = [None] + [int(n) for n in everything[1:].multiplicative_order()]
        records.append(record)
    return records


def maps():
    """Trace and norm to the prime field and minimal polynomial over it, of every element."""
    records = []
    for q in [8, 9, 16, 27, 64, 81, 256]:
        f = field(q)
        everything = f(np.arange(q))
        record = {"q": q, "modulus": modulus(f)}
        record["traces"] = codes(everything.field_trace())
        record["norms"] = codes(everything.field_norm())
        if q <= 64:
            record["minimal"] = [ascending(a.minimal_poly()) for a in everything]
        records.append(record)
    return records


# -- polynomials ----------------------------------------------------------------------------------------------------


def primitives():
    """All monic primitive polynomials of a degree, in ascending order, the highest degree compared first."""
    degrees = {2: range(1, 11), 3: range(1, 7), 4: range(1, 6), 5: range(1, 5), 7: range(1, 4), 8: range(1, 4), 9: range(1, 4)}
    records = []
    for q, wanted in degrees.items():
        f = field(q)
        for n in wanted:
            found = [ascending(h) for h in galois.primitive_polys(q, n)]
            records.append({"q": q, "modulus": modulus(f), "degree": n, "polynomials": found})
    return records


def first_primitives():
    """The first primitive polynomial of a degree; none where galois's search takes long."""
    degrees = {2: [16, 32, 64, 89, 107, 127, 128], 3: [8, 12, 20, 30], 4: [6, 8, 12, 16], 5: [6, 8, 12], 8: [5, 8], 9: [4, 6, 10], 16: [3, 5], 25: [3], 27: [3]}
    records = []
    for q, wanted in degrees.items():
        f = field(q)
        records += [{"q": q, "modulus": modulus(f), "degree": n, "polynomial": ascending(galois.primitive_poly(q, n, method="min"))} for n in wanted]
    return records


def irreducible_counts():
    """How many monic irreducible and how many primitive polynomials there are, by listing them."""
    records = []
    for q, largest in [(2, 10), (3, 6), (4, 5), (5, 4), (8, 3), (9, 3)]:
        for n in range(1, largest + 1):
            found = list(galois.irreducible_polys(q, n))
            records.append({"q": q, "modulus": modulus(field(q)), "degree": n, "irreducible": len(found), "primitive": sum(h.is_primitive() for h in found)})
    return records


def arithmetic():
    """Quotients, remainders and monic greatest common divisors of drawn polynomials, half with a common factor."""
    draw = np.random.default_rng(2004)
    records = []
    for q in [2, 3, 4, 9, 16, 27, 256]:
        f = field(q)
        for i in range(12):
            a, b = (galois.Poly(f(draw.integers(0, q, draw.integers(2, 10)))) for _ in range(2))
            if i % 2:
                common = galois.Poly(f(draw.integers(0, q, 4)))
                a, b = a * common, b * common
            if b == galois.Poly.Zero(f):
                continue
            quotient, remainder = divmod(a, b)
            assert quotient * b + remainder == a
            g = galois.gcd(a, b)
            g = g // galois.Poly([g.coeffs[0]], field=f)
            records.append(
                {"q": q, "modulus": modulus(f), "a": ascending(a), "b": ascending(b), "quotient": ascending(quotient), "remainder": ascending(remainder), "gcd": ascending(g)}
            )
    return records


def factorisations():
    """The factors of q^n - 1, primes with their exponents; decimal strings, since many exceed 2^53."""
    wanted = {2: list(range(2, 129)), 3: list(range(1, 51)), 5: list(range(1, 31)), 7: list(range(1, 25))}
    records = []
    for p, exponents in wanted.items():
        for n in exponents:
            primes, multiplicities = galois.factors(p**n - 1) if p**n > 2 else ([], [])
            product = 1
            for l, e in zip(primes, multiplicities):
                product *= l**e
            assert product == p**n - 1
            records.append({"p": p, "n": n, "factors": [[str(l), e] for l, e in zip(primes, multiplicities)]})
    return records


# -- sequences ------------------------------------------------------------------------------------------------------


def obeys(f, h, terms):
    """The project's recurrence."""
    n = len(h) - 1
    windows = [terms[j : len(terms) - n + j] for j in range(n + 1)]
    return not np.any(sum((f(c) * w for c, w in zip(h, windows)), f.Zeros(len(terms) - n)))


def register(f, h, state, count):
    """galois's Fibonacci register takes the feedback polynomial, which is the reciprocal of the characteristic one, and
    its state with the oldest symbol last."""
    terms = galois.FLFSR(polynomial(f, h).reverse(), state=list(reversed(state))).step(count)
    assert codes(terms[: len(state)]) == list(state) and obeys(f, h, terms)
    return terms


def sequences():
    """Terms from the state 0 ... 0 1 and from a drawn one: a whole period and the beginning of the next, or 400 terms."""
    chosen = [
        (2, [1, 1, 0, 0, 1]), (2, [1, 1, 0, 0, 0, 0, 0, 1]), (2, [1, 0, 1, 1, 1, 0, 0, 0, 1]),
        (3, [2, 1, 1]), (3, [1, 2, 0, 1]), (3, [2, 1, 0, 0, 1]),
        (4, [3, 2, 1, 0, 1]), (4, [2, 1, 1]), (4, [2, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1]), (4, [2, 1, 3, 3, 3, 1, 2, 3, 1, 3, 1, 3, 1]),
        (5, None), (5, None), (7, None), (8, None), (9, None), (9, None), (9, None), (16, None), (27, None), (256, None),
    ]  # fmt: skip
    degrees = iter([2, 3, 2, 2, 2, 3, 4, 2, 2, 2])
    draw = np.random.default_rng(53)
    records = []
    for q, h in chosen:
        f = field(q)
        if h is None:
            h = ascending(galois.primitive_poly(q, next(degrees), method="max"))
        n = len(h) - 1
        assert polynomial(f, h).is_primitive() and h[-1] == 1
        count = min(q**n - 1 + 2 * n, 400)
        for state in ([0] * (n - 1) + [1], [int(c) for c in draw.integers(0, q, n - 1)] + [1]):
            records.append({"q": q, "modulus": modulus(f), "polynomial": h, "state": state, "terms": codes(register(f, h, state, count))})
    return records


def distant_terms():
    """Twelve terms from far away, by powers of the companion matrix."""
    records = []
    for q, h in [(2, [1, 1, 0, 0, 1]), (3, [2, 1, 0, 0, 1]), (4, [3, 2, 1, 0, 1]), (4, [2, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1]), (9, None), (256, None)]:
        f = field(q)
        h = h or ascending(galois.primitive_poly(q, 3, method="min"))
        n = len(h) - 1
        step = f.Zeros((n, n))  # the state s(i) ... s(i + n - 1) as a column, one step on
        for i in range(n - 1):
            step[i, i + 1] = 1
        step[n - 1, :] = -f(h[:n])
        start = f([0] * (n - 1) + [1])
        for t in [q**n - 2, 10**6 + 3, 10**18, 10**18 + 12345]:
            power, square, e = f.Identity(n), step, t
            while e:
                power = power @ square if e & 1 else power
                square, e = square @ square, e >> 1
            state = power @ start
            terms = register(f, h, codes(state), 12) if n < 12 else state
            records.append({"q": q, "modulus": modulus(f), "polynomial": h, "from": str(t), "terms": codes(terms)})
    return records


def recurrences():
    """The shortest recurrence, by Berlekamp and Massey, of terms that a drawn recurrence makes from a drawn state."""
    draw = np.random.default_rng(1969)
    records = []
    for q in [2, 3, 4, 5, 9, 16, 256]:
        f = field(q)
        for n in [1, 2, 3, 5, 8]:
            taps = [int(draw.integers(1, q))] + [int(c) for c in draw.integers(0, q, n - 1)] + [1]
            terms = list(f(draw.integers(0, q, n)))
            if not any(terms):
                terms[0] = f(1)
            while len(terms) < 2 * n + 6:
                last = f(terms[-n:])
                terms.append(-np.sum(last * f(taps[:n])))
            terms = f([int(t) for t in terms])
            minimal = ascending(galois.berlekamp_massey(terms, output="characteristic"))
            assert minimal[-1] == 1 and obeys(f, minimal, terms)
            records.append({"q": q, "modulus": modulus(f), "terms": codes(terms), "shortest": minimal})
    return records


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    files = {
        "fields": [("conway", conway), ("fields", fields), ("maps", maps)],
        "polynomials": [("primitives", primitives), ("first_primitives", first_primitives), ("counts", irreducible_counts), ("arithmetic", arithmetic)],
        "factorisations": [("factorisations", factorisations)],
        "sequences": [("sequences", sequences), ("distant_terms", distant_terms), ("recurrences", recurrences)],
    }
    made_by = f"galois {galois.__version__}, numpy {np.__version__}, Python {platform.python_version()}"
    for name, sections in files.items():
        header = {"program": made_by, "command": COMMAND, "conventions": "codes; polynomials constant term first; see the head of the script"}
        texts = [f' "provenance": {json.dumps(header)}']
        for key, make in sections:
            records = ",\n  ".join(json.dumps(r, separators=(",", ":")) for r in make())
            texts.append(f' "{key}": [\n  {records}\n ]')
        (folder / f"{name}.json").write_text("{\n" + ",\n".join(texts) + "\n}\n")
        print(f"wrote {folder / name}.json", file=sys.stderr)


main()
