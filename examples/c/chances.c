#include "chances.h"

/* A product of many probabilities may be less than any double. It is kept as fraction * 2^-512k,
 * the fraction being 0 or more than 2^-512, so that no logarithms are needed. */
typedef struct {
    double fraction;
    int32_t k;
} tiny;

static const double step = 0x1p-512;

static tiny normal(tiny x)
{
    while (x.fraction > 0 && x.fraction <= step) {
        x.fraction /= step;
        x.k++;
    }
    return x;
}

static tiny weight[MAX_CELLS];
static double total;
static int32_t least;

static void multiply_by(const array *a, extent e, const felt *cell, const tiny *chances)
{
    for (uint32_t k = 0; k < e.rows * e.columns; k++) {
        position at = {k / e.columns, k % e.columns};
        tiny chance = chances[cell_from(a, a->beyond, at, cell)];
        weight[k].fraction *= chance.fraction;
        weight[k].k += chance.k;
        weight[k] = normal(weight[k]);
    }
}

/* A weight beside the greatest ones, which have the least k. */
static double beside(tiny x)
{
    for (int32_t k = least; k < x.k && x.fraction > 0; k++)
        x.fraction *= step;
    return x.fraction;
}

double posterior_at(uint32_t k)
{
    return beside(weight[k]) / total;
}

outcome posterior(array *a, const patch *p, chance_reader *read, extent *e)
{
    double chances[256];
    tiny factors[256];
    array_cells(a);
    *e = admissible(a, a->beyond, p);
    uint32_t count = e->rows * e->columns;
    for (uint32_t k = 0; k < count; k++)
        weight[k] = (tiny){1, 0};
    for (uint32_t cell = 0; cell < p->count; cell++) {
        read(cell, chances);
        for (unsigned code = 0; code < a->f.q; code++)
            factors[code] = normal((tiny){chances[code], 0});
        multiply_by(a, *e, &p->cell[cell], factors);
    }
    least = INT32_MAX;
    for (uint32_t k = 0; k < count; k++)
        if (weight[k].fraction > 0 && weight[k].k < least)
            least = weight[k].k;
    total = 0;
    for (uint32_t k = 0; k < count; k++)
        total += beside(weight[k]);
    return total > 0 ? ANSWERED : CONTRADICTION;
}
