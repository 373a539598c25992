/* plan_figures.c - places the values at points where they do not cover anything, and
 * describes the whole plane in words. */
#include "charts/room/plan_figures.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/sheet/page.h"
#include "model/results/reading.h"

/* ---- at the points ---- */

bool pp_plan_figures_has(const struct pp_plan_chart *chart, int receiver)
{
    const struct pp_receiver *at = &chart->report->receivers[receiver];
    return chart->figures && at->normal.z > 1.0 - 1e-9
           && fabs(at->position.z - chart->world->working_plane_m) < 1e-6
           && isfinite(chart->figures->points[receiver].value);
}

void pp_plan_figures_value(char *words, size_t room, const struct pp_plan_chart *chart,
                           int receiver)
{
    pp_style_percent(words, room, chart->figures->points[receiver].value);
    char *space = strstr(words, "\u00a0");
    if (space)
        *space = '\0';
}

/* Finds a box beside a mark that does not cover anything. If there is none, finds the
 * nearest box, up to four times as far away, that covers nothing except lines;
 * *on_lines is then true. Returns false if there is none. */
static bool find_box(struct pp_box *box, bool *on_lines, const struct pp_labels *labels,
                     struct pp_box size, double x, double y, double off)
{
    for (int ring = 0; ring < 3; ring++, off *= 2.0) {
        const double places[][2] = {{off, -0.5 * size.height},
                                    {-off - size.width, -0.5 * size.height},
                                    {-0.5 * size.width, -off - size.height},
                                    {-0.5 * size.width, off},
                                    {off, -size.height},
                                    {off, 0.0},
                                    {-off - size.width, -size.height},
                                    {-off - size.width, 0.0}};
        for (int i = 0; i < 16; i++) {
            *box = (struct pp_box){x + places[i % 8][0], y + places[i % 8][1],
                                   size.width, size.height};
            *on_lines = i >= 8;
            if (*on_lines ? pp_labels_covers_lines_only(labels, *box)
                          : ring == 0 && pp_labels_is_free(labels, *box))
                return true;
        }
    }
    return false;
}

bool pp_plan_figures_fit(cairo_t *cr, const struct pp_style *style,
                         const struct pp_room_plan *plan,
                         const struct pp_plan_chart *chart)
{
    const struct pp_report *report = chart->report;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL};
    struct pp_box size = pp_lettering_measure(cr, style, &set, 0, 0, "0.00");
    double wide = size.width + 0.8 * style->scale,
           high = size.height + 1.4 * style->scale;
    for (int i = 0; report && i < report->receiver_count; i++)
        for (int k = 0; k < i; k++) {
            struct pp_vec3 to = pp_vec_sub(report->receivers[k].position,
                                           report->receivers[i].position);
            if (pp_plan_figures_has(chart, i) && pp_plan_figures_has(chart, k)
                && fabs(to.x) * plan->mm_per_m < wide
                && fabs(to.y) * plan->mm_per_m < high)
                return false;
        }
    return true;
}

void pp_plan_figures_place(struct pp_plan_figure *list, cairo_t *cr,
                           const struct pp_style *style,
                           const struct pp_room_plan *plan,
                           const struct pp_plan_chart *chart, struct pp_labels *labels)
{
    const struct pp_report *report = chart->report;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL};
    for (int i = 0; i < report->receiver_count; i++) {
        double x = pp_plan_frame_x(plan, report->receivers[i].position.x);
        double y = pp_plan_frame_y(plan, report->receivers[i].position.y);
        pp_labels_note(labels, PP_LABEL_MARKS, x, y, x, y);
    }
    for (int i = 0; i < report->receiver_count; i++) {
        char words[32];
        list[i] = (struct pp_plan_figure){0};
        if (!pp_plan_figures_has(chart, i))
            continue;
        double x = pp_plan_frame_x(plan, report->receivers[i].position.x);
        double y = pp_plan_frame_y(plan, report->receivers[i].position.y);
        pp_plan_figures_value(words, sizeof words, chart, i);
        struct pp_box size = pp_lettering_measure(cr, style, &set, 0, 0, words);
        list[i].placed = find_box(&list[i].box, &list[i].on_lines, labels, size, x, y,
                                  0.8 * style->scale);
        if (list[i].placed)
            pp_labels_note_box(labels, list[i].box);
    }
}

void pp_plan_figures_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_plan *plan,
                          const struct pp_plan_chart *chart,
                          const struct pp_plan_figure *list)
{
    const struct pp_report *report = chart->report;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL};
    for (int i = 0; i < report->receiver_count; i++) {
        char words[32];
        if (!list || !list[i].placed)
            continue;
        pp_plan_figures_value(words, sizeof words, chart, i);
        (list[i].on_lines ? pp_lettering_draw_on_white : pp_lettering_draw)(
            cr, style, &set, list[i].box.x, list[i].box.y, words);
    }
    for (int i = 0; i < report->receiver_count; i++)
        pp_style_marker(cr, style, PP_POINT_MARK,
                        pp_plan_frame_x(plan, report->receivers[i].position.x),
                        pp_plan_frame_y(plan, report->receivers[i].position.y));
}

/* ---- of the plane ---- */

/* Appends `what` and a value such as "1.46 %" or "1.46 ± 0.02 %", with two decimals as
 * in df. */
static void say_reading(char *text, size_t room, const char *what,
                        const struct pp_reading *reading, const char *end)
{
    if (isfinite(reading->std_error))
        pp_page_say(text, room, "%s %.2f\u00a0\u00b1\u00a0%.2f\u00a0%%%s", what,
                    100.0 * reading->value, pp_reading_printed_error(reading), end);
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
        pp_page_say(text, room,
                    chart->report->grid_of_standard
                        ? "At the %d points of the EN 17037 grid, 0.5\u00a0m or more "
                          "from the walls:"
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
        say_reading(text, room, "Average over the whole plane", &figures->average, ".");
}
