/* How many windows of a mask differ, and its rank. */
#include <string.h>

#include "locate.h"

static uint32_t order[2][MAX_CELLS]; /* positions, sorted and being sorted */

static position position_of(uint32_t k, extent e)
{
    return (position){k / e.columns, k % e.columns};
}

/* Sort the positions by one cell's content, keeping the order of those that have the same. */
static void sort_by(const array *a, const felt *cell, extent e, const uint32_t *from, uint32_t *to)
{
    uint32_t start[257] = {0}, count = e.rows * e.columns;
    for (uint32_t k = 0; k < count; k++)
        start[cell_from(a, a->beyond, position_of(from[k], e), cell) + 1]++;
    for (int code = 0; code < 256; code++)
        start[code + 1] += start[code];
    for (uint32_t k = 0; k < count; k++)
        to[start[cell_from(a, a->beyond, position_of(from[k], e), cell)]++] = from[k];
}

static bool are_same(const array *a, const patch *mask, position one, position other)
{
    for (uint32_t k = 0; k < mask->count; k++)
        if (cell_from(a, a->beyond, one, &mask->cell[k]) !=
            cell_from(a, a->beyond, other, &mask->cell[k]))
            return false;
    return true;
}

/* Sorting by each cell in turn brings equal windows together. */
uint32_t mask_contents(array *a, const patch *mask)
{
    extent e = admissible(a, a->beyond, mask);
    uint32_t count = e.rows * e.columns, contents = 1, now = 0;
    array_cells(a);
    for (uint32_t k = 0; k < count; k++)
        order[0][k] = k;
    for (uint32_t k = 0; k < mask->count; k++, now = 1 - now)
        sort_by(a, &mask->cell[k], e, order[now], order[1 - now]);
    for (uint32_t k = 1; k < count; k++)
        contents += !are_same(a, mask, position_of(order[now][k - 1], e),
                              position_of(order[now][k], e));
    return contents;
}

/* The windows at the first n terms are a basis of all. */
static uint8_t matrix[MAX_TERMS][MAX_WINDOW];

static void fill_matrix(array *a, const patch *mask)
{
    const uint8_t *terms = array_terms(a);
    for (uint32_t k = 0; k < mask->count; k++) {
        uint32_t index = array_index(a, mask->cell[k].row, mask->cell[k].column);
        for (unsigned t = 0; t < a->h.degree; t++)
            matrix[t][k] = terms[(t + index) % a->size];
    }
}

/* Take a multiple of the row `pivot` away from a row, so that it is 0 in a column. */
static void clear(const field *f, unsigned row, unsigned pivot, uint32_t column, uint32_t width)
{
    uint8_t inverse = field_inverse(f, matrix[pivot][column]);
    uint8_t factor = field_negate(f, field_multiply(f, matrix[row][column], inverse));
    for (uint32_t k = column; factor != 0 && k < width; k++)
        matrix[row][k] =
            field_add(f, matrix[row][k], field_multiply(f, factor, matrix[pivot][k]));
}

static void swap_rows(unsigned one, unsigned other, uint32_t width)
{
    for (uint32_t k = 0; k < width; k++) {
        uint8_t kept = matrix[one][k];
        matrix[one][k] = matrix[other][k];
        matrix[other][k] = kept;
    }
}

unsigned mask_rank(array *a, const patch *mask)
{
    unsigned rank = 0, n = a->h.degree;
    fill_matrix(a, mask);
    for (uint32_t column = 0; column < mask->count && rank < n; column++) {
        unsigned pivot = rank;
        while (pivot < n && matrix[pivot][column] == 0)
            pivot++;
        if (pivot == n)
            continue;
        swap_rows(rank, pivot, mask->count);
        for (unsigned row = rank + 1; row < n; row++)
            clear(&a->f, row, rank, column, mask->count);
        rank++;
    }
    return rank;
}
