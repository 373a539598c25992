/* lumen_table.c - the program's tables of coefficients of utilization, and
 * interpolation in any table. */
#include "methods/lumen/lumen_table.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "methods/lumen/lumen_table_build.h"

/* Columns: Ev/Eh (NAN: ground), ceiling and wall reflectance, depth, position in per
 * cent of the depth (NAN: average), then the coefficients for own_widths. */
enum { OWN_COLUMNS = 13 };
static const double own_side[][OWN_COLUMNS] = {
#include "tables/lumen_sidelight.inc"
};
static const struct pp_lumen_axis own_widths = {8, {0.5, 1, 2, 3, 4, 6, 8, INFINITY}};

static const double own_top[][4] = {
#include "tables/lumen_toplight.inc"
};

enum {
    OWN_SIDE = sizeof own_side / sizeof own_side[0],
    OWN_TOP = sizeof own_top / sizeof own_top[0],
};

/* Tables with Ev/Eh of this value or more are for clear skies, those below for overcast
 * skies. */
static const double clear_from = 0.45;

/* A value outside a range by at most this still counts as inside. */
static const double range_tolerance = 1e-3;

/* Ascending values in a key column; each value covers `step` rows. */
static struct pp_lumen_axis own_axis(int column, int step)
{
    struct pp_lumen_axis axis = {0};
    for (int i = 0; i < OWN_SIDE && axis.count < PP_LUMEN_AXIS_MOST; i += step) {
        double value = own_side[i][column];
        if (isnan(value) || (axis.count > 0 && value <= axis.at[axis.count - 1]))
            break;
        axis.at[axis.count++] = value;
    }
    return axis;
}

/* Side table of the program. Its rows are in grid order, position varying fastest, so
 * that the table is used in place. */
static struct pp_lumen_side_table own_side_table(void)
{
    static const int columns[] = {
        [PP_LUMEN_CEILING] = 1, [PP_LUMEN_WALLS] = 2, [PP_LUMEN_DEPTH] = 3};
    struct pp_lumen_side_table side = {.cu = own_side[0] + 5,
                                       .pitch = OWN_COLUMNS,
                                       .axes[PP_LUMEN_WIDTH] = own_widths};
    int step = PP_LUMEN_POSITIONS;
    for (int axis = PP_LUMEN_DEPTH; axis >= PP_LUMEN_CEILING; axis--) {
        side.axes[axis] = own_axis(columns[axis], step);
        step *= side.axes[axis].count;
    }
    side.sky = own_axis(0, step);
    assert((side.sky.count + 1) * step == OWN_SIDE);
    return side;
}

static enum pp_status build_own(struct pp_lumen_table *table,
                                struct pp_lumen_top_line *top, struct pp_error *err)
{
    table->side = own_side_table();
    for (int i = 0; i < OWN_TOP; i++)
        top[i] = (struct pp_lumen_top_line){own_top[i][0], own_top[i][1], own_top[i][2],
                                            own_top[i][3], 0};
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "the built-in table");
    enum pp_status status =
        pp_lumen_table_build_top(&table->top, top, OWN_TOP, &mistakes, err);
    pp_mistakes_clear(&mistakes);
    return status;
}

enum pp_status pp_lumen_table_create(struct pp_lumen_table **result,
                                     struct pp_error *err)
{
    struct pp_lumen_table *table = calloc(1, sizeof *table);
    struct pp_lumen_top_line *top = malloc(OWN_TOP * sizeof *top);
    enum pp_status status =
        table && top ? build_own(table, top, err) : pp_fail_memory(err);
    free(top);
    if (status == PP_OK)
        *result = table;
    else
        pp_lumen_table_destroy(table);
    return status;
}

void pp_lumen_table_destroy(struct pp_lumen_table *table)
{
    if (!table)
        return;
    free(table->side.made);
    free(table->top.cu);
    free(table);
}

/* Two neighbouring values on an axis, and the position between them: 0 at low, 1 at
 * high. */
struct between {
    int low, high;
    double share;
};

static bool find_between(struct between *between, const struct pp_lumen_axis *axis,
                         int first, double value, bool reciprocal)
{
    *between = (struct between){0, 0, 0.0};
    if (axis->count == 0)
        return true;
    int last = axis->count - 1;
    if (!(first <= last && value >= axis->at[first] - range_tolerance
          && value <= axis->at[last] + range_tolerance))
        return false;
    int i = first;
    while (i < last && axis->at[i + 1] < value)
        i++;
    *between = (struct between){i, i < last ? i + 1 : i, 0.0};
    double low = axis->at[i], high = axis->at[between->high];
    if (high > low) {
        double share = reciprocal ? (1.0 / low - 1.0 / value) / (1.0 / low - 1.0 / high)
                                  : (value - low) / (high - low);
        between->share = fmin(fmax(share, 0.0), 1.0);
    }
    return true;
}

/* The coefficient at one position for one sky or the ground, from the 16 neighbours:
 * along the width first, then depth, walls and ceiling. A neighbour whose weight is 0
 * may be missing from the table. */
static double interpolate(const struct pp_lumen_side_table *table, int light,
                          const struct between between[PP_LUMEN_SIDE_AXES],
                          int position)
{
    double values[1 << PP_LUMEN_SIDE_AXES];
    for (int corner = 0; corner < 1 << PP_LUMEN_SIDE_AXES; corner++) {
        int at[PP_LUMEN_SIDE_AXES];
        for (int axis = 0; axis < PP_LUMEN_SIDE_AXES; axis++)
            at[axis] = corner >> axis & 1 ? between[axis].high : between[axis].low;
        values[corner] =
            table->cu[pp_lumen_table_build_cell(table, light, at, position)];
    }
    for (int axis = PP_LUMEN_SIDE_AXES - 1; axis >= 0; axis--) {
        double t = between[axis].share;
        for (int k = 0; k < 1 << axis; k++) {
            double low = values[k], high = values[k + (1 << axis)];
            bool geometric = axis == PP_LUMEN_DEPTH || axis == PP_LUMEN_WIDTH;
            values[k] = t == 0.0    ? low
                        : t == 1.0  ? high
                        : geometric ? low * pow(high / low, t)
                                    : low + t * (high - low);
        }
    }
    return values[0];
}

static const char *const axis_names[PP_LUMEN_SIDE_AXES] = {
    [PP_LUMEN_CEILING] = "is in a room whose ceiling reflectance is",
    [PP_LUMEN_WALLS] = "is in a room whose mean wall reflectance is",
    [PP_LUMEN_DEPTH] = "is in a room whose ratio of depth to window height is",
    [PP_LUMEN_WIDTH] = "is in a room whose ratio of width to window height is",
};

/* Writes a message that a value is outside its axis; returns false. */
static bool outside(char *why, size_t room, const char *what, double value,
                    const struct pp_lumen_axis *axis, int first)
{
    if (first >= axis->count)
        snprintf(why, room, "%s %.3g; the table has no such value", what, value);
    else
        snprintf(why, room, "%s %.3g; the table covers %.3g to %.3g", what, value,
                 axis->at[first], axis->at[axis->count - 1]);
    return false;
}

/* Finds the two skies to interpolate between, or the ground. Returns false, with a
 * message, if the table covers no such sky. */
static bool find_light(struct between *light, const struct pp_lumen_side_table *table,
                       const struct pp_lumen_query *query, char *why, size_t room)
{
    int clear = 0;
    while (clear < table->sky.count && table->sky.at[clear] < clear_from)
        clear++;
    if (isnan(query->ev_over_eh)) {
        *light = (struct between){table->sky.count, table->sky.count, 0.0};
        return true;
    }
    if (query->overcast) {
        if (clear == 0) {
            snprintf(why, room,
                     "faces an overcast sky, but the table covers only clear skies, "
                     "with Ev/Eh of %.3g or more",
                     table->sky.count > 0 ? table->sky.at[0] : NAN);
            return false;
        }
        *light = (struct between){clear - 1, clear - 1, 0.0};
        return true;
    }
    if (!find_between(light, &table->sky, clear, query->ev_over_eh, false))
        return outside(why, room, "faces a sky whose Ev/Eh is", query->ev_over_eh,
                       &table->sky, clear);
    return true;
}

bool pp_lumen_table_side(double cu[PP_LUMEN_POSITIONS],
                         const struct pp_lumen_table *table,
                         const struct pp_lumen_query *query, char *why, size_t room)
{
    const struct pp_lumen_side_table *side = &table->side;
    struct between light, between[PP_LUMEN_SIDE_AXES];
    if (!find_light(&light, side, query, why, room))
        return false;
    for (int axis = 0; axis < PP_LUMEN_SIDE_AXES; axis++)
        if (!find_between(&between[axis], &side->axes[axis], 0, query->at[axis],
                          axis == PP_LUMEN_WIDTH))
            return outside(why, room, axis_names[axis], query->at[axis],
                           &side->axes[axis], 0);
    double five = 0.0;
    for (int k = 0; k < PP_LUMEN_POSITIONS; k++) {
        double low = interpolate(side, light.low, between, k);
        cu[k] =
            light.share == 0.0
                ? low
                : low + light.share * (interpolate(side, light.high, between, k) - low);
        five += k < PP_LUMEN_AVERAGE ? cu[k] / PP_LUMEN_AVERAGE : 0.0;
    }
    if (isnan(cu[PP_LUMEN_AVERAGE]))
        cu[PP_LUMEN_AVERAGE] = five;
    if (!isnan(five))
        return true;
    snprintf(why, room, "needs coefficients for %s that are missing from the table",
             isnan(query->ev_over_eh) ? "light from the ground" : "light from the sky");
    return false;
}

double pp_lumen_table_at_depth(const double cu[PP_LUMEN_POSITIONS], double share)
{
    double place = fmin(fmax((share - 0.1) / 0.2, 0.0), PP_LUMEN_AVERAGE - 1.0);
    int i = (int)fmin(floor(place), PP_LUMEN_AVERAGE - 2.0);
    return cu[i] * pow(cu[i + 1] / cu[i], place - i);
}

double pp_lumen_table_top(const struct pp_lumen_table *table, double rcr,
                          double ceiling, double walls, char *why, size_t room)
{
    static const char *const names[PP_LUMEN_TOP_AXES] = {
        "is in a room whose cavity ratio is", "is in a ceiling whose reflectance is",
        "is in a room whose mean wall reflectance is"};
    const struct pp_lumen_top_table *top = &table->top;
    const double at[PP_LUMEN_TOP_AXES] = {rcr, ceiling, walls};
    struct between between[PP_LUMEN_TOP_AXES];
    for (int axis = 0; axis < PP_LUMEN_TOP_AXES; axis++)
        if (!find_between(&between[axis], &top->axes[axis], 0, at[axis], false)) {
            outside(why, room, names[axis], at[axis], &top->axes[axis], 0);
            return NAN;
        }
    double sum = 0.0;
    for (int corner = 0; corner < 8; corner++) {
        double weight = 1.0;
        int cell = 0;
        for (int axis = 0; axis < PP_LUMEN_TOP_AXES; axis++) {
            bool high = corner >> axis & 1;
            weight *= high ? between[axis].share : 1.0 - between[axis].share;
            cell = cell * top->axes[axis].count
                   + (high ? between[axis].high : between[axis].low);
        }
        if (weight > 0.0)
            sum += weight * top->cu[cell];
    }
    if (isnan(sum))
        snprintf(why, room, "needs coefficients that are missing from the table");
    return sum;
}
