"""Functions of this process as a subject of the conformance suite.

The suite starts a process and speaks with it over pipes. That process (`RELAY`) hands its two pipes
to this one over a socket and waits, so that functions answer in the process that has them.
"""

import contextlib
import inspect
import json
import keyword
import os
import re
import secrets
import socket
import sys
import threading
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional

RELAY = """
import os, socket, struct, sys
to = socket.socket(socket.AF_UNIX)
to.connect("\\0" + sys.argv[1])
to.sendmsg([b"0"], [(socket.SOL_SOCKET, socket.SCM_RIGHTS, struct.pack("2i", 0, 1))])
os.close(0)
os.close(1)
to.recv(1)
"""

INTEGER = re.compile("-?[0-9]+")
# Operations whose texts are fractions and names.
WITH_TEXTS = {"solid", "cells", "whereabouts", "pose"}


Operations = Mapping[str, Callable[[Any], bytes]]


class Refused(Exception):
    """To be raised by a function that refuses: Refused("division-by-zero")."""


@contextlib.contextmanager
def served(functions: Mapping[str, Callable[..., Any]]) -> Iterator[List[str]]:
    """The command to put under the suite, which these functions answer while the context lasts."""
    name = "pra-tactile-" + secrets.token_hex(16)
    operations = {operation: _operation(operation, functions[operation]) for operation in functions}
    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind("\0" + name)
        listening.listen()
        threading.Thread(target=_accept, args=(listening, operations), daemon=True).start()
        try:
            yield [sys.executable, "-I", "-S", "-c", RELAY, name]
        finally:
            # What waits to accept is woken by this, and not by closing.
            listening.shutdown(socket.SHUT_RDWR)


def _accept(listening: socket.socket, operations: Operations) -> None:
    """Each process that the suite starts is answered by a thread, so that one whose function never
    returns keeps no other from an answer."""
    while True:
        try:
            relay, _ = listening.accept()
        except OSError:
            return
        threading.Thread(target=_converse, args=(relay, operations), daemon=True).start()


def _converse(relay: socket.socket, operations: Operations) -> None:
    with relay:
        _, sent, _, _ = relay.recvmsg(1, socket.CMSG_SPACE(8))
        fds = [fd for _, _, data in sent for fd in memoryview(data).cast("i")]
        if len(fds) != 2:
            return
        with open(fds[0], "rb", buffering=0) as requests, open(fds[1], "wb") as replies:
            with contextlib.suppress(OSError):
                _answer(requests, replies, operations)


def _answer(requests: Any, replies: Any, operations: Operations) -> None:
    """Answer all lines that have come at once, until stop or the end."""
    rest = b""
    while True:
        chunk = requests.read(1 << 16)
        *lines, rest = (rest + chunk).split(b"\n")
        for line in lines:
            reply = _reply(operations, line)
            if reply is None:
                return
            replies.write(reply + b"\n")
        replies.flush()
        if not chunk:
            return


def _reply(operations: Operations, line: bytes) -> Optional[bytes]:
    """The reply to a line; None to the request to stop."""
    try:
        request = json.loads(line, parse_constant=int)  # which takes no NaN
        command = request.get("command")
    except (ValueError, RecursionError, AttributeError) as error:
        return _written({"errored": f"not a request: {error}"})
    if command == "stop":
        return None
    if command == "start":
        offered = [name for name in operations if name != "profile"]
        return _written({"protocol": 1, "name": "python", "operations": offered, "in_flight": 64})
    if command == "profile":
        opened = operations.get("profile")
        return opened(request) if opened else b'{"result":true}'
    function = None if request.get("operation") == "profile" else operations.get(str(request.get("operation")))
    reply = function(request.get("input")) if function else b'{"skipped":"no such function"}'
    if "sequence" not in request:
        return reply
    return b'{"sequence":' + json.dumps(request["sequence"]).encode() + b"," + reply[1:]


def _operation(name: str, function: Callable[..., Any]) -> Callable[[Any], bytes]:
    """From an operation's input to the reply without its sequence."""
    if name == "profile":
        return lambda request: _replied(lambda: function(request.get("profile")) is not False)
    try:
        parameters = list(inspect.signature(function).parameters.values())
    except ValueError:  # of some that are written in C
        parameters = []
    names = {one.name for one in parameters}
    every = not names or any(one.kind is one.VAR_KEYWORD for one in parameters)
    variadic = (inspect.Parameter.VAR_KEYWORD, inspect.Parameter.VAR_POSITIONAL)
    needed = {one.name for one in parameters if one.default is one.empty and one.kind not in variadic}

    def compute(given: Any) -> Any:
        if type(given) is not dict:
            raise Refused("invalid")
        arguments = {
            key + "_" * keyword.iskeyword(key): value if name in WITH_TEXTS else _numbers(value)
            for key, value in given.items()
        }
        if not needed <= arguments.keys():
            raise Refused("invalid")
        return function(**{key: value for key, value in arguments.items() if every or key in names})

    return lambda given: _replied(lambda: compute(given))


def _numbers(value: Any, rows: int = 2) -> Any:
    """With integers in place of their decimal texts, in lists and rows of them. What is deeper is the
    probabilities of a cell, which may not be texts."""
    if type(value) is str:
        return int(value) if INTEGER.fullmatch(value) else value
    if type(value) is list and rows > 0:
        return [_numbers(one, rows - 1) for one in value]
    return value


def _replied(compute: Callable[[], Any]) -> bytes:
    try:
        return _written({"result": compute()})
    except Refused as refusal:
        return _written({"refused": str(refusal)})
    except Exception as error:  # whatever a function raises is its answer
        return _written({"errored": f"{type(error).__name__}: {error}"})


def _written(reply: Dict[str, Any]) -> bytes:
    return json.dumps(reply, separators=(",", ":"), allow_nan=False, default=_plain).encode()


def _plain(value: Any) -> Any:
    """Numbers and arrays of numpy as Python's own."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} is no JSON")
