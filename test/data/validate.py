"""Hold JSON values against the schemas in data/schemas, by the jsonschema package.

Reads lines of {"schema": NAME, "value": VALUE} and prints a line for each: "good", or what is wrong.
With --spoil each value is spoilt in all the ways below, and the line is "good" if its schema refuses
every one of them, or the first that it accepts. With --once as well, each way is tried once for each
schema, on the shortest value that can be spoilt so.
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


def validators(names):
    schemas = {}
    for file_name in os.listdir(FOLDER):
        with open(os.path.join(FOLDER, file_name)) as file:
            schemas[file_name] = json.load(file)
    found = {}
    for name in names:
        schema = schemas[name + ".json"]
        Draft202012Validator.check_schema(schema)
        resolver = RefResolver(schema["$id"], schema, store=schemas)
        found[name] = Draft202012Validator(schema, resolver=resolver)
    return found


def places(value, path=()):
    """Each part with the way to it; of a list the first item stands for all."""
    yield path, value
    if type(value) in (dict, list):
        for key, part in value.items() if type(value) is dict else enumerate(value[:1]):
            yield from places(part, (*path, key))


def changed(value, path, change):
    """A copy in which `change` was done to what holds the last step of a path; what is beside the
    path is not copied."""
    copied = copy.copy(value)
    holder = copied
    for step in path[:-1]:
        holder[step] = copy.copy(holder[step])
        holder = holder[step]
    change(holder, path[-1])
    return copied


def with_another_key(holder, step):
    holder[step] = {**holder[step], "no such key": 0}


def with_no_type(holder, step):
    holder[step] = [{"": {}}]


def spoilt(value, always, is_open):
    """What to do, and the value where it is done: leave out a key that every such value has, add a
    key, put a value of a type that stands nowhere."""
    for key in always:
        yield f"without {key}", lambda: {k: v for k, v in value.items() if k != key}
    for path, part in places(value):
        if FREE.intersection(path):
            continue
        if type(part) is dict and not is_open:
            yield f"a further key in {path}", lambda: changed([value], (0, *path), with_another_key)[0]
        if path and type(part) not in (dict, list):
            yield f"spoilt {path}", lambda: changed(value, path, with_no_type)
    yield "a list of it", lambda: [value]


def first_accepted(validator, value, always, is_open, tried):
    for what, bad in spoilt(value, always, is_open):
        if what not in tried and validator.is_valid(bad()):
            return what
        tried.add(what)
    return "good"


def main():
    lines = sys.stdin.readlines()
    given = [json.loads(line) for line in lines]
    known = validators({line["schema"] for line in given})
    common = defaultdict(list)
    for line in given:
        common[line["schema"]].append(set(line["value"]))
    found = [""] * len(given)
    before = defaultdict(set)
    for i in sorted(range(len(given)), key=lambda i: len(lines[i])):
        name, value = given[i]["schema"], given[i]["value"]
        if "--spoil" in sys.argv:
            always = sorted(set.intersection(*common[name]))
            tried = before[name] if "--once" in sys.argv else set()
            found[i] = first_accepted(known[name], value, always, name in OPEN, tried)
        else:
            error = next(known[name].iter_errors(value), None)
            found[i] = "good" if error is None else f"{list(error.path)}: {error.message}"[:1000]
    for line in found:
        print(line)


main()
