/* What comes of a request. */
#ifndef OUTCOME_H
#define OUTCOME_H

typedef enum {
    ANSWERED,
    INVALID,
    OUT_OF_RANGE,
    DIVISION_BY_ZERO,
    IMPOSSIBLE,
    TOO_FEW_CELLS,
    NO_COMPLETE_WINDOW,
    ZERO_WINDOW,
    NOT_IN_ARRAY,
    OFF_SHEET,
    CONTRADICTION,
    BEYOND_RADIUS,
    TOO_LARGE, /* no refusal: it exceeds what this program has room for */
    UNKNOWN    /* no refusal: there is no such operation */
} outcome;

#endif
