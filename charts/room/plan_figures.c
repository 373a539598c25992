/* plan_figures.c - places the figures of points where they cover nothing, and describes
 * the plane as a whole in words. */
#include "charts/room/plan_figures.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/sheet/page.h"

/* ---- at the points ---- */

/* Owner of the marks' places in the label layout. */
enum { MARKS = 1000000 };

/* Formats like pp_style_percent, without the per cent sign. */
static void to_words(char *words, size_t room, double fraction)
{
    pp_style_percent(words, room, fraction);
    char *space = strstr(words, "\u00a0");
    if (space)
        *space = '\0';
}

static bool is_on_plane(const struct pp_world *world,
                        const struct pp_receiver *receiver)
{
    return receiver->normal.z > 1.0 - 1e-9
           && fabs(receiver->position.z - world->working_plane_m) < 1e-6;
}

/* The first box next to a mark that covers nothing; false: there is none. */
static bool find_box(struct pp_box *box, const struct pp_labels *labels,
                     struct pp_box size, double x, double y, double off)
{
    const double places[][2] = {{off, -0.5 * size.height},
                                {-off - size.width, -0.5 * size.height},
                                {-0.5 * size.width, -off - size.height},
                                {-0.5 * size.width, off},
                                {off, -size.height},
                                {off, 0.0},
                                {-off - size.width, -size.height},
                                {-off - size.width, 0.0}};
    for (int i = 0; i < 8; i++) {
        *box = (struct pp_box){x + places[i][0], y + places[i][1], size.width,
                               size.height};
        if (pp_labels_is_free(labels, *box))
            return true;
    }
    return false;
}

void pp_plan_figures_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_plan *plan,
                          const struct pp_plan_chart *chart, struct pp_labels *labels)
{
    const struct pp_report *report = chart->report;
    struct pp_lettering set = {.size = PP_TEXT_SMALL};
    for (int i = 0; report && i < report->receiver_count; i++) {
        double x = pp_room_plan_x(plan, report->receivers[i].position.x);
        double y = pp_room_plan_y(plan, report->receivers[i].position.y);
        pp_labels_note(labels, MARKS, x, y, x, y);
    }
    for (int i = 0; report && i < report->receiver_count; i++) {
        const struct pp_receiver *receiver = &report->receivers[i];
        double x = pp_room_plan_x(plan, receiver->position.x);
        double y = pp_room_plan_y(plan, receiver->position.y);
        bool hidden = pp_labels_is_near(labels, -1, x, y, 1.2 * style->scale);
        if (!hidden)
            pp_style_marker(cr, style, PP_POINT_MARK, x, y);
        if (!chart->figures || !is_on_plane(chart->world, receiver)
            || !isfinite(chart->figures->points[i].value))
            continue;
        char words[32];
        struct pp_box box;
        to_words(words, sizeof words, chart->figures->points[i].value);
        struct pp_box size = pp_lettering_measure(cr, style, &set, 0, 0, words);
        if (!find_box(&box, labels, size, x, y, 0.8 * style->scale))
            continue;
        pp_lettering_draw(cr, style, &set, box.x, box.y, words);
        pp_labels_note_box(labels, box);
    }
}

/* ---- of the plane ---- */

/* "1.46 %", or "1.46 ± 0.02 %": two decimals, as df prints them. */
static void say_reading(char *text, size_t room, const char *what,
                        const struct pp_reading *reading, const char *end)
{
    if (isfinite(reading->std_error))
        pp_page_say(text, room, "%s %.2f\u00a0\u00b1\u00a0%.2f\u00a0%%%s", what,
                    100.0 * reading->value,
                    ceil(1e4 * reading->std_error - 1e-9) / 100.0, end);
    else
        pp_page_say(text, room, "%s %.2f\u00a0%%%s", what, 100.0 * reading->value, end);
}

void pp_plan_figures_say(char *text, size_t room, const struct pp_plan_chart *chart)
{
    const struct pp_column *figures = chart->figures;
    if (!figures || !chart->report)
        return;
    if (figures->has_plane) {
        const struct pp_plane_reading *plane = &figures->plane;
        pp_page_say(
            text, room,
            chart->report->grid_of_standard
                ? "At the %d points of the EN 17037 grid, 0.5\u00a0m from the walls:"
                : "At the %d points of the grid:",
            chart->report->grid_points);
        say_reading(text, room, "minimum", &plane->minimum, ",");
        say_reading(text, room, "median", &plane->median, ",");
        say_reading(text, room, "mean", &plane->average, ",");
        if (isfinite(plane->uniformity))
            pp_page_say(text, room, "uniformity (minimum over mean) %.4f;",
                        plane->uniformity);
        for (int i = 0; i < PP_PLANE_LEVELS; i++)
            pp_page_say(text, room, "%s%.0f\u00a0%% of points reach %g\u00a0%%%s",
                        i == PP_PLANE_LEVELS - 1 ? "and " : "", 100.0 * plane->over[i],
                        100.0 * pp_plane_levels[i],
                        i == PP_PLANE_LEVELS - 1 ? "." : ",");
    }
    if (isfinite(figures->average.value))
        say_reading(text, room, "Average of the whole plane", &figures->average, ".");
}
