"""Hold JSON values against the schemas in data/schemas, by the jsonschema package.

Reads lines of {"schema": NAME, "value": VALUE} and prints a line for each: "good", or what is wrong.
With --spoil each value is spoilt in all the ways below, and the line is "good" if its schema refuses
every one of them, or the first that it accepts.
"""

import copy
import json
import os
import sys
import warnings
from collections import defaultdict

warnings.simplefilter("ignore", DeprecationWarning)
from jsonschema import Draft202012Validator, RefResolver

FOLDER = os.path.join("data", "schemas")
# Further keys are ignored in what is read of others.
OPEN = {"request", "reply"}
# Under these keys stands what a test asks, or what a subject said, which may be anything.
FREE = {"input", "requests", "got"}


def validators():
    schemas = {}
    for name in os.listdir(FOLDER):
        with open(os.path.join(FOLDER, name)) as file:
            schemas[name] = json.load(file)
        Draft202012Validator.check_schema(schemas[name])
    return {
        name[: -len(".json")]: Draft202012Validator(
            schema, resolver=RefResolver(schema["$id"], schema, store=schemas)
        )
        for name, schema in schemas.items()
    }


def places(value, path=()):
    """Each part with the way to it; of a list the first item stands for all."""
    yield path, value
    if type(value) in (dict, list):
        for key, part in value.items() if type(value) is dict else enumerate(value[:1]):
            yield from places(part, (*path, key))


def changed(value, path, change):
    """A copy in which `change` was done to what holds the last step of a path."""
    copied = copy.deepcopy(value)
    holder = copied
    for step in path[:-1]:
        holder = holder[step]
    change(holder, path[-1])
    return copied


def spoilt(value, always, is_open):
    """Each with what was done: a key that every such value has left out, a key too many, a value of
    a type that stands nowhere."""
    for key in always:
        yield f"without {key}", {k: v for k, v in value.items() if k != key}
    for path, part in places(value):
        if FREE.intersection(path):
            continue
        if type(part) is dict and not is_open:
            further = changed([value], (0, *path), lambda h, k: h[k].update({"no such key": 0}))
            yield f"a further key in {path}", further[0]
        if path and type(part) not in (dict, list):
            yield f"spoilt {path}", changed(value, path, lambda h, k: h.__setitem__(k, [{"": {}}]))
    yield "a list of it", [value]


def first_accepted(validator, value, always, is_open):
    for what, bad in spoilt(value, always, is_open):
        if validator.is_valid(bad):
            return what
    return "good"


def main():
    known = validators()
    given = [json.loads(line) for line in sys.stdin]
    common = defaultdict(list)
    for line in given:
        common[line["schema"]].append(set(line["value"]))
    for line in given:
        name, value = line["schema"], line["value"]
        if "--spoil" in sys.argv:
            always = sorted(set.intersection(*common[name]))
            print(first_accepted(known[name], value, always, name in OPEN))
        else:
            error = next(known[name].iter_errors(value), None)
            print("good" if error is None else f"{list(error.path)}: {error.message}"[:1000])


main()
