// The primes that divide p^d - 1: first apart by the p^e - 1 that divide it, then by Pollard's method.

export function gcd(a, b) {
  return b === 0n ? a : gcd(b, a % b);
}

function powerModulo(base, exponent, modulus) {
  let result = 1n;
  for (let b = base; exponent > 0n; exponent >>= 1n, b = (b * b) % modulus) if (exponent & 1n) result = (result * b) % modulus;
  return result;
}

const smallPrimes = [2n, 3n, 5n, 7n, 11n, 13n, 17n, 19n, 23n, 29n, 31n, 37n, 41n, 43n, 47n];

// By Miller and Rabin.
function isPrime(n) {
  const small = smallPrimes.find((p) => n % p === 0n);
  if (small !== undefined) return n === small;
  let odd = n - 1n;
  while (odd % 2n === 0n) odd /= 2n;
  return smallPrimes.every((witness) => {
    let x = powerModulo(witness, odd, n);
    if (x === 1n) return true;
    for (let e = odd; e < n - 1n; e *= 2n, x = (x * x) % n) if (x === n - 1n) return true;
    return false;
  });
}

function divisor(n) {
  const small = smallPrimes.find((p) => n % p === 0n);
  if (small !== undefined) return small;
  for (let c = 1n; ; c++) {
    const step = (x) => (x * x + c) % n;
    let [slow, fast, found] = [step(2n), step(step(2n)), 1n];
    while (found === 1n) {
      // The product of many differences has a factor in common with n as soon as one of them has.
      let [product, from] = [1n, [slow, fast]];
      for (let i = 0; i < 100; i++, slow = step(slow), fast = step(step(fast))) product = (product * (n + fast - slow)) % n;
      found = gcd(n, product);
      for ([slow, fast] = found === n ? from : [slow, fast]; found === n && slow !== fast; slow = step(slow), fast = step(step(fast))) {
        const one = gcd(n, n + fast - slow);
        if (one > 1n && one < n) return one;
      }
    }
    if (found < n) return found;
  }
}

function primesOf(n) {
  if (n === 1n) return [];
  if (isPrime(n)) return [n];
  const d = divisor(n);
  return [...primesOf(d), ...primesOf(n / d)];
}

const known = new Map();

export function primeFactors(p, d) {
  const key = `${p}^${d}`;
  if (known.has(key)) return known.get(key);
  let parts = [p ** BigInt(d) - 1n];
  for (let e = 1; e < d; e++) {
    if (d % e === 0) parts = parts.flatMap((part) => [gcd(part, p ** BigInt(e) - 1n), part / gcd(part, p ** BigInt(e) - 1n)]);
  }
  known.set(key, [...new Set(parts.flatMap(primesOf))]);
  return known.get(key);
}
