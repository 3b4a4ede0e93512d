// Each operation: what is read of its input, and its answer under the array of a profile.
import * as located from "./locate.mjs";
import { firstPrimitive, isPrimitive } from "./polynomial.mjs";
import { integer, list, mask, natural, patch, refuse } from "./reading.mjs";

const code = ({ q }, value) => Number(natural(value, q));
const codes = (array, value) => list(value, (each) => code(array, each));
// A line has room for so many codes.
const length = (value) => (natural(value) > 250000n ? refuse("too-long") : Number(natural(value)));

const unary = (name) => (array, { a }) => array.field[name](code(array, a));
const binary = (name) => (array, { a, b }) => array.field[name](code(array, a), code(array, b));

const cellsOfWindow = ({ window: [high, wide] }) => high * wide;
const inOrder = ({ packing }, cells) =>
  packing === "most-significant-first" ? cells : cells.toReversed();

export const operations = {
  add: binary("add"),
  multiply: binary("multiply"),
  negate: unary("negate"),
  inverse: unary("inverse"),
  logarithm: unary("logarithm"),
  trace: unary("trace"),
  power: (array, { a, exponent }) => array.field.power(code(array, a), integer(exponent)),
  primitive: (array, { polynomial }) => isPrimitive(array.field, codes(array, polynomial)),
  "first-primitive": ({ field }, { degree }) =>
    firstPrimitive(field, length(degree) || refuse("invalid")),
  term: (array, { index }) => array.terms(natural(index), 1)[0],
  terms: (array, { from, length: count }) => array.terms(natural(from), length(count)),
  cell: (array, { row, column }) => array.cell(natural(row), natural(column)),
  pack(array, { cells }) {
    const digits = inOrder(array, codes(array, cells));
    if (digits.length !== cellsOfWindow(array)) refuse("invalid");
    return digits.reduce((sum, digit) => sum * array.q + BigInt(digit), 0n);
  },
  unpack(array, { packed }) {
    let [rest, digits] = [natural(packed), []];
    for (; digits.length < cellsOfWindow(array); rest /= array.q) {
      digits.unshift(Number(rest % array.q));
    }
    return rest > 0n ? refuse("out-of-range") : inOrder(array, digits);
  },
  locate: (array, input) => located.locate(array, patch(array.q, input.patch)),
  nearest: (array, input) => {
    const radius = input.radius === null ? null : natural(input.radius);
    return located.nearest(array, patch(array.q, input.patch), radius);
  },
  posterior: (array, input) => located.posterior(array, patch(array.q, input.patch, true)),
  prove: (array, input) => located.prove(array, mask(input.mask)),
  distance: (array, input) => located.distance(array, mask(input.mask)),
};
