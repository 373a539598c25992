/* moment_chart.c - see moment_chart.h. */
#include "charts/year/moment_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/room/plan_names.h"
#include "charts/room/plan_strip.h"
#include "charts/room/room_plan.h"
#include "charts/sheet/hatch.h"
#include "charts/sheet/page.h"
#include "charts/year/colour_scale.h"

static const struct pp_colour_scale lux_classes = {
    {0.0, 100.0, 300.0, 500.0, 1000.0, 3000.0, 10000.0}, " lx"};

/* Overlap of neighbouring rows, so that rounding does not leave gaps between them. */
static const double OVERLAP_MM = 0.03;

/* Distance between the hatching lines for direct sunlight, mm on A4. */
static const double SUN_HATCH_MM = 1.6;

struct moment_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_moment_plan *plan;
    struct pp_room_plan frame;
    struct pp_box field; /* position of the plane on paper */
    struct pp_labels *labels;
};

/* ---- parts of cells ---- */

/* Function that returns the class of a part of a cell; -1: the part is not drawn.
 * Adjoining parts of the same class are drawn together. */
typedef int class_of_part(const struct pp_moment_plan *plan, size_t part);

static int colour_of_part(const struct pp_moment_plan *plan, size_t part)
{
    double lx = plan->diffuse[part] + plan->sun[part];
    return isnan(lx) ? -1 : pp_colour_scale_class(&lux_classes, lx);
}

static int sun_of_part(const struct pp_moment_plan *plan, size_t part)
{
    return plan->sun[part] > 0.0f ? 1 : -1;
}

/* Adds a rectangle to the path for the parts [first, end) of a row. */
static void add_run(const struct moment_drawing *drawing, int row, int first, int end)
{
    const struct pp_moment_plan *plan = drawing->plan;
    double part_x = plan->cell_m[0] / PP_MOMENT_PLAN_SUB,
           part_y = plan->cell_m[1] / PP_MOMENT_PLAN_SUB;
    double x = pp_plan_frame_x(&drawing->frame, plan->low[0] + first * part_x);
    double y = pp_plan_frame_y(&drawing->frame, plan->low[1] + (row + 1) * part_y);
    cairo_rectangle(drawing->cr, x, y,
                    (end - first) * part_x * drawing->frame.mm_per_m + OVERLAP_MM,
                    part_y * drawing->frame.mm_per_m + OVERLAP_MM);
}

/* Adds all parts of a class to the path. */
static void add_class(const struct moment_drawing *drawing, class_of_part *class_of,
                      int class)
{
    int columns = drawing->plan->columns * PP_MOMENT_PLAN_SUB;
    for (int row = 0; row < drawing->plan->rows * PP_MOMENT_PLAN_SUB; row++)
        for (int first = 0, end; first < columns; first = end + 1) {
            size_t at = (size_t)row * (size_t)columns;
            for (end = first;
                 end < columns && class_of(drawing->plan, at + (size_t)end) == class;)
                end++;
            if (end > first)
                add_run(drawing, row, first, end);
        }
}

static void draw_parts(const struct moment_drawing *drawing)
{
    cairo_t *cr = drawing->cr;
    cairo_save(cr);
    /* Antialiasing is switched off before the clip is set, because cairo 1.16 aborts if
     * it fills a path without antialiasing within a clip of several rectangles that do
     * not end at pixel boundaries. */
    cairo_set_antialias(cr, CAIRO_ANTIALIAS_NONE);
    pp_room_plan_path(cr, &drawing->frame);
    cairo_clip(cr);
    cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
    for (int i = 0; i < PP_COLOUR_CLASSES; i++) {
        pp_colour_scale_set(cr, &lux_classes, i > 0 ? lux_classes.limits[i] : -1.0);
        add_class(drawing, colour_of_part, i);
        cairo_fill(cr);
    }
    cairo_set_antialias(cr, CAIRO_ANTIALIAS_DEFAULT);
    add_class(drawing, sun_of_part, 1);
    pp_hatch_path(cr, drawing->field, SUN_HATCH_MM * drawing->style.scale,
                  drawing->style.thin, PP_INK);
    cairo_restore(cr);
}

/* ---- points ---- */

/* True if the receiver lies on the working plane and faces up. */
static bool is_on_plane(const struct pp_annual_sheet *sheet, int x)
{
    const struct pp_receiver *receiver = &sheet->receivers[x];
    return receiver->normal.z > 0.999
           && fabs(receiver->position.z - sheet->world->working_plane_m) < 0.01;
}

/* Writes a point's value right or left of it, or above or below, if there is space. */
static void draw_value(const struct moment_drawing *drawing, double x, double y,
                       double lx)
{
    static const int sides[][2] = {{1, 0}, {-1, 0}, {0, -1}, {0, 1}};
    char words[32];
    double beside = 1.4 * drawing->style.scale;
    snprintf(words, sizeof words, "%.0f", lx);
    for (int i = 0; i < 4; i++) {
        const struct pp_lettering set = {.size = PP_TEXT_SMALL,
                                         .across = 0.5 - 0.5 * sides[i][0],
                                         .down = 0.5 - 0.5 * sides[i][1]};
        double at[2] = {x + sides[i][0] * beside, y + sides[i][1] * beside};
        struct pp_box box = pp_lettering_measure(drawing->cr, &drawing->style, &set,
                                                 at[0], at[1], words);
        if (!pp_labels_is_free(drawing->labels, box))
            continue;
        pp_lettering_draw_on_white(drawing->cr, &drawing->style, &set, at[0], at[1],
                                   words);
        pp_labels_note_box(drawing->labels, box);
        return;
    }
}

/* Marks the room's points on the plane, with their values. */
static void draw_points(const struct moment_drawing *drawing)
{
    const struct pp_annual_sheet *sheet = &drawing->plan->points;
    const struct pp_room_plan *frame = &drawing->frame;
    double size = drawing->style.marker;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < sheet->receiver_count; i++) {
            double x = pp_plan_frame_x(frame, sheet->receivers[i].position.x);
            double y = pp_plan_frame_y(frame, sheet->receivers[i].position.y);
            if (!is_on_plane(sheet, i))
                continue;
            if (pass == 1) {
                draw_value(drawing, x, y, sheet->points[i].year_lxh.value);
                continue;
            }
            pp_style_marker(drawing->cr, &drawing->style, PP_DISC, x, y);
            pp_labels_note_box(
                drawing->labels,
                (struct pp_box){x - 0.5 * size, y - 0.5 * size, size, size});
        }
}

/* ---- words ---- */

/* Appends the mean illuminance over the plane with its components, the extremes, and
 * the fraction of the plane in direct sunlight. */
static void say_summary(char *text, size_t room, const struct pp_moment_plan *plan)
{
    const struct pp_annual_figures *mean = &plan->cells.mean;
    pp_page_say(text, room,
                "Mean over the plane %.0f\u00a0\u00b1\u00a0%.0f\u00a0lx: %.0f from the "
                "sky, %.0f from the sun directly, %.0f from sunlit surfaces.",
                mean->year_lxh.value - mean->sun_lxh.value + plan->sun_lx,
                mean->year_lxh.std_error, mean->sky_lxh.value, plan->sun_lx,
                mean->sun_reflected_lxh.value);
    pp_page_say(text, room, "Lowest %.0f\u00a0lx, highest %.0f\u00a0lx.",
                plan->lowest_lx, plan->highest_lx);
    if (plan->sun_share > 0.0)
        pp_page_say(text, room, "%.1f\u00a0%% of the plane is in direct sunlight.",
                    100.0 * plan->sun_share);
    else
        pp_page_say(text, room, "No direct sunlight reaches the plane.");
}

static void say_foot_of_moment(char *foot, size_t room,
                               const struct pp_moment_plan *plan,
                               const struct pp_outside_light *light)
{
    const struct pp_annual_sheet *sheet = &plan->cells;
    pp_page_say(foot, room, "%s.", sheet->weather);
    for (int i = 0; i < sheet->warning_count; i++)
        pp_page_say(foot, room, "Warning: %s.", sheet->warnings[i]);
    pp_page_say(foot, room,
                "Skylight and reflected sunlight: simulated at the centres of cells of "
                "%.2f x %.2f m, interpolated; direct sunlight: at %d x %d points of "
                "each cell.",
                plan->cell_m[0], plan->cell_m[1], PP_MOMENT_PLAN_SUB,
                PP_MOMENT_PLAN_SUB);
    pp_page_assumptions(foot, room, sheet->world, light);
}

static void say_subtitle(char *text, size_t room, const struct pp_moment_plan *plan)
{
    const struct pp_annual_hour *hour = &plan->cells.hours[0];
    char plane[32];
    pp_style_metres(plane, sizeof plane, plan->cells.world->working_plane_m);
    if (isnan(hour->sun_altitude_rad))
        snprintf(text, room,
                 "Illuminance, simulated, on the working plane %s above the floor; no "
                 "sun; outside %.0f\u00a0lx diffuse horizontal",
                 plane, hour->diffuse_lx);
    else
        snprintf(
            text, room,
            "Illuminance, simulated, on the working plane %s above the floor%s%s%s; "
            "sun %.1f\u00b0 high, bearing %.1f\u00b0; outside %.0f\u00a0lx diffuse "
            "horizontal, %.0f\u00a0lx direct normal",
            plane, plan->when ? ", " : "", plan->when ? plan->when : "",
            plan->when ? " (standard time)" : "", hour->sun_altitude_rad / PP_RAD,
            hour->sun_bearing_rad / PP_RAD, hour->diffuse_lx, hour->direct_lx);
}

static int gather_moment_keys(struct pp_key *keys, const struct moment_drawing *drawing)
{
    int count = 0;
    if (drawing->plan->sun_share > 0.0) {
        keys[count] = (struct pp_key){.kind = PP_KEY_HATCH};
        keys[count].curve.dashes[0] = SUN_HATCH_MM;
        snprintf(keys[count++].words, sizeof keys[0].words, "direct sunlight");
    }
    if (drawing->plan->points.receiver_count > 0) {
        keys[count] = (struct pp_key){.kind = PP_KEY_MARKER};
        keys[count].curve.marker = PP_DISC;
        snprintf(keys[count++].words, sizeof keys[0].words,
                 "calculation points, with values in lx");
    }
    return count;
}

/* ---- the sheet ---- */

static void find_field(struct moment_drawing *drawing)
{
    const struct pp_room_plan *frame = &drawing->frame;
    double width = (frame->extent.high[0] - frame->extent.low[0]) * frame->mm_per_m;
    double height = (frame->extent.high[1] - frame->extent.low[1]) * frame->mm_per_m;
    drawing->field = (struct pp_box){frame->x, frame->y - height, width, height};
    drawing->labels->field = drawing->field;
}

enum pp_status pp_moment_chart_draw(struct pp_canvas *canvas,
                                    const struct pp_moment_plan *plan,
                                    const struct pp_outside_light *light,
                                    struct pp_error *err)
{
    const struct pp_world *world = plan->cells.world;
    struct moment_drawing drawing = {.cr = pp_canvas_cairo(canvas),
                                     .style = pp_page_style(canvas),
                                     .plan = plan,
                                     .frame = {.named = true},
                                     .labels = calloc(1, sizeof *drawing.labels)};
    if (!drawing.labels)
        return pp_fail_memory(err);
    const struct pp_style *style = &drawing.style;
    char subtitle[400], foot[4096] = "", summary[640] = "";
    struct pp_key keys[2];
    say_subtitle(subtitle, sizeof subtitle, plan);
    say_foot_of_moment(foot, sizeof foot, plan, light);
    say_summary(summary, sizeof summary, plan);
    const struct pp_page page = {world->name, subtitle, foot};
    struct pp_box body = pp_page_draw(canvas, style, &page);
    int key_count = gather_moment_keys(keys, &drawing);
    struct pp_lettering set = {.size = PP_TEXT_BODY, .width = body.width, .lines = 4};
    double gap = 3.0 * style->scale, legend = 9.0 * style->scale;
    double strip = pp_plan_strip_height(style, key_count);
    double words =
        pp_lettering_measure(drawing.cr, style, &set, body.x, body.y, summary).height;
    double below = strip + words + legend + 2.0 * gap;
    struct pp_box field = {body.x, body.y, body.width, body.height - below};
    pp_room_plan_fit(&drawing.frame, world, style, field.width, field.height);
    pp_room_plan_place(&drawing.frame, style, field, false);
    find_field(&drawing);
    pp_plan_names_note(drawing.labels, drawing.cr, style, &drawing.frame);
    draw_parts(&drawing);
    pp_room_plan_draw(drawing.cr, style, &drawing.frame);
    pp_plan_names_draw(drawing.cr, style, &drawing.frame, NULL);
    draw_points(&drawing);
    double y = body.y + body.height - below + gap;
    pp_lettering_draw(drawing.cr, style, &set, body.x, y, summary);
    y += words + gap;
    pp_colour_scale_legend(drawing.cr, style, &lux_classes, body.x, y,
                           0.75 * body.width);
    pp_plan_strip_draw(drawing.cr, style,
                       (struct pp_box){body.x, y + legend, body.width, strip},
                       drawing.frame.scale, world->north_rad, keys, key_count);
    free(drawing.labels);
    return PP_OK;
}
