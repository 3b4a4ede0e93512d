"""Registration of pairs of frames: `pra-tactile register --batch` beside scikit-image, OpenCV, m2stitch and Ashlar.

Every pair is two 16 x 16 frames of a face of symbols, 16-bit PGM files on disk, 0.45 + 0.1 times the relief, so that no noise is
clipped. The second lies 8 taxels right of or below the first, with whole errors uniform on -2 .. 2 on both axes. Right is within
0.75 taxel on both axes; a refusal counts by its `best`. numpy, TM_CCOEFF_NORMED and m2stitch are held to the search of 3 taxels, ECC and
Ashlar start from the nominal step; phase_cross_correlation takes neither.

usage: bench/peers/stitching.py [--program bin/pra-tactile] [--pairs 1000] [--seed 1] [--real FOLDER] [--realistic] [--felt] [--mosaics N] [--json FILE]
needs: numpy, scipy; scikit-image, opencv-python-headless, m2stitch and ashlar where their rows are wanted
"""

import argparse
import json
import math
import pathlib
import re
import subprocess
import tempfile
import time
import warnings

import numpy as np
from scipy.special import ndtr

SIDE, PITCH_X, PITCH_Y, BLUR, SEARCH = 16, 16, 20, 0.7, 3
LEVELS = [0, 0.1, 0.2, 0.3, 0.5]
HERE = pathlib.Path(__file__).resolve().parent


def alphabet():
    """The shapes of `data/shapes.txt`, 12 rows of 8."""
    shapes = []
    for line in (HERE.parent.parent / "data" / "shapes.txt").read_text().splitlines():
        if line.startswith("symbol"):
            shapes.append([])
        elif line.strip() and not line.startswith(";"):
            shapes[-1].append([c == "#" for c in line.rstrip()])
    return np.array(shapes, float)


def symbols_of_the_array(program):
    text = subprocess.run([program, "array", "--format", "csv"], check=True, capture_output=True, text=True).stdout
    rows = [line.split(",") for line in text.splitlines() if line.strip()]
    code = {"0": 0, "1": 1, "2": 2, "3": 3, "A": 2, "A^2": 3}
    return np.array([[code[c.strip()] for c in row] for row in rows if all(c.strip() in code for c in row)])


def seen(shapes, array, x, y, turn=0.0):
    """What a frame reads whose pixel (0, 0) lies at (x, y), taxels: the relief under a normal blur, exactly.

    A turned frame (degrees, about its centre) takes each symbol's taxels for round, which a blur nearly makes them."""
    v, u = np.mgrid[0:SIDE, 0:SIDE].astype(float)
    c = (SIDE - 1) / 2
    a = math.radians(turn)
    px = x + c + math.cos(a) * (u - c) - math.sin(a) * (v - c)
    py = y + c + math.sin(a) * (u - c) + math.cos(a) * (v - c)
    image = np.zeros((SIDE, SIDE))
    for i in range(int((y - 8) // PITCH_Y), int((y + SIDE + 8) // PITCH_Y) + 1):
        for j in range(int((x - 8) // PITCH_X), int((x + SIDE + 8) // PITCH_X) + 1):
            shape = shapes[array[i % array.shape[0], j % array.shape[1]]]
            for b, a_ in zip(*np.nonzero(shape)):
                dx, dy = px - (PITCH_X * j + 4 + a_), py - (PITCH_Y * i + 4 + b)
                near = (abs(dx) < 4) & (abs(dy) < 4)
                if near.any():
                    share = lambda t: ndtr((t + 0.5) / BLUR) - ndtr((t - 0.5) / BLUR)
                    image[near] += share(dx[near]) * share(dy[near])
    return image


def write(path, image):
    values = np.clip(np.round(image * 65535), 0, 65535).astype(">u2")
    path.write_bytes(b"P5\n%d %d\n65535\n" % (image.shape[1], image.shape[0]) + values.tobytes())
    return values.astype(float) / 65535


def simulated(folder, program, noise, pairs, seed, realistic=False, reliefs=None):
    """Pairs on disk: each the names, the images, the nominal step and the true one.

    How far the relief of the true overlap ranges, without noise, is appended to `reliefs`."""
    rng = np.random.default_rng([seed, int(1000 * noise), realistic])
    shapes, array = alphabet(), symbols_of_the_array(program)
    pattern = 0.1 * rng.standard_normal((SIDE, SIDE)) if realistic else 0
    for k in range(pairs):
        step = np.array([8, 0] if rng.integers(2) else [0, 8])
        true = step + rng.integers(-2, 3, 2)
        x, y = rng.uniform(0, PITCH_X * array.shape[1]), rng.uniform(0, PITCH_Y * array.shape[0])
        turns = rng.normal(0, 1.5, 2) if realistic else (0, 0)
        images = []
        for name, dx, dy, turn in (("a", 0, 0, turns[0]), ("b", true[0], true[1], turns[1])):
            relief = seen(shapes, array, x + dx, y + dy, turn) + pattern
            if name == "a" and reliefs is not None:
                reliefs.append(np.ptp(relief[max(0, true[1]):SIDE + min(0, true[1]), max(0, true[0]):SIDE + min(0, true[0])]))
            images.append(0.45 + 0.1 * (relief + noise * rng.standard_normal((SIDE, SIDE))))
        yield pair_on_disk(folder, k, images, step, true)


def pair_on_disk(folder, k, images, step, true):
    names = [folder / f"{k:05d}{side}.pgm" for side in "ab"]
    return names, [write(n, i) for n, i in zip(names, images)], step, true


def read_pgm(path):
    data = re.sub(rb"#[^\n]*\n", b"", path.read_bytes(), count=3)
    fields, at = [], 0
    while len(fields) < 4:
        end = at
        while data[end : end + 1] not in (b" ", b"\n", b"\t", b"\r"):
            end += 1
        fields.append(data[at:end])
        at = end + 1
    w, h, top = map(int, fields[1:])
    return np.frombuffer(data[at:], ">u2" if top > 255 else "u1", w * h).reshape(h, w).astype(float)


def real(folder, source, noise, pairs, seed):
    """Crops of real frames brought to full range, whose overlap has a standard deviation of at least 0.15."""
    rng = np.random.default_rng([seed, int(1000 * noise), 77])
    frames = [read_pgm(f) for f in sorted(source.glob("fscan_*.pgm"))]
    frames = [f / f.max() for f in frames if f.max() > 0]
    k = 0
    while k < pairs:
        f = frames[rng.integers(len(frames))]
        step = np.array([8, 0] if rng.integers(2) else [0, 8])
        true = step + rng.integers(-2, 3, 2)
        x, y = rng.integers(0, f.shape[1] - SIDE + 1), rng.integers(0, f.shape[0] - SIDE + 1)
        if not (0 <= x + true[0] <= f.shape[1] - SIDE and 0 <= y + true[1] <= f.shape[0] - SIDE):
            continue
        a = f[y : y + SIDE, x : x + SIDE]
        b = f[y + true[1] :, x + true[0] :][:SIDE, :SIDE]
        if overlap(a, b, true)[0].std() < 0.15:
            continue
        images = [0.45 + 0.1 * (i + noise * rng.standard_normal(i.shape)) for i in (a, b)]
        yield pair_on_disk(folder, k, images, step, true)
        k += 1


def overlap(a, b, shift):
    dx, dy = int(shift[0]), int(shift[1])
    x0, y0 = max(0, dx), max(0, dy)
    part = a[y0 : min(SIDE, SIDE + dy), x0 : min(SIDE, SIDE + dx)]
    return part, b[y0 - dy : y0 - dy + part.shape[0], x0 - dx : x0 - dx + part.shape[1]]


def searched(step, score):
    shifts = [step + np.array([i, j]) for j in range(-SEARCH, SEARCH + 1) for i in range(-SEARCH, SEARCH + 1)]
    return max(shifts, key=score)


def peers():
    """Each peer by name: from two images and the nominal step to the place of the second in the first."""
    found = {}

    def correlated(a, b, step):
        def score(shift):
            p, q = overlap(a, b, shift)
            p, q = p - p.mean(), q - q.mean()
            return (p * q).sum() / max(1e-12, math.sqrt((p * p).sum() * (q * q).sum()))

        return searched(step, score)

    found["numpy, full-overlap correlation"] = correlated
    try:
        from skimage.registration import phase_cross_correlation

        found["scikit-image phase_cross_correlation"] = lambda a, b, step: phase_cross_correlation(a, b)[0][::-1]
        ones = np.ones((SIDE, SIDE), bool)
        found["scikit-image, masked"] = lambda a, b, step: np.array(
            phase_cross_correlation(a, b, reference_mask=ones, moving_mask=ones, overlap_ratio=0.25)[0][::-1]
        )
    except ImportError:
        pass
    try:
        import cv2

        def template(a, b, step):
            # The part of B that lies in A wherever the search goes, looked for in A.
            w, h = SIDE - abs(step[0]) - SEARCH * (step[0] != 0), SIDE - abs(step[1]) - SEARCH * (step[1] != 0)
            left = 0 if step[0] > 0 else SEARCH
            top = 0 if step[1] > 0 else SEARCH
            patch = b[top : top + (h if step[1] else SIDE - 2 * SEARCH), left : left + (w if step[0] else SIDE - 2 * SEARCH)]
            scores = cv2.matchTemplate(a.astype(np.float32), np.ascontiguousarray(patch, np.float32), cv2.TM_CCOEFF_NORMED)

            def score(shift):
                x, y = shift + np.array([left, top])
                inside = 0 <= y < scores.shape[0] and 0 <= x < scores.shape[1]
                return scores[y, x] if inside else -2

            return searched(step, score)

        def ecc(a, b, step):
            warp = np.array([[1, 0, -step[0]], [0, 1, -step[1]]], np.float32)
            scaled = [((i - i.mean()) / (i.std() + 1e-9)).astype(np.float32) for i in (a, b)]
            criteria = (cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_COUNT, 200, 1e-6)
            try:
                _, warp = cv2.findTransformECC(scaled[0], scaled[1], warp, cv2.MOTION_TRANSLATION, criteria, None, 3)
            except cv2.error:
                return step
            return -warp[:, 2]

        found["OpenCV TM_CCOEFF_NORMED"] = template
        found["OpenCV ECC"] = ecc
    except ImportError:
        pass
    try:
        from m2stitch._translation_computation import interpret_translation, multi_peak_max, pcm

        def m2(a, b, step):
            peaks = multi_peak_max(pcm(a, b).real)
            limits = [step[1] - SEARCH, step[1] + SEARCH, step[0] - SEARCH, step[0] + SEARCH]
            _, y, x = interpret_translation(a, b, *peaks[:2], *limits, 10)
            return np.array([x, y])

        found["m2stitch"] = m2
    except ImportError:
        pass
    try:
        from ashlar import utils as ashlar

        def ash(a, b, step):
            pa, pb = overlap(a, b, step)
            shift, _ = ashlar.register(pa, pb, sigma=0, upsample=1)
            return step + np.array(shift)[::-1]

        found["Ashlar register"] = ash
    except ImportError:
        pass
    return found


def interval(right, n):
    """Wilson's 95 % interval."""
    z, p = 1.96, right / n
    centre, half = p + z * z / 2 / n, z * math.sqrt(p * (1 - p) / n + z * z / 4 / n / n)
    return (centre - half) / (1 + z * z / n), (centre + half) / (1 + z * z / n)


def is_right(shift, true):
    return bool(np.all(np.abs(np.asarray(shift, float) - true) <= 0.75))


def ours(program, method, pairs):
    lines = "".join(
        json.dumps({"a": str(names[0]), "b": str(names[1]), "step": [float(s) for s in step]}) + "\n"
        for names, _, step, _ in pairs
    )
    start = time.perf_counter()
    out = subprocess.run(
        [program, "register", "--batch", "--method", method, "--search", str(SEARCH)],
        input=lines, capture_output=True, text=True,
    )
    seconds = time.perf_counter() - start
    answers = [json.loads(line) for line in out.stdout.splitlines()]
    if len(answers) != len(pairs):
        raise SystemExit(f"{program}: {out.stderr.strip()}")
    right = [is_right(a["best"], true) for a, (_, _, _, true) in zip(answers, pairs)]
    given = [a["outcome"] == "registered" for a in answers]
    return right, given, [a["probability"] for a in answers], seconds


def row(name, right, seconds, more=None):
    low, high = interval(sum(right), len(right))
    told = {"name": name, "right": sum(right), "pairs": len(right), "interval": [low, high],
            "milliseconds_a_pair": 1000 * seconds / len(right), **(more or {})}
    calibration = ""
    if more:
        calibration = f"  given {more['given']}, of these wrong {more['wrong_of_given']}; expected right {more['expected']:.1f}"
    print(f"  {name:38s} {100 * told['right'] / told['pairs']:6.1f} % ({100 * low:.1f} .. {100 * high:.1f})"
          f" {told['milliseconds_a_pair']:8.3f} ms{calibration}", flush=True)
    return told


def table(program, title, pairs, methods=("correlation", "blind", "lattice", "auto"), others=True, felt=None):
    """Each method's row; with `felt`, whether each pair's overlap shows anything, how many of both kinds are right."""
    print(title, flush=True)
    rows = []
    for method in methods:
        right, given, probability, seconds = ours(program, method, pairs)
        wrong = sum(g and not r for g, r in zip(given, right))
        rows.append(row("pra-tactile " + method, right, seconds,
                        {"given": sum(given), "wrong_of_given": wrong, "expected": sum(probability)}))
        if felt is not None:
            shows = {kind: [r for r, f in zip(right, felt) if f == kind] for kind in (True, False)}
            rows[-1]["right_where_felt"] = [sum(shows[True]), len(shows[True])]
            rows[-1]["right_where_not"] = [sum(shows[False]), len(shows[False])]
            print(f"    of {len(shows[True])} whose overlap shows relief {sum(shows[True])} are right,"
                  f" of {len(shows[False])} whose overlap is noise alone {sum(shows[False])}", flush=True)
    for name, peer in peers().items() if others else ():
        start = time.perf_counter()
        right = []
        for _, (a, b), step, true in pairs:
            try:
                right.append(is_right(peer(a, b, step), true))
            except (ValueError, IndexError, AssertionError):
                right.append(False)
        rows.append(row(name, right, time.perf_counter() - start))
    return {"title": title, "rows": rows}


def mosaics(program, noise, count, seed, method):
    """Of mosaics of 4 x 4 frames, 8 taxels apart, with whole errors uniform on -2 .. 2: how many are wholly right."""
    rng = np.random.default_rng([seed, int(1000 * noise), 44])
    shapes, array = alphabet(), symbols_of_the_array(program)
    right, seconds = [], 0.0
    for _ in range(count):
        x, y = rng.uniform(0, PITCH_X * array.shape[1]), rng.uniform(0, PITCH_Y * array.shape[0])
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            lines, errors = ["file,x_mm,y_mm,rotation_deg,force_n"], []
            for k in range(16):
                nominal = np.array([8 * (k % 4), 8 * (k // 4)])
                errors.append(rng.integers(-2, 3, 2))
                relief = seen(shapes, array, *(np.array([x, y]) + nominal + errors[-1]))
                write(folder / f"{k:02d}.pgm", 0.45 + 0.1 * (relief + noise * rng.standard_normal(relief.shape)))
                lines.append(f"{k:02d}.pgm,{1.5875 * nominal[0]},{1.5875 * nominal[1]},0,10")
            (folder / "manifest.csv").write_text("\n".join(lines) + "\n")
            start = time.perf_counter()
            out = subprocess.run([program, "stitch", name, "--json", "--method", method, "--position-error", "1.5"],
                                 check=True, capture_output=True, text=True).stdout
            seconds += time.perf_counter() - start
        off = np.array([f["correction"] for f in json.loads(out)["frames"]]) - np.array(errors)
        # A shift common to all frames cannot be seen.
        right.append(bool(np.all(off.max(0) - off.min(0) <= 1.5)))
    return row(f"4 x 4 mosaics, noise {noise}, {method}", right, seconds)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(HERE.parent.parent / "bin" / "pra-tactile"))
    parser.add_argument("--pairs", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--levels", type=float, nargs="*", default=LEVELS)
    parser.add_argument("--real", type=pathlib.Path)
    parser.add_argument("--realistic", action="store_true")
    parser.add_argument("--felt", action="store_true", help="tell apart pairs whose overlap shows relief, and noise alone")
    parser.add_argument("--mosaics", type=int, default=0)
    parser.add_argument("--no-peers", action="store_true")
    parser.add_argument("--json", type=pathlib.Path)
    given = parser.parse_args()
    warnings.simplefilter("ignore")
    told = []
    for level in given.levels:
        with tempfile.TemporaryDirectory() as folder:
            reliefs = []
            pairs = list(simulated(pathlib.Path(folder), given.program, level, given.pairs, given.seed, reliefs=reliefs))
            # What ranges over less than three standard deviations of the noise is not felt.
            felt = [bool(r > 3 * level) for r in reliefs] if given.felt else None
            told.append(table(given.program, f"noise {level} of the relief", pairs, others=not given.no_peers, felt=felt))
    if given.realistic:
        with tempfile.TemporaryDirectory() as folder:
            pairs = list(simulated(pathlib.Path(folder), given.program, 0.3, given.pairs, given.seed, True))
            told.append(table(given.program, "rotation sd 1.5 degrees, fixed pattern 0.1, noise 0.3", pairs,
                              others=not given.no_peers))
    for level in (0, 0.1) if given.real else ():
        with tempfile.TemporaryDirectory() as folder:
            pairs = list(real(pathlib.Path(folder), given.real, level, given.pairs, given.seed))
            told.append(table(given.program, f"real frames, noise {level}", pairs, others=not given.no_peers))
    for level in (0.2, 0.3) if given.mosaics else ():
        for method in ("auto", "lattice", "joint", "incremental"):
            told.append({"title": "mosaics", "rows": [mosaics(given.program, level, given.mosaics, given.seed, method)]})
    if given.json:
        given.json.write_text(json.dumps(told, indent=1) + "\n")


if __name__ == "__main__":
    main()
