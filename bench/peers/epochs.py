#!/usr/bin/env python3
"""How many seconds of the processor 5000 epochs take scikit-learn and PyTorch: gradient descent with momentum on all images at once, on as
many sigmoid units, from the same first weights where they can be told. Prints a line each, the best of three; bench/Traingdx.hs runs it.

usage: bench/peers/epochs.py FIRST.json IMAGES, as for traingdx.py"""
import json, pathlib, sys, time, warnings
import numpy as np

first = json.loads(pathlib.Path(sys.argv[1]).read_text())
folder = pathlib.Path(sys.argv[2])
names = [line.split(",")[0] for line in (folder / "labels.csv").read_text().split()[1:]]
x = (np.array([np.frombuffer((folder / name).read_bytes()[-192:], ">u2") / 65535 for name in names]) - 0.25) / 0.5
labels = np.array([int(name.split("_")[0]) for name in names])
units = [np.array(first[which]) for which in ("hidden_units", "output_units")]
EPOCHS = 5000


def by_scikit():
    from sklearn.neural_network import MLPClassifier

    warnings.filterwarnings("ignore")
    rule = dict(solver="sgd", momentum=0.95, nesterovs_momentum=False, batch_size=len(x), learning_rate_init=0.01, alpha=0, tol=0)
    net = MLPClassifier((len(units[0]),), activation="logistic", max_iter=EPOCHS, n_iter_no_change=EPOCHS + 1, **rule)
    return lambda: net.fit(x, labels)


def by_torch():
    import torch

    torch.set_num_threads(1)
    layers = [torch.nn.Linear(u.shape[1] - 1, u.shape[0]) for u in units]
    for layer, u in zip(layers, units):
        layer.weight.data, layer.bias.data = torch.tensor(u[:, :-1]), torch.tensor(u[:, -1])
    net = torch.nn.Sequential(layers[0], torch.nn.Sigmoid(), layers[1], torch.nn.Sigmoid())
    inputs, targets = torch.tensor(x), torch.tensor(labels[:, None] == np.arange(len(units[1]))).double()
    rule = torch.optim.SGD(net.parameters(), lr=0.01, momentum=0.95)

    def run():
        for _ in range(EPOCHS):
            rule.zero_grad()
            ((net(inputs) - targets) ** 2).sum().backward()
            rule.step()

    return run


def seconds(run):
    start = time.process_time()
    run()
    return time.process_time() - start


for name, prepare in (("scikit-learn", by_scikit), ("PyTorch", by_torch)):
    try:
        print(f"{name} {min(seconds(prepare()) for _ in range(3)):.3f}", flush=True)
    except ImportError:
        print(f"{name} not here", flush=True)
