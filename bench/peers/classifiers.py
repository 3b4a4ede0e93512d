"""Which symbol an image shows: `pra-tactile classify` beside scikit-learn's MLPClassifier, PyTorch, logistic regression and class mean, all on
images that `pra-tactile images --set press` wrote. Peers are trained with images of one seed, and all are tried on images of another, at the
eleven levels of noise of the paper's experiment; what counts is the class with most errors, of its images at all levels together. The peers
have as many hidden units as our network, and every seed of theirs is a row of the spread.

usage: bench/peers/classifiers.py [--program bin/pra-tactile] [--q 4] [--sensor real] [--train 100] [--test 300] [--seeds 8]
needs: numpy, scikit-learn; torch where its row is wanted
"""

import argparse
import json
import pathlib
import re
import subprocess
import tempfile

import numpy

parser = argparse.ArgumentParser()
parser.add_argument("--program", default="bin/pra-tactile")
parser.add_argument("--q", type=int, default=4)
parser.add_argument("--sensor", default="real")
parser.add_argument("--train", type=int, default=100, help="images a class")
parser.add_argument("--test", type=int, default=300, help="images a class")
parser.add_argument("--seeds", type=int, default=8)
options = parser.parse_args()
LEVELS = numpy.arange(11) * 0.05
HIDDEN = max(8, 2 * options.q)


def pressed(folder, count, seed):
    command = ["images", "--set", "press", "--q", str(options.q), "--sensor", options.sensor]
    subprocess.run([options.program, *command, "--count", str(count), "--seed", str(seed), "--output", str(folder)], check=True, capture_output=True)
    paths = sorted(folder.glob("*.pgm"))
    values = []
    for path in paths:
        data = path.read_bytes()
        samples = numpy.frombuffer(data[re.match(rb"P5\s+8\s+12\s+65535\s", data).end() :], ">u2")
        values.append((samples / 65535 - 0.25) / 0.5)
    return numpy.array(values), numpy.array([int(path.name.split("_")[0]) for path in paths])


def written(folder, values):
    """The images as files that `classify` reads, in order: values from -2 to 3 are not clipped."""
    folder.mkdir()
    for i, image in enumerate(values):
        samples = numpy.clip((image * 0.2 + 0.4) * 65535, 0, 65535).round().astype(">u2")
        (folder / f"{i:06}.pgm").write_bytes(b"P5\n8 12\n65535\n" + samples.tobytes())
    return "".join(f"{folder}/{i:06}.pgm\n" for i in range(len(values)))


def ours(folder, values, classifier):
    command = ["classify", "--batch", "--levels", "0.4,0.6", "--q", str(options.q), "--classifier", classifier, "--json"]
    run = subprocess.run([options.program, *command], input=written(folder, values), capture_output=True, text=True)
    answers = [json.loads(line) for line in run.stdout.splitlines()]
    # The likeliest class, whichever way up, and whether or not it is told for sure: of twice as many cases as the peers choose from.
    return numpy.array([numpy.argmax(answer["probabilities"]) for answer in answers])


def outputs(folder, values):
    """By the outputs of the shipped network alone, as the peers: for who knows that the image is upright."""
    subprocess.run([options.program, "network", "--q", str(options.q), "--output", str(folder)], check=True, capture_output=True)
    network = json.loads(folder.read_text())
    for units in (network["hidden_units"], network["output_units"]):
        values = 1 / (1 + numpy.exp(-(numpy.column_stack([values, numpy.ones(len(values))]) @ numpy.array(units).T)))
    return values.argmax(1)


def by_scikit(x, y, seed):
    from sklearn.neural_network import MLPClassifier

    return MLPClassifier((HIDDEN,), activation="logistic", max_iter=2000, random_state=seed).fit(x, y).predict


def by_logistic(x, y, seed):
    from sklearn.linear_model import LogisticRegression

    return LogisticRegression(max_iter=2000).fit(x, y).predict


def by_mean(x, y, seed):
    means = numpy.array([standardised(x[y == k]).mean(0) for k in range(options.q)])
    return lambda images: (standardised(images) @ standardised(means).T).argmax(1)


def standardised(images):
    centred = images - images.mean(1, keepdims=True)
    return centred / numpy.linalg.norm(centred, axis=1, keepdims=True)


def by_torch(x, y, seed):
    import torch

    torch.manual_seed(seed)
    torch.set_num_threads(1)
    net = torch.nn.Sequential(torch.nn.Linear(96, HIDDEN), torch.nn.Sigmoid(), torch.nn.Linear(HIDDEN, options.q))
    inputs, labels = torch.tensor(x, dtype=torch.float32), torch.tensor(y)
    optimiser = torch.optim.Adam(net.parameters(), lr=0.01)
    for _ in range(1000):
        optimiser.zero_grad()
        torch.nn.functional.cross_entropy(net(inputs), labels).backward()
        optimiser.step()
    return lambda images: net(torch.tensor(images, dtype=torch.float32)).argmax(1).numpy()


def worst(told, labels):
    """The share that is told wrong of the images of a class at all levels together, per cent, of the class where it is greatest."""
    return max(100 * numpy.mean([level[labels == k] != k for level in told]) for k in range(options.q))


with tempfile.TemporaryDirectory() as place:
    place = pathlib.Path(place)
    clean, labels = pressed(place / "train", options.train, 101)
    images, truth = pressed(place / "test", options.test, 102)
    noise = numpy.random.default_rng(1)
    noisy = [images + noise.normal(0, level, images.shape) for level in LEVELS]
    # As the shipped regimen has it, peers learn from clean images and from noisy ones.
    x = numpy.vstack([clean] + [clean + noise.normal(0, level, clean.shape) for level in (0.1, 0.2, 0.3)])
    y = numpy.tile(labels, 4)
    print(f"q = {options.q}, {options.sensor}: {len(y)} images to train with, {len(truth)} to try at each level, {HIDDEN} hidden units")
    told = [outputs(place / "network.json", level) for level in noisy]
    print(f"pra-tactile's outputs    {worst(told, truth):6.2f} %")
    for classifier in ("network", "means", "logistic"):
        told = [ours(place / f"{classifier}{i}", level, classifier) for i, level in enumerate(noisy)]
        print(f"pra-tactile {classifier:12} {worst(told, truth):6.2f} %", flush=True)
    for name, train, seeds in (
        ("scikit-learn MLP", by_scikit, options.seeds),
        ("PyTorch", by_torch, options.seeds),
        ("scikit-learn logistic", by_logistic, 1),
        ("class mean", by_mean, 1),
    ):
        try:
            found = sorted(worst([predict(level) for level in noisy], truth) for predict in (train(x, y, seed) for seed in range(seeds)))
        except (ImportError, ValueError) as missing:
            print(f"{name:24} not here: {missing}"[:100])
            continue
        print(f"{name:24} {numpy.median(found):6.2f} %  [{found[0]:.2f}..{found[-1]:.2f}] of {seeds} seeds", flush=True)
