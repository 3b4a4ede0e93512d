// The array of a profile: its sequence, how it is folded, and what lies where on its surface.
import { gcd } from "./factors.mjs";
import { fieldOf } from "./field.mjs";
import { isPrimitive, powerOfX, timesX, trimmed } from "./polynomial.mjs";
import { refuse } from "./reading.mjs";

const largestTable = 2n ** 20n; // Arrays up to this many cells are written out, where all positions are compared.

const possible = (holds) => holds || refuse("impossible-profile");

const modulo = (a, n) => ((a % n) + n) % n;

// Of a modulo n, which has no divisor in common with it.
const inverse = (a, n) => (n === 1n ? 0n : a === 1n ? 1n : modulo((1n - n * inverse(n % a, a)) / a, n));

const fields = new Map();

function fieldOfProfile(q, modulus) {
  possible(q >= 2n && q <= 256n);
  let p = 2;
  while (q % BigInt(p) !== 0n) p++;
  const m = modulus.length - 1;
  possible(m >= 1 && p ** m === Number(q) && modulus[m] === 1n && modulus.every((c) => c < p));
  const key = `${q}:${modulus}`;
  if (!fields.has(key)) fields.set(key, fieldOf(Number(q), p, modulus.map(Number)));
  return fields.get(key) ?? refuse("impossible-profile");
}

export function arrayOf({ q, modulus, polynomial, reading, state, folding, shape, window, surface, packing }) {
  const field = fieldOfProfile(q, modulus);
  possible([...polynomial, ...state].every((c) => c < q));
  const stated = trimmed(polynomial.map(Number));
  possible(isPrimitive(field, stated));
  const n = stated.length - 1;
  possible(state.length === n && state.some((c) => c > 0n));

  const period = q ** BigInt(n) - 1n;
  const [n1, n2] = shape;
  possible(n1 * n2 === period && (folding === "row-major" || gcd(n1, n2) === 1n));
  possible(window[0] >= 1n && window[1] >= 1n && window[0] * window[1] <= 4096n);

  // The reciprocal, x^n h(1/x), is made monic.
  const start = state.map(Number);
  const backwards = stated.toReversed().map((c) => field.multiply(c, field.inverse(stated[0])));
  const h = reading === "characteristic" ? stated : backwards;
  const sum = (factors, terms) => terms.reduce((total, term, i) => field.add(total, field.multiply(factors[i], term)), 0);
  const terms = (from, count) => {
    let residue = powerOfX(field, h, from % period);
    return Array.from({ length: count }, () => {
      const term = sum(residue, start);
      residue = timesX(field, h, residue);
      return term;
    });
  };

  // The cell r rows down and c columns to the right is the term at r down + c right: in the diagonal folding the index
  // that is r modulo n1 and c modulo n2.
  const [down, right] = folding === "row-major" ? [n2, 1n] : [n2 * inverse(n2 % n1, n1), n1 * inverse(n1 % n2, n2)];
  const cell = (row, column) => terms(row * down + column * right, 1)[0];

  // A period of terms; and where in it a cell is found on a surface, -1 where there is none.
  let written;
  const all = (reason) => (written ??= period > largestTable ? refuse(reason) : Uint8Array.from(terms(0n, Number(period))));
  const own = folding === "diagonal" ? "torus" : "twisted-torus";
  const indexOn = (where) => {
    const [rows, columns, size, byRow, byColumn] = [n1, n2, period, down % period, right % period].map(Number);
    const inside = (r, c) => (r * byRow + c * byColumn) % size;
    const twisted = (r, c) => {
      const i = (r * columns + c) % size;
      return inside(Math.floor(i / columns), i % columns);
    };
    if (where === own) return inside;
    if (where === "sheet") return (r, c) => (r >= 0 && c >= 0 && r < rows && c < columns ? inside(r, c) : -1);
    return where === "torus" ? (r, c) => inside(r % rows, c % columns) : twisted;
  };
  return { field, n, period, own, surface, packing, rows: Number(n1), columns: Number(n2), window: window.map(Number), terms, cell, all, indexOn };
}
