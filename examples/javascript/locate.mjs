// Where a patch lies: by the table of all windows, by the fewest differences, and by Bayes'
// theorem; and what masks tell apart. A patch is a list of its observed cells, and a place the
// number of a cell in reading order.
import { refuse } from "./reading.mjs";

const position = ({ columns }, place) => ({
  row: Math.floor(place / columns),
  column: place % columns,
});

const grid = ([high, wide]) =>
  Array.from({ length: high * wide }, (_, i) => position({ columns: wide }, i));

const plus = (a, b) => ({ row: a.row + b.row, column: a.column + b.column });
const minus = (a, b) => ({ row: a.row - b.row, column: a.column - b.column });

const least = (numbers) => numbers.reduce((a, b) => Math.min(a, b), Infinity);

function told(array, places) {
  const positions = places.sort((a, b) => a - b).map((place) => position(array, place));
  return positions.length === 1 ? { position: positions[0] } : { positions };
}

// The places at which all cells lie on the surface, in order, each with what lies there.
function* windows(array, cells, reason, surface = array.surface) {
  const codes = array.codes(reason);
  const at = array.on(surface);
  for (let place = 0; place < codes.length; place++) {
    const { row, column } = position(array, place);
    const content = cells.map((cell) => codes[at(row + cell.row, column + cell.column)]);
    if (!content.includes(undefined)) yield { place, content };
  }
}

const contentOf = (cells) => cells.map(({ value }) => value).join();

// The places of each content of the profile's window.
function tableOf(array) {
  if (array.table) return array.table;
  array.table = new Map();
  for (const { place, content } of windows(array, grid(array.window), "table-too-large")) {
    const places = array.table.get(content.join());
    if (places) places.push(place);
    else array.table.set(content.join(), [place]);
  }
  return array.table;
}

function completeWindows({ window }, cells) {
  const key = ({ row, column }) => `${row},${column}`;
  const observed = new Map(cells.map((cell) => [key(cell), cell]));
  return cells
    .map((corner) => grid(window).map((cell) => observed.get(key(plus(corner, cell)))))
    .filter((found) => !found.includes(undefined));
}

export function locate(array, cells) {
  if (cells.length === 0) refuse("too-few-cells");
  const complete = completeWindows(array, cells);
  if (complete.length === 0) refuse("no-complete-window");
  const table = tableOf(array);
  const occurring = complete.filter((window) => table.has(contentOf(window)));
  const isZero = complete.flat().every(({ value }) => value === 0);
  if (occurring.length === 0) refuse(isZero ? "zero-window" : "not-in-array");

  // The patch's upper left cell may lie beyond a sheet, as others that were not observed.
  const [window] = occurring;
  const [codes, on] = [array.codes("table-too-large"), array.on(array.surface)];
  const at = (corner, cell) => on(corner.row + cell.row, corner.column + cell.column);
  const agrees = (corner) => (cell) => codes[at(corner, cell)] === cell.value;
  const isBeyond = (corner) => (cell) => at(corner, cell) < 0;
  const corners = table
    .get(contentOf(window))
    .map((place) => minus(position(array, place), window[0]))
    .filter((corner) => occurring.flat().every(agrees(corner)))
    .filter((corner) => cells.every((cell) => agrees(corner)(cell) || isBeyond(corner)(cell)));
  const origin = { row: 0, column: 0 };
  const found = corners.filter((corner) => ![origin, ...cells].some(isBeyond(corner)));
  if (found.length > 0) return told(array, found.map((corner) => at(corner, origin)));
  return refuse(corners.length > 0 ? "off-sheet" : "contradiction");
}

const isOwnOrSheet = ({ surface, own }) => surface === own || surface === "sheet";

const guaranteedRadius = (array, cells) =>
  isOwnOrSheet(array) ? Math.max(0, Math.floor((distance(array, cells) - 1) / 2)) : 0;

export function nearest(array, cells, stated) {
  if (cells.length === 0) refuse("too-few-cells");
  const radius = stated ?? guaranteedRadius(array, cells);
  const all = Array.from(windows(array, cells, "table-too-large"), ({ place, content }) => ({
    place,
    differing: cells.filter(({ value }, i) => value !== content[i]).length,
  }));
  const fewest = least(all.map(({ differing }) => differing));
  const found = all.filter(({ differing }) => differing === fewest);
  if (fewest <= radius) return told(array, found.map(({ place }) => place));
  if (radius == 0 && completeWindows(array, cells).length > 0) return locate(array, cells);
  if (cells.filter(({ value }) => value !== 0).length <= radius) refuse("zero-window");
  return refuse(radius == 0 ? "contradiction" : "beyond-radius");
}

// By sums of logarithms: the product of a thousand probabilities may be smaller than any number.
export function posterior(array, cells) {
  const logarithm = (value, code) =>
    Math.log(Array.isArray(value) ? value[code] : Number(value === code));
  const all = Array.from(windows(array, cells, "table-too-large"), ({ place, content }) => ({
    ...position(array, place),
    weight: cells.reduce((sum, { value }, i) => sum + logarithm(value, content[i]), 0),
  }));
  const largest = -least(all.map(({ weight }) => -weight));
  if (largest === -Infinity) refuse("contradiction");
  const shares = all.map(({ weight }) => Math.exp(weight - largest));
  const total = shares.reduce((a, b) => a + b, 0);
  return all.map(({ row, column }, i) => [row, column, shares[i] / total]);
}

export function prove(array, cells) {
  const contentsOn = (surface) =>
    Array.from(windows(array, cells, "too-many-windows", surface), ({ content }) => content.join());
  const contents = contentsOn(array.surface);
  if (contents.length === 0) refuse("off-sheet");
  const different = new Set(contents).size;
  // Together with zeros the contents on the folding's own surface are a space, of q^rank vectors.
  const space = new Set([...contentsOn(array.own), cells.map(() => 0).join()]);
  const rank = Math.round(Math.log(space.size) / Math.log(Number(array.q)));
  return {
    proved: different === contents.length,
    rank: isOwnOrSheet(array) ? rank : null,
    windows: different,
  };
}

// The difference of two windows is a window itself, or zero: the fewest cells that are not 0.
export function distance(array, cells) {
  const all = windows(array, cells, "too-many-windows", array.own);
  return least(Array.from(all, ({ content }) => content.filter((code) => code !== 0).length));
}
