/* The primes that divide a number. */
#ifndef FACTORS_H
#define FACTORS_H

#include <stdint.h>

enum { MAX_FACTORS = 16 }; /* the product of the first 16 primes is above 2^63 */

/* The primes that divide n, 1 <= n < 2^63, each once; how many they are. */
int prime_factors(uint64_t n, uint64_t primes[MAX_FACTORS]);

#endif
