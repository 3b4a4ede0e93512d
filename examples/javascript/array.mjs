// The array of a profile: its sequence, and which code lies where on a surface.
import { gcd } from "./factors.mjs";
import { fieldOf } from "./field.mjs";
import { isPrimitive, powerOfX, timesX, trimmed } from "./polynomial.mjs";
import { refuse } from "./reading.mjs";

const possible = (holds) => holds || refuse("impossible-profile");

const fields = new Map();

function fieldOfProfile({ q, modulus }) {
  possible(q >= 2n && q <= 256n);
  let p = 2;
  while (q % BigInt(p) !== 0n) p++;
  const m = modulus.length - 1;
  possible(m >= 1 && p ** m === Number(q) && modulus[m] === 1n && modulus.every((c) => c < p));
  const key = `${q}:${modulus}`;
  if (!fields.has(key)) fields.set(key, fieldOf(Number(q), p, modulus.map(Number)));
  return fields.get(key) ?? refuse("impossible-profile");
}

const modulo = (a, n) => ((a % n) + n) % n;

// Of a modulo n, which have no divisor in common.
function inverse(a, n) {
  if (n === 1n) return 0n;
  return a === 1n ? 1n : modulo((1n - n * inverse(n % a, a)) / a, n);
}

// The number, in reading order, of the cell at a row and a column; -1 where there is none.
const surfaces = {
  torus: (rows, columns, r, c) => modulo(r, rows) * columns + modulo(c, columns),
  "twisted-torus": (rows, columns, r, c) => modulo(r * columns + c, rows * columns),
  sheet: (rows, columns, r, c) =>
    r >= 0 && c >= 0 && r < rows && c < columns ? r * columns + c : -1,
};

export function arrayOf(profile) {
  const field = fieldOfProfile(profile);
  possible([...profile.polynomial, ...profile.state].every((c) => c < profile.q));
  const stated = trimmed(profile.polynomial.map(Number));
  possible(isPrimitive(field, stated));
  const state = profile.state.map(Number);
  possible(state.length === stated.length - 1 && state.some((c) => c > 0));
  const period = profile.q ** BigInt(state.length) - 1n;
  const [n1, n2] = profile.shape;
  const isDiagonal = profile.folding === "diagonal";
  possible(n1 * n2 === period && (!isDiagonal || gcd(n1, n2) === 1n));
  const window = profile.window.map(Number);
  possible(window[0] >= 1 && window[1] >= 1 && window[0] * window[1] <= 4096);

  // The reciprocal, x^n h(1/x), made monic.
  const unit = field.inverse(stated[0]);
  const reciprocal = stated.toReversed().map((c) => field.multiply(c, unit));
  const h = profile.reading === "characteristic" ? stated : reciprocal;

  // If x^i is the sum of the r(j) x^j modulo h, then s(i) is that of the r(j) s(j).
  const terms = (from, count) => {
    const found = [];
    let r = powerOfX(field, h, from % period);
    for (; found.length < count; r = timesX(field, h, r)) {
      found.push(r.map((c, j) => field.multiply(c, state[j])).reduce(field.add));
    }
    return found;
  };
  // What lies at a row and a column is s(i): i is the column modulo n2, and n2 times a number more,
  // which is the row, or makes i the row modulo n1.
  const unfolded = isDiagonal && inverse(n2 % n1, n1);
  const cell = (row, column) => {
    const times = isDiagonal ? modulo((row - column) * unfolded, n1) : row;
    return terms(column + n2 * times, 1)[0];
  };

  const own = isDiagonal ? "torus" : "twisted-torus";
  const on = (surface) => surfaces[surface].bind(null, Number(n1), Number(n2));
  let written;
  const codes = (reason) => {
    if (period > 2n ** 20n) refuse(reason);
    if (!written) {
      const at = on(own);
      written = new Uint8Array(Number(period));
      for (const [i, code] of terms(0n, written.length).entries()) {
        written[at(isDiagonal ? i : 0, i)] = code;
      }
    }
    return written;
  };
  return { ...profile, field, window, columns: Number(n2), terms, cell, own, on, codes };
}
