#!/usr/bin/env python3
"""How many seconds of the processor numpy takes for a network's outputs for COUNT images, and their sum; bench/Traingdx.hs runs it. The
value k of the images is (k + SEED) * 2654435761 modulo 2^32, over 2^32.

usage: bench/peers/outputs.py FIRST.json COUNT SEED, as for traingdx.py"""
import json, pathlib, sys, time
import numpy as np

first = json.loads(pathlib.Path(sys.argv[1]).read_text())
units = [np.array(first[which]) for which in ("hidden_units", "output_units")]
count, seed = map(int, sys.argv[2:])
x = ((np.arange(96 * count, dtype=np.uint64) + seed) * 2654435761 % 2**32 / 2**32).reshape(96, count)
start = time.process_time()
for weights in units:
    x = 1 / (1 + np.exp(-(weights[:, :-1] @ x + weights[:, -1:])))
total = x.sum()
print(time.process_time() - start, total)
