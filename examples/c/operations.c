#include "operations.h"

#include "numbers.h"
#include "output.h"
#include "patches.h"

static bool read_code(const array *a, json value, uint8_t *code)
{
    uint64_t number;
    if (!read_natural(value, &number) || number >= a->f.q)
        return false;
    *code = (uint8_t)number;
    return true;
}

static outcome answer(uint64_t number)
{
    reply_with("result");
    put_number(number);
    return ANSWERED;
}

static outcome answer_codes(const uint8_t *codes, uint64_t from, uint64_t length, uint64_t period)
{
    reply_with("result");
    put("[");
    for (uint64_t k = 0; k < length; k++) {
        if (k > 0)
            put(",");
        put_number(codes[(from + k) % period]);
    }
    put("]");
    return ANSWERED;
}

/* The field */

static outcome binary(array *a, json input,
                      uint8_t (*function)(const field *, uint8_t, uint8_t))
{
    uint8_t x, y;
    if (!read_code(a, json_member(input, "a"), &x) || !read_code(a, json_member(input, "b"), &y))
        return INVALID;
    return answer(function(&a->f, x, y));
}

static outcome add(array *a, json input)
{
    return binary(a, input, field_add);
}

static outcome multiply(array *a, json input)
{
    return binary(a, input, field_multiply);
}

static outcome negate(array *a, json input)
{
    uint8_t x;
    return read_code(a, json_member(input, "a"), &x) ? answer(field_negate(&a->f, x)) : INVALID;
}

static outcome trace(array *a, json input)
{
    uint8_t x;
    return read_code(a, json_member(input, "a"), &x) ? answer(field_trace(&a->f, x)) : INVALID;
}

static outcome inverse(array *a, json input)
{
    uint8_t x;
    if (!read_code(a, json_member(input, "a"), &x))
        return INVALID;
    return x == 0 ? DIVISION_BY_ZERO : answer(field_inverse(&a->f, x));
}

static outcome power(array *a, json input)
{
    uint8_t x;
    uint32_t rest;
    bool zero, negative;
    if (!read_code(a, json_member(input, "a"), &x) ||
        !read_integer(json_member(input, "exponent"), a->f.q - 1, &rest, &zero, &negative))
        return INVALID;
    if (x == 0)
        return zero ? answer(1) : negative ? DIVISION_BY_ZERO : answer(0);
    return answer(a->f.exp[a->f.log[x] * rest % (a->f.q - 1)]);
}

static outcome logarithm(array *a, json input)
{
    uint8_t x;
    if (!read_code(a, json_member(input, "a"), &x))
        return INVALID;
    return x == 0 ? OUT_OF_RANGE : answer(a->f.log[x]);
}

/* Polynomials */

static outcome primitive(array *a, json input)
{
    json list = json_member(input, "polynomial");
    static polynomial h;
    uint32_t terms = 0; /* up to the last one that is not 0 */
    uint8_t lowest = 0, highest = 0, code;
    if (!json_is_list(list))
        return INVALID;
    uint32_t k = 0;
    for (json item = json_first(list); item != NULL; item = json_next(item), k++) {
        if (!read_code(a, item, &code))
            return INVALID;
        if (k <= MAX_DEGREE)
            h.c[k] = code;
        if (k == 0)
            lowest = code;
        if (code != 0) {
            terms = k + 1;
            highest = code;
        }
    }
    bool candidate = terms >= 2 && highest == 1 && lowest != 0;
    if (candidate && (terms > MAX_DEGREE + 1 || field_period(&a->f, terms - 1) == 0))
        return TOO_LARGE;
    h.degree = candidate ? terms - 1 : 0;
    reply_with("result");
    put(candidate && polynomial_is_primitive(&a->f, &h) ? "true" : "false");
    return ANSWERED;
}

static outcome first_primitive(array *a, json input)
{
    static polynomial h;
    uint64_t degree;
    if (!read_natural(json_member(input, "degree"), &degree) || degree == 0)
        return INVALID;
    if (degree > MAX_DEGREE || field_period(&a->f, (unsigned)degree) == 0)
        return TOO_LARGE;
    h.degree = (unsigned)degree;
    polynomial_first_primitive(&a->f, &h);
    return answer_codes(h.c, 0, degree + 1, degree + 1);
}

/* The sequence and the array */

static outcome term(array *a, json input)
{
    uint32_t index;
    if (!read_modulo(json_member(input, "index"), a->size, &index))
        return INVALID;
    return answer(array_terms(a)[index]);
}

static outcome terms(array *a, json input)
{
    uint32_t from;
    uint64_t length;
    if (!read_modulo(json_member(input, "from"), a->size, &from) ||
        !read_natural(json_member(input, "length"), &length))
        return INVALID;
    return length > MAX_RUN ? TOO_LARGE : answer_codes(array_terms(a), from, length, a->size);
}

static outcome cell(array *a, json input)
{
    uint32_t row, column;
    if (!read_modulo(json_member(input, "row"), a->size, &row) ||
        !read_modulo(json_member(input, "column"), a->size, &column))
        return INVALID;
    return answer(array_terms(a)[array_index(a, row, column)]);
}

/* Windows as numbers */

static uint8_t window[MAX_WINDOW];

static outcome pack(array *a, json input)
{
    static large packed;
    json cells = json_member(input, "cells");
    uint32_t count = a->window_rows * a->window_columns, given = 0;
    if (!json_is_list(cells))
        return INVALID;
    for (json item = json_first(cells); item != NULL; item = json_next(item))
        if (given == count || !read_code(a, item, &window[given++]))
            return INVALID;
    if (given < count)
        return INVALID;
    packed.used = 0;
    for (uint32_t k = 0; k < count; k++)
        large_multiply_add(&packed, a->f.q,
                           window[a->most_significant_first ? k : count - 1 - k]);
    reply_with("result");
    large_put(&packed);
    return ANSWERED;
}

static outcome unpack(array *a, json input)
{
    static large packed;
    uint32_t count = a->window_rows * a->window_columns;
    if (!read_large(json_member(input, "packed"), &packed))
        return INVALID;
    for (uint32_t k = 0; k < count; k++)
        window[a->most_significant_first ? count - 1 - k : k] =
            (uint8_t)large_divide(&packed, a->f.q);
    return packed.used > 0 ? OUT_OF_RANGE : answer_codes(window, 0, count, count);
}

/* All of them */

static const struct {
    const char *name;
    outcome (*run)(array *a, json input);
} operations[] = {
    {"add", add},
    {"multiply", multiply},
    {"negate", negate},
    {"inverse", inverse},
    {"power", power},
    {"logarithm", logarithm},
    {"trace", trace},
    {"primitive", primitive},
    {"first-primitive", first_primitive},
    {"term", term},
    {"terms", terms},
    {"cell", cell},
    {"pack", pack},
    {"unpack", unpack},
    {"locate", patches_locate},
    {"nearest", patches_nearest},
    {"posterior", patches_posterior},
    {"prove", patches_prove},
    {"distance", patches_distance},
};

enum { OPERATIONS = sizeof operations / sizeof operations[0] };

outcome operations_run(array *a, json operation, json input)
{
    for (int k = 0; k < OPERATIONS; k++)
        if (json_equals(operation, operations[k].name))
            return operations[k].run(a, input);
    return UNKNOWN;
}

void operations_put(void)
{
    for (int k = 0; k < OPERATIONS; k++) {
        put(k == 0 ? "[\"" : ",\"");
        put(operations[k].name);
        put("\"");
    }
    put("]");
}
