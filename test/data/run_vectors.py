"""Put the test vectors in data/vectors, but those that need no profile, to a decoder, all in one session: run_vectors.py PROFILES COMMAND ARGS...
PROFILES is a pattern of their profiles' names. Prints those that it does not pass, and how many there are."""

import json
import subprocess
import sys
from pathlib import Path


def same(operation, wanted, came):
    if wanted[0] == came[0] == "result" and operation == "posterior":
        one, other = ({(r, c): p for r, c, p in ranking} for ranking in (wanted[1], came[1]))
        return all(abs(one.get(at, 0) - other.get(at, 0)) <= 1e-9 for at in one.keys() | other.keys())
    return wanted == came


requests, wanted = [], []


def ask(request, outcome):
    requests.append(json.dumps(request) + "\n")
    wanted.append((request, outcome))


ask({"command": "start", "protocol": 1}, None)
for file in sorted(Path("data/vectors").glob(f"*/{sys.argv[1]}.json"), key=lambda file: file.name):
    vectors = json.loads(file.read_text())
    if vectors["profile"] is None:
        continue
    ask({"command": "profile", "profile": vectors["profile"]}, ("result", True))
    for group in vectors["groups"]:
        for test in group["tests"]:
            run = {"command": "run", "sequence": len(requests), "operation": vectors["operation"], "input": test["input"]}
            outcome = ("result", test["result"]) if test["outcome"] == "result" else ("refused", test["reason"])
            ask(run, outcome)
requests.append(json.dumps({"command": "stop"}) + "\n")
replies = subprocess.run(sys.argv[2:], input="".join(requests), capture_output=True, text=True).stdout.splitlines()
for (request, outcome), line in zip(wanted[1:], replies[1:]):
    reply = json.loads(line)
    kind = next(kind for kind in ("result", "refused", "skipped", "errored") if kind in reply)
    if not same(request.get("operation"), outcome, (kind, reply[kind])):
        print(request, "yours:", reply, "the vector:", outcome)
print(len(replies) - 1 if len(replies) == len(wanted) else "replies are missing")
