// GF(q) by tables: the base-p digits of an element's code, lowest first, are the coefficients of its residue.

export function fieldOf(q, p, modulus) {
  const m = modulus.length - 1;
  const code = (coefficients) => coefficients.reduceRight((sum, c) => sum * p + c, 0);
  const elements = Array.from({ length: q }, (_, a) => modulus.slice(1).map((_, i) => Math.floor(a / p ** i) % p));

  const sum = (a, b) => a.map((c, i) => (c + b[i]) % p);
  const timesRoot = (a) => a.map((_, i) => ((i === 0 ? 0 : a[i - 1]) + (p - a[m - 1]) * modulus[i]) % p);
  const scaled = (a, factor) => a.map((c) => (c * factor) % p);
  const product = (a, b) => b.reduceRight((total, digit) => sum(timesRoot(total), scaled(a, digit)), scaled(a, 0));
  const table = (operation) => Uint8Array.from({ length: q * q }, (_, i) => code(operation(elements[Math.floor(i / q)], elements[i % q])));
  const sums = table(sum);
  const products = table(product);

  const powersOf = (a) => {
    const powers = [1];
    for (let x = a; x > 1 && powers.length < q; x = products[x * q + a]) powers.push(x);
    return powers;
  };
  const powers = Array.from({ length: q }, (_, a) => powersOf(a)).find((some, a) => a > 0 && some.length === q - 1);
  if (powers === undefined) return undefined; // Some element has no inverse: the modulus is reducible.
  const logarithm = (a) => powers.indexOf(a);
  const power = (a, exponent) => {
    if (a === 0) return exponent === 0n ? 1 : 0;
    const order = BigInt(q - 1);
    return powers[Number((((BigInt(logarithm(a)) * exponent) % order) + order) % order)];
  };
  const add = (a, b) => sums[a * q + b];
  const conjugates = (a) => elements[0].map((_, i) => power(a, BigInt(p) ** BigInt(i)));
  return {
    q,
    p,
    m,
    add,
    multiply: (a, b) => products[a * q + b],
    negate: (a) => code(scaled(elements[a], p - 1)),
    inverse: (a) => power(a, -1n),
    power,
    logarithm,
    trace: (a) => conjugates(a).reduce(add),
  };
}
