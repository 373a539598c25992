/* protractor_sheet_fill.c - fills in the marks of the primary scale, the lines of the
 * auxiliary scale, the names of sky and glass, and the opening shown. */
#include "methods/protractor/protractor_sheet_fill.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "methods/method.h"
#include "methods/protractor/protractor_read.h"

/* ---- the primary scale ---- */

/* Smallest of the usual divisions, in tenths of a per cent, whose marks are at least
 * apart_rad apart where the scale has that slope. */
static int division(double slope, double apart_rad)
{
    static const int usual[] = {1, 2, 5, 10, 20, 50, 100};
    int i = 0;
    while (i < 6 && 1e-3 * usual[i] < slope * apart_rad)
        i++;
    return usual[i];
}

static enum pp_status make_marks(struct pp_protractor_scale *scale,
                                 const struct pp_protractor_dial *dial,
                                 struct pp_mark_spacing spacing, struct pp_error *err)
{
    int last = (int)floor(1e3 * scale->whole + 1e-6);
    scale->marks = calloc((size_t)last + 1, sizeof *scale->marks);
    if (!scale->marks)
        return pp_fail_memory(err);
    double angle = 0.0, labelled = 0.0;
    for (int tenths = 1; tenths <= last; tenths++) {
        double share = fmin(1e-3 * tenths, scale->whole);
        angle = pp_protractor_dial_angle(dial, share, fmax(angle, 0.02));
        double slope = pp_protractor_dial_slope(dial, angle);
        int fine = division(slope, spacing.fine_rad);
        int middle = division(slope, 4.0 * spacing.fine_rad);
        int label = division(slope, spacing.label_rad);
        if (tenths % fine)
            continue;
        enum pp_mark_rank rank = PP_MARK_FINE;
        if (tenths % middle == 0)
            rank = PP_MARK_MIDDLE;
        /* Labels would collide at an end where the scale meets its mirror image. */
        double left = scale->range_rad - angle;
        if (tenths % label == 0 && angle - labelled > 0.8 * spacing.label_rad
            && left > 0.6 * spacing.label_rad) {
            rank = PP_MARK_LABELLED;
            labelled = angle;
        }
        scale->marks[scale->mark_count++] =
            (struct pp_protractor_mark){angle, share, rank};
    }
    return PP_OK;
}

/* ---- the auxiliary ---- */

enum { LINES = 24 }; /* correction factors 0.02 to 0.48 */

static enum pp_status make_lines(struct pp_protractor_scale *scale,
                                 const struct pp_protractor_dial *dial,
                                 struct pp_error *err)
{
    int count =
        (int)floor(scale->last_average_rad / PP_PROTRACTOR_LINE_STEP_RAD + 0.5) + 1;
    scale->lines = calloc(LINES, sizeof *scale->lines);
    if (!scale->lines)
        return pp_fail_memory(err);
    for (int i = 0; i < LINES; i++) {
        struct pp_protractor_line *line = &scale->lines[scale->line_count++];
        line->factor = 0.02 * (i + 1);
        line->jamb_rad = calloc((size_t)count, sizeof *line->jamb_rad);
        if (!line->jamb_rad)
            return pp_fail_memory(err);
    }
    for (int k = 0; k < count; k++) {
        struct pp_protractor_semicircle semicircle;
        pp_protractor_dial_semicircle_init(&semicircle, &dial->protractor,
                                           k * PP_PROTRACTOR_LINE_STEP_RAD);
        for (int i = 0; i < LINES; i++) {
            struct pp_protractor_line *line = &scale->lines[i];
            line->jamb_rad[line->count++] = pp_protractor_dial_jamb_angle(
                &semicircle, line->factor, scale->turned_down);
        }
    }
    return PP_OK;
}

/* ---- the sheet ---- */

static void write_sky(char *text, size_t room, const struct pp_sky *sky)
{
    if (sky->kind == PP_SKY_ISO)
        snprintf(text, room, "ISO 15469 sky of type %d", sky->iso);
    else
        snprintf(text, room, "%s",
                 sky->kind == PP_SKY_OVERCAST ? "CIE overcast sky" : "uniform sky");
}

static void write_glass(char *text, size_t room, const struct pp_protractor *protractor,
                        const char *glass_words)
{
    double slope_deg = protractor->slope_rad / PP_RAD;
    if (protractor->glass.panes == 0)
        snprintf(text, room, "unglazed aperture");
    else if (slope_deg > 89.99)
        snprintf(text, room, "vertical, %s", glass_words);
    else if (slope_deg < 0.01)
        snprintf(text, room, "horizontal, %s", glass_words);
    else
        snprintf(text, room, "%.3g\u00b0 to the horizontal, %s", slope_deg,
                 glass_words);
}

static enum pp_status make_scale(struct pp_protractor_scale *scale,
                                 const struct pp_protractor_dial *dial,
                                 bool turned_down, const char *glass_words,
                                 struct pp_mark_spacing spacing, struct pp_error *err)
{
    const struct pp_protractor *protractor = &dial->protractor;
    scale->number = pp_protractor_scale_number(protractor);
    write_sky(scale->sky, sizeof scale->sky, &protractor->sky);
    write_glass(scale->glass, sizeof scale->glass, protractor, glass_words);
    scale->slope_rad = protractor->slope_rad;
    scale->range_rad = dial->range_rad;
    scale->whole = pp_protractor_dial_share(dial, dial->range_rad);
    scale->turned_down = turned_down;
    bool bare = protractor->glass.panes == 0;
    scale->symmetric = turned_down && (bare || protractor->slope_rad < 1e-6);
    scale->last_average_rad =
        scale->symmetric || !turned_down
            ? PP_PI / 2.0
            : floor(scale->range_rad / (10.0 * PP_RAD) + 1e-6) * 10.0 * PP_RAD;
    enum pp_status status = make_marks(scale, dial, spacing, err);
    if (status == PP_OK)
        status = make_lines(scale, dial, err);
    return status;
}

enum pp_status pp_protractor_sheet_fill_blank(struct pp_protractor_sheet *sheet,
                                              const struct pp_protractor *protractor,
                                              const char *glass_words,
                                              struct pp_mark_spacing spacing,
                                              struct pp_error *err)
{
    *sheet = (struct pp_protractor_sheet){.allowance = 1.0};
    if (protractor->glass.diffusing)
        return pp_fail(
            err, PP_BAD_INPUT,
            "protractors do not cover diffusing glass; expected clear glass");
    if (pp_sky_has_azimuth(&protractor->sky))
        return pp_fail(err, PP_BAD_INPUT,
                       "protractors do not cover this sky; expected a sky whose "
                       "luminance does not depend on azimuth");
    struct pp_protractor_dial *dial = malloc(sizeof *dial);
    if (!dial)
        return pp_fail_memory(err);
    pp_protractor_dial_init(dial, protractor);
    bool upright = fabs(protractor->slope_rad - PP_PI / 2.0) < 1e-6;
    enum pp_status status =
        make_scale(&sheet->scale, dial, !upright, glass_words, spacing, err);
    free(dial);
    return status;
}

/* Reads one opening, and keeps the reading if its direct component is the largest so
 * far. */
static enum pp_status keep_if_largest(struct pp_protractor_sheet *sheet,
                                      const struct pp_outside_light *light,
                                      struct pp_protractor_dial *dial,
                                      const struct pp_opening *opening,
                                      struct pp_error *err)
{
    const struct pp_world *world = sheet->world;
    struct pp_receiver receiver = {.position = sheet->point, .normal = {0, 0, 1}};
    const char *why = pp_method_refuses_opening(&pp_method_protractor, world, light,
                                                opening, &receiver);
    if (why)
        return pp_fail(err, PP_BAD_INPUT, "%s %s %s",
                       pp_world_kind(world, opening->line), opening->label, why);
    struct pp_protractor protractor;
    enum pp_status status =
        pp_protractor_read_choose(&protractor, &light->sky, opening, err);
    if (status != PP_OK)
        return status;
    struct pp_protractor_readings read;
    pp_protractor_dial_init(dial, &protractor);
    status = pp_protractor_read(&read, dial, world, light, opening, sheet->point, err);
    if (status != PP_OK)
        return status;
    pp_protractor_read_work(&read);
    bool larger =
        read.count > 0
        && (!sheet->opening
            || read.sky + read.external > sheet->read.sky + sheet->read.external);
    if (larger) {
        pp_protractor_sheet_readings_clear(&sheet->read);
        sheet->read = read;
        sheet->opening = opening;
    } else {
        pp_protractor_sheet_readings_clear(&read);
    }
    return PP_OK;
}

enum pp_status pp_protractor_sheet_fill_room(struct pp_protractor_sheet *sheet,
                                             const struct pp_world *world,
                                             const struct pp_outside_light *light,
                                             const struct pp_receiver *receiver,
                                             struct pp_mark_spacing spacing,
                                             struct pp_error *err)
{
    *sheet = (struct pp_protractor_sheet){.world = world, .point = receiver->position};
    const char *why = pp_method_protractor.refuses_room(world, light, receiver);
    if (why)
        return pp_fail(err, PP_BAD_INPUT, "no protractor applies: %s", why);
    struct pp_protractor_dial *dial = malloc(sizeof *dial);
    if (!dial)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++)
        status = keep_if_largest(sheet, light, dial, &world->openings[i], err);
    if (status == PP_OK && !sheet->opening)
        status = pp_fail(err, PP_BAD_INPUT,
                         "no part of any opening is visible from the point above the "
                         "horizon");
    struct pp_protractor protractor;
    if (status == PP_OK)
        status =
            pp_protractor_read_choose(&protractor, &light->sky, sheet->opening, err);
    if (status == PP_OK) {
        sheet->others = world->opening_count - 1;
        sheet->allowance =
            pp_allowance_of(&pp_method_protractor, world, sheet->opening);
        pp_protractor_dial_init(dial, &protractor);
        bool upright = fabs(sheet->read.slope_rad - PP_PI / 2.0) < 1e-3;
        status = make_scale(&sheet->scale, dial, !upright, "clear single glass",
                            spacing, err);
    }
    free(dial);
    return status;
}
