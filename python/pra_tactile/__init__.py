"""Recognise objects by touch, and test a decoder of pseudorandom arrays, from Python.

Everything is computed by the program pra-tactile, which comes with this package; nothing is decoded
here. An answer is the dictionary of the program's JSON form (docs/reference/json.md), refusals included. Only
what is no answer raises: `Failed`, and TypeError or ValueError for an argument that says nothing.

    import pra_tactile
    pra_tactile.decode("frames")["message"]
    pra_tactile.locate([[3, 2], [3, 1]])
    pra_tactile.array(q=4, shape=(15, 17))
    pra_tactile.conform({"add": lambda a, b: a ^ b}, stage="field")

An option of the program is a keyword: `taxel=2.5` is `--taxel 2.5`, `any_angle=True` is
`--any-angle`, a tuple is a size (`shape=(15, 17)`), a list of numbers has commas between them
(`polynomial=[3, 2, 1, 0, 1]`), and a list of texts is the option several times.
"""

import atexit
import contextlib
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

from ._conform import Refused, served

__all__ = ["Failed", "Refused", "array", "conform", "decode", "locate", "program", "run"]

Answer = Dict[str, Any]
Cell = Union[int, None, Sequence[float]]


class Failed(Exception):
    """The program gave no answer: it is missing, was misused (status 2), or ended. Its words."""

    def __init__(self, message: str, status: Optional[int] = None) -> None:
        super().__init__(message)
        self.status = status


def program() -> str:
    """The program that is run: the environment's PRA_TACTILE, this package's own, or that on PATH."""
    own = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "pra-tactile")
    for path in (os.environ.get("PRA_TACTILE"), own, shutil.which("pra-tactile")):
        if path and os.path.isfile(path) and os.access(path, os.X_OK):
            return path
    raise Failed("there is no program pra-tactile, neither in this package nor on the PATH")


def run(command: str, *arguments: str, stdin: bytes = b"", fds: Sequence[int] = (), **options: Any) -> Answer:
    """What a command answers as JSON: run("prove", q=4, ...) is `pra-tactile prove --json --q 4 ..`."""
    asked = [program(), command, *_flags({"json": True, **options}), *arguments]
    ended = subprocess.run(asked, input=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE, pass_fds=fds)
    if ended.returncode not in (0, 1) or not ended.stdout:
        raise _failed(ended.returncode, ended.stderr)
    answer: Answer = json.loads(ended.stdout)
    return answer


def decode(frames: Any, *, full_scale: Optional[float] = None, **options: Any) -> Answer:
    """Object, face and place. `frames` is the path of a folder or an image; or one image, the whole
    composite; or frames with their poses, (image, x_mm, y_mm) or (image, x_mm, y_mm, rotation_deg).

    An image is any two-dimensional buffer or a list of rows. `full_scale` is the reading of full
    contact; without it the largest of an integer type, and 1 of floats.
    """
    if isinstance(frames, (str, os.PathLike)):
        return run("decode", os.fspath(frames), full_scale=full_scale, **options)
    if not isinstance(frames, list) or not all(isinstance(frame, tuple) for frame in frames):
        return run("decode", "-", stdin=_npy([frames], full_scale), full_scale=full_scale, **options)
    if not frames or not all(len(frame) in (3, 4) for frame in frames):
        raise ValueError("frames are a list of (image, x_mm, y_mm, rotation_deg), one or more")
    movie = _npy([frame[0] for frame in frames], full_scale)
    rows = [",".join(repr(float(number)) for number in (*frame[1:], 0)[:3]) for frame in frames]
    with _handed("\n".join(["x_mm,y_mm,rotation_deg", *rows, ""])) as (fd, poses):
        return run("decode", "-", stdin=movie, fds=[fd], poses=poses, full_scale=full_scale, **options)


def locate(cells: Union[str, Sequence[Sequence[Cell]]], **options: Any) -> Answer:
    """Where in the array a patch is. A cell is a code, None where it was not observed, or the
    probabilities of all codes. One process answers all questions with the same options."""
    line = cells if isinstance(cells, str) else json.dumps(cells, separators=(",", ":"))
    if "\n" in line or "\r" in line:
        raise ValueError("a patch is one line")
    flags = ("locate", "--batch", *_flags(options))
    with _lock:
        if flags not in _asked:
            if len(_asked) >= 8:
                _asked.pop(next(iter(_asked))).end()
            _asked[flags] = _Asked(flags)
        answer: Answer = json.loads(_asked[flags].answer(line.encode()))
        return answer


def array(
    q: Optional[int] = None,
    shape: Optional[Tuple[int, int]] = None,
    polynomial: Optional[Sequence[int]] = None,
    **options: Any,
) -> List[List[int]]:
    """The array as rows of codes: the paper's, or of this field, shape and polynomial, which is the
    first primitive one of the degree unless it is given."""
    if q is not None and shape is not None and polynomial is None and "profile" not in options:
        degree, size = 0, shape[0] * shape[1]
        while q > 1 and q ** (degree + 1) <= size + 1:
            degree += 1
        modulus = options.get("modulus")
        first = run("polynomials", q=q, degree=max(1, degree), first=True, modulus=modulus)
        polynomial = first["polynomials"][0]
    chosen = {"q": q, "shape": shape, "polynomial": polynomial and list(polynomial), **options}
    rows: List[List[int]] = run("array", json=None, format="json", **chosen)["rows"]
    return rows


def conform(
    functions: Mapping[str, Callable[..., Any]],
    *,
    profile: Optional[Mapping[str, Any]] = None,
    **options: Any,
) -> Answer:
    """The report of the conformance suite on functions of this process, by the names of their
    operations (docs/reference/protocol.md).

    The keys of an operation's input are the function's arguments (`from` is `from_`), with integers
    as int; what it returns is the result, and raising `Refused(reason)` refuses. A function named
    "profile" is called with each profile before it is in force; where there is none, the laws are
    tried under `profile` alone, or the paper's.
    """
    given = profile if profile is not None or "profile" in functions else run("profile", json=None)
    with _handed(json.dumps(given)) as (fd, file), served(functions) as subject:
        chosen = options if given is None else {"profile": file, **options}
        return run("conform", "--", *subject, fds=[fd], **chosen)


@contextlib.contextmanager
def _handed(text: str) -> Iterator[Tuple[int, str]]:
    """A descriptor to be handed to the program, and the path by which it reads this text there: in
    memory, where the system has such files."""
    in_memory = getattr(os, "memfd_create", None)
    with open(in_memory("pra-tactile"), "w+b") if in_memory else tempfile.TemporaryFile() as file:
        file.write(text.encode())
        file.flush()
        yield file.fileno(), f"/dev/fd/{file.fileno()}"


def _flags(options: Mapping[str, Any]) -> Iterator[str]:
    for name, value in options.items():
        flag = "--" + name.rstrip("_").replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            yield flag
            continue
        if isinstance(value, tuple):
            value = "x".join(map(str, value))
        elif isinstance(value, list) and not any(isinstance(one, str) for one in value):
            value = ",".join(map(str, value))
        for one in value if isinstance(value, list) else [value]:
            yield f"{flag}={os.fspath(one) if isinstance(one, os.PathLike) else one}"


def _failed(status: int, said: bytes) -> Failed:
    words = said.decode(errors="replace").strip().splitlines()
    return Failed(words[-1] if words else f"pra-tactile ended with status {status}", status)


class _Asked:
    """A process that answers each line with a line. After a fork the child starts its own; after a
    fault the next question does."""

    def __init__(self, flags: Sequence[str]) -> None:
        pipe = subprocess.PIPE
        self.flags = flags
        self.process = subprocess.Popen(
            [program(), *flags], bufsize=-1, stdin=pipe, stdout=pipe, stderr=pipe
        )

    def answer(self, line: bytes) -> bytes:
        assert self.process.stdin and self.process.stdout
        reply = b""
        try:
            self.process.stdin.write(line + b"\n")
            self.process.stdin.flush()
            reply = self.process.stdout.readline()
        except OSError:
            pass
        finally:
            if not reply.endswith(b"\n"):
                _asked.pop(tuple(self.flags), None)
                said = self.end()
        if not reply.endswith(b"\n"):
            raise _failed(self.process.returncode, said)
        return reply

    def end(self) -> bytes:
        self.process.kill()
        try:
            return self.process.communicate()[1]
        except (OSError, ValueError):
            return b""


_lock = threading.RLock()
_asked: Dict[Tuple[str, ...], _Asked] = {}


def _forget() -> None:
    """In a child that was forked: the processes are the parent's."""
    global _lock, _asked
    for one in _asked.values():
        one.process.returncode = 0  # it is not this process's to wait for
        for stream in (one.process.stdin, one.process.stdout, one.process.stderr):
            if stream:
                stream.close()
    _lock, _asked = threading.RLock(), {}


def _end_all() -> None:
    for one in list(_asked.values()):
        one.end()


os.register_at_fork(after_in_child=_forget)
atexit.register(_end_all)

# The types of numbers that the program reads, by the letters that buffers have for them.
_TYPES = {"B": "u1", "H": "u2", "h": "i2", "i": "i4", "f": "f4", "d": "f8"}


def _npy(images: Sequence[Any], full_scale: Optional[float]) -> bytes:
    """Images of one size as a file of numpy's, of one image or a movie."""
    read = [_buffer(image, full_scale) for image in images]
    if len({kind for kind, _ in read}) > 1:
        raise ValueError("frames are of one size and type")
    (descr, shape), _ = read[0]
    whole = shape if len(images) == 1 else (len(images), *shape)
    header = f"{{'descr': '{descr}', 'fortran_order': False, 'shape': {whole}, }}".encode()
    header += b" " * (-(len(header) + 11) % 64) + b"\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + b"".join(part for _, part in read)


def _buffer(image: Any, full_scale: Optional[float]) -> Tuple[Tuple[str, Tuple[int, ...]], bytes]:
    try:
        view = memoryview(image)
    except TypeError:
        rows = [[float("nan") if value is None else float(value) for value in row] for row in image]
        if not rows or not rows[0] or len({len(row) for row in rows}) > 1:
            raise ValueError("an image is rows of numbers, all of one length") from None
        if full_scale is None and any(value > 1 for row in rows for value in row):
            raise ValueError("readings above 1 need full_scale") from None
        flat = [value for row in rows for value in row]
        return ("<f8", (len(rows), len(rows[0]))), struct.pack(f"<{len(flat)}d", *flat)
    if view.ndim != 2:
        raise ValueError(f"an image has two dimensions, this buffer has {view.ndim}")
    form, shape = "=" + view.format, view.shape or ()
    order, letter = form[-2], form[-1]
    if letter in _TYPES:
        little = order == "<" or (order in "=@" and sys.byteorder == "little")
        return ("<>"[not little] + _TYPES[letter], shape), view.tobytes()
    if full_scale is None:
        raise ValueError(f"an image of type {view.format!r} needs full_scale")
    return _buffer(view.tolist(), full_scale)
