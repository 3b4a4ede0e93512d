// Polynomials over a field, lists of codes with the constant term first; their residues modulo a
// monic one, h; and which of them are primitive.
import { primeFactors } from "./factors.mjs";

export function timesX(field, h, a) {
  const top = field.negate(a[a.length - 1]);
  return a.map((_, i) => field.add(i === 0 ? 0 : a[i - 1], field.multiply(top, h[i])));
}

export function times(field, h, a, b) {
  const step = (total, digit) =>
    timesX(field, h, total).map((c, i) => field.add(c, field.multiply(digit, a[i])));
  return b.reduceRight(step, new Array(a.length).fill(0));
}

export function powerOfX(field, h, exponent) {
  let result = h.slice(1).map((_, i) => (i === 0 ? 1 : 0));
  for (const bit of exponent.toString(2)) {
    result = times(field, h, result, result);
    if (bit === "1") result = timesX(field, h, result);
  }
  return result;
}

// Without the coefficients of 0 at its end.
export const trimmed = (h) => h.slice(0, h.findLastIndex((c) => c !== 0) + 1);

// Where the powers of x are all q^n - 1 residues but 0, each of these has an inverse: h is
// irreducible as well.
export function isPrimitive(field, stated) {
  const h = trimmed(stated);
  const n = h.length - 1;
  if (n < 1 || h[n] !== 1 || h[0] === 0) return false;
  const isOne = (exponent) => powerOfX(field, h, exponent).every((c, i) => c === Number(i === 0));
  const order = BigInt(field.q) ** BigInt(n) - 1n;
  return isOne(order) && primeFactors(field.p, field.m * n).every((r) => !isOne(order / r));
}

export function firstPrimitive(field, n) {
  const h = [...new Array(n).fill(0), 1];
  while (!isPrimitive(field, h)) {
    let i = 0;
    while (h[i] === field.q - 1) h[i++] = 0;
    h[i]++;
  }
  return h;
}
