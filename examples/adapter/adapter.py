import json, sys
from somebody import number_of, symbol_at

request = json.load(sys.stdin)
operation, given = request.get("operation"), request.get("input")
reply = {key: request[key] for key in ["sequence"] if key in request}
if operation is None:  # is this profile possible?
    reply["result"] = True
elif operation == "cell":
    reply["result"] = symbol_at(int(given["row"]), int(given["column"]))
elif operation == "pack":
    reply["result"] = number_of(given["cells"])
else:
    reply["skipped"] = "not written yet"
print(json.dumps(reply))
