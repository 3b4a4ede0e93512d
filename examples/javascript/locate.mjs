// Where a patch lies: by the table of all windows, by the fewest differences, and by Bayes' theorem; what masks tell apart.
import { refuse } from "./reading.mjs";

const told = (places) => (places.length === 1 ? { position: places[0] } : { positions: places });

// The places at which every cell lies on the surface, in order, each with the terms that are expected there.
function* candidates(array, cells, reason, surface = array.surface) {
  const terms = array.all(reason);
  const at = array.indexOn(surface);
  for (let row = 0; row < array.rows; row++) {
    for (let column = 0; column < array.columns; column++) {
      const indices = cells.map((cell) => at(row + cell.row, column + cell.column));
      if (indices.every((index) => index >= 0)) yield { place: { row, column }, expected: indices.map((index) => terms[index]) };
    }
  }
}

const grid = (high, wide) => Array.from({ length: high * wide }, (_, i) => ({ row: Math.floor(i / wide), column: i % wide }));

// Where on the surface each content of a window lies.
function tableOf(array) {
  if (array.table) return array.table;
  const table = new Map();
  for (const { place, expected } of candidates(array, grid(...array.window), "table-too-large")) {
    const places = table.get(expected.join());
    if (places) places.push(place);
    else table.set(expected.join(), [place]);
  }
  return (array.table = table);
}

function completeWindows({ window }, { rows }) {
  const offsets = grid(...window);
  return grid(Math.max(0, rows.length - window[0] + 1), Math.max(0, rows[0].length - window[1] + 1))
    .map(({ row, column }) => ({ row, column, content: offsets.map((cell) => rows[row + cell.row][column + cell.column]) }))
    .filter(({ content }) => !content.includes(null));
}

// The upper left of a patch of which a cell lies at a place.
function upperLeft({ surface, rows, columns }, place, { row, column }) {
  const modulo = (a, n) => ((a % n) + n) % n;
  const [r, c] = [place.row - row, place.column - column];
  if (surface === "sheet") return { row: r, column: c };
  if (surface === "torus") return { row: modulo(r, rows), column: modulo(c, columns) };
  const i = modulo(r * columns + c, rows * columns);
  return { row: Math.floor(i / columns), column: i % columns };
}

export function locate(array, patch) {
  const { cells } = patch;
  if (cells.length === 0) refuse("too-few-cells");
  const complete = completeWindows(array, patch);
  if (complete.length === 0) refuse("no-complete-window");
  const table = tableOf(array);
  const occurring = complete.filter(({ content }) => table.has(content.join()));
  const zeros = complete.every(({ content }) => content.every((code) => code === 0));
  if (occurring.length === 0) refuse(zeros ? "zero-window" : "not-in-array");

  const terms = array.all("table-too-large");
  const at = array.indexOn(array.surface);
  const [first, ...others] = occurring;
  const common = table
    .get(first.content.join())
    .map((place) => upperLeft(array, place, first))
    // Of the others it is enough that they lie on the surface: their cells are compared with all others.
    .filter(({ row, column }) => others.every((other) => grid(...array.window).every((cell) => at(row + other.row + cell.row, column + other.column + cell.column) >= 0)))
    .map((place) => ({ place, indices: cells.map(({ row, column }) => at(place.row + row, place.column + column)) }))
    .filter(({ indices }) => indices.every((index, i) => index < 0 || terms[index] === cells[i].value));
  const found = common.filter(({ place, indices }) => at(place.row, place.column) >= 0 && indices.every((index) => index >= 0));
  if (found.length > 0) return told(found.map(({ place }) => place).sort((a, b) => a.row - b.row || a.column - b.column));
  return refuse(common.length > 0 ? "off-sheet" : "contradiction");
}

function guaranteedRadius(array, cells) {
  const d = array.surface === array.own || array.surface === "sheet" ? distance(array, cells) : 0;
  return d === 0 ? 0 : Math.floor((d - 1) / 2);
}

export function nearest(array, patch, stated) {
  const { cells } = patch;
  if (cells.length === 0) refuse("too-few-cells");
  const radius = stated ?? guaranteedRadius(array, cells);
  let [found, fewest] = [[], Infinity];
  for (const { place, expected } of candidates(array, cells, "table-too-large")) {
    const differing = cells.reduce((count, { value }, i) => (value === expected[i] ? count : count + 1), 0);
    if (differing < fewest) [found, fewest] = [[], differing];
    if (differing === fewest) found.push(place);
  }
  if (fewest <= radius) return told(found);
  if (radius == 0 && completeWindows(array, patch).length > 0) return locate(array, patch);
  if (cells.filter(({ value }) => value !== 0).length <= radius) refuse("zero-window");
  return refuse(radius == 0 ? "contradiction" : "beyond-radius");
}

// By sums of logarithms, because the product of a thousand probabilities may be smaller than any number.
export function posterior(array, { cells }) {
  const logarithm = (value, code) => Math.log(Array.isArray(value) ? value[code] : value === code ? 1 : 0);
  const weights = [];
  for (const { place, expected } of candidates(array, cells, "table-too-large")) {
    weights.push([place, cells.reduce((sum, { value }, i) => sum + logarithm(value, expected[i]), 0)]);
  }
  const largest = weights.reduce((most, [, weight]) => Math.max(most, weight), -Infinity);
  if (largest === -Infinity) refuse("contradiction");
  const shares = weights.map(([, weight]) => Math.exp(weight - largest));
  const total = shares.reduce((sum, share) => sum + share, 0);
  return weights.map(([{ row, column }], i) => [row, column, shares[i] / total]);
}

// The sequence is determined by n terms in a row; so the rank is that of the cells' terms from n starts in a row.
function rank(array, cells) {
  const { field, n, period } = array;
  const terms = array.all("too-many-windows");
  const at = array.indexOn(array.own);
  const vectors = cells.map(({ row, column }) => Array.from({ length: n }, (_, i) => terms[(at(row, column) + i) % Number(period)]));
  let rank = 0;
  for (let column = 0; column < n; column++) {
    const pivot = vectors.findIndex((vector, i) => i >= rank && vector[column] !== 0);
    if (pivot < 0) continue;
    [vectors[rank], vectors[pivot]] = [vectors[pivot], vectors[rank]];
    const unit = field.inverse(vectors[rank][column]);
    for (let i = rank + 1; i < vectors.length; i++) {
      const factor = field.negate(field.multiply(vectors[i][column], unit));
      vectors[i] = vectors[i].map((code, j) => field.add(code, field.multiply(factor, vectors[rank][j])));
    }
    rank++;
  }
  return rank;
}

export function prove(array, cells) {
  const contents = new Set();
  let windows = 0;
  for (const { expected } of candidates(array, cells, "too-many-windows")) {
    contents.add(expected.join());
    windows++;
  }
  if (windows === 0) refuse("off-sheet");
  const ranked = array.surface === array.own || array.surface === "sheet";
  return { proved: contents.size === windows, rank: ranked ? rank(array, cells) : null, windows: contents.size };
}

// The difference of two windows is a window itself, or zero: it is the fewest cells of a window that are not 0.
export function distance(array, cells) {
  let least = Infinity;
  for (const { expected } of candidates(array, cells, "too-many-windows", array.own)) {
    least = Math.min(least, expected.filter((code) => code !== 0).length);
  }
  return least;
}
