#include "profile.h"

#include <stddef.h>

#include "numbers.h"

static bool read_name(json value, const char *const *names, int *chosen)
{
    for (*chosen = 0; names[*chosen] != NULL; ++*chosen)
        if (json_equals(value, names[*chosen]))
            return true;
    return false;
}

/* At most `room` numbers are kept; how many there are is counted. */
static bool read_numbers(json list, uint64_t *numbers, unsigned room, unsigned *count)
{
    *count = 0;
    if (!json_is_list(list))
        return false;
    for (json item = json_first(list); item != NULL; item = json_next(item), ++*count) {
        uint64_t number;
        if (!read_natural(item, &number))
            return false;
        if (*count < room)
            numbers[*count] = number;
    }
    return true;
}

static bool read_pair(json list, uint64_t pair[2])
{
    unsigned count;
    return read_numbers(list, pair, 2, &count) && count == 2;
}

typedef struct {
    uint64_t q, modulus[9], h[MAX_DEGREE + 1], state[MAX_DEGREE], shape[2], window[2];
    unsigned modulus_terms, h_terms, state_terms;
    int fold, beyond, packing, reading;
} stated;

static bool read_stated(stated *s, json profile)
{
    static const char *const folds[] = {"diagonal", "row-major", NULL};
    static const char *const beyond[] = {"torus", "twisted-torus", "sheet", NULL};
    static const char *const packings[] = {"least-significant-first", "most-significant-first",
                                           NULL};
    static const char *const readings[] = {"characteristic", "reciprocal", NULL};
    json schema = json_member(profile, "schema");
    return schema != NULL && json_equals(schema, "pra-tactile/profile/1") &&
           read_natural(json_member(profile, "q"), &s->q) &&
           read_numbers(json_member(profile, "modulus"), s->modulus, 9, &s->modulus_terms) &&
           read_numbers(json_member(profile, "polynomial"), s->h, MAX_DEGREE + 1, &s->h_terms) &&
           read_numbers(json_member(profile, "state"), s->state, MAX_DEGREE, &s->state_terms) &&
           read_pair(json_member(profile, "shape"), s->shape) &&
           read_pair(json_member(profile, "window"), s->window) &&
           read_name(json_member(profile, "folding"), folds, &s->fold) &&
           read_name(json_member(profile, "surface"), beyond, &s->beyond) &&
           read_name(json_member(profile, "packing"), packings, &s->packing) &&
           read_name(json_member(profile, "reading"), readings, &s->reading);
}

/* Codes below q, not all of them zeros. */
static bool copy_codes(const field *f, const uint64_t *given, unsigned count, uint8_t *codes)
{
    bool some = false;
    for (unsigned k = 0; k < count; k++) {
        if (given[k] >= f->q)
            return false;
        codes[k] = (uint8_t)given[k];
        some = some || codes[k] != 0;
    }
    return some;
}

/* x^n h(1/x), made monic. */
static void reciprocal(const field *f, polynomial *h)
{
    polynomial given = *h;
    uint8_t inverse = field_inverse(f, given.c[0]);
    for (unsigned k = 0; k <= h->degree; k++)
        h->c[k] = field_multiply(f, inverse, given.c[h->degree - k]);
}

/* q^n - 1 cells, and a window that is not too large. */
static outcome check_sizes(array *a, const stated *s)
{
    uint64_t order = s->h_terms > MAX_DEGREE + 1 ? 0 : field_period(&a->f, a->h.degree);
    uint64_t n1 = s->shape[0], n2 = s->shape[1];
    if (n1 == 0 || n2 == 0 || s->window[0] == 0 || s->window[1] == 0 ||
        s->window[0] > MAX_WINDOW || s->window[1] > MAX_WINDOW / s->window[0])
        return IMPOSSIBLE;
    bool vast = n1 > ((uint64_t)1 << 63) / n2;
    if (order == 0 || vast)
        return order == 0 && vast ? TOO_LARGE : IMPOSSIBLE;
    return n1 * n2 == order - 1 ? ANSWERED : IMPOSSIBLE;
}

outcome profile_read(array *a, json profile)
{
    static stated s;
    if (!read_stated(&s, profile))
        return INVALID;
    a->has_terms = a->has_cells = false;
    if (s.h_terms <= MAX_DEGREE + 1)
        while (s.h_terms > 0 && s.h[s.h_terms - 1] == 0)
            s.h_terms--;
    if (!field_make(&a->f, s.q, s.modulus, s.modulus_terms) || s.h_terms < 2 ||
        s.state_terms != s.h_terms - 1)
        return IMPOSSIBLE;
    a->h.degree = s.h_terms - 1;
    outcome sizes = check_sizes(a, &s);
    if (sizes != ANSWERED)
        return sizes;
    if (!copy_codes(&a->f, s.h, s.h_terms, a->h.c) ||
        !copy_codes(&a->f, s.state, s.state_terms, a->state) ||
        !polynomial_is_primitive(&a->f, &a->h))
        return IMPOSSIBLE;
    if (s.reading == 1)
        reciprocal(&a->f, &a->h);
    if (s.shape[0] * s.shape[1] > MAX_CELLS)
        return TOO_LARGE;
    a->rows = (unsigned)s.shape[0];
    a->columns = (unsigned)s.shape[1];
    a->size = a->rows * a->columns;
    a->window_rows = (unsigned)s.window[0];
    a->window_columns = (unsigned)s.window[1];
    a->fold = (folding)s.fold;
    a->beyond = (surface)s.beyond;
    a->most_significant_first = s.packing == 1;
    a->inverse = inverse_modulo(a->rows, a->columns);
    return a->fold == DIAGONAL && a->inverse == 0 && a->columns > 1 ? IMPOSSIBLE : ANSWERED;
}
