/* The m-sequence of x^12 + x^4 + x^3 + x^2 + A over GF(4), folded along the diagonal into 63 x 266305 cells, and
   every 3 x 4 window on the torus entered in a bit set: one thread, the time of the whole. */
#include "measure.h"

enum { ROWS = 63, COLUMNS = 266305, HEIGHT = 3, WIDTH = 4 };

static uint8_t *folded(void) {
  uint8_t *s = malloc(PERIOD), *cells = malloc(PERIOD);
  if (!s || !cells) exit(1);
  fill(first_primitive, s, PERIOD);
  for (long i = 0, r = 0, c = 0; i < PERIOD; i++) {
    cells[r * COLUMNS + c] = s[i];
    if (++r == ROWS) r = 0;
    if (++c == COLUMNS) c = 0;
  }
  free(s);
  return cells;
}

/* How many different windows there are. The key of a window is its columns one after the other, the latest in
   the lowest six bits, so that the next window to the right takes one shift and three cells. */
static long distinct_windows(const uint8_t *cells) {
  const uint32_t all = (1u << (2 * HEIGHT * WIDTH)) - 1;
  uint64_t *seen = calloc((size_t)1 << (2 * HEIGHT * WIDTH - 6), sizeof *seen);
  long distinct = 0;
  if (!seen) exit(1);
  for (long r = 0; r < ROWS; r++) {
    const uint8_t *a = cells + r * COLUMNS;
    const uint8_t *b = cells + (r + 1) % ROWS * COLUMNS;
    const uint8_t *c = cells + (r + 2) % ROWS * COLUMNS;
    uint32_t key = 0;
    for (long j = 0; j < COLUMNS + WIDTH - 1; j++) {
      long k = j < COLUMNS ? j : j - COLUMNS;
      key = (key << 6 | (uint32_t)(a[k] << 4 | b[k] << 2 | c[k])) & all;
      if (j >= WIDTH - 1) {
        uint64_t bit = (uint64_t)1 << (key & 63);
        distinct += !(seen[key >> 6] & bit);
        seen[key >> 6] |= bit;
      }
    }
  }
  free(seen);
  return distinct;
}

int main(void) {
  while (requested()) {
    char check[32];
    double start = now();
    uint8_t *cells = folded();
    long distinct = distinct_windows(cells);
    free(cells);
    double seconds = now() - start;
    snprintf(check, sizeof check, "%ld", distinct);
    report("sequence, fold and proof, GF(4), 63 x 266305, 3 x 4", seconds, "s", check);
  }
  return 0;
}
