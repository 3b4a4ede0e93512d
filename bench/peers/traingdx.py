#!/usr/bin/env python3
"""traingdx of the Neural Network Toolbox of 2002 with numpy; bench/Traingdx.hs compares ours with it.

FIRST.json has the first weights, as 'pra-tactile network' writes weights, and the folder IMAGES is as
'pra-tactile images' writes it. Writes every epoch to TRACE, and prints how many seconds of the processor they took."""
import argparse, csv, json, pathlib, time
import numpy as np


def read_images(folder):
    rows = list(csv.DictReader(open(folder / "labels.csv")))
    values = [np.frombuffer((folder / row["file"]).read_bytes()[-192:], ">u2") / 65535 for row in rows]
    return (np.array(values).T - 0.25) / 0.5, np.array([int(row["class"]) for row in rows])


def error_and_gradient(w, x, t):
    hidden = np.vstack([1 / (1 + np.exp(-(w[0] @ x))), np.ones(x.shape[1])])
    y = 1 / (1 + np.exp(-(w[1] @ hidden)))
    d2 = 2 * (y - t) * y * (1 - y)
    d1 = (w[1][:, :-1].T @ d2) * hidden[:-1] * (1 - hidden[:-1])
    return np.sum((y - t) ** 2), [d1 @ x.T, d2 @ hidden.T]


def traingdx(w, x, t, epochs, lr, least, mc=0.95, up=1.05, down=0.7, most=1.04):
    e, g = error_and_gradient(w, x, t)
    norm = np.sqrt(sum(np.sum(a * a) for a in g))
    dx = [-lr * a for a in g]
    for epoch in range(1, epochs + 1):
        if e <= 0 or norm < least:
            return
        dx = [mc * c - (1 - mc) * lr * a for c, a in zip(dx, g)]
        there = [a + c for a, c in zip(w, dx)]
        e2, g2 = error_and_gradient(there, x, t)
        if e2 / e > most:
            lr, step = lr * down, "undone"
            dx = [-lr * a for a in g]
        else:
            lr, step = (lr * up, "lower") if e2 < e else (lr, "tolerated")
            w, e, g = there, e2, g2
            norm = np.sqrt(sum(np.sum(a * a) for a in g))
        yield epoch, float(e), float(norm), lr, step


parser = argparse.ArgumentParser()
for name, kind, standard in [("--epochs", int, 5000), ("--rate", float, 0.01), ("--least", float, 1e-6)]:
    parser.add_argument(name, type=kind, default=standard)
for name in ["first", "images", "trace"]: parser.add_argument(name, type=pathlib.Path)
given = parser.parse_args()
first = json.loads(given.first.read_text())
images, labels = read_images(given.images)
x = np.vstack([images, np.ones(images.shape[1])])
t = (labels == np.arange(first["outputs"])[:, None]).astype(float)
w = [np.array(first[units]) for units in ["hidden_units", "output_units"]]
start = time.process_time()
run = list(traingdx(w, x, t, given.epochs, given.rate, given.least))
print(time.process_time() - start)
csv.writer(open(given.trace, "w")).writerows([["epoch", "error", "gradient", "rate", "step"], *run])
