"""Put the test vectors in data/vectors to the decoder in examples/python. Prints how many tests there
are, and those that it does not pass."""

import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, "examples/python")

from locate import Refused
from operations import OPERATIONS
from reading import array_of


def outcome(array, operation, given):
    try:
        return "result", OPERATIONS[operation](array, given)
    except Refused as refusal:
        return "refused", str(refusal)


def same(operation, wanted, came):
    if wanted[0] == came[0] == "result" and operation == "posterior":
        one, other = ({(r, c): p for r, c, p in ranking} for ranking in (wanted[1], came[1]))
        return all(abs(one.get(at, 0) - other.get(at, 0)) <= 1e-9 for at in one.keys() | other.keys())
    return wanted == came


count = 0
for file in sorted(Path("data/vectors").glob("*/*.json")):
    vectors = json.loads(file.read_text())
    array, operation = array_of(vectors["profile"]), vectors["operation"]
    for group in vectors["groups"]:
        for test in group["tests"]:
            wanted = test["outcome"], test.get("result", test.get("reason"))
            came = outcome(array, operation, test["input"])
            count += 1
            if not same(operation, wanted, came):
                print(file, test["id"], test["input"], "yours:", came, "the vector:", wanted)
print(count)
