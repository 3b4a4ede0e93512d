// GF(q): the base-p digits of an element's code, lowest first, are the coefficients of its residue.
import { times } from "./polynomial.mjs";
import { refuse } from "./reading.mjs";

const below = (n) => [...new Array(n).keys()];

// None where no powers are all elements but 0: then the modulus is reducible.
export function fieldOf(q, p, modulus) {
  const [elements, exponents] = [below(q), below(modulus.length - 1)];
  const residues = elements.map((a) => exponents.map((i) => Math.floor(a / p ** i) % p));
  const code = (residue) => residue.reduceRight((sum, c) => sum * p + c, 0);
  const integers = {
    add: (a, b) => (a + b) % p,
    multiply: (a, b) => (a * b) % p,
    negate: (a) => (p - a) % p,
  };
  const sum = (a, b) => code(residues[a].map((c, i) => integers.add(c, residues[b][i])));
  const product = (a, b) => code(times(integers, modulus, residues[a], residues[b]));

  const powersOf = (a, powers = [1]) => {
    for (let x = a; x > 1 && powers.length < q; x = product(x, a)) powers.push(x);
    return powers;
  };
  const primitive = elements.find((a) => a > 0 && powersOf(a).length === q - 1);
  if (primitive === undefined) return undefined;
  const powers = powersOf(primitive);
  const logarithms = elements.map((a) => powers.indexOf(a));
  const sums = elements.map((a) => elements.map((b) => sum(a, b)));

  const add = (a, b) => sums[a][b];
  const multiply = (a, b) =>
    a === 0 || b === 0 ? 0 : powers[(logarithms[a] + logarithms[b]) % (q - 1)];
  const power = (a, exponent) => {
    if (a === 0 && exponent < 0n) refuse("division-by-zero");
    if (a === 0) return exponent === 0n ? 1 : 0;
    return powers.at(Number((BigInt(logarithms[a]) * exponent) % BigInt(q - 1)));
  };
  const negate = (a) => multiply(p - 1, a);
  const inverse = (a) => power(a, -1n);
  const logarithm = (a) => (a === 0 ? refuse("out-of-range") : logarithms[a]);
  const trace = (a) => exponents.map((i) => power(a, BigInt(p ** i))).reduce(add);
  return { q, p, m: exponents.length, add, multiply, negate, inverse, power, logarithm, trace };
}
