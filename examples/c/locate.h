/* From what was felt of some cells back to their place in the array, and what masks of cells can
 * tell. */
#ifndef LOCATE_H
#define LOCATE_H

#include "array.h"
#include "json.h"
#include "outcome.h"

/* An observed cell: its offset from the patch's upper left cell, and what was felt. */
typedef struct {
    uint16_t row, column;
    uint8_t code;
} felt;

typedef struct {
    felt *cell;
    uint32_t count;
    uint32_t rows, columns; /* of the patch, observed or not; at most MAX_PATCH cells */
} patch;

typedef struct {
    uint32_t row, column;
} position;

typedef struct {
    position at[MAX_CELLS];
    uint32_t count;
} places;

/* The rectangle of positions from which the cells lie on a surface, the position as well. */
typedef struct {
    uint32_t rows, columns;
} extent;

extent admissible(const array *a, surface beyond, const patch *p);

/* ANSWERED with the places, ascending, or the reason why not. */
outcome locate(array *a, const patch *p, places *found);
outcome nearest(array *a, const patch *p, bool guaranteed, uint64_t radius, places *found);

/* The cell at an offset from a position on a surface, on which it must lie. */
uint8_t cell_from(const array *a, surface beyond, position from, const felt *cell);

/* In how many cells two windows differ at least, on the folding's own surface. */
uint32_t mask_distance(array *a, const patch *mask);

/* Of the windows on the profile's surface, of which there is at least one: how many differ. */
uint32_t mask_contents(array *a, const patch *mask);

/* The rank of the mask on the folding's own surface. */
unsigned mask_rank(array *a, const patch *mask);

#endif
