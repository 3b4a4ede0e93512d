/* A pseudorandom array: one period of an m-sequence, folded into n1 x n2 cells. */
#ifndef ARRAY_H
#define ARRAY_H

#include "field.h"

typedef enum { DIAGONAL, ROW_MAJOR } folding;
typedef enum { TORUS, TWISTED_TORUS, SHEET } surface;

typedef struct {
    field f;
    polynomial h;             /* the characteristic polynomial, of degree n */
    uint8_t state[MAX_DEGREE]; /* the first n terms */
    unsigned rows, columns;
    unsigned window_rows, window_columns;
    folding fold;
    surface beyond; /* what lies beyond the edges, by the profile */
    bool most_significant_first;
    uint32_t size;    /* rows x columns */
    uint32_t inverse; /* of the rows modulo the columns, for the diagonal */
    bool has_terms, has_cells;
    uint8_t terms[MAX_CELLS];
    uint8_t cells[MAX_CELLS]; /* row by row */
} array;

/* The array's terms and its cells, computed when they are first asked for. */
const uint8_t *array_terms(array *a);
const uint8_t *array_cells(array *a);

/* Which term a cell holds; beyond the edges on the folding's own surface. */
uint32_t array_index(const array *a, uint32_t row, uint32_t column);

/* The surface on which the neighbours of all cells are alike. */
surface array_own_surface(const array *a);

/* The inverse of a modulo n, if there is one; 0 if not, or if n is 1. */
uint32_t inverse_modulo(uint32_t a, uint32_t n);

#endif
