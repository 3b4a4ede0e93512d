#include "locate.h"

#include <string.h>

extent admissible(const array *a, surface beyond, const patch *p)
{
    extent e = {a->rows, a->columns};
    for (uint32_t k = 0; beyond == SHEET && k < p->count; k++) {
        uint32_t row = p->cell[k].row, column = p->cell[k].column;
        if (row >= a->rows || column >= a->columns)
            return (extent){0, 0};
        if (e.rows > a->rows - row)
            e.rows = a->rows - row;
        if (e.columns > a->columns - column)
            e.columns = a->columns - column;
    }
    return e;
}

uint8_t cell_from(const array *a, surface beyond, position from, const felt *cell)
{
    uint64_t row = (uint64_t)from.row + cell->row, column = (uint64_t)from.column + cell->column;
    if (beyond == TWISTED_TORUS)
        return a->cells[(row * a->columns + column) % a->size];
    return a->cells[row % a->rows * a->columns + column % a->columns];
}

/* How often the observed cells differ from the array, for every position at once. One cell after
 * the other is compared everywhere, along whole rows, of which compilers make vector instructions. */
static uint16_t counts[MAX_CELLS];

static void count_run(uint16_t *count, const uint8_t *cells, uint32_t length, uint8_t code)
{
    for (uint32_t k = 0; k < length; k++)
        count[k] = (uint16_t)(count[k] + (cells[k] != code));
}

static void count_cell(const array *a, surface beyond, extent e, const felt *cell, uint8_t code)
{
    if (beyond == TWISTED_TORUS) {
        uint32_t start =
            (uint32_t)(((uint64_t)cell->row * a->columns + cell->column) % a->size);
        count_run(counts, a->cells + start, a->size - start, code);
        count_run(counts + a->size - start, a->cells, start, code);
        return;
    }
    uint32_t start = cell->column % a->columns, before = a->columns - start;
    if (before > e.columns)
        before = e.columns;
    for (uint32_t r = 0; r < e.rows; r++) {
        const uint8_t *row = a->cells + (r + cell->row % a->rows) % a->rows * a->columns;
        uint16_t *count = counts + r * e.columns;
        count_run(count, row + start, before, code);
        count_run(count + before, row, e.columns - before, code);
    }
}

/* The least of the counts. They are of cells that are not 0 instead, if so it is asked. */
static uint32_t count_differences(array *a, surface beyond, extent e, const patch *p, bool nonzero)
{
    array_cells(a);
    memset(counts, 0, sizeof counts[0] * e.rows * e.columns);
    for (uint32_t k = 0; k < p->count; k++)
        count_cell(a, beyond, e, &p->cell[k], nonzero ? 0 : p->cell[k].code);
    uint32_t least = UINT32_MAX;
    for (uint32_t k = 0; k < e.rows * e.columns; k++)
        if (counts[k] < least)
            least = counts[k];
    return least;
}

/* The nearest positions, if they differ in no more cells than the radius. */
static bool within(array *a, const patch *p, uint64_t radius, places *found)
{
    extent e = admissible(a, a->beyond, p);
    uint32_t least = count_differences(a, a->beyond, e, p, false);
    found->count = 0;
    if (least > radius || least == UINT32_MAX)
        return false;
    for (uint32_t k = 0; k < e.rows * e.columns; k++)
        if (counts[k] == least)
            found->at[found->count++] =
                (position){k / e.columns, k % e.columns};
    return true;
}

/* What was felt of the patch's rectangle, row by row; -1 for what was not. */
static int16_t grid[MAX_PATCH];

static void fill_grid(const patch *p)
{
    for (uint32_t k = 0; k < p->rows * p->columns; k++)
        grid[k] = -1;
    for (uint32_t k = 0; k < p->count; k++)
        grid[p->cell[k].row * p->columns + p->cell[k].column] = p->cell[k].code;
}

typedef struct {
    uint32_t row, column;
} offset;

static bool is_complete(const array *a, const patch *p, offset at)
{
    if (at.column + a->window_columns > p->columns)
        return false;
    for (uint32_t i = 0; i < a->window_rows; i++)
        for (uint32_t j = 0; j < a->window_columns; j++)
            if (grid[(at.row + i) * p->columns + at.column + j] < 0)
                return false;
    return true;
}

/* The next complete window from an offset on, row by row. */
static bool next_window(const array *a, const patch *p, offset *at)
{
    for (; at->row + a->window_rows <= p->rows; at->row++, at->column = 0)
        for (; at->column < p->columns; at->column++)
            if (is_complete(a, p, *at))
                return true;
    return false;
}

/* The window at an offset, as a patch. */
static const patch *window_at(const array *a, const patch *p, offset at)
{
    static felt cell[MAX_WINDOW];
    static patch window = {cell, 0, 0, 0};
    window.count = 0;
    for (uint32_t i = 0; i < a->window_rows; i++)
        for (uint32_t j = 0; j < a->window_columns; j++)
            window.cell[window.count++] =
                (felt){(uint16_t)i, (uint16_t)j,
                       (uint8_t)grid[(at.row + i) * p->columns + at.column + j]};
    return &window;
}

static bool is_zero(const patch *p)
{
    for (uint32_t k = 0; k < p->count; k++)
        if (p->cell[k].code != 0)
            return false;
    return true;
}

/* Whether what lies on the sheet of the observed cells agrees, the patch being at a place that may
 * lie beyond its edges. */
static bool agrees_on_sheet(const array *a, const patch *p, int64_t row, int64_t column)
{
    for (uint32_t k = 0; k < p->count; k++) {
        int64_t r = row + p->cell[k].row, c = column + p->cell[k].column;
        if (r >= 0 && r < a->rows && c >= 0 && c < a->columns &&
            a->cells[r * a->columns + c] != p->cell[k].code)
            return false;
    }
    return true;
}

/* Whether every window that occurs on the sheet lies on it if the patch, which agrees, is there. */
static bool is_common_place(array *a, const patch *p, int64_t row, int64_t column)
{
    static places occurrences;
    offset at = {0, 0};
    for (; next_window(a, p, &at); at.column++) {
        int64_t r = row + at.row, c = column + at.column;
        bool on_sheet = r >= 0 && r + a->window_rows <= a->rows && c >= 0 &&
                        c + a->window_columns <= a->columns;
        if (!on_sheet && within(a, window_at(a, p, at), 0, &occurrences))
            return false;
    }
    return true;
}

/* The reason for which a patch with complete windows is nowhere. */
static outcome why_nowhere(array *a, const patch *p)
{
    static places occurrences;
    bool zeros = true, occurs = false;
    offset at = {0, 0};
    for (; next_window(a, p, &at); at.column++) {
        const patch *window = window_at(a, p, at);
        zeros = zeros && is_zero(window);
        occurs = within(a, window, 0, &occurrences);
        if (occurs)
            break;
    }
    if (!occurs)
        return zeros ? ZERO_WINDOW : NOT_IN_ARRAY;
    for (uint32_t k = 0; a->beyond == SHEET && k < occurrences.count; k++) {
        int64_t row = (int64_t)occurrences.at[k].row - at.row;
        int64_t column = (int64_t)occurrences.at[k].column - at.column;
        if (agrees_on_sheet(a, p, row, column) && is_common_place(a, p, row, column))
            return OFF_SHEET;
    }
    return CONTRADICTION;
}

outcome locate(array *a, const patch *p, places *found)
{
    if (p->count == 0)
        return TOO_FEW_CELLS;
    offset at = {0, 0};
    fill_grid(p);
    if (!next_window(a, p, &at))
        return NO_COMPLETE_WINDOW;
    /* Where every cell agrees every complete window occurs, so that these are the common places of
     * the windows that occur, as far as all other cells agree there too. */
    return within(a, p, 0, found) ? ANSWERED : why_nowhere(a, p);
}

outcome nearest(array *a, const patch *p, bool guaranteed, uint64_t radius, places *found)
{
    if (p->count == 0)
        return TOO_FEW_CELLS;
    if (guaranteed) {
        uint32_t distance = mask_distance(a, p);
        bool promised = a->beyond == SHEET || a->beyond == array_own_surface(a);
        radius = distance == 0 || !promised ? 0 : (distance - 1) / 2;
    }
    if (within(a, p, radius, found))
        return ANSWERED;
    offset at = {0, 0};
    fill_grid(p);
    if (radius == 0 && next_window(a, p, &at))
        return why_nowhere(a, p);
    uint64_t nonzero = 0;
    for (uint32_t k = 0; k < p->count; k++)
        nonzero += p->cell[k].code != 0;
    if (nonzero <= radius)
        return ZERO_WINDOW;
    return radius == 0 ? CONTRADICTION : BEYOND_RADIUS;
}

/* The difference of two shifts of an m-sequence is a third one, or zeros if they are the same. So
 * two windows differ in as many cells at least as a window has cells that are not 0. */
uint32_t mask_distance(array *a, const patch *mask)
{
    return count_differences(a, array_own_surface(a), (extent){a->rows, a->columns}, mask, true);
}
