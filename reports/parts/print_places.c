/* print_places.c - finds the coordinates that differ between points, and prints their
 * names. */
#include "reports/parts/print_places.h"

#include <math.h>
#include <string.h>

#include "reports/parts/print.h"
#include "model/base/text.h"

/* The inside face of the wall that contains all windows; NULL: there is no such
 * wall. */
static const struct pp_surface *window_wall(const struct pp_world *world)
{
    const struct pp_surface *wall = NULL;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_surface *face = &world->surfaces[world->openings[i].face];
        if (fabs(face->outline.normal.z) > 1e-6 || (wall && wall != face))
            return NULL;
        wall = face;
    }
    return wall;
}

static bool on_a_line(const struct pp_report *report)
{
    if (report->receiver_count < 3)
        return report->receiver_count == 2;
    struct pp_vec3 first = report->receivers[0].position;
    struct pp_vec3 last = report->receivers[report->receiver_count - 1].position;
    struct pp_vec3 way = pp_vec_sub(last, first);
    for (int i = 1; i < report->receiver_count; i++) {
        struct pp_vec3 to = pp_vec_sub(report->receivers[i].position, first);
        if (pp_vec_length(pp_vec_cross(way, to)) > 1e-6 * pp_vec_dot(way, way))
            return false;
    }
    return true;
}

static double coordinate(const struct pp_receiver *receiver, int axis)
{
    const double all[] = {receiver->position.x, receiver->position.y,
                          receiver->position.z, receiver->normal.x,
                          receiver->normal.y,   receiver->normal.z};
    return all[axis];
}

static bool is_constant(const struct pp_report *report, int axis)
{
    for (int i = 1; i < report->receiver_count; i++)
        if (fabs(coordinate(&report->receivers[i], axis)
                 - coordinate(&report->receivers[0], axis))
            > 1e-9)
            return false;
    return true;
}

static double from_wall(const struct pp_surface *wall, const struct pp_receiver *at)
{
    return pp_vec_dot(pp_vec_sub(at->position, wall->outline.vertices[0]),
                      wall->outline.normal);
}

/* Index of the coordinate that equals the distance from the window wall; -1: none. */
static int axis_from_wall(const struct pp_report *report, const struct pp_surface *wall)
{
    for (int axis = 0; axis < 2; axis++) {
        bool same = true;
        for (int i = 0; i < report->receiver_count && same; i++)
            same = fabs(from_wall(wall, &report->receivers[i])
                        - coordinate(&report->receivers[i], axis))
                   < 1e-9;
        if (same)
            return axis;
    }
    return -1;
}

/* True if the coordinate gets a column, because it differs between points. x and y also
 * get columns if all points have the same position. */
static bool is_shown(const struct pp_report *report, int axis)
{
    bool one_place = axis < 2 && is_constant(report, 0) && is_constant(report, 1)
                     && is_constant(report, 2);
    return one_place || !is_constant(report, axis);
}

static bool add_coordinate(struct pp_table *table, const struct pp_report *report,
                           int axis)
{
    static const char *const names[] = {"x", "y", "z", "nx", "ny", "nz"};
    struct pp_table_column *column = pp_table_add(table, NULL, NULL, names[axis]);
    if (!column)
        return false;
    for (int i = 0; i < report->receiver_count; i++)
        snprintf(column->cells[i], PP_CELL_BYTES, "%.2f",
                 coordinate(&report->receivers[i], axis) + 0.0);
    return true;
}

/* Appends the constant coordinates, such as "; points at x = 1.50, z = 0.85". */
static void say_constants(const struct pp_report *report, char *text, size_t room)
{
    static const char *const names[] = {"x", "y", "z"};
    if (report->receiver_count == 0)
        return;
    const struct pp_receiver *first = &report->receivers[0];
    const char *before = "; points at";
    for (int axis = 0; axis < 3; axis++)
        if (!is_shown(report, axis)) {
            pp_text_append(text, room, "%s %s = %.2f", before, names[axis],
                           coordinate(first, axis));
            before = ",";
        }
    bool same_way =
        !is_shown(report, 3) && !is_shown(report, 4) && !is_shown(report, 5);
    if (same_way && first->normal.z < 1.0 - 1e-9)
        pp_text_append(text, room, "; facing %.3g, %.3g, %.3g", first->normal.x,
                       first->normal.y, first->normal.z);
}

static bool add_distance(struct pp_table *table, const struct pp_report *report,
                         const struct pp_surface *wall)
{
    struct pp_table_column *column = pp_table_add(table, NULL, NULL, "from window");
    for (int i = 0; column && i < report->receiver_count; i++)
        snprintf(column->cells[i], PP_CELL_BYTES, "%.2f",
                 from_wall(wall, &report->receivers[i]) + 0.0);
    return column != NULL;
}

bool pp_print_places(struct pp_table *table, const struct pp_report *report, int width,
                     FILE *out)
{
    char above[320] = "Daylight factors in per cent, lengths in m";
    say_constants(report, above, sizeof above);
    for (int axis = 0; axis < 6; axis++)
        if (is_shown(report, axis) && !add_coordinate(table, report, axis))
            return false;

    const struct pp_surface *wall =
        on_a_line(report) ? window_wall(report->world) : NULL;
    int same = wall ? axis_from_wall(report, wall) : -1;
    if (same >= 0)
        pp_text_append(above, sizeof above, "; %c is the distance from the window wall",
                       "xy"[same]);
    else if (wall && !add_distance(table, report, wall))
        return false;
    table->key_count = table->column_count;

    fputs("  ", out);
    pp_print_wrapped(above, 2, 2, width, out);
    return true;
}
