"""A subject whose protocol is right and who offers addition modulo q alone; as a base of those whose protocol is not."""

import json
import sys


def say(reply):
    sys.stdout.write(json.dumps(reply) + "\n")
    sys.stdout.flush()


def start(in_flight=1):
    return {"protocol": 1, "name": "adder", "operations": ["add"], "in_flight": in_flight}


def code(value, q):
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < q


def answer(profile, request):
    """The reply to a run: the sum of two elements of GF(p^m), their codes being digits to the base p."""
    reply = {"sequence": request["sequence"]}
    if profile is None:
        return {**reply, "errored": "no profile is in force"}
    if request["operation"] != "add":
        return {**reply, "skipped": "not offered", "link": "test/subjects/honest.py"}
    given = request["input"] if isinstance(request["input"], dict) else {}
    a, b = (number(given.get(key)) for key in "ab")
    if not (code(a, profile["q"]) and code(b, profile["q"])):
        return {**reply, "refused": "invalid"}
    p = next(i for i in range(2, profile["q"] + 1) if profile["q"] % i == 0)
    total, place = 0, 1
    while place < profile["q"]:
        total += (a // place + b // place) % p * place
        place *= p
    return {**reply, "result": total}


def number(value):
    """Integers may be decimal strings."""
    return int(value) if isinstance(value, str) and value.isdecimal() and value.isascii() else value


def possible(profile):
    """Whether q is a prime power; the rest of a profile is not of interest to an adder."""
    q = profile["q"]
    p = next((i for i in range(2, q + 1) if q % i == 0), 0)
    while p and q % p == 0:
        q //= p
    return q == 1


def serve(reply_to):
    profile = None
    for line in sys.stdin:
        request = json.loads(line)
        command = request["command"]
        if command == "start":
            say(start())
        elif command == "profile":
            good = possible(request["profile"])
            profile = request["profile"] if good else None
            say({"result": True} if good else {"refused": "impossible-profile"})
        elif command == "run":
            reply_to(profile, request)
        else:
            return


if __name__ == "__main__":
    serve(lambda profile, request: say(answer(profile, request)))
