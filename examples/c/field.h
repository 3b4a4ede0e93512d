/* The field GF(q), q = p^m, of at most 256 elements, and polynomials over it.
 *
 * An element is its code: the number whose base-p digits are the coefficients of a polynomial over
 * the integers modulo p, lowest degree first. Products are reduced by the modulus. In GF(4) with
 * the modulus 1,1,1 the codes 0, 1, 2, 3 are 0, 1, A and A + 1. */
#ifndef FIELD_H
#define FIELD_H

#include <stdbool.h>
#include <stdint.h>

#include "limits.h"

typedef struct {
    unsigned q, p, m;
    unsigned modulus[9];
    uint8_t exp[510]; /* powers of the smallest primitive element, twice over */
    uint8_t log[256]; /* and what power of it an element is; of 0 nothing */
} field;

/* Make the field; false if there is none. The modulus has m + 1 coefficients below p, the constant
 * term first. */
bool field_make(field *f, uint64_t q, const uint64_t *modulus, unsigned coefficients);

uint8_t field_add(const field *f, uint8_t a, uint8_t b);
uint8_t field_negate(const field *f, uint8_t a);
uint8_t field_multiply(const field *f, uint8_t a, uint8_t b);
uint8_t field_inverse(const field *f, uint8_t a); /* of what is not 0 */
uint8_t field_trace(const field *f, uint8_t a);

/* A polynomial: the coefficients of x^0 to x^degree. */
typedef struct {
    unsigned degree;
    uint8_t c[MAX_DEGREE + 1];
} polynomial;

/* q^degree, or 0 if that is 2^63 or more. */
uint64_t field_period(const field *f, unsigned degree);

/* Whether x has the order q^n - 1 modulo a monic polynomial of degree n; q^n is less than 2^63. */
bool polynomial_is_primitive(const field *f, const polynomial *h);

/* The first primitive one of its degree, the coefficients compared from the highest degree down. */
void polynomial_first_primitive(const field *f, polynomial *h);

#endif
