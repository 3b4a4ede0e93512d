"""The outputs of a network for images of symbols: python3 outputs.py NETWORK.json IMAGE.pgm..., images as
'pra-tactile images' writes them. Python's standard library alone."""
import json, math, struct, sys

network = json.load(open(sys.argv[1]))


def layer(units, values):
    return [1 / (1 + math.exp(-sum(map(float.__mul__, unit, values + [1.0])))) for unit in units]


for name in sys.argv[2:]:
    samples = struct.unpack(">96H", open(name, "rb").read()[-192:])
    image = [(sample / 65535 - 0.25) / 0.5 for sample in samples]
    print(name, *layer(network["output_units"], layer(network["hidden_units"], image)))
