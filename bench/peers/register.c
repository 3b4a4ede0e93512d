/* A period of an m-sequence over GF(4), n = 12, into bytes. With "constant" as its argument the register of
   x^12 + x^4 + x^3 + x^2 + A is compiled in; otherwise the arguments are the coefficients c0 ... c11, as a register
   for any polynomial has to take them. */
#include "measure.h"

int main(int count, char **arguments) {
  int constant = count == 2 && strcmp(arguments[1], "constant") == 0;
  uint8_t given[DEGREE] = {0};
  if (!constant) {
    if (count != DEGREE + 1) return fprintf(stderr, "usage: register constant | C0 ... C11\n"), 2;
    for (int j = 0; j < DEGREE; j++) given[j] = (uint8_t)(atoi(arguments[j + 1]) & 3);
  }
  while (requested()) {
    double start = now();
    uint8_t *s = malloc(PERIOD);
    if (!s) return 1;
    if (constant)
      fill(first_primitive, s, PERIOD);
    else
      fill(given, s, PERIOD);
    double seconds = now() - start;
    unsigned long weighted = 0;
    char check[32];
    for (long i = 0; i < PERIOD; i++) weighted += (unsigned long)(i % 257) * s[i];
    snprintf(check, sizeof check, "%lu", weighted);
    report("m-sequence, GF(4), n = 12", PERIOD / seconds, "symbols/s", check);
    free(s);
  }
  return 0;
}
