/* protractor_worked.c - lays the protractor on the room's section and plan,
 * draws sight lines with their readings, and writes the sum below.
 */
#include "charts/drawing_board/protractor_worked.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/sheet/page.h"
#include "charts/drawing_board/protractor_disc.h"
#include "charts/drawing_board/protractor_sums.h"
#include "charts/room/room_plan.h"
#include "charts/section/room_section.h"

enum { SIGHTS_MOST = 12 };

/* Grey level of the protractor, lighter than the sight lines. */
static const double disc_grey = 0.42;

double pp_protractor_worked_radius_mm(const struct pp_canvas *canvas)
{
    struct pp_style style = pp_page_style(canvas);
    double width = pp_canvas_width_mm(canvas), height = pp_canvas_height_mm(canvas);
    double half = width > height ? 0.42 * fmin(width / 2.0, height)
                                 : 0.40 * fmin(width, height / 2.0);
    return fmin(0.62 * half, 62.0 * style.scale);
}

/* A straight line from the centre at an angle, with its reading. */
struct sight_line {
    double angle_rad;
    double reach; /* length to the edge, mm */
    char words[48];
};

struct sight_lines {
    int count;
    struct sight_line list[SIGHTS_MOST];
};

struct protractor_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_protractor_sheet *sheet;
    double radius;
    double least_scale; /* section and plan are drawn at 1 : least_scale or smaller */
};

/* Adds a sight line to the list, sorted by angle, unless the list contains it. */
static void note(struct sight_lines *sights, struct sight_line sight)
{
    int at = 0;
    for (; at < sights->count && sights->list[at].angle_rad < sight.angle_rad + 1e-4;
         at++)
        if (fabs(sights->list[at].angle_rad - sight.angle_rad) < 1e-4)
            return;
    if (sights->count == SIGHTS_MOST)
        return;
    for (int i = sights->count++; i > at; i--)
        sights->list[i] = sights->list[i - 1];
    sights->list[at] = sight;
}

typedef void place_function(const struct pp_protractor_disc *disc, double angle_rad,
                            double distance, double xy[2]);

/* Writes the reading of a sight line: beyond the edge if the edge is near, else at the
 * rim; farther out if other text is there. */
static struct pp_box write_sight(const struct protractor_drawing *drawing,
                                 const struct pp_protractor_disc *disc,
                                 place_function *place, const struct sight_line *sight,
                                 const struct pp_box *taken, int count)
{
    const struct pp_style *style = &drawing->style;
    double rim = disc->radius + pp_protractor_disc_border(style) + 1.0 * style->scale;
    double outside = sight->reach + 3.0 * style->scale, label[2], from[2];
    double at = outside < rim + 25.0 * style->scale ? fmax(outside, rim) : rim;
    place(disc, sight->angle_rad, 1.0, label);
    double dx = label[0] - disc->x, dy = label[1] - disc->y;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL,
                                     .bold = true,
                                     .across = 0.5 - 0.5 * dx,
                                     .down = 0.5 - 0.5 * dy};
    struct pp_box box;
    for (bool clear = false; !clear; at += 0.5 * style->scale) {
        place(disc, sight->angle_rad, at, label);
        box = pp_lettering_measure(drawing->cr, style, &set, label[0], label[1],
                                   sight->words);
        clear = true;
        for (int i = 0; i < count; i++)
            clear = clear && !pp_lettering_boxes_overlap(box, taken[i]);
    }
    place(disc, sight->angle_rad, disc->radius, from);
    pp_style_line(drawing->cr, style->hair, PP_INK);
    cairo_move_to(drawing->cr, from[0], from[1]);
    cairo_line_to(drawing->cr, label[0], label[1]);
    cairo_stroke(drawing->cr);
    return pp_lettering_draw_on_white(drawing->cr, style, &set, label[0], label[1],
                                      sight->words);
}

/* Draws sight lines from the centre to the edges, then their readings. */
static void draw_sights(const struct protractor_drawing *drawing,
                        const struct pp_protractor_disc *disc, place_function *place,
                        const struct sight_lines *sights)
{
    cairo_t *cr = drawing->cr;
    const struct pp_style *style = &drawing->style;
    pp_style_line(cr, style->medium, PP_INK);
    for (int i = 0; i < sights->count; i++) {
        double end[2];
        place(disc, sights->list[i].angle_rad,
              fmax(sights->list[i].reach, disc->radius), end);
        cairo_move_to(cr, disc->x, disc->y);
        cairo_line_to(cr, end[0], end[1]);
    }
    cairo_stroke(cr);
    struct pp_box taken[SIGHTS_MOST];
    for (int i = 0; i < sights->count; i++)
        taken[i] = write_sight(drawing, disc, place, &sights->list[i], taken, i);
    pp_style_marker(cr, style, PP_DISC, disc->x, disc->y);
}

/* --- the section ---------------------------------------------------------------------
 */

static void note_edges(struct sight_lines *sights,
                       const struct pp_protractor_sheet *sheet, double mm_per_m)
{
    for (int r = 0; r < sheet->read.count; r++) {
        const struct pp_protractor_reading *reading = &sheet->read.list[r];
        for (int k = 0; k < 2; k++) {
            double angle = reading->edge_rad[k];
            struct sight_line sight = {
                .angle_rad = angle,
                .reach = mm_per_m * (sheet->read.distance_m + sheet->opening->reveal_m)
                         / fmax(sin(angle + sheet->read.slope_rad), 0.02)};
            char percent[32];
            pp_protractor_sums_percent(percent, sizeof percent, reading->share[k]);
            snprintf(sight.words, sizeof sight.words, "%.1f\u00b0: %s", angle / PP_RAD,
                     percent);
            note(sights, sight);
        }
    }
}

/* Draws the section. If `scale` is not NULL, nothing is drawn; *scale is set to the
 * denominator of the largest scale at which the section fits. */
static enum pp_status draw_section(const struct protractor_drawing *drawing,
                                   struct pp_box box, double *height, double *scale,
                                   struct pp_error *err)
{
    const struct pp_protractor_sheet *sheet = drawing->sheet;
    const struct pp_style *style = &drawing->style;
    struct pp_receiver line[2] = {{.position = sheet->point, .normal = {0, 0, 1}},
                                  {.normal = {0, 0, 1}}};
    line[1].position = pp_vec_along(sheet->point, -0.01, sheet->read.out);
    struct pp_section_cut cut = {0};
    enum pp_status status = pp_section_cut_init(&cut, sheet->world, line, 2, err);
    if (status != PP_OK)
        return status;

    struct pp_report report = {
        .world = sheet->world, .receivers = line, .receiver_count = 1};
    struct pp_room_section section = {.world = sheet->world,
                                      .cut = &cut,
                                      .report = &report,
                                      .least_scale = drawing->least_scale,
                                      .no_sights = true};
    bool to_right =
        cut.along[0] * sheet->read.out.x + cut.along[1] * sheet->read.out.y > 0.0;
    double edge = drawing->radius + pp_protractor_disc_border(style);
    double words = 26.0 * style->scale, s = pp_section_cut_s(&cut, sheet->point);

    /* Reserves space for the scale bar, and for the protractor beside and above the
     * room. */
    bool overhead = sheet->read.list[0].edge_rad[1] > 1.0;
    double left = 0.0, right = 0.0, top = (overhead ? 10.0 : 3.0) * style->scale;
    for (int round = 0; round < 4; round++) {
        pp_room_section_fit(&section, style, box.width - left - right,
                            box.height - top);
        double near = s * section.mm_per_m;
        double far = (cut.length_m - s) * section.mm_per_m;
        section.y = 0.0;
        double above = pp_section_frame_y(&section, sheet->point.z);
        left = fmax(left, to_right ? fmax(edge + 2.0 - near, 4.0)
                                   : fmax(edge + 0.8 * words - near, words));
        right = fmax(right, to_right ? fmax(edge + 0.8 * words - far, words)
                                     : fmax(edge + 2.0 - far, 4.0));
        top = fmax(top, edge + 0.25 * words - above);
    }
    if (scale) {
        *scale = 1000.0 / section.mm_per_m;
        pp_section_cut_clear(&cut);
        return PP_OK;
    }
    double used = left + cut.length_m * section.mm_per_m + right;
    section.x = box.x + (box.width - used) / 2.0 + left;
    section.y = box.y + top;
    section.left_mm = left;
    section.right_mm = right;
    section.head_mm = 3.0 * drawing->style.scale;

    struct pp_protractor_disc disc = {.scale = &sheet->scale,
                                      .x = pp_section_frame_x(&section, s),
                                      .y = pp_section_frame_y(&section, sheet->point.z),
                                      .radius = drawing->radius,
                                      .grey = disc_grey,
                                      .to_right = to_right};
    pp_protractor_disc_primary(drawing->cr, style, &disc, false);
    pp_room_section_draw(drawing->cr, style, &section);
    struct sight_lines sights = {0};
    note_edges(&sights, sheet, section.mm_per_m);
    draw_sights(drawing, &disc, pp_protractor_disc_section, &sights);
    pp_section_cut_clear(&cut);
    *height = fmax(top + section.height_mm,
                   disc.y + 2.0 * style->text[PP_TEXT_SMALL] - box.y);
    return PP_OK;
}

/* --- the plan ------------------------------------------------------------------------
 */

static void note_jambs(struct sight_lines *sights,
                       const struct pp_protractor_sheet *sheet, double ahead_mm)
{
    for (int r = 0; r < sheet->read.count; r++) {
        const struct pp_protractor_reading *reading = &sheet->read.list[r];
        for (int k = 0; k < 2; k++) {
            struct sight_line sight = {.angle_rad = reading->jamb_rad[k]};
            sight.reach = ahead_mm / fmax(cos(sight.angle_rad), 0.02);
            snprintf(sight.words, sizeof sight.words, "%.0f\u00b0: %.3f",
                     fabs(sight.angle_rad) / PP_RAD, fabs(reading->correction[k]));
            note(sights, sight);
        }
    }
}

static void write_caption(const struct protractor_drawing *drawing, double x, double y,
                          double width, const char *words)
{
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT, .width = width, .lines = 2};
    pp_lettering_draw(drawing->cr, &drawing->style, &set, x, y, words);
}

static double caption_mm(const struct pp_style *style)
{
    return 3.6 * style->text[PP_TEXT_SMALL];
}

/* Draws the plan for an auxiliary scale that is turned down. The plan lies in the plane
 * of the average sight line; the opening is a line straight ahead, at the slant
 * distance. */
static void draw_turned_down(const struct protractor_drawing *drawing,
                             struct pp_box box)
{
    const struct pp_protractor_sheet *sheet = drawing->sheet;
    const struct pp_style *style = &drawing->style;
    const struct pp_protractor_reading *reading = &sheet->read.list[0];
    double edge = drawing->radius + pp_protractor_disc_border(style);
    double slant = sheet->read.distance_m
                   / fmax(sin(reading->average_rad + sheet->read.slope_rad), 0.02);
    double jamb[2], least = INFINITY, widest = 1e-3;
    for (int k = 0; k < 2; k++) {
        jamb[k] = slant * tan(reading->jamb_rad[k]);
        widest = fmax(widest, fabs(jamb[k]));
    }
    /* Size of the text around the line (mm), for which space is reserved. */
    double words = 20.0 * style->scale;
    least = fmin((box.height - caption_mm(style) - 0.5 * words) / slant,
                 (box.width / 2.0 - 1.6 * words) / widest);
    static const double usual[] = {1, 2, 2.5, 5};
    double scale = 1.0;
    for (int i = 0; 1000.0 / scale > least && i < 40; i++)
        scale = usual[i % 4] * pow(10.0, i / 4);
    double ahead = slant * 1000.0 / scale;
    double height = fmax(edge, ahead + 0.5 * words);

    struct pp_protractor_disc disc = {
        .scale = &sheet->scale,
        .x = box.x + box.width / 2.0,
        .y = box.y + (box.height - caption_mm(style) - height) / 2.0 + height,
        .radius = drawing->radius,
        .grey = disc_grey,
        .plan = {0.0, -1.0}};
    pp_protractor_disc_auxiliary(drawing->cr, style, &disc, false);
    pp_style_line(drawing->cr, 1.3 * style->thick, PP_INK);
    for (int k = 0; k < 2; k++)
        cairo_line_to(drawing->cr, disc.x + jamb[k] * 1000.0 / scale, disc.y - ahead);
    cairo_stroke(drawing->cr);
    struct sight_lines sights = {0};
    note_jambs(&sights, sheet, ahead);
    draw_sights(drawing, &disc, pp_protractor_disc_plan, &sights);
    char text[200];
    snprintf(text, sizeof text,
             "Plan 1:%g, in the plane of the average sight line; the opening is "
             "%.2f\u00a0m ahead.",
             scale, slant);
    write_caption(drawing, box.x, disc.y + 1.5 * style->text[PP_TEXT_SMALL], box.width,
                  text);
}

/* Increases `low` (left, below) and `high` (right, above), where necessary, to the
 * space (mm) outside the room that the half disc and its text need. */
static void make_room_for_disc(const struct protractor_drawing *drawing,
                               const struct pp_room_plan *plan, double low[2],
                               double high[2])
{
    const struct pp_protractor_sheet *sheet = drawing->sheet;
    const struct pp_style *style = &drawing->style;
    const double out[2] = {sheet->read.out.x, sheet->read.out.y};
    const double at[2] = {sheet->point.x, sheet->point.y};
    const double words[2] = {20.0 * style->scale, 8.0 * style->scale};
    double edge = drawing->radius + pp_protractor_disc_border(style);
    static const enum pp_plan_side sides[2][2] = {{PP_PLAN_LEFT, PP_PLAN_RIGHT},
                                                  {PP_PLAN_BELOW, PP_PLAN_ABOVE}};
    for (int k = 0; k < 2; k++) {
        double below = (at[k] - plan->extent.low[k]) * plan->mm_per_m;
        double above = (plan->extent.high[k] - at[k]) * plan->mm_per_m;
        double across = edge * fabs(out[1 - k]);
        const double border[2] = {pp_room_plan_border(plan, style, sides[k][0]),
                                  pp_room_plan_border(plan, style, sides[k][1])};
        double to_low = fmax(edge * fmax(-out[k], 0.0), across) + words[k];
        double to_high = fmax(edge * fmax(out[k], 0.0), across) + words[k];
        low[k] = fmax(low[k], fmax(to_low - below, border[0] + 0.5 * words[k]));
        high[k] = fmax(high[k], fmax(to_high - above, border[1] + 0.5 * words[k]));
    }
}

static void draw_worked_plan(const struct protractor_drawing *drawing,
                             struct pp_box box, double *scale)
{
    const struct pp_protractor_sheet *sheet = drawing->sheet;
    const struct pp_style *style = &drawing->style;
    struct pp_room_plan plan = {.least_scale = drawing->least_scale};
    double low[2] = {0.0, 0.0}, high[2] = {0.0, 0.0};
    box.height -= caption_mm(style);
    for (int round = 0; round < 4; round++) {
        pp_room_plan_fit(&plan, sheet->world, style, box.width - low[0] - high[0],
                         box.height - low[1] - high[1]);
        make_room_for_disc(drawing, &plan, low, high);
    }
    if (scale) {
        *scale = plan.scale;
        return;
    }
    double width = (plan.extent.high[0] - plan.extent.low[0]) * plan.mm_per_m;
    double height = (plan.extent.high[1] - plan.extent.low[1]) * plan.mm_per_m;
    plan.x = box.x + (box.width - width - low[0] - high[0]) / 2.0 + low[0];
    plan.y = box.y + (box.height - height - low[1] - high[1]) / 2.0 + high[1] + height;

    struct pp_protractor_disc disc = {.scale = &sheet->scale,
                                      .x = pp_plan_frame_x(&plan, sheet->point.x),
                                      .y = pp_plan_frame_y(&plan, sheet->point.y),
                                      .radius = drawing->radius,
                                      .grey = disc_grey,
                                      .plan = {sheet->read.out.x, -sheet->read.out.y}};
    pp_protractor_disc_auxiliary(drawing->cr, style, &disc, false);
    pp_room_plan_draw(drawing->cr, style, &plan);
    struct sight_lines sights = {0};
    note_jambs(&sights, sheet,
               (sheet->read.distance_m + sheet->opening->reveal_m) * plan.mm_per_m);
    draw_sights(drawing, &disc, pp_protractor_disc_plan, &sights);
    char text[100];
    snprintf(text, sizeof text, "Plan 1:%g.", plan.scale);
    write_caption(drawing, plan.x, plan.y + low[1], box.width, text);
}

static void draw_lower(const struct protractor_drawing *drawing, struct pp_box box)
{
    if (drawing->sheet->scale.turned_down)
        draw_turned_down(drawing, box);
    else
        draw_worked_plan(drawing, box, NULL);
}

/* Finds the largest scale at which both section and plan fit, so that equal distances
 * are equally long in both. If the auxiliary scale is turned down, its plan has a
 * separate scale. */
static enum pp_status find_scale(struct protractor_drawing *drawing,
                                 struct pp_box upper, struct pp_box lower,
                                 struct pp_error *err)
{
    double section = 1.0, plan = 1.0, height;
    enum pp_status status = draw_section(drawing, upper, &height, &section, err);
    if (status == PP_OK && !drawing->sheet->scale.turned_down)
        draw_worked_plan(drawing, lower, &plan);
    drawing->least_scale = fmax(section, plan);
    return status;
}

static void say_subtitle(char *text, size_t room,
                         const struct pp_protractor_sheet *sheet)
{
    char name[64] = "Protractor";
    if (sheet->scale.number)
        snprintf(name, sizeof name, "Protractor %d", sheet->scale.number);
    snprintf(text, room,
             "%s (%s; %s) laid on the section and plan at x %.2f, y %.2f, z "
             "%.2f\u00a0m, to read window %s",
             name, sheet->scale.sky, sheet->scale.glass, sheet->point.x, sheet->point.y,
             sheet->point.z, sheet->opening->label);
}

/* Draws one sheet with the protractors of the readings in `sums`. */
static enum pp_status draw_one(struct pp_canvas *canvas,
                               const struct pp_protractor_sheet *sheet,
                               const struct pp_protractor_sums *sums,
                               struct pp_error *err)
{
    struct protractor_drawing drawing = {.cr = pp_canvas_cairo(canvas),
                                         .style = pp_page_style(canvas),
                                         .sheet = sheet,
                                         .radius =
                                             pp_protractor_worked_radius_mm(canvas)};
    char subtitle[320], foot[300] = "", sum[2400] = "";
    say_subtitle(subtitle, sizeof subtitle, sheet);
    pp_protractor_sums_say(sum, sizeof sum, sheet, sums);
    if (sheet->others)
        pp_page_say(foot, sizeof foot,
                    "The opening that contributes most is shown. Read the other %d in "
                    "the same way, and add the results.",
                    sheet->others);
    pp_page_say(foot, sizeof foot,
                "Angles and scale readings are written outside the rim. After BRE "
                "Digest 309, 1986.");
    const struct pp_page page = {
        .title = sheet->world->name, .subtitle = subtitle, .foot = foot};
    struct pp_box box = pp_page_draw(canvas, &drawing.style, &page);

    struct pp_lettering set = {
        .size = PP_TEXT_BODY, .down = 1.0, .width = box.width, .lines = 40};
    struct pp_box written = pp_lettering_draw(drawing.cr, &drawing.style, &set, box.x,
                                              box.y + box.height, sum);
    double gap = 4.0 * drawing.style.scale, used;
    box.height -= written.height + gap;
    bool beside = box.width > box.height;
    struct pp_box part = box;
    if (beside)
        part.width = (box.width - gap) / 2.0;
    else
        part.height = (box.height - gap) / 2.0;
    enum pp_status status = find_scale(&drawing, part, part, err);
    if (status == PP_OK)
        status = draw_section(&drawing, part, &used, NULL, err);
    if (status != PP_OK)
        return status;
    if (beside) {
        part.x += part.width + gap;
    } else {
        part.y += used + gap;
        part.height = box.height - used - gap;
    }
    draw_lower(&drawing, part);
    return PP_OK;
}

enum pp_status pp_protractor_worked_draw(struct pp_canvas *canvas,
                                         const struct pp_protractor_sheet *sheet,
                                         struct pp_error *err)
{
    bool pages = pp_canvas_has_sheets(canvas);
    enum pp_status status = PP_OK;
    struct pp_protractor_sums sums = {.all = sheet->read.count};
    do {
        struct pp_protractor_sheet part = *sheet;
        int rest = sheet->read.count - sums.first;
        part.read.list = sheet->read.list + sums.first;
        part.read.count =
            rest < PP_PROTRACTOR_SUMS_MOST ? rest : PP_PROTRACTOR_SUMS_MOST;
        sums.last = !pages || rest <= PP_PROTRACTOR_SUMS_MOST;
        if (sums.first > 0)
            status = pp_canvas_next_sheet(canvas, err);
        if (status == PP_OK)
            status = draw_one(canvas, &part, &sums, err);
        sums.first += PP_PROTRACTOR_SUMS_MOST;
    } while (status == PP_OK && !sums.last);
    return status;
}
