import json, sys
from somebody import number_of, symbol_at


def natural(value):  # 7 may come as "7", as large numbers do; 7.0, true, "+7" and -7 are invalid
    if type(value) is str and value.isascii() and value.isdecimal():
        value = int(value)
    if type(value) is not int or value < 0:
        raise ValueError
    return value


def cell(given):
    return symbol_at(natural(given["row"]), natural(given["column"]))


def pack(given):
    cells = [natural(code) for code in given["cells"]]
    if type(given["cells"]) is not list or max(cells) > 3:
        raise ValueError
    return number_of(cells)


operations = {"cell": cell, "pack": pack}
for line in sys.stdin:
    request = json.loads(line)
    reply = {key: request[key] for key in ["sequence"] if key in request}
    if request["command"] == "start":
        reply.update(protocol=1, name="somebody", operations=list(operations), in_flight=1)
    elif request["command"] == "profile":
        reply["result"] = True
    elif request["command"] == "stop":
        break
    elif request["operation"] not in operations:
        reply["skipped"] = "not written yet"
    else:
        try:
            answer = operations[request["operation"]]
            reply["result"] = answer(request["input"])
        except (KeyError, TypeError, ValueError):
            reply["refused"] = "invalid"
    print(json.dumps(reply), flush=True)
