// What a line of the protocol says. JSON.parse reads 2.0, 2e0 and 2 as one number and rounds integers above 2^53, so that
// numbers are kept here as they were written, until it is known whether an integer or a probability is wanted.

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

class Written {
  constructor(text) {
    this.text = text;
  }
}

// Each number becomes an object with a key that no line can know, and that a Written.
const tag = crypto.randomUUID();
const stringOrNumber = /"(?:[^"\\]|\\.)*"|-?\d[\d.eE+-]*/g;

export function parse(line) {
  JSON.parse(line);
  const tagged = line.replace(stringOrNumber, (token) => (token[0] === '"' ? token : `{"${tag}":"${token}"}`));
  return JSON.parse(tagged, (_, value) => (isObject(value) && tag in value ? new Written(value[tag]) : value));
}

// And back: integers above 2^53 - 1 as strings, and what is repeated as it came.
export function print(value) {
  if (value instanceof Written) return value.text;
  if (typeof value === "bigint") return value > Number.MAX_SAFE_INTEGER ? `"${value}"` : `${value}`;
  if (Array.isArray(value)) return `[${value.map(print)}]`;
  if (!isObject(value)) return JSON.stringify(value);
  return `{${Object.entries(value).map(([key, inner]) => `"${key}":${print(inner)}`)}}`;
}

export const isObject = (value) => typeof value === "object" && value !== null && !Array.isArray(value);

export function integer(value) {
  const text = value instanceof Written ? value.text : value;
  demand(typeof text === "string" && /^-?\d{1,4096}$/.test(text));
  return BigInt(text);
}

export function natural(value) {
  const number = integer(value);
  demand(number >= 0n);
  return number;
}

export function codeBelow(q, value) {
  const number = natural(value);
  demand(number < q);
  return Number(number);
}

export function list(value, item) {
  demand(Array.isArray(value));
  return value.map((each) => item(each));
}

function chances(q, value) {
  const given = list(value, (each) => (demand(each instanceof Written), Number(each.text)));
  const sum = given.reduce((a, b) => a + b, 0);
  demand(given.length === q && given.every((each) => each >= 0) && Math.abs(sum - 1) <= 0.001);
  return given.map((each) => each / sum);
}

// Rows of one length, as the offsets of those cells of which something is known.
function cellsOf(rows, known) {
  demand(rows.length > 0 && rows[0].length > 0 && rows.every((row) => row.length === rows[0].length));
  return rows.flatMap((row, r) => row.flatMap((cell, c) => (known(cell) ? [{ row: r, column: c, value: cell }] : [])));
}

export function patch(q, value, mayBeChances = false) {
  const cell = (given) => {
    if (given === null) return null;
    return mayBeChances && Array.isArray(given) ? chances(q, given) : codeBelow(q, given);
  };
  const rows = list(value, (row) => list(row, cell));
  return { rows, cells: cellsOf(rows, (given) => given !== null) };
}

export function mask(value) {
  demand(typeof value === "string" && /^[#./]*$/.test(value));
  const cells = cellsOf(value.split("/").map((row) => [...row]), (mark) => mark === "#");
  demand(cells.length >= 1 && cells.length <= 4096);
  return cells;
}

export function profile(value) {
  demand(isObject(value) && value.schema === "pra-tactile/profile/1");
  const word = (key, ...words) => (demand(words.includes(value[key])), value[key]);
  const naturals = (key) => list(value[key], natural);
  const pair = (key) => (demand(naturals(key).length === 2), naturals(key));
  return {
    q: natural(value.q),
    modulus: naturals("modulus"),
    polynomial: naturals("polynomial"),
    reading: word("reading", "characteristic", "reciprocal"),
    state: naturals("state"),
    folding: word("folding", "diagonal", "row-major"),
    shape: pair("shape"),
    window: pair("window"),
    surface: word("surface", "torus", "twisted-torus", "sheet"),
    packing: word("packing", "most-significant-first", "least-significant-first"),
  };
}
