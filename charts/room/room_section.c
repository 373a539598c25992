#include "charts/room/room_section.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/sheet/page.h"
#include "charts/sheet/lettering.h"
#include "model/base/text.h"

/* What stands before a window, as seen from the middle of it. */
struct window_obstruction {
    double angle_rad; /* above the horizontal; 0: nothing */
    double s, z;      /* the window's middle */
    double distance_m;
    bool skyline;
};

static int face_at(const struct pp_section_cut *cut, bool near)
{
    return near ? cut->near_face : cut->far_face;
}

/* Middle of the openings in a face: of those cut, else of all. */
static bool middle_of_openings(const struct pp_room_section *section, int face,
                               double *z)
{
    const struct pp_world *world = section->world;
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < section->cut->count; i++) {
        const struct pp_cut *cut = &section->cut->list[i];
        if (cut->kind != PP_CUT_OPENING || world->openings[cut->of].face != face)
            continue;
        low = fmin(low, fmin(cut->z[0], cut->z[1]));
        high = fmax(high, fmax(cut->z[0], cut->z[1]));
    }
    if (!(high > low)) {
        for (int i = 0; i < world->opening_count; i++) {
            const struct pp_opening *opening = &world->openings[i];
            if (opening->face != face)
                continue;
            for (int k = 0; k < opening->inner.count; k++) {
                low = fmin(low, opening->inner.vertices[k].z);
                high = fmax(high, opening->inner.vertices[k].z);
            }
        }
    }
    *z = 0.5 * (low + high);
    return high > low;
}

/* The highest line of sight from the window's middle, outwards in the section's plane,
 * to what hides sky there. */
static struct window_obstruction sight_of(const struct pp_room_section *section,
                                          bool near)
{
    struct window_obstruction sight = {.s = near ? 0.0 : section->cut->length_m};
    int face = face_at(section->cut, near);
    double out = near ? -1.0 : 1.0;
    if (face < 0 || !middle_of_openings(section, face, &sight.z))
        return sight;
    for (int i = 0; i < section->cut->count; i++) {
        const struct pp_cut *cut = &section->cut->list[i];
        for (int k = 0; k < 2 && cut->kind == PP_CUT_OUTSIDE; k++) {
            double away = out * (cut->s[k] - sight.s), up = cut->z[k] - sight.z;
            if (away > 1e-3 && atan2(up, away) > sight.angle_rad) {
                sight.angle_rad = atan2(up, away);
                sight.distance_m = away;
            }
        }
    }
    for (int i = 0; i < section->world->skyline_count; i++) {
        const struct pp_skyline *skyline = &section->world->skylines[i];
        if (skyline->face != face || skyline->angle_rad <= sight.angle_rad)
            continue;
        sight.angle_rad = skyline->angle_rad;
        sight.z = skyline->middle_z_m;
        sight.distance_m = skyline->distance_m;
        sight.skyline = true;
    }
    return sight;
}

bool pp_room_section_has_outside(const struct pp_room_section *section, bool near)
{
    return sight_of(section, near).angle_rad > 0.0;
}

/* Lowest and highest point of the room where it is cut. */
static void heights_of(const struct pp_section_cut *cut, double *low, double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (int i = 0; i < cut->count; i++)
        for (int k = 0; k < 2 && cut->list[i].kind == PP_CUT_FACE; k++) {
            *low = fmin(*low, cut->list[i].z[k]);
            *high = fmax(*high, cut->list[i].z[k]);
        }
    if (!(*high > *low)) {
        *low = 0.0;
        *high = cut->height_m + 1.0;
    }
}

double pp_room_section_x(const struct pp_room_section *section, double s)
{
    return section->x + s * section->mm_per_m;
}

double pp_room_section_y(const struct pp_room_section *section, double z)
{
    double low, high;
    heights_of(section->cut, &low, &high);
    return section->y + (high - z) * section->mm_per_m;
}

static double caption_mm(const struct pp_style *style)
{
    return 3.2 * style->text[PP_TEXT_SMALL];
}

void pp_room_section_fit(struct pp_room_section *section, const struct pp_style *style,
                         double length_mm, double height_mm)
{
    static const double steps[] = {1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 7.5, 8, 9};
    double low, high;
    heights_of(section->cut, &low, &high);
    double free_mm = fmax(height_mm - caption_mm(style), 5.0);
    double least = fmax(1000.0 * section->cut->length_m / length_mm,
                        1000.0 * (high - low) / free_mm);
    double power = pow(10.0, floor(log10(least)));
    double scale = 10.0 * power;
    for (int i = 11; i >= 0; i--)
        if (steps[i] * power >= least * (1.0 - 1e-9))
            scale = steps[i] * power;
    section->mm_per_m = 1000.0 / scale;
    section->height_mm = section->mm_per_m * (high - low) + caption_mm(style);
}

/* ---- drawing ---- */

struct section_drawing {
    const struct pp_room_section *section;
    cairo_t *cr;
    const struct pp_style *style;
    double low, high; /* z */
};

static double at_s(const struct section_drawing *frame, double s)
{
    return frame->section->x + s * frame->section->mm_per_m;
}

static double at_z(const struct section_drawing *frame, double z)
{
    return frame->section->y + (frame->high - z) * frame->section->mm_per_m;
}

static void line(const struct section_drawing *frame, const double s[2],
                 const double z[2])
{
    cairo_move_to(frame->cr, at_s(frame, s[0]), at_z(frame, z[0]));
    cairo_line_to(frame->cr, at_s(frame, s[1]), at_z(frame, z[1]));
}

static void stroke_cuts(const struct section_drawing *frame, enum pp_cut_kind kind,
                        double weight_mm, double grey, cairo_line_cap_t cap)
{
    const struct pp_section_cut *cut = frame->section->cut;
    pp_style_line(frame->cr, weight_mm, grey);
    cairo_set_line_cap(frame->cr, cap);
    for (int i = 0; i < cut->count; i++)
        if (cut->list[i].kind == kind)
            line(frame, cut->list[i].s, cut->list[i].z);
    cairo_stroke(frame->cr);
}

/* Openings that the plane does not cut, as seen in elevation beyond it. */
static int draw_openings_beyond(const struct section_drawing *frame)
{
    const struct pp_world *world = frame->section->world;
    const struct pp_section_cut *cut = frame->section->cut;
    int drawn = 0;
    pp_style_line(frame->cr, frame->style->thin, PP_GREY_LINE);
    double dash = 0.9 * frame->style->scale;
    cairo_set_dash(frame->cr, &dash, 1, 0.0);
    for (int i = 0; i < world->opening_count; i++) {
        bool is_cut = false;
        for (int k = 0; k < cut->count; k++)
            is_cut =
                is_cut || (cut->list[k].kind == PP_CUT_OPENING && cut->list[k].of == i);
        if (is_cut)
            continue;
        const struct pp_polygon *outline = &world->openings[i].inner;
        cairo_new_sub_path(frame->cr);
        for (int k = 0; k < outline->count; k++)
            cairo_line_to(frame->cr,
                          at_s(frame, pp_section_cut_s(cut, outline->vertices[k])),
                          at_z(frame, outline->vertices[k].z));
        cairo_close_path(frame->cr);
        drawn++;
    }
    cairo_stroke(frame->cr);
    return drawn;
}

/* Glass as two thin lines; the sides of a reveal out to it. */
static void draw_openings_cut(const struct section_drawing *frame)
{
    const struct pp_section_cut *cut = frame->section->cut;
    const struct pp_world *world = frame->section->world;
    double half = 0.45 * frame->style->thick;
    for (int i = 0; i < cut->count; i++) {
        const struct pp_cut *glass = &cut->list[i];
        bool is_opening = glass->kind == PP_CUT_OPENING;
        if (!is_opening && glass->kind != PP_CUT_GLASS)
            continue;
        if (is_opening && world->openings[glass->of].reveal_m > 0.0)
            continue;
        double x0 = at_s(frame, glass->s[0]), y0 = at_z(frame, glass->z[0]);
        double x1 = at_s(frame, glass->s[1]), y1 = at_z(frame, glass->z[1]);
        double length = hypot(x1 - x0, y1 - y0);
        if (!(length > 0.0))
            continue;
        double nx = half * (y1 - y0) / length, ny = -half * (x1 - x0) / length;
        pp_style_line(frame->cr, frame->style->thin, PP_INK);
        for (int side = -1; side <= 1; side += 2) {
            cairo_move_to(frame->cr, x0 + side * nx, y0 + side * ny);
            cairo_line_to(frame->cr, x1 + side * nx, y1 + side * ny);
        }
        for (int k = 0; k < cut->count; k++) {
            const struct pp_cut *inner = &cut->list[k];
            if (glass->kind != PP_CUT_GLASS || inner->kind != PP_CUT_OPENING
                || inner->of != glass->of)
                continue;
            for (int end = 0; end < 2; end++)
                line(frame, (double[]){glass->s[end], inner->s[end]},
                     (double[]){glass->z[end], inner->z[end]});
        }
        cairo_stroke(frame->cr);
    }
}

static void draw_plane(const struct section_drawing *frame)
{
    const struct pp_room_section *section = frame->section;
    cairo_t *cr = frame->cr;
    double y = at_z(frame, section->cut->height_m);
    double dashes[] = {1.6 * frame->style->scale, 0.9 * frame->style->scale};
    pp_style_line(cr, frame->style->thin, PP_INK);
    cairo_set_dash(cr, dashes, 2, 0.0);
    cairo_move_to(cr, at_s(frame, 0.0), y);
    cairo_line_to(cr, at_s(frame, section->cut->length_m), y);
    cairo_stroke(cr);
    pp_style_line(cr, frame->style->thin, PP_INK);
    double tick = 0.8 * frame->style->scale;
    for (int i = 0; i < section->report->receiver_count; i++) {
        double x =
            at_s(frame, pp_section_cut_s(section->cut,
                                         section->report->receivers[i].position));
        cairo_move_to(cr, x, y - tick);
        cairo_line_to(cr, x, y + tick);
    }
    cairo_stroke(cr);
}

/* The ground outside, from the wall to the end of the strip, if it is near the floor.
 */
static void draw_ground(const struct section_drawing *frame)
{
    const struct pp_room_section *section = frame->section;
    double z = section->world->ground_level_m, y = at_z(frame, z);
    if (fabs(z - frame->low) * section->mm_per_m > 3.0 * frame->style->scale)
        return;
    pp_style_line(frame->cr, frame->style->thin, PP_INK);
    for (int near = 0; near < 2; near++) {
        double wall = at_s(frame, near ? 0.0 : section->cut->length_m);
        double reach = near ? section->left_mm : section->right_mm;
        if (reach < 10.0 * frame->style->scale)
            continue;
        cairo_move_to(frame->cr, wall, y);
        cairo_line_to(frame->cr, near ? wall - reach : wall + reach, y);
    }
    cairo_stroke(frame->cr);
}

/* The line of sight to the head of what obstructs, the horizontal, and the angle. */
static void draw_sight(const struct section_drawing *frame, bool near)
{
    const struct pp_room_section *section = frame->section;
    struct window_obstruction sight = sight_of(section, near);
    if (!(sight.angle_rad > 0.0))
        return;
    cairo_t *cr = frame->cr;
    const struct pp_style *style = frame->style;
    double out = near ? -1.0 : 1.0;
    double x = at_s(frame, sight.s), y = at_z(frame, sight.z);
    double reach = (near ? section->left_mm : section->right_mm) - 1.0;
    /* As far as the strip and the section's top allow. */
    double top = fmax(y - section->y + 2.0 * style->scale, 1.0);
    double run = fmin(reach, top / tan(sight.angle_rad));
    run =
        fmin(run, sight.distance_m > 0.0 ? sight.distance_m * section->mm_per_m : run);
    pp_style_line(cr, style->thin, PP_INK);
    cairo_move_to(cr, x, y);
    cairo_line_to(cr, x + out * run, y - run * tan(sight.angle_rad));
    cairo_stroke(cr);
    pp_style_line(cr, style->hair, PP_INK);
    cairo_move_to(cr, x, y);
    cairo_line_to(cr, x + out * reach, y);
    cairo_stroke(cr);
    double radius = fmin(0.45 * reach, 0.9 * run / cos(sight.angle_rad));
    cairo_new_path(cr);
    if (near)
        cairo_arc(cr, x, y, radius, PP_PI, PP_PI + sight.angle_rad);
    else
        cairo_arc_negative(cr, x, y, radius, 0.0, -sight.angle_rad);
    cairo_stroke(cr);

    char words[64], far[32] = "";
    if (isfinite(sight.distance_m) && sight.distance_m > 0.0)
        pp_style_metres(far, sizeof far, sight.distance_m);
    snprintf(words, sizeof words, "%.0f\u00b0%s%s", sight.angle_rad / PP_RAD,
             *far ? " at " : "", far);
    struct pp_lettering text = {
        .size = PP_TEXT_SMALL, .across = near ? 0.0 : 1.0, .down = 0.0};
    pp_lettering_draw(cr, style, &text, x + out * reach, y + 0.5 * style->scale, words);
}

static void write_caption(const struct section_drawing *frame, int beyond)
{
    const struct pp_room_section *section = frame->section;
    char text[512], length[32], plane[32];
    pp_style_metres(length, sizeof length, section->cut->length_m);
    pp_style_metres(plane, sizeof plane, section->cut->height_m);
    snprintf(text, sizeof text,
             "Section 1:%g. Room %s long; reference points %s above the floor",
             1000.0 / section->mm_per_m, length, plane);
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < section->cut->count; i++) {
        const struct pp_cut *cut = &section->cut->list[i];
        if (cut->kind != PP_CUT_OPENING
            || section->world->openings[cut->of].face != section->cut->near_face)
            continue;
        low = fmin(low, fmin(cut->z[0], cut->z[1]));
        high = fmax(high, fmax(cut->z[0], cut->z[1]));
    }
    if (high > low) {
        char sill[32], head[32];
        pp_style_metres(sill, sizeof sill, low);
        pp_style_metres(head, sizeof head, high);
        pp_text_append(text, sizeof text, "; window sill %s, head %s", sill, head);
    }
    pp_text_append(text, sizeof text, ".%s",
                   beyond ? " Openings beside the section dashed." : "");
    struct pp_lettering set = {.size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT};
    double left = section->x, right = at_s(frame, section->cut->length_m);
    /* A narrow room's caption may go on beyond it. */
    set.width = fmax(right - left, 90.0 * frame->style->scale);
    set.lines = 2;
    pp_lettering_draw(frame->cr, frame->style, &set, left,
                      at_z(frame, frame->low) + 1.4 * frame->style->scale, text);
}

void pp_room_section_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_section *section)
{
    struct section_drawing frame = {section, cr, style, 0.0, 0.0};
    heights_of(section->cut, &frame.low, &frame.high);

    /* What lies outside may reach far beyond the sheet. */
    cairo_save(cr);
    double left = section->x - section->left_mm;
    double right = at_s(&frame, section->cut->length_m) + section->right_mm;
    cairo_rectangle(cr, left, section->y - 3.0 * style->scale, right - left,
                    section->height_mm + 3.0 * style->scale);
    cairo_clip(cr);
    int beyond = draw_openings_beyond(&frame);
    draw_ground(&frame);
    stroke_cuts(&frame, PP_CUT_OUTSIDE, style->medium, PP_INK, CAIRO_LINE_CAP_SQUARE);
    for (int near = 1; near >= 0 && !section->no_sights; near--)
        draw_sight(&frame, near);
    stroke_cuts(&frame, PP_CUT_FACE, style->thick, PP_INK, CAIRO_LINE_CAP_SQUARE);
    stroke_cuts(&frame, PP_CUT_INSIDE, style->medium, PP_INK, CAIRO_LINE_CAP_BUTT);
    draw_openings_cut(&frame);
    draw_plane(&frame);
    cairo_restore(cr);
    write_caption(&frame, beyond);
}
