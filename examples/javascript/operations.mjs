// Each operation: what is read of its input, and its answer under the array of the profile in force.
import * as located from "./locate.mjs";
import { firstPrimitive, isPrimitive } from "./polynomial.mjs";
import { codeBelow, integer, list, mask, natural, patch, refuse } from "./reading.mjs";

const longest = 250000n; // A line has room for so many codes.

const code = (array, value) => codeBelow(array.field.q, value);
const binary = (operation) => (array, { a, b }) => array.field[operation](code(array, a), code(array, b));
const unary = (operation) => (array, { a }) => array.field[operation](code(array, a));

const inReadingOrder = (array, cells) => (array.packing === "most-significant-first" ? cells : cells.toReversed());

export const operations = {
  add: binary("add"),
  multiply: binary("multiply"),
  negate: unary("negate"),
  trace: unary("trace"),
  inverse: (array, { a }) => array.field.inverse(code(array, a) || refuse("division-by-zero")),
  logarithm: (array, { a }) => array.field.logarithm(code(array, a) || refuse("out-of-range")),
  power(array, { a, exponent }) {
    const [base, by] = [code(array, a), integer(exponent)];
    return base === 0 && by < 0n ? refuse("division-by-zero") : array.field.power(base, by);
  },
  primitive: (array, { polynomial }) => isPrimitive(array.field, list(polynomial, (c) => code(array, c))),
  "first-primitive"(array, { degree }) {
    const n = natural(degree);
    if (n === 0n) refuse("invalid");
    return n > longest ? refuse("too-long") : firstPrimitive(array.field, Number(n));
  },
  term: (array, { index }) => array.terms(natural(index), 1)[0],
  terms(array, { from, length }) {
    const [first, count] = [natural(from), natural(length)];
    return count > longest ? refuse("too-long") : array.terms(first, Number(count));
  },
  cell: (array, { row, column }) => array.cell(natural(row), natural(column)),
  pack(array, { cells }) {
    const codes = list(cells, (c) => code(array, c));
    if (codes.length !== array.window[0] * array.window[1]) refuse("invalid");
    return inReadingOrder(array, codes).reduce((sum, c) => sum * BigInt(array.field.q) + BigInt(c), 0n);
  },
  unpack(array, { packed }) {
    const [number, q, cells] = [natural(packed), BigInt(array.field.q), array.window[0] * array.window[1]];
    if (number >= q ** BigInt(cells)) refuse("out-of-range");
    const digits = Array.from({ length: cells }, (_, i) => Number((number / q ** BigInt(i)) % q));
    return inReadingOrder(array, digits.reverse());
  },
  locate: (array, input) => located.locate(array, patch(array.field.q, input.patch)),
  nearest: (array, input) =>
    located.nearest(array, patch(array.field.q, input.patch), input.radius === null ? null : natural(input.radius)),
  posterior: (array, input) => located.posterior(array, patch(array.field.q, input.patch, true)),
  prove: (array, input) => located.prove(array, mask(input.mask)),
  distance: (array, input) => located.distance(array, mask(input.mask)),
};
