/* What there is room for: all buffers are fixed. What is beyond is answered by "skipped". */
#ifndef LIMITS_H
#define LIMITS_H

enum {
    MAX_LINE = 1 << 20,  /* characters of a request */
    MAX_CELLS = 1 << 18, /* cells of an array, at most 2^18 - 1 */
    MAX_TERMS = 18,      /* of its state, since 2^18 - 1 cells are the terms of a period */
    MAX_WINDOW = 4096,   /* cells of a window or a mask: no profile has more */
    MAX_PATCH = 65535,   /* cells of a patch, observed or not */
    MAX_DEGREE = 63,     /* of a polynomial h over GF(q); and q^degree is below 2^63 */
    MAX_RUN = 200000     /* terms that are asked for at once: so many fit into a line */
};

#endif
