"""The galois package (pip install galois) as a subject: its fields, polynomials and registers."""
import functools, galois, inspect, json, math, numpy, sys
GF = functools.partial(galois.GF, compile="python-calculate")  # "auto" would compile for seconds

def demand(condition, reason="invalid"):
    if not condition: raise ValueError(reason)

def whole(x, least=0):  # plainly or as a decimal string; 2.0 and true are no whole numbers
    plain = type(x) is int or type(x) is str and x.isascii() and x.removeprefix("-").isdecimal()
    return int(x) if plain and int(x) >= least else demand(False)

class Decoder:
    def __init__(self, q, modulus, polynomial, reading, state, folding, shape, window, **others):
        (p, *more), (m, *_), n, size = *galois.factors(q), len(state), math.prod(shape)
        demand(q <= 256 and not more and len(modulus) == m + 1 and modulus[-1] == 1)
        demand(size == q**n - 1 and n == len(polynomial) - 1 and any(state))
        demand(1 <= math.prod(window) <= 4096 and (math.gcd(*shape) == 1 or folding == "row-major"))
        self.q, self.GF, irreducible = q, GF(p), galois.Poly(modulus[::-1], field=GF(p))
        if m > 1: self.GF = GF(p, m, irreducible_poly=irreducible)
        demand(self.primitive(polynomial))
        h = galois.Poly(polynomial[::-1], field=self.GF)
        feedback = h.reverse() if reading == "characteristic" else h // h.coeffs[-1]
        self.s = galois.FLFSR(feedback, state=self.GF(state[::-1])).step(size)
    def primitive(self, polynomial):
        f = galois.Poly(self.GF(polynomial[::-1] or [0]))
        return bool(f.coeffs[0] == 1 and f.is_primitive())
    def first_primitive(self, degree):
        tails = ([k // self.q**i % self.q for i in range(degree)] for k in range(self.q**degree))
        return next(h for h in (tail + [1] for tail in tails) if self.primitive(h))
    def power(self, a, exponent):
        demand(a[0] or exponent >= 0, "division-by-zero")
        return a ** (exponent % (self.q - 1) if a[0] else min(exponent, 1))
    def read(self, key, x):
        if key in "ab": return self.GF([whole(x)])
        if key != "polynomial": return whole(x, {"exponent": -math.inf, "degree": 1}.get(key, 0))
        return [int(self.GF(whole(c))) for c in demand(type(x) is list) or x]
    def run(self, operation, input, **others):
        f = OPERATIONS[operation]
        result = f(self, *(self.read(k, input[k]) for k in [*inspect.signature(f).parameters][1:]))
        return result if type(result) in (bool, list) else int(result[0])

OPERATIONS = {"add": lambda d, a, b: a + b, "multiply": lambda d, a, b: a * b,
    "negate": lambda d, a: -a, "inverse": lambda d, a: d.power(a, -1), "power": Decoder.power,
    "logarithm": lambda d, a: numpy.log(a) if a[0] else demand(False, "out-of-range"),
    "trace": lambda d, a: a.field_trace() if d.GF.degree > 1 else a, "primitive": Decoder.primitive,
    "first-primitive": Decoder.first_primitive, "term": lambda d, index: d.s[[index % d.s.size]]}
START, decoder = dict(protocol=1, name="galois", operations=[*OPERATIONS], in_flight=1), None
for request in map(json.loads, sys.stdin):
    reply, profile = {k: request[k] for k in request if k == "sequence"}, request.get("profile")
    if request["command"] == "stop": break
    decoder = None if profile else decoder
    try:
        if profile: decoder = Decoder(**profile)
        result = decoder.run(**request) if decoder and not profile else True
        reply.update({"result": result} if decoder else {"errored": "no profile is in force"})
    except (ValueError, TypeError, KeyError, OverflowError) as error:
        own = {str(error)} & {"division-by-zero", "out-of-range"}
        reply["refused"] = min(own, default="invalid" if decoder else "impossible-profile")
    print(json.dumps(START if request["command"] == "start" else reply), flush=True)
