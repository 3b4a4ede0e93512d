/* What the C peers share: GF(4), the register's polynomial, the clock, and the protocol: for each line on
   standard input one measurement is made and one line of JSON is printed. */
#ifndef MEASURE_H
#define MEASURE_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Products of GF(4), A^2 = A + 1; 0, 1, A, A^2 are coded 0, 1, 2, 3. Sums are exclusive ors. */
static const uint8_t product[4][4] = {{0, 0, 0, 0}, {0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}};

/* x^12 + x^4 + x^3 + x^2 + A, the first primitive polynomial of degree 12: c0 ... c11. */
enum { DEGREE = 12, PERIOD = 16777215 };
static const uint8_t first_primitive[DEGREE] = {2, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0};

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The largest resident set so far, in MiB. */
static double peak_mib(void) {
  char line[256];
  long kib = 0;
  FILE *f = fopen("/proc/self/status", "r");
  if (!f) return 0;
  while (fgets(line, sizeof line, f))
    if (sscanf(line, "VmHWM: %ld", &kib) == 1) break;
  fclose(f);
  return (double)kib / 1024;
}

/* Wait for the next request; 0 when there are no more. */
static int requested(void) {
  char line[256];
  return fgets(line, sizeof line, stdin) != NULL;
}

static void report(const char *what, double value, const char *unit, const char *check) {
  printf("{\"what\": \"%s\", \"value\": %.9g, \"unit\": \"%s\", \"check\": \"%s\", \"peak_mib\": %.1f}\n", what, value,
         unit, check, peak_mib());
  fflush(stdout);
}

/* The terms s(0) ... s(count - 1), s(i + 12) = c0 s(i) + ... + c11 s(i + 11), from the state 0 ... 0 1. The tables
   of the products with the coefficients that are not zero are found before the loop. Called with a constant, the
   compiler unrolls the loop over the taps. */
static inline void fill(const uint8_t *coefficients, uint8_t *s, long count) {
  const uint8_t *row[DEGREE];
  int offset[DEGREE], taps = 0;
  for (int j = 0; j < DEGREE; j++)
    if (coefficients[j]) {
      row[taps] = product[coefficients[j]];
      offset[taps++] = j;
    }
  memset(s, 0, DEGREE);
  s[DEGREE - 1] = 1;
  for (long i = DEGREE; i < count; i++) {
    uint8_t sum = 0;
    for (int j = 0; j < taps; j++) sum ^= row[j][s[i - DEGREE + offset[j]]];
    s[i] = sum;
  }
}

#endif
