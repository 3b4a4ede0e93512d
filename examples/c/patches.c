#include "patches.h"

#include <stdlib.h>
#include <string.h>

#include "chances.h"
#include "locate.h"
#include "numbers.h"
#include "output.h"

static felt cells[MAX_PATCH];
static json chances[MAX_PATCH];
static patch given = {cells, 0, 0, 0};

/* The probabilities of a cell: q numbers, not negative, that add up to 1 within a thousandth. */
static bool are_chances(json list, unsigned q)
{
    unsigned count = 0;
    double sum = 0;
    for (json item = json_first(list); item != NULL; item = json_next(item), count++) {
        double chance = json_is_number(item) ? strtod(item, NULL) : -1;
        if (!(chance >= 0 && chance <= 2))
            return false;
        sum += chance;
    }
    return count == q && sum >= 1 - 0.001 - 1e-12 && sum <= 1 + 0.001 + 1e-12;
}

static bool read_felt(const array *a, json item, bool may_be_chances)
{
    uint64_t code = 0;
    if (may_be_chances && json_is_list(item) ? !are_chances(item, a->f.q)
                                             : !read_natural(item, &code) || code >= a->f.q)
        return false;
    cells[given.count].code = (uint8_t)code;
    chances[given.count] = json_is_list(item) ? item : NULL;
    return true;
}

/* A list of rows of one length. A cell is a code, null, or, where they are asked for, a list of
 * chances. */
static outcome read_patch(const array *a, json rows, bool may_be_chances)
{
    bool fits = true;
    given.count = given.rows = given.columns = 0;
    if (!json_is_list(rows))
        return INVALID;
    for (json row = json_first(rows); row != NULL; row = json_next(row), given.rows++) {
        uint32_t column = 0;
        if (!json_is_list(row))
            return INVALID;
        for (json item = json_first(row); item != NULL; item = json_next(item), column++) {
            fits = fits && given.rows * (uint64_t)given.columns + column < MAX_PATCH;
            if (json_is_null(item))
                continue;
            uint32_t k = fits ? given.count : 0;
            given.count = k;
            if (!read_felt(a, item, may_be_chances))
                return INVALID;
            cells[k].row = (uint16_t)given.rows;
            cells[k].column = (uint16_t)column;
            given.count = k + 1;
        }
        if (given.rows > 0 && column != given.columns)
            return INVALID;
        given.columns = column;
    }
    if (given.columns == 0)
        return INVALID;
    return fits ? ANSWERED : TOO_LARGE;
}

static void put_position(position at)
{
    put("{\"row\":");
    put_number(at.row);
    put(",\"column\":");
    put_number(at.column);
    put("}");
}

static outcome answer_places(const places *found)
{
    reply_with("result");
    put(found->count == 1 ? "{\"position\":" : "{\"positions\":[");
    for (uint32_t k = 0; k < found->count; k++) {
        if (k > 0)
            put(",");
        put_position(found->at[k]);
    }
    put(found->count == 1 ? "}" : "]}");
    return ANSWERED;
}

static places found;

outcome patches_locate(array *a, json input)
{
    outcome read = read_patch(a, json_member(input, "patch"), false);
    outcome located = read == ANSWERED ? locate(a, &given, &found) : read;
    return located == ANSWERED ? answer_places(&found) : located;
}

outcome patches_nearest(array *a, json input)
{
    json stated = json_member(input, "radius");
    uint64_t radius = 0;
    if (!json_is_null(stated) && !read_natural(stated, &radius))
        return INVALID;
    outcome read = read_patch(a, json_member(input, "patch"), false);
    outcome located = read == ANSWERED
                          ? nearest(a, &given, json_is_null(stated), radius, &found)
                          : read;
    return located == ANSWERED ? answer_places(&found) : located;
}

static unsigned symbols;

/* The chances of an observed cell, which is certain if it was given by a code. */
static void read_chances(uint32_t cell, double *values)
{
    double sum = 0;
    unsigned k = 0;
    if (chances[cell] == NULL) {
        for (k = 0; k < symbols; k++)
            values[k] = k == cells[cell].code;
        return;
    }
    for (json item = json_first(chances[cell]); item != NULL; item = json_next(item)) {
        values[k] = strtod(item, NULL);
        sum += values[k++];
    }
    for (k = 0; k < symbols; k++)
        values[k] /= sum;
}

outcome patches_posterior(array *a, json input)
{
    extent e;
    outcome read = read_patch(a, json_member(input, "patch"), true);
    symbols = a->f.q;
    outcome known = read == ANSWERED ? posterior(a, &given, read_chances, &e) : read;
    if (known != ANSWERED)
        return known;
    const char *separator = "[";
    reply_with("result");
    for (uint32_t k = 0; k < e.rows * e.columns; k++) {
        double chance = posterior_at(k);
        if (chance == 0)
            continue;
        put(separator);
        put("[");
        put_number(k / e.columns);
        put(",");
        put_number(k % e.columns);
        put(",");
        put_real(chance);
        put("]");
        separator = ",";
    }
    put("]");
    return ANSWERED;
}

/* A drawing such as ##./.##. Rows and columns that are blank at its end leave no trace. */
static outcome read_mask(json drawing)
{
    uint32_t row = 0, column = 0, columns = 0, count = 0;
    if (!json_is_string(drawing))
        return INVALID;
    json at = drawing + 1;
    for (;;) {
        int character = json_character(&at);
        if (character < 0 || character == '/') {
            if (row > 0 && column != columns)
                return INVALID;
            columns = column;
            column = 0;
            row++;
            if (character < 0)
                break;
        } else if (character == '#' || character == '.') {
            if (character == '#' && count < MAX_PATCH)
                cells[count++] = (felt){(uint16_t)row, (uint16_t)column, 0};
            column++;
        } else {
            return INVALID;
        }
    }
    given.count = count;
    if (count == 0 || count > MAX_WINDOW)
        return INVALID;
    return row > UINT16_MAX || columns > UINT16_MAX ? TOO_LARGE : ANSWERED;
}

outcome patches_prove(array *a, json input)
{
    outcome read = read_mask(json_member(input, "mask"));
    if (read != ANSWERED)
        return read;
    extent e = admissible(a, a->beyond, &given);
    if (e.rows == 0)
        return OFF_SHEET;
    uint32_t contents = mask_contents(a, &given);
    reply_with("result");
    put(contents == e.rows * e.columns ? "{\"proved\":true" : "{\"proved\":false");
    put(",\"rank\":");
    if (a->beyond == SHEET || a->beyond == array_own_surface(a))
        put_number(mask_rank(a, &given));
    else
        put("null");
    put(",\"windows\":");
    put_number(contents);
    put("}");
    return ANSWERED;
}

outcome patches_distance(array *a, json input)
{
    outcome read = read_mask(json_member(input, "mask"));
    if (read != ANSWERED)
        return read;
    reply_with("result");
    put_number(mask_distance(a, &given));
    return ANSWERED;
}
