/* lumen_table_build.c - arranges the lines of a table of coefficients of utilization,
 * in any order, in a grid over its axes. */
#include "methods/lumen/lumen_table_build.h"

#include <math.h>
#include <stdlib.h>

/* The index of `value` on the axis; a new value is inserted in order. -1: the axis is
 * full. */
static int insert_on(struct pp_lumen_axis *axis, double value)
{
    int i = 0;
    while (i < axis->count && axis->at[i] < value)
        i++;
    if (i < axis->count && axis->at[i] == value)
        return i;
    if (axis->count == PP_LUMEN_AXIS_MOST)
        return -1;
    for (int k = axis->count++; k > i; k--)
        axis->at[k] = axis->at[k - 1];
    axis->at[i] = value;
    return i;
}

static int find_on(const struct pp_lumen_axis *axis, double value)
{
    for (int i = 0; i < axis->count; i++)
        if (axis->at[i] == value)
            return i;
    return 0;
}

/* The number of cells along an axis; 1 for an axis that the table does not have. */
static int cells_of(const struct pp_lumen_axis *axis)
{
    return axis->count > 0 ? axis->count : 1;
}

size_t pp_lumen_table_build_cell(const struct pp_lumen_side_table *table, int light,
                                 const int at[PP_LUMEN_SIDE_AXES], int position)
{
    size_t cell = (size_t)light;
    for (int axis = PP_LUMEN_CEILING; axis <= PP_LUMEN_DEPTH; axis++)
        cell = cell * (size_t)cells_of(&table->axes[axis]) + (size_t)at[axis];
    return (cell * PP_LUMEN_POSITIONS + (size_t)position) * (size_t)table->pitch
           + (size_t)at[PP_LUMEN_WIDTH];
}

static void too_many(struct pp_mistakes *mistakes, int line, const char *what)
{
    pp_mistakes_add(mistakes, line, "more than %d different %s", PP_LUMEN_AXIS_MOST,
                    what);
}

static double *cells_create(size_t count)
{
    double *cells = malloc(count * sizeof *cells);
    for (size_t i = 0; cells && i < count; i++)
        cells[i] = NAN;
    return cells;
}

/* Collects the axes of the lines. False if an axis is too long, which is noted as a
 * mistake. */
static bool collect_axes(struct pp_lumen_side_table *table,
                         const struct pp_lumen_line *lines, int count,
                         struct pp_mistakes *mistakes)
{
    static const char *const names[] = {"ceiling reflectances", "wall reflectances",
                                        "room depths"};
    for (int i = 0; i < count; i++) {
        const double at[] = {lines[i].ceiling, lines[i].walls, lines[i].depth};
        for (int axis = 0; axis < 3; axis++)
            if (!isnan(at[axis]) && insert_on(&table->axes[axis], at[axis]) < 0) {
                too_many(mistakes, lines[i].line, names[axis]);
                return false;
            }
        if (!isnan(lines[i].light) && insert_on(&table->sky, lines[i].light) < 0) {
            too_many(mistakes, lines[i].line, "skies");
            return false;
        }
    }
    return true;
}

enum pp_status pp_lumen_table_build_side(struct pp_lumen_side_table *table,
                                         const struct pp_lumen_axis *widths,
                                         const struct pp_lumen_line *lines, int count,
                                         struct pp_mistakes *mistakes,
                                         struct pp_error *err)
{
    *table = (struct pp_lumen_side_table){0};
    table->axes[PP_LUMEN_WIDTH] = *widths;
    if (!collect_axes(table, lines, count, mistakes))
        return pp_fail(err, PP_BAD_INPUT, "the table has too many lines");
    size_t size = (size_t)(table->sky.count + 1) * PP_LUMEN_POSITIONS;
    for (int axis = 0; axis < PP_LUMEN_SIDE_AXES; axis++)
        size *= (size_t)cells_of(&table->axes[axis]);
    table->pitch = widths->count;
    table->cu = table->made = cells_create(size);
    if (!table->made)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++) {
        int at[PP_LUMEN_SIDE_AXES] = {
            find_on(&table->axes[PP_LUMEN_CEILING], lines[i].ceiling),
            find_on(&table->axes[PP_LUMEN_WALLS], lines[i].walls),
            find_on(&table->axes[PP_LUMEN_DEPTH], lines[i].depth), 0};
        int light = isnan(lines[i].light) ? table->sky.count
                                          : find_on(&table->sky, lines[i].light);
        double *cell = table->made
                       + pp_lumen_table_build_cell(table, light, at, lines[i].position);
        if (!isnan(cell[0]))
            pp_mistakes_add(mistakes, lines[i].line,
                            "duplicate line; an earlier line already gives "
                            "coefficients for these values");
        for (int k = 0; k < widths->count; k++)
            cell[k] = lines[i].cu[k];
    }
    return PP_OK;
}

enum pp_status pp_lumen_table_build_top(struct pp_lumen_top_table *table,
                                        const struct pp_lumen_top_line *lines,
                                        int count, struct pp_mistakes *mistakes,
                                        struct pp_error *err)
{
    static const char *const names[] = {"room cavity ratios", "ceiling reflectances",
                                        "wall reflectances"};
    *table = (struct pp_lumen_top_table){0};
    size_t size = 1;
    for (int i = 0; i < count; i++) {
        const double at[] = {lines[i].rcr, lines[i].ceiling, lines[i].walls};
        for (int axis = 0; axis < PP_LUMEN_TOP_AXES; axis++)
            if (insert_on(&table->axes[axis], at[axis]) < 0) {
                too_many(mistakes, lines[i].line, names[axis]);
                return pp_fail(err, PP_BAD_INPUT, "the table has too many lines");
            }
    }
    for (int axis = 0; axis < PP_LUMEN_TOP_AXES; axis++)
        size *= (size_t)cells_of(&table->axes[axis]);
    table->cu = cells_create(size);
    if (!table->cu)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++) {
        int r = find_on(&table->axes[0], lines[i].rcr);
        int c = find_on(&table->axes[1], lines[i].ceiling);
        int w = find_on(&table->axes[2], lines[i].walls);
        double *cell =
            table->cu + (r * table->axes[1].count + c) * table->axes[2].count + w;
        if (!isnan(*cell))
            pp_mistakes_add(mistakes, lines[i].line,
                            "duplicate line; an earlier line already gives a "
                            "coefficient for these values");
        *cell = lines[i].cu;
    }
    return PP_OK;
}
