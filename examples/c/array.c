#include "array.h"

#include <string.h>

/* s(i + n) = - (c0 s(i) + ... + c(n-1) s(i+n-1)). Mind the minus: it shows where p is odd. */
const uint8_t *array_terms(array *a)
{
    if (a->has_terms)
        return a->terms;
    unsigned n = a->h.degree;
    memcpy(a->terms, a->state, n);
    for (uint32_t i = 0; i + n < a->size; i++) {
        uint8_t sum = 0;
        for (unsigned k = 0; k < n; k++)
            if (a->h.c[k] != 0)
                sum = field_add(&a->f, sum, field_multiply(&a->f, a->h.c[k], a->terms[i + k]));
        a->terms[i + n] = field_negate(&a->f, sum);
    }
    a->has_terms = true;
    return a->terms;
}

uint32_t array_index(const array *a, uint32_t row, uint32_t column)
{
    if (a->fold == ROW_MAJOR)
        return (uint32_t)(((uint64_t)a->columns * row + column) % a->size);
    /* i = row modulo the rows and i = column modulo the columns: the Chinese remainder theorem. */
    row %= a->rows;
    uint32_t apart = (column % a->columns + a->columns - row % a->columns) % a->columns;
    return row + a->rows * (uint32_t)((uint64_t)apart * a->inverse % a->columns);
}

const uint8_t *array_cells(array *a)
{
    if (a->has_cells)
        return a->cells;
    const uint8_t *terms = array_terms(a);
    for (uint32_t r = 0; r < a->rows; r++)
        for (uint32_t c = 0; c < a->columns; c++)
            a->cells[r * a->columns + c] = terms[array_index(a, r, c)];
    a->has_cells = true;
    return a->cells;
}

surface array_own_surface(const array *a)
{
    return a->fold == DIAGONAL ? TORUS : TWISTED_TORUS;
}

/* Euclid's algorithm, which keeps a multiple of a beside each remainder. */
uint32_t inverse_modulo(uint32_t a, uint32_t n)
{
    int64_t r0 = n, r1 = a % n, t0 = 0, t1 = 1;
    while (r1 != 0) {
        int64_t quotient = r0 / r1, r = r0 - quotient * r1, t = t0 - quotient * t1;
        r0 = r1, r1 = r, t0 = t1, t1 = t;
    }
    return r0 == 1 ? (uint32_t)((t0 % n + n) % n) : 0;
}
