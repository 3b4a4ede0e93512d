#!/usr/bin/env python3
"""How many seconds of the processor numpy takes for a network's outputs for COUNT images, here of noise; bench/Traingdx.hs runs it.

usage: bench/peers/outputs.py FIRST.json COUNT, as for traingdx.py"""
import json, pathlib, sys, time
import numpy as np

first = json.loads(pathlib.Path(sys.argv[1]).read_text())
units = [np.array(first[which]) for which in ("hidden_units", "output_units")]
x = np.random.default_rng(1).random((96, int(sys.argv[2])))
start = time.process_time()
for weights in units:
    x = 1 / (1 + np.exp(-(weights[:, :-1] @ x + weights[:, -1:])))
x.sum()
print(time.process_time() - start)
