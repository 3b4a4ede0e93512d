"""The adder as a process a request; what the first argument names is done wrong."""

import json
import sys
import time

import honest

FAULT = sys.argv[1] if len(sys.argv) > 1 else "none"
request = json.load(sys.stdin)
good = honest.possible(request["profile"])
if "operation" in request:
    reply = honest.answer(request["profile"] if good else None, {"input": {}, "sequence": 0, **request})
else:
    reply = {"result": True} if good else {"refused": "impossible-profile"}
if "sequence" not in request:
    reply.pop("sequence", None)
at_fault = request.get("sequence", 0) % 7 == 3
if FAULT == "crash" and at_fault:
    sys.exit("the table is not there")
if FAULT == "hang" and at_fault:
    time.sleep(1000)
if FAULT == "wrong-number" and at_fault:
    reply["sequence"] += 1
if FAULT == "silent" and at_fault:
    sys.exit(0)
honest.say(reply)
if FAULT == "twice" and at_fault:
    honest.say(reply)
if FAULT == "garbage-after" and at_fault:
    print("done")
if FAULT == "half-line-after" and at_fault:
    sys.stdout.write('{"sequence": 3')
if FAULT == "long-line-after" and at_fault:
    print(" " * 8_000_000)
if FAULT.startswith("lines-after-") and at_fault:
    sys.stdout.write("done\n" * int(FAULT.split("-")[2]))
if FAULT == "status" and at_fault:
    sys.exit(4)
if FAULT == "stays" and at_fault:
    time.sleep(1000)
