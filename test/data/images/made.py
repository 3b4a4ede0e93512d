"""Writes made.json: images as numpy and Pillow write them, with what they show as those programs read them.

usage: python3 test/data/images/made.py        (numpy and Pillow, in an environment outside the project)

Each entry has the file in base64, and either the shares of full scale, image by image and row by row
(null where there is no reading), or the reason for which it is no image.
"""

import base64
import io
import itertools
import json
import os

import numpy
from PIL import Image

random = numpy.random.default_rng(2004)


def written(array, version=(1, 0)):
    file = io.BytesIO()
    numpy.lib.format.write_array(file, array, version=version)
    return file.getvalue()


def drawn(kind, shape):
    if numpy.dtype(kind).kind == "f":
        return random.random(shape).astype(kind)
    return random.integers(0, numpy.iinfo(kind).max, shape, endpoint=True).astype(kind)


def shares(array, full):
    values = numpy.clip(array.astype(float) / full, 0, 1).reshape(-1, array.shape[-2] * array.shape[-1])
    return [[None if numpy.isnan(v) else float(v) for v in image] for image in values]


def entries():
    for kind, fortran, movie in itertools.product(
        ["|u1", "<u2", ">u2", "<i2", ">i2", "<i4", ">i4", "<f4", ">f4", "<f8", ">f8"], [False, True], [False, True]
    ):
        array = drawn(kind, (3, 4, 5) if movie else (4, 5))
        array = numpy.asfortranarray(array) if fortran else array
        full = 1 if array.dtype.kind == "f" else numpy.iinfo(kind).max
        name = f"{kind}, {'Fortran' if fortran else 'C'}, {'a movie' if movie else 'an image'}"
        yield name, written(array), {"shares": shares(array, full), "width": 5}
    array = drawn("<u2", (4, 5))
    for version in [(2, 0), (3, 0)]:
        yield f"version {version[0]}", written(array, version), {"shares": shares(array, 65535), "width": 5}
    array = drawn("<f8", (4, 5))
    array[1, 2], array[0, 0], array[3, 3], array[2, 2] = numpy.nan, -0.5, 1.5, numpy.inf
    yield "not a number, below and above", written(array), {"shares": shares(array, 1), "width": 5}
    yield "signed, below 0", written(numpy.array([[-5, 32767]], "<i2")), {"shares": [[0, 1]], "width": 2}
    objects = io.BytesIO()
    numpy.save(objects, numpy.array([[{}]], dtype=object), allow_pickle=True)
    yield "objects", objects.getvalue(), {"refused": "NumpyType"}
    yield "records", written(numpy.zeros((2, 2), [("a", "<f4"), ("b", "<i4")])), {"refused": "NumpyType"}
    yield "eight bytes", written(numpy.zeros((2, 2), "<i8")), {"refused": "NumpyType"}
    yield "complex", written(numpy.zeros((2, 2), "<c8")), {"refused": "NumpyType"}
    yield "one dimension", written(numpy.zeros(4, "u1")), {"refused": "NumpyShape"}
    yield "four dimensions", written(numpy.zeros((1, 1, 2, 2), "u1")), {"refused": "NumpyShape"}
    yield "no pixels", written(numpy.zeros((0, 4), "u1")), {"refused": "ZeroSize"}
    huge = written(numpy.zeros((11, 11), "<f4"))[: 10 + 118].replace(b"(11, 11)", b"(1000000000, 1000000000)")
    yield "10^9 x 10^9", huge, {"refused": "TooManyPixels"}
    yield "cut short", written(array)[:-1], {"refused": "Truncated"}
    yield "too long", written(array) + b"\0", {"refused": "TrailingData"}
    for name, image, found in pictures():
        file = io.BytesIO()
        image.save(file, "png")
        yield name, file.getvalue(), found
    for delimiter in [",", ";", " ", "\t"]:
        array = random.random((4, 5))
        text = io.StringIO()
        numpy.savetxt(text, array, delimiter=delimiter, header="frame 1")
        yield f"text with {delimiter!r}", text.getvalue().encode(), {"shares": shares(array, 1), "width": 5}


def pictures():
    grey, deep = drawn("u1", (4, 5)), drawn("<u2", (4, 5))
    yield "8 bits of grey", Image.fromarray(grey), {"shares": shares(grey, 255), "width": 5}
    yield "16 bits of grey", Image.fromarray(deep), {"shares": shares(deep, 65535), "width": 5}
    yield "grey in three channels", Image.fromarray(numpy.dstack([grey] * 3)), {"shares": shares(grey, 255), "width": 5}
    yield "colour", Image.fromarray(numpy.dstack([grey, grey, grey ^ 1])), {"refused": "PngColour"}
    yield "a palette", Image.fromarray(grey).convert("P"), {"refused": "PngPalette"}
    yield "transparency", Image.fromarray(grey).convert("LA"), {"refused": "PngTransparent"}
    yield "one bit", Image.fromarray(grey).convert("1"), {"refused": "PngDepth"}


with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "made.json"), "w") as out:
    rows = [{"name": n, "file": base64.b64encode(f).decode(), **found} for n, f, found in entries()]
    out.write("[\n" + ",\n".join(json.dumps(row) for row in rows) + "\n]\n")
