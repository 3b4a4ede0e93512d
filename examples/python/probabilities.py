"""What images of symbols show: python3 probabilities.py NETWORK.json SHAPES.txt IMAGE.pgm..., a line each of the probabilities of
the classes, and last that of another shape. Python's standard library alone; docs/explanation/network.md has the formulas."""
import json, math, re, struct, sys

network, sure = (lambda n: (n, n["calibration"]))(json.load(open(sys.argv[1])))
rows = [[float(c == "#") for c in row] for row in re.findall("^[#.]{8}$", open(sys.argv[2]).read(), re.M)]
shapes = [rows[i : i + 12] for i in range(0, len(rows), 12)]
STEPS = (-0.5, 0.0, 0.5)


def layer(units, values):
    return [1 / (1 + math.exp(-sum(map(float.__mul__, unit, values + [1.0])))) for unit in units]


def moved(shape, right, down):
    at = lambda x, y: shape[y][x] if 0 <= x < 8 and 0 <= y < 12 else 0.0
    near = lambda t: [(math.floor(t), math.floor(t) + 1 - t), (math.floor(t) + 1, t - math.floor(t))]
    return [sum(v * u * at(i, j) for j, v in near(y - down) for i, u in near(x - right)) for y in range(12) for x in range(8)]


def centred(values):
    return [v - sum(values) / len(values) for v in values]


def correlation(a, b):
    return sum(map(float.__mul__, a, b)) / math.sqrt(sum(v * v for v in a) * sum(v * v for v in b))


def free(z):
    blocks = sorted((sum(z[8 * (y + j) + x + i] for j in (0, 1) for i in (0, 1)) / 4 for y in range(0, 12, 2) for x in range(0, 8, 2)), reverse=True)
    return max(sum(blocks[:k]) / math.sqrt(sum(v * v for v in z) / 4 * k * (24 - k) / 24) for k in range(8, 17))


weight = lambda s: -math.log(max(0.01, 1 - max(0.0, s) ** 2))
seen = [[centred(moved(shape, r, d)) for r in STEPS for d in STEPS] for shape in shapes]
for name in sys.argv[3:]:
    image = [(s / 65535 - 0.25) / 0.5 for s in struct.unpack(">96H", open(name, "rb").read()[-192:])]
    told = []
    for values in (image, image[::-1]):
        outputs = layer(network["output_units"], layer(network["hidden_units"], values))
        for c, o in enumerate(min(1 - 1e-15, max(1e-15, o)) for o in outputs):
            told.append((math.log(o / (1 - o)), max(correlation(centred(values), t) for t in seen[c]), c))
    scores = [sure["per_logit"] * z + sure["per_likeness"] * weight(s) + sure["classes"][c] for z, s, c in told]
    z, s, _ = told[scores.index(max(scores))]
    ratio = sum(map(float.__mul__, map(float, sure["none"]), [1.0, weight(free(centred(image))) - weight(s), s, z]))
    none = 1 / (1 + math.exp(-max(-9, min(9, ratio))))
    powers = [math.exp(score - max(scores)) for score in scores]
    print(name, *((1 - none) * sum(p for p, t in zip(powers, told) if t[2] == c) / sum(powers) for c in range(len(shapes))), none)
