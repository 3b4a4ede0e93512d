// The primes that divide p^d - 1.
import { checkPrimeSync } from "node:crypto";

export const gcd = (a, b) => (b === 0n ? a : gcd(b, a % b));

// Of a number that is no prime: a small one, or one by Pollard's method.
function divisor(n) {
  for (let d = 2n; d < 1000n; d++) if (n % d === 0n) return d;
  for (let c = 1n; ; c++) {
    const next = (x) => (x * x + c) % n;
    let [slow, fast, found] = [2n, 2n, 1n];
    while (found === 1n) {
      [slow, fast] = [next(slow), next(next(fast))];
      found = gcd(n, n + fast - slow);
    }
    if (found < n) return found;
  }
}

function primesOf(n) {
  if (n === 1n || checkPrimeSync(n)) return n === 1n ? [] : [n];
  const d = divisor(n);
  return [...primesOf(d), ...primesOf(n / d)];
}

const known = new Map();

// Those of the p^e - 1 that divide it, and of what these leave.
export function primeFactors(p, d) {
  const key = `${p}^${d}`;
  if (!known.has(key)) {
    const primes = new Set();
    for (let e = 1; e < d; e++) if (d % e === 0) primeFactors(p, e).forEach((r) => primes.add(r));
    let left = BigInt(p) ** BigInt(d) - 1n;
    for (const r of primes) while (left % r === 0n) left /= r;
    known.set(key, [...primes, ...new Set(primesOf(left))]);
  }
  return known.get(key);
}
