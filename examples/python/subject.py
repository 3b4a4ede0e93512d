#!/usr/bin/env python3
"""The protocol: JSON lines on standard input and output, or one request with --one-shot."""

import json
import os
import sys

import network
from locate import Refused
from operations import OPERATIONS, Errored
from reading import array_of

NAME = "python-example"
IN_FLIGHT = 64


def replied(compute):
    """A reply without its sequence."""
    try:
        return {"result": compute()}
    except Refused as refusal:
        return {"refused": str(refusal)}
    except Errored as error:
        return {"errored": str(error)}


def run(array, request):
    operation = request.get("operation")
    if type(operation) is not str or operation not in {**OPERATIONS, **network.OPERATIONS}:
        return {"skipped": "no such operation", "link": "docs/reference/protocol.md"}
    if operation in network.OPERATIONS:
        return replied(lambda: network.OPERATIONS[operation](request.get("input")))
    if array is None:
        return {"errored": "no profile is in force"}
    return replied(lambda: OPERATIONS[operation](array, request.get("input")))


def parsed(line):
    """The request, an object. NaN and Infinity, which Python would read, are no JSON."""

    def no_number(name):
        raise ValueError(name)

    request = json.loads(line, parse_constant=no_number)
    if type(request) is not dict:
        raise ValueError("the request is no object")
    return request


def one_shot(line):
    """The reply to a request that brings its profile along."""
    request = parsed(line)
    array = None

    def opened():
        nonlocal array
        array = array_of(request.get("profile"))
        return True

    reply = replied(opened)
    if array is not None and "operation" in request:
        reply = run(array, request)
    if "sequence" in request:
        reply = {"sequence": request["sequence"], **reply}
    return reply


class Session:
    """What is in force between requests."""

    def __init__(self):
        self.array = None

    def reply(self, line):
        """The reply to a line; None to the request to stop."""
        try:
            request = parsed(line)
        except (ValueError, RecursionError) as error:
            return {"errored": f"not a request: {error}"}
        command = request.get("command")
        if command == "start":
            return {
                "protocol": 1,
                "name": NAME,
                "operations": [*OPERATIONS, *network.OPERATIONS],
                "in_flight": IN_FLIGHT,
            }
        if command == "profile":
            self.array = None
            return replied(lambda: self.open(request.get("profile")))
        if command == "run":
            sequence = {"sequence": request["sequence"]} if "sequence" in request else {}
            return {**sequence, **run(self.array, request)}
        if command == "stop":
            return None
        return {"errored": "no such command"}

    def open(self, profile):
        self.array = array_of(profile)
        return True


def written(reply):
    return json.dumps(reply, separators=(",", ":")).encode() + b"\n"


def converse():
    """Answer line after line, all that have come at once, until stop or the end of the input."""
    session, rest = Session(), b""
    while chunk := os.read(0, 1 << 16):
        *lines, rest = (rest + chunk).split(b"\n")
        replies, reply = [], {}
        for line in lines:
            reply = session.reply(line)
            if reply is None:
                break
            replies.append(written(reply))
        sys.stdout.buffer.write(b"".join(replies))
        sys.stdout.buffer.flush()
        if reply is None:
            return


def main():
    if sys.argv[1:] == ["--one-shot"]:
        try:
            reply = one_shot(sys.stdin.buffer.readline())
        except (ValueError, RecursionError) as error:
            reply = {"errored": f"not a request: {error}"}
        sys.stdout.buffer.write(written(reply))
    elif sys.argv[1:]:
        sys.exit("usage: subject.py [--one-shot]")
    else:
        converse()


if __name__ == "__main__":
    main()
