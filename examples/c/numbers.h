/* Whole numbers of any size, as requests have them. */
#ifndef NUMBERS_H
#define NUMBERS_H

#include <stdbool.h>
#include <stdint.h>

#include "json.h"

/* Each returns false if the value is no natural number. */
bool read_natural(json value, uint64_t *number); /* UINT64_MAX where it is that or more */
bool read_modulo(json value, uint32_t modulus, uint32_t *rest);

/* An integer of either sign modulo a modulus, and whether it is 0, and whether it is negative. */
bool read_integer(json value, uint32_t modulus, uint32_t *rest, bool *zero, bool *negative);

/* A number as digits to the base 10^9, the least significant first: enough for 256^4096. */
enum { LIMBS = 1100 };
typedef struct {
    uint32_t limb[LIMBS];
    int used;
} large;

bool read_large(json value, large *number);
void large_multiply_add(large *number, uint32_t factor, uint32_t summand);
uint32_t large_divide(large *number, uint32_t divisor); /* the remainder */
void large_put(const large *number);

#endif
