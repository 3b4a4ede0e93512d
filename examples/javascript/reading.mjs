// What a line of the protocol says. JSON.parse reads 2.0, 2e0 and 2 as one number and rounds
// integers above 2^53, so that a number is kept here as a string of how it was written, with a
// mark that no line can know, until it is clear whether an integer or a probability is wanted.

class Refused extends Error {}

export const refuse = (reason) => {
  throw new Refused(reason);
};

// What an action returns, or refuses, or what goes wrong in it, as a reply.
export function reply(action) {
  try {
    return { result: action() };
  } catch (error) {
    return error instanceof Refused ? { refused: error.message } : { errored: String(error) };
  }
}

const demand = (holds) => holds || refuse("invalid");

const mark = crypto.randomUUID();
const stringOrNumber = /"(?:[^"\\]|\\.)*"|-?\d[\d.eE+-]*/g;

export function parse(line) {
  JSON.parse(line);
  const marked = (token) => (token[0] === '"' ? token : `"${mark}${token}"`);
  return JSON.parse(line.replace(stringOrNumber, marked));
}

// And back: integers above 2^53 - 1 as strings, and what is repeated as it came.
export function print(value) {
  const plain = (number) => (number > Number.MAX_SAFE_INTEGER ? String(number) : Number(number));
  const text = JSON.stringify(value, (_, each) => (typeof each === "bigint" ? plain(each) : each));
  return text.replace(new RegExp(`"${mark}([^"]*)"`, "g"), "$1");
}

export function object(value) {
  demand(typeof value === "object" && value !== null && !Array.isArray(value));
  return value;
}

export function list(value, item) {
  demand(Array.isArray(value));
  return value.map((each) => item(each));
}

export function integer(value) {
  demand(typeof value === "string");
  const text = value.replace(mark, "");
  demand(/^-?\d{1,4096}$/.test(text));
  return BigInt(text);
}

export function natural(value, below = Infinity) {
  const number = integer(value);
  demand(number >= 0n && number < below);
  return number;
}

function chances(q, value) {
  const given = list(value, (each) => {
    demand(typeof each === "string" && each.startsWith(mark));
    return Number(each.replace(mark, ""));
  });
  const sum = given.reduce((a, b) => a + b, 0);
  demand(given.length === Number(q) && given.every((p) => p >= 0) && Math.abs(sum - 1) <= 0.001);
  return given.map((p) => p / sum);
}

// Rows of one length, as those of their cells of which something is known.
function cellsOf(rows, unknown) {
  demand(rows.length > 0 && rows[0].length > 0);
  demand(rows.every((row) => row.length === rows[0].length));
  const cells = rows.flatMap((row, r) => row.map((value, c) => ({ row: r, column: c, value })));
  return cells.filter(({ value }) => value !== unknown);
}

export function patch(q, value, mayBeChances = false) {
  const cell = (given) => {
    if (given === null) return null;
    return mayBeChances && Array.isArray(given) ? chances(q, given) : Number(natural(given, q));
  };
  return cellsOf(list(value, (row) => list(row, cell)), null);
}

export function mask(value) {
  demand(typeof value === "string" && /^[#./]*$/.test(value));
  const cells = cellsOf(value.split("/").map((row) => [...row]), ".");
  demand(cells.length >= 1 && cells.length <= 4096);
  return cells;
}

const words = {
  schema: ["pra-tactile/profile/1"],
  reading: ["characteristic", "reciprocal"],
  folding: ["diagonal", "row-major"],
  surface: ["torus", "twisted-torus", "sheet"],
  packing: ["most-significant-first", "least-significant-first"],
};
const lists = ["modulus", "polynomial", "state", "shape", "window"];

export function profile(value) {
  const { q } = object(value);
  demand(Object.entries(words).every(([key, some]) => some.includes(value[key])));
  const read = Object.fromEntries(lists.map((key) => [key, list(value[key], natural)]));
  demand(read.shape.length === 2 && read.window.length === 2);
  return { ...value, ...read, q: natural(q) };
}
