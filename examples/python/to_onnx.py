"""A network as ONNX: python3 to_onnx.py NETWORK.json NETWORK.onnx. Its input is `image`, any number of rows of 96 values,
its output `outputs`, a row of one a class each, in double precision. Needs the package onnx."""
import json, sys
from onnx import TensorProto, checker, helper, save

network = json.load(open(sys.argv[1]))
nodes, weights, given = [], [], "image"
for made in ("hidden", "output"):
    units = network[made + "_units"]
    sums, made = made + "_sums", "outputs" if made == "output" else made
    for name, size, values in (
        (made + "_weights", [len(units), len(units[0]) - 1], [w for unit in units for w in unit[:-1]]),
        (made + "_biases", [len(units)], [unit[-1] for unit in units]),
    ):
        weights.append(helper.make_tensor(name, TensorProto.DOUBLE, size, values))
    nodes.append(helper.make_node("Gemm", [given, made + "_weights", made + "_biases"], [sums], transB=1))
    nodes.append(helper.make_node("Sigmoid", [sums], [made]))
    given = made


def rows(name, size):
    return helper.make_tensor_value_info(name, TensorProto.DOUBLE, ["images", size])


graph = helper.make_graph(nodes, "network", [rows("image", network["inputs"])], [rows("outputs", network["outputs"])], weights)
model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], ir_version=8)
checker.check_model(model, full_check=True)
save(model, sys.argv[2])
